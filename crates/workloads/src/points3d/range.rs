//! The ends of the double range in space.

use super::Space;
use crate::Rng;
use crate::num::pow2;
use crate::points2d::range::any_double;

/// Random bits in every coordinate.
pub(crate) fn full(n: usize, rng: &mut Rng) -> Space {
    (0..n).map(|_| [any_double(rng), any_double(rng), any_double(rng)]).collect()
}

/// The unit cube times 2^-900, exact.
pub(crate) fn tiny(n: usize, rng: &mut Rng) -> Space {
    super::solid::uniform(n, rng).into_iter().map(|p| p.map(|x| x * pow2(-900))).collect()
}

/// The unit cube times 2^900, exact.
pub(crate) fn huge(n: usize, rng: &mut Rng) -> Space {
    super::solid::uniform(n, rng).into_iter().map(|p| p.map(|x| x * pow2(900))).collect()
}
