//! Floating-point filters: the sign when doubles suffice to know it, safe under underflow and overflow.
//!
//! **Design.** Each filter computes the determinant of differences in plain doubles, and beside it the *permanent*, the
//! same expression with every product taken in magnitude. With u = 2^-53 the rounding error of the determinant is at
//! most `A * permanent`, where A counts the roundings on the longest path ([She97] sections 4.2 to 4.4; A is rounded up
//! there so that the bound itself may be computed in doubles).
//!
//! **Underflow.** A product that underflows loses at most 2^-1075 in magnitude, which no relative bound covers. So each
//! inner magnitude gets a guard G = 2^-1020 added *before* it is scaled by its outer factor: A G >= 7 * 2^-53 * 2^-1020
//! = 28 * 2^-1075, more than the two (or, in a squared length, three) products below it can lose. The guard of the last
//! sum covers the outermost products and the rounding of `A * permanent` itself. Differences never underflow inexactly.
//! For orient2d, where both products are outermost, [OBO16] prove the sharper form used here.
//!
//! **Overflow.** A difference or product that overflows makes the permanent infinite or NaN, and then no comparison
//! below succeeds: uncertain.
//!
//! **Out.** `None` means uncertain, never "zero".

use crate::Sign;

const U: f64 = f64::EPSILON / 2.0;
const GUARD: f64 = 4.0 * f64::MIN_POSITIVE;

const ORIENT_2D: f64 = (3.0 + 16.0 * U) * U;
const ORIENT_3D: f64 = (7.0 + 56.0 * U) * U;
const IN_CIRCLE: f64 = (10.0 + 96.0 * U) * U;
const IN_SPHERE: f64 = (16.0 + 224.0 * U) * U;

/// The sign of `value`, if its magnitude is over the error bound.
#[inline(always)]
fn certain(value: f64, bound: f64) -> Option<Sign> {
    if value > bound {
        Some(Sign::Positive)
    } else if -value > bound {
        Some(Sign::Negative)
    } else {
        None
    }
}

/// `|a d| + |b c|`, guarded, beside `a d - b c`.
#[inline(always)]
fn minor2(a: f64, b: f64, c: f64, d: f64) -> (f64, f64) {
    let (left, right) = (a * d, b * c);
    (left - right, left.abs() + right.abs() + GUARD)
}

#[inline(always)]
pub(crate) fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<Sign> {
    let left = (a[0] - c[0]) * (b[1] - c[1]);
    let right = (a[1] - c[1]) * (b[0] - c[0]);
    certain(left - right, ORIENT_2D * ((left + right).abs() + f64::MIN_POSITIVE))
}

/// The sign of `(b - a) x (d - c)`: the same roundings as in `orient2d`, one for each difference.
#[inline(always)]
pub(crate) fn cross([a, b, c, d]: [[f64; 2]; 4]) -> Option<Sign> {
    let left = (b[0] - a[0]) * (d[1] - c[1]);
    let right = (b[1] - a[1]) * (d[0] - c[0]);
    certain(left - right, ORIENT_2D * ((left + right).abs() + f64::MIN_POSITIVE))
}

#[inline(always)]
pub(crate) fn orient3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Option<Sign> {
    let [p, q, r] = [a, b, c].map(|v| [v[0] - d[0], v[1] - d[1], v[2] - d[2]]);
    let (qr, qr_mag) = minor2(q[0], q[1], r[0], r[1]);
    let (rp, rp_mag) = minor2(r[0], r[1], p[0], p[1]);
    let (pq, pq_mag) = minor2(p[0], p[1], q[0], q[1]);
    let value = p[2] * qr + q[2] * rp + r[2] * pq;
    let permanent = p[2].abs() * qr_mag + q[2].abs() * rp_mag + r[2].abs() * pq_mag + GUARD;
    certain(value, ORIENT_3D * permanent).map(|sign| -sign) // the reference is the last point
}

#[inline(always)]
pub(crate) fn in_circle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Option<Sign> {
    let [p, q, r] = [a, b, c].map(|v| [v[0] - d[0], v[1] - d[1]]);
    let [hp, hq, hr] = [p, q, r].map(|v| v[0] * v[0] + v[1] * v[1]);
    let (qr, qr_mag) = minor2(q[0], q[1], r[0], r[1]);
    let (rp, rp_mag) = minor2(r[0], r[1], p[0], p[1]);
    let (pq, pq_mag) = minor2(p[0], p[1], q[0], q[1]);
    let value = hp * qr + hq * rp + hr * pq;
    let permanent = (hp + GUARD) * qr_mag + (hq + GUARD) * rp_mag + (hr + GUARD) * pq_mag + GUARD;
    certain(value, IN_CIRCLE * permanent)
}

#[inline(always)]
pub(crate) fn in_sphere(
    a: [f64; 3],
    b: [f64; 3],
    c: [f64; 3],
    d: [f64; 3],
    e: [f64; 3],
) -> Option<Sign> {
    let [p, q, r, s] = [a, b, c, d].map(|v| [v[0] - e[0], v[1] - e[1], v[2] - e[2]]);
    let [hp, hq, hr, hs] = [p, q, r, s].map(|v| v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    let (pq, pq_mag) = minor2(p[0], p[1], q[0], q[1]);
    let (qr, qr_mag) = minor2(q[0], q[1], r[0], r[1]);
    let (rs, rs_mag) = minor2(r[0], r[1], s[0], s[1]);
    let (sp, sp_mag) = minor2(s[0], s[1], p[0], p[1]);
    let (pr, pr_mag) = minor2(p[0], p[1], r[0], r[1]);
    let (qs, qs_mag) = minor2(q[0], q[1], s[0], s[1]);
    let (pz, qz, rz, sz) = (p[2], q[2], r[2], s[2]);
    let pqr = pz * qr - qz * pr + rz * pq;
    let qrs = qz * rs - rz * qs + sz * qr;
    let rsp = rz * sp + sz * pr + pz * rs;
    let spq = sz * pq + pz * qs + qz * sp;
    let value = (hs * pqr - hr * spq) + (hq * rsp - hp * qrs);

    let [pz, qz, rz, sz] = [pz, qz, rz, sz].map(f64::abs);
    let pqr = pz * qr_mag + qz * pr_mag + rz * pq_mag + GUARD;
    let qrs = qz * rs_mag + rz * qs_mag + sz * qr_mag + GUARD;
    let rsp = rz * sp_mag + sz * pr_mag + pz * rs_mag + GUARD;
    let spq = sz * pq_mag + pz * qs_mag + qz * sp_mag + GUARD;
    let permanent =
        (hs + GUARD) * pqr + (hr + GUARD) * spq + (hq + GUARD) * rsp + (hp + GUARD) * qrs + GUARD;
    certain(value, IN_SPHERE * permanent).map(|sign| -sign) // see `determinant::lifted`
}
