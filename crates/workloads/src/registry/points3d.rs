//! Point sets of space.

use super::{Workload, space};
use crate::points3d::{flat, range, solid, spheres};

pub(super) const ROWS: [Workload; 18] = [
    space("uniform-3d", solid::uniform, "uniform in the unit cube"),
    space("gauss-3d", solid::gauss, "a standard normal cloud"),
    space("clusters-3d", solid::clusters, "about n^(1/4) normal clouds of very different width"),
    space(
        "grid-3d",
        solid::grid,
        "the cubic integer lattice, layer by layer, side = ceil(cbrt(n))",
    ),
    space(
        "ulp-grid-3d",
        solid::ulps,
        "two far sites on the diagonal and a lattice of ULPs at (1/2, 1/2, 1/2)",
    ),
    space("duplicates-3d", solid::duplicates, "n draws with replacement of about n/4 sites"),
    space("sphere", spheres::sphere, "rational points of the unit sphere, rounded"),
    space(
        "cospherical",
        spheres::cospherical,
        "exactly cospherical integers, by quaternions of prime norm",
    ),
    space(
        "cube-surface",
        flat::cube_surface,
        "uniform on the surface of a cube: six coplanar sets",
    ),
    space("coplanar", flat::coplanar, "an integer lattice in the plane z = 1"),
    space("coplanar-tilted", flat::coplanar_tilted, "an integer lattice in the plane z = 2x + 3y"),
    space("near-coplanar", flat::near_coplanar, "z = x/3 + y/7 rounded: coplanar on paper only"),
    space("collinear-3d", flat::collinear, "integers on the line (i, 2i, 3i)"),
    space("skew-lines", flat::skew_lines, "two skew lines: n^2/4 Delaunay tetrahedra"),
    space(
        "moment-curve",
        flat::moment_curve,
        "(t, t^2, t^3): about n^2/2 Delaunay tetrahedra; exact up to n = 208,064",
    ),
    space("full-range-3d", range::full, "random bits in every coordinate"),
    space("scaled-tiny-3d", range::tiny, "the unit cube times 2^-900, exact"),
    space("scaled-huge-3d", range::huge, "the unit cube times 2^900, exact"),
];
