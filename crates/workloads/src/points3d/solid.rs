//! Sets that fill a part of space, and its lattices.

use super::Space;
use crate::Rng;
use crate::num::{pow2, real, side};

/// Uniform in the unit cube.
pub(crate) fn uniform(n: usize, rng: &mut Rng) -> Space {
    (0..n).map(|_| [rng.unit(), rng.unit(), rng.unit()]).collect()
}

/// A standard normal cloud.
pub(crate) fn gauss(n: usize, rng: &mut Rng) -> Space {
    (0..n).map(|_| [rng.gauss(), rng.gauss(), rng.gauss()]).collect()
}

/// About n^(1/4) normal clouds of very different width.
pub(crate) fn clusters(n: usize, rng: &mut Rng) -> Space {
    let centres: Vec<([f64; 3], f64)> = (0..side(side(n)).max(1))
        .map(|_| ([rng.unit(), rng.unit(), rng.unit()], 0.1 * rng.unit() * rng.unit()))
        .collect();
    (0..n)
        .map(|_| {
            let (centre, width) = centres[rng.index(centres.len())];
            centre.map(|x| x + width * rng.gauss())
        })
        .collect()
}

/// The smallest `k` with `k^3 >= n`.
fn edge(n: usize) -> usize {
    (1..).find(|k| k * k * k >= n).unwrap_or(1)
}

fn cubic(n: usize) -> impl Iterator<Item = [f64; 3]> {
    let k = edge(n);
    (0..n).map(move |i| [real(i % k), real(i / k % k), real(i / (k * k))])
}

/// The first `n` points of the smallest cubic lattice that holds them, layer by layer.
pub(crate) fn grid(n: usize, _: &mut Rng) -> Space {
    cubic(n).collect()
}

/// (12, 12, 12), (24, 24, 24), then a cubic lattice of ULPs at (1/2, 1/2, 1/2).
pub(crate) fn ulps(n: usize, _: &mut Rng) -> Space {
    let far = [[12.0; 3], [24.0; 3]].into_iter();
    let near = cubic(n.saturating_sub(2)).map(|p| p.map(|x| 0.5 + x * pow2(-53)));
    far.chain(near).take(n).collect()
}

/// `n` draws, with replacement, of about n/4 sites.
pub(crate) fn duplicates(n: usize, rng: &mut Rng) -> Space {
    let distinct = uniform(n.div_ceil(4), rng);
    (0..n).map(|_| distinct[rng.index(distinct.len())]).collect()
}
