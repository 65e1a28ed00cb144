//! The exact value of a constructed point: computed when it is made, or, of a point between two others, when it is first asked for.
//!
//! ```text
//!     b - a = d + e        s + x = a + t d        t d = p + q        t e = y + z        a + t (b - a) = s + (x + q + y + z)
//! ```
//!
//! All four are exact sums of two doubles each, the second being the rounding of the first (\[She97\]), so that the point is
//! known to some 100 bits before any long number is made. That tells its nearest double, and whether it is that, but for points
//! next to the middle between two doubles, and where something may under- or overflow.

use std::sync::OnceLock;

use crate::Dyadic;
use crate::ring::Homogeneous;

/// Products of magnitudes from the one to the other have exact roundings.
const RANGE: std::ops::RangeInclusive<f64> = 1e-250..=1e250;

/// See the module's text.
#[derive(Clone, Debug)]
pub(super) struct Value<const D: usize> {
    /// The ends and the parameter of a point between.
    between: Option<([[f64; D]; 2], f64)>,
    exact: OnceLock<Box<Homogeneous<Dyadic, D>>>,
}

impl<const D: usize> Value<D> {
    pub(super) fn known(exact: Homogeneous<Dyadic, D>) -> Self {
        Self { between: None, exact: OnceLock::from(Box::new(exact)) }
    }

    /// `a + t (b - a)` with the double nearest to each coordinate, and whether it is that; `None` if doubles cannot say.
    pub(super) fn between(ends: [[f64; D]; 2], t: f64) -> Option<(Self, [f64; D], bool)> {
        let (mut position, mut all_exact) = ([0.0; D], true);
        for axis in 0..D {
            let (nearest, is_exact) = nearest(ends[0][axis], ends[1][axis], t)?;
            position[axis] = nearest;
            all_exact &= is_exact;
        }
        Some((Self { between: Some((ends, t)), exact: OnceLock::new() }, position, all_exact))
    }

    /// The value.
    pub(super) fn get(&self) -> &Homogeneous<Dyadic, D> {
        self.exact.get_or_init(|| {
            let ([a, b], t) = self.between.expect("a value is known, or known how");
            let (t, a, b) = (Dyadic::from(t), a.map(Dyadic::from), b.map(Dyadic::from));
            let at = |axis: usize| (b[axis].clone() - &a[axis]) * &t + &a[axis];
            Box::new(Homogeneous::plain(std::array::from_fn(at)))
        })
    }
}

/// The double nearest to `a + t (b - a)`, and whether it is that; `None` if this is not certain.
fn nearest(a: f64, b: f64, t: f64) -> Option<(f64, bool)> {
    if a.abs().max(b.abs()) > *RANGE.end() {
        return None;
    }
    let (d, e) = two_sum(b, -a);
    let ((p, q), (y, z)) = (two_product(t, d)?, two_product(t, e)?);
    let (sum, x) = two_sum(a, p);
    // What is left, and the roundings of adding that up.
    let (rest, first) = two_sum(x, q);
    let (rest, second) = two_sum(rest, y);
    let (rest, third) = two_sum(rest, z);
    let off = first.abs() + second.abs() + third.abs();
    let (nearest, rest) = two_sum(sum, rest);
    if off == 0.0 {
        return Some((nearest, rest == 0.0));
    }
    // What is further off than this by a little is as near to no other double.
    let further = rest.abs() * (1.0 + 4.0 * f64::EPSILON) + 4.0 * off;
    let is_nearest = nearest + further == nearest && nearest - further == nearest;
    (is_nearest && rest.abs() > 2.0 * off).then_some((nearest, false))
}

/// The sum and its rounding.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// The product and its rounding; `None` if the latter may not be a double.
fn two_product(a: f64, b: f64) -> Option<(f64, f64)> {
    let product = a * b;
    if product == 0.0 && (a == 0.0 || b == 0.0) {
        return Some((0.0, 0.0));
    }
    if !(RANGE.contains(&product.abs()) && RANGE.contains(&a.abs()) && RANGE.contains(&b.abs())) {
        return None;
    }
    let ([a0, a1], [b0, b1]) = (halves(a), halves(b));
    Some((product, a1 * b1 - (((product - a0 * b0) - a1 * b0) - a0 * b1)))
}

/// Two doubles of 26 bits that sum up to this one: the higher first.
fn halves(x: f64) -> [f64; 2] {
    let scaled = 134_217_729.0 * x; // 2^27 + 1
    let high = scaled - (scaled - x);
    [high, x - high]
}

#[cfg(test)]
mod tests;
