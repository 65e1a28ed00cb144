//! Exact determinants of points in doubles: aligned integers, no rounding, no allocation, the full range of doubles.
//!
//! **Design.** Put all coordinates of a call on one common power of two: each becomes an integer of at most `w` bits,
//! where `w` is the distance from the lowest to the highest bit set in any of them (at most 2,098). Take differences to
//! the last point and expand the determinant by cofactors in [`Int<N>`], with `N` the smallest tier that the bound
//! below allows. spec: predicates, section 2.
//!
//! **The head-room.** An aligned coordinate is below 2^w in magnitude, a difference below 2^(w+1), a squared distance
//! in D coordinates below D 2^(2w+2). A k x k determinant sums k! products, so
//! * orientation in k axes: below k! 2^(k(w+1));
//! * lifted, k axes: below (k+1)! D 2^((k+2)(w+1)).
//!
//! One more bit holds the sign. Intermediate values may wrap (see `int.rs`).

use crate::Sign;
use crate::int::Int;

/// The largest number of axes: a lifted determinant then has degree 9.
pub(crate) const AXES_MAX: usize = 7;

/// The exponent of the lowest bit set and the width `w`, over all values; `None` if all are zero.
fn span(values: impl Iterator<Item = f64>) -> Option<(i32, usize)> {
    let (mut low, mut high) = (i32::MAX, i32::MIN);
    for value in values {
        let (mantissa, exponent) = decode(value);
        if mantissa != 0 {
            low = low.min(exponent + mantissa.trailing_zeros().cast_signed());
            high = high.max(exponent + (64 - mantissa.leading_zeros()).cast_signed());
        }
    }
    (high > low).then(|| (low, high.abs_diff(low) as usize))
}

/// `|value| = mantissa * 2^exponent`, exactly.
fn decode(value: f64) -> (u64, i32) {
    let bits = value.to_bits();
    let field = u16::try_from(bits >> 52 & 0x7ff).expect("eleven bits");
    let fraction = bits & ((1 << 52) - 1);
    debug_assert!(field != 0x7ff, "a coordinate that is not finite reached a predicate");
    if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, i32::from(field) - 1075) }
}

/// `value / 2^low`, an integer by the choice of `low`.
fn aligned<const N: usize>(value: f64, low: i32) -> Int<N> {
    let (mantissa, exponent) = decode(value);
    if mantissa == 0 {
        return Int::ZERO;
    }
    let zeros = mantissa.trailing_zeros();
    let shift = (exponent + zeros.cast_signed()).abs_diff(low) as usize;
    Int::shifted(mantissa >> zeros, shift, value.is_sign_negative())
}

/// Bits of `n!`, rounded up.
fn factorial_bits(n: usize) -> usize {
    [0, 0, 1, 3, 5, 7, 10, 13, 16][n]
}

/// Runs `$body` with the constant `$N` set to the smallest tier of at least `$bits` bits.
macro_rules! with_limbs {
    ($bits:expr, $N:ident => $body:expr) => {
        with_limbs!(@ $bits, $N, $body; 1 2 3 4 5 6 8 12 16 24 32 48 72 104 136 168 208 304)
    };
    (@ $bits:expr, $N:ident, $body:expr; $($tier:literal)*) => {{
        let bits: usize = $bits;
        $(if bits <= 64 * $tier {
            const $N: usize = $tier;
            $body
        } else)* {
            panic!("a determinant of {bits} bits is over the widest tier")
        }
    }};
}

/// Runs `$body` with the constant `$K` set to `$k`, from 0 to 8.
macro_rules! with_rows {
    ($k:expr, $K:ident => $body:expr) => {
        with_rows!(@ $k, $K, $body; 1 2 3 4 5 6 7 8)
    };
    (@ $k:expr, $K:ident, $body:expr; $($rows:literal)*) => {
        match $k {
            $($rows => {
                const $K: usize = $rows;
                $body
            })*
            k => panic!("{k} rows: predicates go from 1 to {AXES_MAX} axes"),
        }
    };
}

/// The sign of `det[p1 - p0; ..; pk - p0]` in the k given axes. `points` are k+1.
#[cold]
#[inline(never)]
pub(crate) fn orient(points: &[&[f64]], axes: &[usize]) -> Sign {
    let k = axes.len();
    assert_eq!(points.len(), k + 1, "orient in {k} axes takes {} points", k + 1);
    if k == 0 {
        return Sign::Positive;
    }
    let Some((low, w)) = span(points.iter().flat_map(|p| axes.iter().map(|&axis| p[axis]))) else {
        return Sign::Zero;
    };
    let bits = k * (w + 1) + factorial_bits(k) + 1;
    let sign = with_limbs!(bits, N => with_rows!(k, K => {
        let at = |p: &[f64]| -> [Int<N>; K] {
            std::array::from_fn(|column| aligned(p[axes[column]], low))
        };
        let last = at(points[K]);
        let rows: [[Int<N>; K]; K] = std::array::from_fn(|i| difference(at(points[i]), &last));
        determinant(&rows).sign()
    }));
    sign.times_minus_one_to(k) // the reference is the last point, not the first
}

/// The sign of `(b - a) x (d - c)` in the plane.
///
/// Differences of any two aligned points are below 2^(w+1), so the head-room is that of an orientation in two axes.
#[cold]
#[inline(never)]
pub(crate) fn cross([a, b, c, d]: [[f64; 2]; 4]) -> Sign {
    let Some((low, w)) = span([a, b, c, d].into_iter().flatten()) else {
        return Sign::Zero;
    };
    with_limbs!(2 * (w + 1) + 2, N => {
        let at = |p: [f64; 2]| p.map(|coordinate| aligned::<N>(coordinate, low));
        determinant(&[difference(at(b), &at(a)), difference(at(d), &at(c))]).sign()
    })
}

/// The sign of the lifted determinant: positive if the last of the k+2 points is inside the circumsphere of the first
/// k+1, these being positively oriented in the k given axes; heights are squared lengths in *all* coordinates.
#[cold]
#[inline(never)]
pub(crate) fn lifted(points: &[&[f64]], axes: &[usize]) -> Sign {
    let k = axes.len();
    assert_eq!(points.len(), k + 2, "in_sphere in {k} axes takes {} points", k + 2);
    let Some((low, w)) = span(points.iter().flat_map(|p| p.iter().copied())) else {
        return Sign::Zero;
    };
    let dimension = points[0].len();
    let height_bits = (dimension.next_power_of_two().trailing_zeros()) as usize;
    let bits = (k + 2) * (w + 1) + factorial_bits(k + 1) + height_bits + 1;
    let sign = with_limbs!(bits, N => with_rows!(k + 1, K => {
        let query = points[K];
        let rows: [[Int<N>; K]; K] = std::array::from_fn(|i| {
            let mut row = [Int::ZERO; K];
            let mut height = Int::ZERO;
            for (axis, (&a, &b)) in points[i].iter().zip(query).enumerate() {
                let d = aligned::<N>(a, low) - aligned(b, low);
                height = height + d * d;
                if let Some(column) = axes.iter().position(|&kept| kept == axis) {
                    row[column] = d;
                }
            }
            row[K - 1] = height;
            row
        });
        determinant(&rows).sign()
    }));
    sign.times_minus_one_to(k)
}

fn difference<const N: usize, const K: usize>(a: [Int<N>; K], b: &[Int<N>; K]) -> [Int<N>; K] {
    std::array::from_fn(|i| a[i] - b[i])
}

/// The determinant, by cofactors along the rows from the top.
fn determinant<const N: usize, const K: usize>(rows: &[[Int<N>; K]; K]) -> Int<N> {
    let columns: [usize; K] = std::array::from_fn(|i| i);
    minor(rows, &columns)
}

/// The minor of the last `columns.len()` rows in the given columns.
fn minor<const N: usize, const K: usize>(rows: &[[Int<N>; K]; K], columns: &[usize]) -> Int<N> {
    let row = &rows[K - columns.len()];
    match *columns {
        [c] => row[c],
        [c, d] => row[c] * rows[K - 1][d] - row[d] * rows[K - 1][c],
        _ => {
            let mut sum = Int::ZERO;
            for (i, &c) in columns.iter().enumerate() {
                let mut rest = [0; K];
                rest[..i].copy_from_slice(&columns[..i]);
                rest[i..columns.len() - 1].copy_from_slice(&columns[i + 1..]);
                let term = row[c] * minor(rows, &rest[..columns.len() - 1]);
                sum = if i % 2 == 0 { sum + term } else { sum - term };
            }
            sum
        }
    }
}
