//! Circumcentres and off-centres: in doubles, which may move them a little; where doubles are too coarse for a triangle so small, in as many
//! bits as its shortest edge asks for.
//!
//! ```text
//!            c               Both are on the bisector of the shortest edge pq, s |pq| from its middle: the circumcentre with
//!            |               s = cot(r) / 2, r being the angle at the third corner, which is opposite pq and so the least; the
//!       x    |               off-centre with s = cot(a / 2) / 2, a being the least angle asked for, if that is less.
//!      / \   |
//!     p---q
//! ```

use delone_predicates::{Dyadic, Sign};

use super::Centre;
use crate::ratio::{log4, quotient, rounded};
use crate::vector::{Vector, between, cross, dot, square};

/// By how much an off-centre stays short of the place where the angle just keeps the bound: rounding must not undo it.
const SHORT: f64 = 0.95;

/// Bits of what is to the shortest edge, beyond which an exact centre is rounded.
const BITS: i64 = 40;

/// How far from the middle of the shortest edge, in terms of its length, half the cotangent of the least angle being that; `cotangent` is that of
/// half the least angle asked for.
fn distance(half_cotangent: f64, kind: Centre, cotangent: f64) -> f64 {
    match kind {
        Centre::Circumcentre => half_cotangent,
        Centre::OffCentre => half_cotangent.min(SHORT * 0.5 * cotangent),
    }
}

/// The centre of a triangle whose shortest edge is from `p` to `q`. `None` if doubles cannot say.
pub(super) fn centre([p, q, r]: [[f64; 2]; 3], kind: Centre, cotangent: f64) -> Option<[f64; 2]> {
    let from = |o: [f64; 2], p: [f64; 2]| [p[0] - o[0], p[1] - o[1]];
    let (u, a, b) = (from(p, q), from(r, p), from(r, q));
    let (along, across) = (a[0] * b[0] + a[1] * b[1], a[0] * b[1] - a[1] * b[0]);
    // Of a triangle so flat that rounding turns it over nothing is known but that the circumcentre is far.
    let half_cotangent = if across > 0.0 { 0.5 * along / across } else { f64::INFINITY };
    let s = distance(half_cotangent, kind, cotangent);
    let centre = [p[0] + (0.5 * u[0] - s * u[1]), p[1] + (0.5 * u[1] + s * u[0])];
    centre.iter().all(|x| x.is_finite()).then_some(centre)
}

/// The same, rounded to what is far less than the shortest edge.
pub(super) fn exact_centre(
    [p, q, r]: &[Vector; 3],
    kind: Centre,
    cotangent: f64,
) -> Option<Vector> {
    let (u, a, b) = (between(p, q), between(r, p), between(r, q));
    let (along, across) = (dot(&a, &b), cross(&a, &b));
    if [&along, &across].iter().any(|x| x.sign() != Sign::Positive) {
        return None; // no triangle whose shortest edge is pq
    }
    let s = distance(0.5 * quotient(&along, &across, 53).to_f64(), kind, cotangent);
    if !s.is_finite() {
        return None;
    }
    let (s, unit) = (Dyadic::from(s), log4(&square(&u)) - BITS);
    let [x, y] = u;
    let off = [x.clone().half() - &s * &y, y.half() + &s * &x];
    let [x, y] = off;
    Some([rounded(&(x + &p[0]), unit), rounded(&(y + &p[1]), unit)])
}

#[cfg(test)]
mod tests;
