//! Exact numbers for constructions: doubles as integers on one power of two, determinants, points with a common denominator.
//!
//! Predicates never come here (`delone-predicates` has its own, faster arithmetic). **Cost.** O(D^3) products of big integers
//! for a determinant (fraction-free elimination: each division leaves no rest).

use std::cmp::Ordering;

use dashu_int::IBig;
use dashu_int::ops::{Abs, BitTest};

/// The odd mantissa and the exponent of a finite double: `x = mantissa * 2^exponent`; zeros for zero.
fn decode(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let biased = i32::try_from(bits >> 52 & 0x7ff).expect("eleven bits");
    let fraction = (bits & ((1 << 52) - 1)).cast_signed();
    let (mantissa, exponent) =
        if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
    if mantissa == 0 {
        return (0, 0);
    }
    let zeros = mantissa.trailing_zeros();
    let odd = mantissa >> zeros;
    (if x < 0.0 { -odd } else { odd }, exponent.saturating_add_unsigned(zeros))
}

/// The largest power of two, as its exponent, that all these are multiples of.
pub(crate) fn unit(numbers: impl Iterator<Item = f64>) -> i32 {
    numbers.filter(|&x| x != 0.0).map(|x| decode(x).1).min().unwrap_or(0)
}

/// `x / 2^unit`.
pub(crate) fn integer(x: f64, unit: i32) -> IBig {
    match decode(x) {
        (0, _) => IBig::ZERO,
        (mantissa, exponent) => IBig::from(mantissa) << exponent.abs_diff(unit) as usize,
    }
}

/// The order of the distances of `a` and `b` from `q`, exactly.
pub(crate) fn compare_distances<const D: usize>(
    q: &[f64; D],
    a: &[f64; D],
    b: &[f64; D],
) -> Ordering {
    let square = |p: &[f64; D]| (0..D).map(|x| (p[x] - q[x]) * (p[x] - q[x])).sum::<f64>();
    let (to_a, to_b) = (square(a), square(b));
    // A sum of D squares of rounded differences is off by a factor of less than 1 + (D + 3) 2^-53 either way, D <= 8, if
    // nothing underflows or overflows; what underflows is less than 8 * 2^-1074.
    let sure = |near: f64, far: f64| near * (1.0 + f64::EPSILON * 16.0) + 1e-300 < far;
    if to_a.max(to_b) < f64::INFINITY {
        if sure(to_a, to_b) {
            return Ordering::Less;
        }
        if sure(to_b, to_a) {
            return Ordering::Greater;
        }
    }
    let unit = unit(q.iter().chain(a).chain(b).copied());
    let exact = |p: &[f64; D]| {
        let away = (0..D).map(|x| integer(p[x], unit) - integer(q[x], unit));
        away.map(|d| &d * &d).sum::<IBig>()
    };
    exact(a).cmp(&exact(b))
}

/// The determinant of the square matrix of these rows (Bareiss' elimination).
pub(crate) fn determinant(mut rows: Vec<Vec<IBig>>) -> IBig {
    let n = rows.len();
    let (mut negative, mut last) = (false, IBig::ONE);
    for k in 0..n {
        let Some(pivot) = (k..n).find(|&i| !rows[i][k].is_zero()) else { return IBig::ZERO };
        negative ^= pivot != k;
        rows.swap(pivot, k);
        let (upper, lower) = rows.split_at_mut(k + 1);
        let top = &upper[k];
        for row in lower {
            for j in k + 1..n {
                row[j] = (&row[j] * &top[k] - &row[k] * &top[j]) / &last;
            }
        }
        last = rows[k][k].clone();
    }
    if negative { -last } else { last }
}

/// A point with rational coordinates, `numerators[i] / denominator * 2^exponent`.
#[derive(Clone, Debug)]
pub struct ExactPoint<const D: usize> {
    /// One for each axis.
    pub numerators: [IBig; D],
    /// Positive; not reduced.
    pub denominator: IBig,
    /// Of two.
    pub exponent: i32,
}

impl<const D: usize> ExactPoint<D> {
    /// The nearest doubles (of numbers below 2^-1022, one of the two nearest); infinite beyond the largest.
    #[must_use]
    pub fn rounded(&self) -> [f64; D] {
        std::array::from_fn(|axis| self.rounded_on(axis))
    }

    fn rounded_on(&self, axis: usize) -> f64 {
        let (n, d) = (&self.numerators[axis], &self.denominator);
        let bits = |x: &IBig| i32::try_from(x.bit_len()).expect("fewer than 2^31 bits");
        // A quotient of 65 bits or more, and a last bit that says whether there is a rest: then one rounding.
        let shift = (66 + bits(d) - bits(n)).max(0);
        let scaled = n.clone() << shift.unsigned_abs() as usize;
        let (quotient, rest) = (&scaled / d, &scaled % d);
        let sticky = (quotient << 1) + if rest.is_zero() { 0 } else { 1 } * sign_of(n);
        times_power_of_two(sticky.to_f64().value(), self.exponent - shift - 1)
    }
}

/// 1 or -1.
fn sign_of(n: &IBig) -> i32 {
    if *n < IBig::ZERO { -1 } else { 1 }
}

fn times_power_of_two(mut x: f64, mut exponent: i32) -> f64 {
    while exponent != 0 && x != 0.0 && x.is_finite() {
        let step = exponent.clamp(-1000, 1000);
        x *= f64::from_bits(u64::from((step + 1023).unsigned_abs()) << 52);
        exponent -= step;
    }
    x
}

/// Equal positions are equal, whatever the denominators.
impl<const D: usize> PartialEq for ExactPoint<D> {
    fn eq(&self, other: &Self) -> bool {
        let shift = self.exponent.abs_diff(other.exponent) as usize;
        let (mine, theirs) = if self.exponent > other.exponent { (shift, 0) } else { (0, shift) };
        (0..D).all(|axis| {
            let left = (&self.numerators[axis] * &other.denominator) << mine;
            left == (&other.numerators[axis] * &self.denominator) << theirs
        })
    }
}

impl<const D: usize> Eq for ExactPoint<D> {}

/// The center of the sphere orthogonal to the balls around these D + 1 points, whose squared radii are the weights: the
/// circumcenter, if all are equal. The points are not in a hyperplane.
///
/// With the first point for origin, `2 (p_i - p_0) . c = |p_i - p_0|^2 - (w_i - w_0)`, solved by Cramer's rule.
pub(crate) fn orthocenter<const D: usize>(points: &[[f64; D]], weights: &[f64]) -> ExactPoint<D> {
    let roots = unit(weights.iter().copied()).div_euclid(2);
    let unit = unit(points.iter().flatten().copied()).min(roots);
    let origin: Vec<IBig> = points[0].iter().map(|&x| integer(x, unit)).collect();
    let weigh = |i: usize| weights.get(i).map_or(IBig::ZERO, |&w| integer(w, 2 * unit));
    let mut rows = Vec::with_capacity(D);
    let mut sides = Vec::with_capacity(D);
    for (i, point) in points.iter().enumerate().skip(1) {
        let row: Vec<IBig> =
            point.iter().zip(&origin).map(|(&x, from)| integer(x, unit) - from).collect();
        let square: IBig = row.iter().map(|d| d * d).sum();
        sides.push(square - (weigh(i) - weigh(0)));
        rows.push(row);
    }
    let denominator = determinant(rows.clone()) * 2;
    let sign = sign_of(&denominator);
    let numerators = std::array::from_fn(|axis| {
        let mut replaced = rows.clone();
        for (row, side) in replaced.iter_mut().zip(&sides) {
            row[axis].clone_from(side);
        }
        (determinant(replaced) + &origin[axis] * &denominator) * sign
    });
    ExactPoint { numerators, denominator: denominator.abs(), exponent: unit }
}

#[cfg(test)]
mod tests;
