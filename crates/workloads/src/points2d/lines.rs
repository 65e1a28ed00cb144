//! Collinear, almost collinear, and thin.

use super::Plane;
use crate::Rng;
use crate::num::{nudge, pow2, real};

/// On y = 1, at integers.
pub(crate) fn horizontal(n: usize, _: &mut Rng) -> Plane {
    (0..n).map(|i| [real(i), 1.0]).collect()
}

/// On x = 1, at integers.
pub(crate) fn vertical(n: usize, _: &mut Rng) -> Plane {
    (0..n).map(|i| [1.0, real(i)]).collect()
}

/// On y = 3x, at integers: exactly collinear on a slope.
pub(crate) fn diagonal(n: usize, _: &mut Rng) -> Plane {
    (0..n).map(|i| [real(i), 3.0 * real(i)]).collect()
}

/// y = x/3 + 1/10 rounded: collinear on paper, a zigzag of half-ULPs in truth.
pub(crate) fn inexact(n: usize, rng: &mut Rng) -> Plane {
    (0..n)
        .map(|_| {
            let x = rng.unit();
            [x, x / 3.0 + 0.1]
        })
        .collect()
}

/// The diagonal y = x of the unit square, y off by up to two ULPs.
pub(crate) fn near(n: usize, rng: &mut Rng) -> Plane {
    (0..n)
        .map(|_| {
            let x = 0.5 + 0.5 * rng.unit();
            [x, nudge(x, rng.integer(-2, 2))]
        })
        .collect()
}

/// Integers on y = 0 and on y = 1: every square between is cocircular.
pub(crate) fn parallel(n: usize, _: &mut Rng) -> Plane {
    (0..n).map(|i| [real(i / 2), real(i % 2)]).collect()
}

/// All on y = 0 but the last, one ULP of 1 above it.
pub(crate) fn one_off(n: usize, _: &mut Rng) -> Plane {
    let mut points: Plane = (0..n).map(|i| [real(i), 0.0]).collect();
    if let Some(last) = points.last_mut() {
        *last = [real(n / 2), pow2(-52)];
    }
    points
}

/// A strip of width 1 and height 1e-300: a determinant in doubles underflows to zero on all of it.
pub(crate) fn thin_strip(n: usize, rng: &mut Rng) -> Plane {
    (0..n).map(|_| [rng.unit(), 1e-300 * rng.unit()]).collect()
}

/// Convex position with integer coordinates: (i, i^2), i centred on 0. Exact while n < 2^27.
pub(crate) fn parabola(n: usize, _: &mut Rng) -> Plane {
    (0..n)
        .map(|i| {
            let x = real(i) - real(n / 2);
            [x, x * x]
        })
        .collect()
}
