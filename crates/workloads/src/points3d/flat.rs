//! Sets of lower dimension, and lines whose Delaunay tetrahedra are quadratic in number.

use super::Space;
use crate::Rng;
use crate::num::real;
use crate::points2d::lattices::square;

/// An integer lattice in the plane z = 1.
pub(crate) fn coplanar(n: usize, _: &mut Rng) -> Space {
    square(n).map(|[x, y]| [x, y, 1.0]).collect()
}

/// An integer lattice in the plane z = 2x + 3y: exactly coplanar, on a slope.
pub(crate) fn coplanar_tilted(n: usize, _: &mut Rng) -> Space {
    square(n).map(|[x, y]| [x, y, 2.0 * x + 3.0 * y]).collect()
}

/// z = x/3 + y/7 rounded: coplanar on paper only.
pub(crate) fn near_coplanar(n: usize, rng: &mut Rng) -> Space {
    (0..n)
        .map(|_| {
            let [x, y] = [rng.unit(), rng.unit()];
            [x, y, x / 3.0 + y / 7.0]
        })
        .collect()
}

/// On the line (i, 2i, 3i).
pub(crate) fn collinear(n: usize, _: &mut Rng) -> Space {
    (0..n).map(|i| [real(i), 2.0 * real(i), 3.0 * real(i)]).collect()
}

/// Half on the x-axis, half on the line x = 0, z = 1: each pair of neighbours on one line makes a
/// Delaunay tetrahedron with each pair on the other, n^2/4 in all.
pub(crate) fn skew_lines(n: usize, _: &mut Rng) -> Space {
    (0..n)
        .map(|i| {
            let t = real(i / 2);
            if i % 2 == 0 { [t, 0.0, 0.0] } else { [0.0, t, 1.0] }
        })
        .collect()
}

/// The moment curve (t, t^2, t^3), t = 0, 1, ..: every two sites are Delaunay neighbours. Exact for n up to 208,064.
pub(crate) fn moment_curve(n: usize, _: &mut Rng) -> Space {
    (0..n).map(|i| [real(i), real(i) * real(i), real(i) * real(i) * real(i)]).collect()
}

/// Uniform on the surface of the unit cube: six coplanar sets.
pub(crate) fn cube_surface(n: usize, rng: &mut Rng) -> Space {
    (0..n)
        .map(|_| {
            let [u, v, side] = [rng.unit(), rng.unit(), if rng.coin() { 1.0 } else { 0.0 }];
            match rng.below(3) {
                0 => [side, u, v],
                1 => [u, side, v],
                _ => [u, v, side],
            }
        })
        .collect()
}
