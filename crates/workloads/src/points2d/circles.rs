//! Circles: rational and rounded, rational and exact, and a few ULPs off.

use super::Plane;
use crate::Rng;
use crate::num::{nudge, signed};

/// ((1 - t^2) / (1 + t^2), 2t / (1 + t^2)), rounded; t in [0, 1] is the first quarter.
pub(crate) fn quarter(t: f64) -> [f64; 2] {
    let d = 1.0 + t * t;
    [(1.0 - t * t) / d, 2.0 * t / d]
}

/// `p` after `turns` quarter turns.
pub(crate) fn turned<T: Copy + std::ops::Neg<Output = T>>([x, y]: [T; 2], turns: u64) -> [T; 2] {
    match turns % 4 {
        0 => [x, y],
        1 => [-y, x],
        2 => [-x, -y],
        _ => [y, -x],
    }
}

/// Random rational points of the unit circle, rounded.
pub(crate) fn circle(n: usize, rng: &mut Rng) -> Plane {
    (0..n).map(|_| turned(quarter(rng.unit()), rng.below(4))).collect()
}

/// The same, each coordinate off by up to two ULPs more.
pub(crate) fn near(n: usize, rng: &mut Rng) -> Plane {
    circle(n, rng).into_iter().map(|p| p.map(|x| nudge(x, rng.integer(-2, 2)))).collect()
}

/// Primes 1 mod 4 as a^2 + b^2. Their product, the largest radius below, is under 2^50: every coordinate is exact.
const SUMS: [[i64; 2]; 10] =
    [[1, 2], [2, 3], [1, 4], [2, 5], [1, 6], [4, 5], [2, 7], [5, 6], [3, 8], [5, 8]];

/// Exactly cocircular integers: `u * prod z_p`, each `z_p` one of `pi^2`, `pi pi'`, `pi'^2` for the Gaussian prime `pi`
/// over p, and `u` a unit. Unique factorization makes all 4 * 3^k distinct. At most 236,196 sites.
pub(crate) fn lattice(n: usize, rng: &mut Rng) -> Vec<[i64; 2]> {
    let mut points: Vec<[i64; 2]> = (0..4).map(|turns| turned([1, 0], turns)).collect();
    for [a, b] in SUMS {
        if points.len() >= n {
            break;
        }
        let square = [a * a - b * b, 2 * a * b];
        let factors = [square, [a * a + b * b, 0], [square[0], -square[1]]];
        points = points
            .iter()
            .flat_map(|&[x, y]| factors.map(|[u, v]| [x * u - y * v, x * v + y * u]))
            .collect();
    }
    rng.shuffle(&mut points);
    points.truncate(n);
    points
}

/// [`lattice`] as doubles.
pub(crate) fn exact(n: usize, rng: &mut Rng) -> Plane {
    lattice(n, rng).into_iter().map(|p| p.map(signed)).collect()
}
