//! Equal sites, and sites that a tolerance would call equal.

use super::Plane;
use crate::Rng;
use crate::num::nudge;

/// `n` draws, with replacement, of about n/4 sites.
pub(crate) fn duplicates(n: usize, rng: &mut Rng) -> Plane {
    let distinct = super::scatter::uniform(n.div_ceil(4), rng);
    (0..n).map(|_| distinct[rng.index(distinct.len())]).collect()
}

/// Groups of four within three ULPs of each other; some are equal.
pub(crate) fn near(n: usize, rng: &mut Rng) -> Plane {
    let centres = super::scatter::uniform(n.div_ceil(4), rng);
    (0..n).map(|i| centres[i / 4].map(|x| nudge(x, rng.integer(-3, 3)))).collect()
}

/// The same site `n` times.
pub(crate) fn all_equal(n: usize, _: &mut Rng) -> Plane {
    vec![[0.1, 0.2]; n]
}
