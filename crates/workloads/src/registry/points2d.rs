//! Point sets of the plane.

use super::{Workload, plane};
use crate::points2d::{circles, lattices, lines, range, repeats, scatter, worst};

pub(super) const ROWS: [Workload; 39] = [
    plane("uniform", scatter::uniform, "uniform in the unit square"),
    plane("gauss", scatter::gauss, "a standard normal cloud"),
    plane("clusters", scatter::clusters, "about n^(1/4) normal clouds of very different width"),
    plane("kuzmin", scatter::kuzmin, "Kuzmin's galactic disk: dense centre, distant rim"),
    plane("spiral", scatter::spiral, "an Archimedean spiral of about sqrt(n) turns"),
    plane("line-horizontal", lines::horizontal, "collinear: integers on y = 1"),
    plane("line-vertical", lines::vertical, "collinear: integers on x = 1; every x equal"),
    plane("line-diagonal", lines::diagonal, "collinear: integers on y = 3x"),
    plane("line-inexact", lines::inexact, "y = x/3 + 1/10 rounded: collinear on paper only"),
    plane("near-collinear", lines::near, "the diagonal y = x, off by up to two ULPs"),
    plane(
        "parallel-lines",
        lines::parallel,
        "integers on y = 0 and y = 1: a ladder of cocircular squares",
    ),
    plane(
        "one-off-line",
        lines::one_off,
        "all on a line but the last, which is one ULP of 1 off it",
    ),
    plane("thin-strip", lines::thin_strip, "width 1, height 1e-300: determinants underflow"),
    plane("parabola", lines::parabola, "convex position: (i, i^2), exact up to n = 2^27"),
    plane("grid", lattices::grid, "the integer lattice, row by row, side = ceil(sqrt(n))"),
    plane(
        "hexagonal",
        lattices::hexagonal,
        "the triangular lattice rounded: near-cocircular everywhere",
    ),
    plane(
        "grid-tilted-exact",
        lattices::tilted_exact,
        "the lattice of (3, 4) and (-4, 3): tilted, exactly cocircular",
    ),
    plane(
        "grid-tilted",
        lattices::tilted,
        "the lattice turned by (3/5, 4/5), each coordinate rounded",
    ),
    plane(
        "grid-tilted-slightly",
        lattices::tilted_slightly,
        "the lattice turned by a tenth of a degree, rounded",
    ),
    plane(
        "ulp-grid",
        lattices::ulps,
        "Kettner et al.: (12, 12), (24, 24) and a lattice of ULPs at (1/2, 1/2)",
    ),
    plane(
        "few-columns",
        lattices::few_columns,
        "about sqrt(n) distinct x, copied: sorting must break ties by y",
    ),
    plane("circle", circles::circle, "rational points of the unit circle, rounded"),
    plane("circle-exact", circles::exact, "exactly cocircular integers")
        .rounding("n, at most 236,196"),
    plane("near-cocircular", circles::near, "the unit circle, coordinates off by up to two ULPs"),
    plane("full-range", range::full, "random bits: exponents from -1074 to 1023 side by side"),
    plane("denormals", range::denormals, "multiples of 2^-1074: every product vanishes"),
    plane(
        "largest",
        range::largest,
        "within 16 ULPs of the largest double in four corners: differences overflow; with repeats",
    ),
    plane("scaled-tiny", range::tiny, "the unit square times 2^-900, exact"),
    plane("scaled-huge", range::huge, "the unit square times 2^900, exact"),
    plane("far-cluster", range::far, "around (1e15, 1e15) on the lattice of ULPs there"),
    plane(
        "two-scales",
        range::two_scales,
        "half in a unit square, half in a cluster of width 1e-15 at its centre",
    ),
    plane("duplicates", repeats::duplicates, "n draws with replacement of about n/4 sites"),
    plane("near-duplicates", repeats::near, "groups of four within three ULPs; some are equal"),
    plane("all-equal", repeats::all_equal, "the same site n times"),
    plane(
        "falling-sites",
        worst::falling,
        "a row, then sites falling towards it: in this order each insertion digs all triangles, n^2 in all",
    ),
    plane(
        "shuttle",
        worst::shuttle,
        "a strip, then sites at its two ends by turns: in this order each walk crosses it, n^2 steps in all",
    ),
    plane(
        "shuffled-column",
        worst::column,
        "high and narrow, x in random order: merges of halves left and right zip from end to end",
    ),
    plane(
        "beach",
        worst::beach,
        "a row, then sites above it: a sweep has n/2 arcs on its beach line",
    ),
    plane("wheel", worst::wheel, "a hub among cocircular sites: a vertex of degree n - 1")
        .rounding("n, at most 236,197"),
];
