//! General position, more or less: what benchmarks of other libraries stop at.

use super::Plane;
use crate::Rng;
use crate::num::{real, side};

/// Uniform in the unit square.
pub(crate) fn uniform(n: usize, rng: &mut Rng) -> Plane {
    (0..n).map(|_| [rng.unit(), rng.unit()]).collect()
}

/// A standard normal cloud.
pub(crate) fn gauss(n: usize, rng: &mut Rng) -> Plane {
    (0..n).map(|_| [rng.gauss(), rng.gauss()]).collect()
}

/// About n^(1/4) normal clouds of very different width.
pub(crate) fn clusters(n: usize, rng: &mut Rng) -> Plane {
    let centres: Vec<[f64; 3]> = (0..side(side(n)).max(1))
        .map(|_| [rng.unit(), rng.unit(), 0.1 * rng.unit() * rng.unit() * rng.unit()])
        .collect();
    (0..n)
        .map(|_| {
            let [x, y, width] = centres[rng.index(centres.len())];
            [x + width * rng.gauss(), y + width * rng.gauss()]
        })
        .collect()
}

/// Kuzmin's disk, the flat galaxy: density falls as r^-3, so the centre is dense and the rim far away.
pub(crate) fn kuzmin(n: usize, rng: &mut Rng) -> Plane {
    (0..n)
        .map(|_| {
            let outside = 1.0 - rng.unit(); // in (0, 1]: the part of the mass beyond r
            let r = (1.0 / (outside * outside) - 1.0).sqrt();
            let [x, y] = rng.direction();
            [r * x, r * y]
        })
        .collect()
}

/// An Archimedean spiral of about sqrt(n) turns: each turn is almost parallel to the next.
pub(crate) fn spiral(n: usize, _: &mut Rng) -> Plane {
    let [mut x, mut y] = [1.0_f64, 0.0_f64];
    let t = 3.0 / real(side(n).max(1)); // half of an angle of about 2 pi / side, as a tangent
    let (cos, sin) = ((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t));
    (0..n)
        .map(|i| {
            let here = [real(i) * x, real(i) * y];
            let [u, v] = [x * cos - y * sin, x * sin + y * cos];
            let norm = (u * u + v * v).sqrt();
            [x, y] = [u / norm, v / norm];
            here
        })
        .collect()
}
