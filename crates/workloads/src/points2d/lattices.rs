//! Lattices: every square is cocircular, every row collinear.

use super::Plane;
use crate::Rng;
use crate::num::{pow2, real, side};

/// The first `n` cells of the smallest square lattice that holds them, row by row.
pub(crate) fn square(n: usize) -> impl Iterator<Item = [f64; 2]> {
    let k = side(n).max(1);
    (0..n).map(move |i| [real(i % k), real(i / k)])
}

/// The integer lattice.
pub(crate) fn grid(n: usize, _: &mut Rng) -> Plane {
    square(n).collect()
}

/// Rows of the triangular lattice, their distance sqrt(3)/2 rounded: near-cocircular hexagons everywhere.
pub(crate) fn hexagonal(n: usize, _: &mut Rng) -> Plane {
    let rise = 3.0_f64.sqrt() / 2.0;
    square(n).map(|[x, y]| [x + 0.5 * (y % 2.0), y * rise]).collect()
}

/// The lattice of (3, 4) and (-4, 3): tilted, and exact.
pub(crate) fn tilted_exact(n: usize, _: &mut Rng) -> Plane {
    square(n).map(|[x, y]| [3.0 * x - 4.0 * y, 4.0 * x + 3.0 * y]).collect()
}

/// The same scaled by 1/5: each coordinate rounded, each cocircularity broken or kept by chance.
pub(crate) fn tilted(n: usize, _: &mut Rng) -> Plane {
    square(n).map(|[x, y]| [(3.0 * x - 4.0 * y) / 5.0, (4.0 * x + 3.0 * y) / 5.0]).collect()
}

/// The lattice turned by about a tenth of a degree (half-angle tangent 1/1146).
pub(crate) fn tilted_slightly(n: usize, _: &mut Rng) -> Plane {
    let t = 1.0 / 1146.0;
    let (cos, sin) = ((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t));
    square(n).map(|[x, y]| [cos * x - sin * y, sin * x + cos * y]).collect()
}

/// The set of Kettner, Mehlhorn, Pion, Schirra and Yap (2008): (12, 12), (24, 24), then a lattice of ULPs at (1/2, 1/2),
/// where a naive orientation against the first two is wrong in a pattern.
pub(crate) fn ulps(n: usize, _: &mut Rng) -> Plane {
    let far = [[12.0, 12.0], [24.0, 24.0]].into_iter();
    let near = square(n.saturating_sub(2)).map(|p| p.map(|x| 0.5 + x * pow2(-53)));
    far.chain(near).take(n).collect()
}

/// About sqrt(n) distinct x shared by all: columns of sites, as in tables.
pub(crate) fn few_columns(n: usize, rng: &mut Rng) -> Plane {
    let columns: Vec<f64> = (0..side(n)).map(|_| rng.unit()).collect();
    (0..n).map(|_| [columns[rng.index(columns.len())], rng.unit()]).collect()
}
