//! The ends of the double range, and both ends at once.

use super::Plane;
use super::scatter::uniform;
use crate::Rng;
use crate::num::{count, nudge, pow2};

/// A finite double with random bits: every exponent is as likely as any other.
pub(crate) fn any_double(rng: &mut Rng) -> f64 {
    loop {
        let x = f64::from_bits(rng.next_u64());
        if x.is_finite() {
            return x;
        }
    }
}

/// Random bits: exponents from -1074 to 1023 side by side.
pub(crate) fn full(n: usize, rng: &mut Rng) -> Plane {
    (0..n).map(|_| [any_double(rng), any_double(rng)]).collect()
}

/// Multiples of 2^-1074 up to 2^-1054, both signs.
pub(crate) fn denormals(n: usize, rng: &mut Rng) -> Plane {
    let one = |rng: &mut Rng| {
        let x = f64::from_bits(rng.below(1 << 20));
        if rng.coin() { x } else { -x }
    };
    (0..n).map(|_| [one(rng), one(rng)]).collect()
}

/// Within 16 ULPs of the largest double, in all four corners of the plane: differences overflow.
pub(crate) fn largest(n: usize, rng: &mut Rng) -> Plane {
    let one = |rng: &mut Rng| {
        let x = nudge(f64::MAX, -rng.integer(0, 16));
        if rng.coin() { x } else { -x }
    };
    (0..n).map(|_| [one(rng), one(rng)]).collect()
}

fn scaled(n: usize, rng: &mut Rng, by: f64) -> Plane {
    uniform(n, rng).into_iter().map(|p| p.map(|x| x * by)).collect()
}

/// The unit square times 2^-900, exact: products of two coordinates vanish.
pub(crate) fn tiny(n: usize, rng: &mut Rng) -> Plane {
    scaled(n, rng, pow2(-900))
}

/// The unit square times 2^900, exact: products of two coordinates overflow.
pub(crate) fn huge(n: usize, rng: &mut Rng) -> Plane {
    scaled(n, rng, pow2(900))
}

/// Around (1e15, 1e15) on the lattice of ULPs there (1/8), a window 2^20 ULPs wide.
pub(crate) fn far(n: usize, rng: &mut Rng) -> Plane {
    let one = |rng: &mut Rng| 1e15 + 0.125 * crate::num::real(count(rng.below(1 << 20)));
    (0..n).map(|_| [one(rng), one(rng)]).collect()
}

/// Half in a square of side 1 around the origin, half in one of side 1e-15.
pub(crate) fn two_scales(n: usize, rng: &mut Rng) -> Plane {
    (0..n)
        .map(|i| {
            let p = [rng.unit(), rng.unit()];
            // The cluster sits at the origin: elsewhere doubles are too coarse for it.
            if i % 2 == 0 { p.map(|x| x - 0.5) } else { p.map(|x| (x - 0.5) * 1e-15) }
        })
        .collect()
}
