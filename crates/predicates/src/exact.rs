//! Exact determinants of points in doubles: aligned integers, no rounding, no allocation, the full range of doubles.
//!
//! **Design.** Put all coordinates of a call on one common power of two, take differences to the last point, divide
//! them by their common power of two, and expand the determinant by cofactors in integers as wide as needed and no
//! wider. The tiers, by the number b of bits of a difference:
//!
//! | tier | differences | |
//! |---|---|---|
//! | machine words | b <= 30, 30, 20 (orient3d, in_circle, in_sphere) | `i64` and `i128` |
//! | one limb | b <= 62 | minors in 2 limbs, cofactors in 3, heights in 2, up to 5 |
//! | distilled sums | products inside the range | orient2d: no differences, a sum of doubles without error ([`distilled`]) |
//! | two limbs, four limbs | b <= 126, b <= 254 | the same formulas, 2 and 4 times as wide |
//! | leading terms | any | no differences: doubles scaled by powers of two, with a bound ([`leading`]) |
//! | long sums | any | no differences: sums of monomials ([`long`]) |
//!
//! **Head-room.** Let every difference be at most 2^b in magnitude. (Two's complement makes the bound non-strict: `-2^b`
//! has b bits.) In up to three axes:
//! * a 2 x 2 minor is at most 2^(2b+1), a 3 x 3 minor at most 6 * 2^(3b) < 2^(3b+3);
//! * a height, the sum of three squares and of a difference of weights of at most 2^(2b+2), is at most 7 * 2^(2b) <
//!   2^(2b+3);
//! * det[p h; q h] is below 2 * 2^b * 2^(2b+3) = 2^(3b+4), in_circle below 3 * 2^(2b+1) * 2^(2b+3) < 2^(4b+6),
//!   in_sphere below 4 * 6 * 2^(3b) * 2^(2b+3) < 2^(5b+8).
//!
//! With b <= 64 L - 2 these are 2^(128 L - 3), 2^(192 L - 3), 2^(128 L - 1), 2^(192 L - 2), 2^(256 L - 2) and
//! 2^(320 L - 2): each fits into its 2 L, 3 L, 2 L, 3 L, 4 L and 5 L limbs with a sign. Partial sums are sums of fewer of
//! the same terms.
//!
//! Machine words, unweighted: orient2d in one limb is one `i128`, 2^(2*62+1). orient3d, b <= 30: minors 2^61 in `i64`, the sum
//! 6 * 2^90 in `i128`. in_circle, b <= 30: heights 2 * 2^60 = minors 2^61 in `i64`, the sum 3 * 2^122 in `i128`.
//! in_circle of a plane of space: heights 3 * 2^60, the sum 9 * 2^121. in_sphere, b <= 20: minors 2^41 and 6 * 2^60 < 2^63 in `i64`, the sum in `i128`.
//!
//! Aligned from the top, one limb holds magnitudes below 2^61, so differences below 2^62. Aligned from the lowest bit
//! set, coordinates of w bits have differences below 2^(w+1): b = w + 1.

pub(crate) mod align;
mod any;
mod distilled;
pub(crate) mod formulas;
mod general;
mod leading;
mod long;

use crate::int::Int;
use crate::{Sign, Stage};
use align::{extent, one_limb, two_limbs};

pub(crate) use general::{lifted, orient};

/// The largest number of axes: a lifted determinant then has degree 9.
pub(crate) const AXES_MAX: usize = 7;

/// The most points of one call.
pub(crate) const POINTS_MAX: usize = AXES_MAX + 2;

/// A sign, and the tier that found it.
pub(crate) type Answer = (Sign, Stage);

fn wide(a: i64) -> i128 {
    i128::from(a)
}

#[inline(always)]
fn in_plane<T, const L: usize>([x, y]: [T; 2]) -> [Int<L>; 2]
where
    Int<L>: From<T>,
{
    [x.into(), y.into()]
}

#[inline(always)]
fn in_space<T, const L: usize>([x, y, z]: [T; 3]) -> [Int<L>; 3]
where
    Int<L>: From<T>,
{
    [x.into(), y.into(), z.into()]
}

#[inline(always)]
fn sign(value: i128) -> Sign {
    Sign::from(value.cmp(&0))
}

/// Rows of differences to the last point, the points' coordinates one after the other.
macro_rules! differences {
    ($values:expr, $d:tt: $($row:literal)*) => {{
        let (values, last) = (&$values, $values.len() - $d);
        [$(differences!(@ values, $row * $d, last, $d)),*]
    }};
    (@ $values:ident, $from:expr, $last:ident, 2) => {
        [$values[$from] - $values[$last], $values[$from + 1] - $values[$last + 1]]
    };
    (@ $values:ident, $from:expr, $last:ident, 3) => {
        [
            $values[$from] - $values[$last],
            $values[$from + 1] - $values[$last + 1],
            $values[$from + 2] - $values[$last + 2],
        ]
    };
}

/// The orientation of three points in the plane.
#[inline(never)]
pub(crate) fn orient2d(a: &[f64; 2], b: &[f64; 2], c: &[f64; 2]) -> Answer {
    let values = [a[0], a[1], b[0], b[1], c[0], c[1]];
    if let Some(values) = one_limb(&values) {
        let [p, q] = differences!(values, 2: 0 1);
        return (sign(wide(p[0]) * wide(q[1]) - wide(p[1]) * wide(q[0])), Stage::OneLimb);
    }
    if let Some(sign) = distilled::orient2d(&values) {
        return (sign, Stage::Distilled);
    }
    if let Some(sign) = leading::orient(&[a, b, c], &[0, 1]) {
        return (sign, Stage::LeadingTerms);
    }
    orient2d_in_two_limbs(&values).unwrap_or_else(|| orient(&[a, b, c], &[0, 1]))
}

#[inline(never)]
fn orient2d_in_two_limbs(values: &[f64; 6]) -> Option<Answer> {
    let values = two_limbs(values)?;
    let [p, q] = differences!(values, 2: 0 1);
    let (p, q) = (in_plane(p), in_plane(q));
    Some((formulas::plane::<2, 4>([&p, &q]).sign(), Stage::TwoLimbs))
}

/// The sign of `(b - a) x (d - c)` in the plane.
#[inline(never)]
pub(crate) fn cross(a: &[f64; 2], b: &[f64; 2], c: &[f64; 2], d: &[f64; 2]) -> Answer {
    match one_limb(&[a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]]) {
        Some([ax, ay, bx, by, cx, cy, dx, dy]) => {
            let det = wide(bx - ax) * wide(dy - cy) - wide(by - ay) * wide(dx - cx);
            (sign(det), Stage::OneLimb)
        }
        None => general::cross(&[*a, *b, *c, *d]),
    }
}

/// The orientation of four points in space.
#[inline(never)]
pub(crate) fn orient3d(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3], d: &[f64; 3]) -> Answer {
    let values = [a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1], d[2]];
    // The reference is the last point, not the first: signs change.
    let Some(values) = one_limb(&values) else {
        let answer = orient3d_in_two_limbs(&values);
        return answer.unwrap_or_else(|| orient(&[a, b, c, d], &[0, 1, 2]));
    };
    let [p, q, r] = differences!(values, 3: 0 1 2);
    let (bits, zeros) = extent(&[p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]]);
    if bits.saturating_sub(zeros) <= 30 {
        let minor = |p: [i64; 3], q: [i64; 3]| {
            (p[0] >> zeros) * (q[1] >> zeros) - (p[1] >> zeros) * (q[0] >> zeros)
        };
        let det = wide(p[2] >> zeros) * wide(minor(q, r))
            + wide(q[2] >> zeros) * wide(minor(r, p))
            + wide(r[2] >> zeros) * wide(minor(p, q));
        return (-sign(det), Stage::MachineWords);
    }
    let (p, q, r) = (in_space(p), in_space(q), in_space(r));
    (-formulas::space::<1, 2, 3>([&p, &q, &r]).sign(), Stage::OneLimb)
}

#[inline(never)]
fn orient3d_in_two_limbs(values: &[f64; 12]) -> Option<Answer> {
    let values = two_limbs(values)?;
    let [p, q, r] = differences!(values, 3: 0 1 2);
    let (p, q, r) = (in_space(p), in_space(q), in_space(r));
    Some((-formulas::space::<2, 4, 6>([&p, &q, &r]).sign(), Stage::TwoLimbs))
}

/// Whether the last of four points is inside the circle of the others.
#[inline(never)]
pub(crate) fn in_circle(a: &[f64; 2], b: &[f64; 2], c: &[f64; 2], d: &[f64; 2]) -> Answer {
    let values = [a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]];
    let Some(values) = one_limb(&values) else {
        let answer = in_circle_in_two_limbs(&values);
        return answer.unwrap_or_else(|| lifted(&[a, b, c, d], &[0, 1], None));
    };
    let [p, q, r] = differences!(values, 2: 0 1 2);
    let (bits, zeros) = extent(&[p[0], p[1], q[0], q[1], r[0], r[1]]);
    if bits.saturating_sub(zeros) <= 30 {
        let shifted = |p: [i64; 2]| [p[0] >> zeros, p[1] >> zeros];
        let (p, q, r) = (shifted(p), shifted(q), shifted(r));
        let minor = |p: [i64; 2], q: [i64; 2]| p[0] * q[1] - p[1] * q[0];
        let height = |p: [i64; 2]| p[0] * p[0] + p[1] * p[1];
        let det = wide(height(p)) * wide(minor(q, r))
            + wide(height(q)) * wide(minor(r, p))
            + wide(height(r)) * wide(minor(p, q));
        return (sign(det), Stage::MachineWords);
    }
    let (p, q, r) = (in_plane(p), in_plane(q), in_plane(r));
    (formulas::in_circle::<1, 2, 4>([&p, &q, &r]).sign(), Stage::OneLimb)
}

#[inline(never)]
fn in_circle_in_two_limbs(values: &[f64; 8]) -> Option<Answer> {
    let values = two_limbs(values)?;
    let [p, q, r] = differences!(values, 2: 0 1 2);
    let (p, q, r) = (in_plane(p), in_plane(q), in_plane(r));
    Some((formulas::in_circle::<2, 4, 8>([&p, &q, &r]).sign(), Stage::TwoLimbs))
}

/// Whether the last of four points in a plane of space is inside the circle of the others, which turn left on the first
/// two axes.
pub(crate) fn in_circle_of_space(points: [&[f64; 3]; 4]) -> Answer {
    let [a, b, c, d] = points;
    let values = [a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1], d[2]];
    let general = || lifted(&points.map(|p| &p[..]), &[0, 1], None);
    let Some(values) = one_limb(&values) else { return general() };
    let [p, q, r] = differences!(values, 3: 0 1 2);
    let (bits, zeros) = extent(&[p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2]]);
    if bits.saturating_sub(zeros) > 30 {
        return general();
    }
    let shifted = |p: [i64; 3]| [p[0] >> zeros, p[1] >> zeros, p[2] >> zeros];
    let (p, q, r) = (shifted(p), shifted(q), shifted(r));
    let minor = |p: [i64; 3], q: [i64; 3]| p[0] * q[1] - p[1] * q[0];
    let height = |p: [i64; 3]| p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    let det = wide(height(p)) * wide(minor(q, r))
        + wide(height(q)) * wide(minor(r, p))
        + wide(height(r)) * wide(minor(p, q));
    (sign(det), Stage::MachineWords)
}

/// Whether the last of five points is inside the sphere of the others.
#[inline(never)]
pub(crate) fn in_sphere(
    a: &[f64; 3],
    b: &[f64; 3],
    c: &[f64; 3],
    d: &[f64; 3],
    e: &[f64; 3],
) -> Answer {
    let values =
        [a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1], d[2], e[0], e[1], e[2]];
    let Some(values) = one_limb(&values) else {
        let answer = in_sphere_in_two_limbs(&values);
        return answer.unwrap_or_else(|| lifted(&[a, b, c, d, e], &[0, 1, 2], None));
    };
    let [p, q, r, s] = differences!(values, 3: 0 1 2 3);
    let (bits, zeros) =
        extent(&[p[0], p[1], p[2], q[0], q[1], q[2], r[0], r[1], r[2], s[0], s[1], s[2]]);
    if bits.saturating_sub(zeros) <= 20 {
        let shifted = |p: [i64; 3]| [p[0] >> zeros, p[1] >> zeros, p[2] >> zeros];
        let det = in_sphere_in_words(shifted(p), shifted(q), shifted(r), shifted(s));
        return (sign(det), Stage::MachineWords);
    }
    let (p, q, r, s) = (in_space(p), in_space(q), in_space(r), in_space(s));
    (formulas::in_sphere::<1, 2, 3, 5>([&p, &q, &r, &s]).sign(), Stage::OneLimb)
}

#[inline(never)]
fn in_sphere_in_two_limbs(values: &[f64; 15]) -> Option<Answer> {
    let values = two_limbs(values)?;
    let [p, q, r, s] = differences!(values, 3: 0 1 2 3);
    let (p, q, r, s) = (in_space(p), in_space(q), in_space(r), in_space(s));
    Some((formulas::in_sphere::<2, 4, 6, 10>([&p, &q, &r, &s]).sign(), Stage::TwoLimbs))
}

/// As `formulas::sphere`.
#[inline(always)]
fn in_sphere_in_words(p: [i64; 3], q: [i64; 3], r: [i64; 3], s: [i64; 3]) -> i128 {
    let minor = |p: [i64; 3], q: [i64; 3]| p[0] * q[1] - p[1] * q[0];
    let height = |p: [i64; 3]| wide(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    let (pq, qr, rs, sp) = (minor(p, q), minor(q, r), minor(r, s), minor(s, p));
    let (pr, qs) = (minor(p, r), minor(q, s));
    let pqr = p[2] * qr - q[2] * pr + r[2] * pq;
    let qrs = q[2] * rs - r[2] * qs + s[2] * qr;
    let rsp = r[2] * sp + s[2] * pr + p[2] * rs;
    let spq = s[2] * pq + p[2] * qs + q[2] * sp;
    (height(r) * wide(spq) - height(s) * wide(pqr))
        + (height(p) * wide(qrs) - height(q) * wide(rsp))
}

#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
