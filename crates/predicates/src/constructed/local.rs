//! A filter for calls in the plane on vertices that are rounded, by the differences of the call itself.
//!
//! The static bound takes all vertices for as far apart as the whole set is wide and far from the origin. A call on vertices that are
//! near each other, far from the origin, needs less: let D be the largest difference of two coordinates that the determinant is
//! made of, in doubles, m the largest magnitude of a coordinate, u = 2^-53. A nearest double is off by at most u m, a
//! difference in doubles so by at most e = u (D + 2 m). Where e <= D / 16:
//!
//! - in_circle is a sum of 12 products of 4 differences. Of each, the errors of its factors make at most 4 e (D + e)^3 <= 4.8 e D^3; the
//!   roundings of the evaluation, at most 10 u of the sum of magnitudes (`filter.rs`), 120 u D^4. Together 57.6 e D^3 + 120 u D^4.
//! - orient, and a scalar product, is a sum of two products of 2: 2.2 e D each, and 3 u of 2 D^2. Together 4.4 e D + 6 u D^2.
//!
//! A distance of two points is at least D but for two roundings: a bound of larger D, which takes no more than the squares that are computed
//! anyhow. The bounds below are larger by more than the roundings of their own computation. Of D and m within 2^-200 and 2^200 nothing
//! under- or overflows but terms of 2^-1000, which are far below what the bounds have to spare.

use crate::Sign;
use crate::filter::value;

const U: f64 = f64::EPSILON / 2.0;

/// Where no term under- or overflows.
const RANGE: std::ops::RangeInclusive<f64> = 6.3e-61..=1.6e60;

/// The sign of the orientation of points whose nearest doubles these are, if that is certain; `value` is that of these doubles.
#[inline]
pub(super) fn orient2d([a, b, c]: [&[f64; 2]; 3], value: f64) -> Option<Sign> {
    let (d, e) = errors([a, b], c)?;
    certain(value, (5.0 * e + 8.0 * U * d) * d)
}

/// The same of the circle through the first three and the last.
#[inline]
pub(super) fn in_circle([a, b, c, q]: [&[f64; 2]; 4]) -> Option<Sign> {
    let (d, e) = errors([a, b, c], q)?;
    certain(value::in_circle([a, b, c, q]), (64.0 * e + 136.0 * U * d) * (d * d * d))
}

/// The same by what is known already: the squared distances from the last point, and the largest magnitude of any coordinate. A little
/// less sharp, and shorter.
#[inline(always)]
pub(super) fn in_circle_within(value: f64, heights: [f64; 3], m: f64) -> Option<Sign> {
    let larger = |x: f64, y: f64| if x > y { x } else { y }; // none is NaN where what follows is certain
    let square = larger(larger(heights[0], heights[1]), heights[2]);
    let d = square.sqrt();
    certain(value, (64.0 * error(d, m)? + 136.0 * U * d) * (d * square))
}

/// The sign of `(b - a) . (d - c)`, which is as large as an orientation.
pub(super) fn dot([a, b, c, d]: [&[f64; 2]; 4]) -> Option<Sign> {
    let (along, other) = ([b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]);
    let largest = along.into_iter().chain(other).fold(0.0, |m: f64, x| m.max(x.abs()));
    let coordinates = [a, b, c, d].into_iter().flatten();
    let e = error(largest, coordinates.fold(0.0, |m: f64, x| m.max(x.abs())))?;
    let value = along[0] * other[0] + along[1] * other[1];
    certain(value, (5.0 * e + 8.0 * U * largest) * largest)
}

/// The largest difference to the last point, and by how much differences are off.
#[inline(always)]
fn errors<const N: usize>(points: [&[f64; 2]; N], last: &[f64; 2]) -> Option<(f64, f64)> {
    let larger = |x: f64, y: f64| if x > y { x } else { y }; // none is NaN
    let (mut d, mut m) = (0.0, larger(last[0].abs(), last[1].abs()));
    for p in points {
        let of_p = larger((p[0] - last[0]).abs(), (p[1] - last[1]).abs());
        d = larger(d, of_p);
        m = larger(m, larger(p[0].abs(), p[1].abs()));
    }
    Some((d, error(d, m)?))
}

/// By how much differences up to `d` of coordinates up to `m` are off.
#[inline(always)]
fn error(d: f64, m: f64) -> Option<f64> {
    let e = U * (d + 2.0 * m);
    (RANGE.contains(&d) && RANGE.contains(&m) && e <= d / 16.0).then_some(e)
}

#[inline(always)]
fn certain(value: f64, bound: f64) -> Option<Sign> {
    (value.abs() > bound).then(|| Sign::of(value))
}
