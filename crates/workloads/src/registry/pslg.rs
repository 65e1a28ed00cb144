//! Planar straight-line graphs.

use super::{Meets, Workload, graph};
use crate::pslg::{circles, coast, crossing, curves, lattices, long, polygons, scatter, touching};

pub(super) const ROWS: [Workload; 26] = [
    graph("random-segments", scatter::sparse, "a random short segment in each cell of a grid"),
    graph(
        "dense-segments",
        scatter::dense,
        "a jittered lattice with seven in ten of its edges and diagonals",
    ),
    graph("slits", scatter::slits, "a rectangle with staggered horizontal slits")
        .rounding("n rounded down to an even number; below 4, isolated sites"),
    graph("comb", polygons::comb, "one polygon with needles a thousand times as long as wide"),
    graph("fan", polygons::fan, "segments from one site to all others: the highest degree"),
    graph("spiral-polygon", polygons::spiral, "a wound corridor as one polygon, integers")
        .rounding("n rounded down to an even number; below 8, isolated sites"),
    graph("star-polygon", polygons::star, "a star-shaped polygon with random radii"),
    graph("nested-polygons", polygons::nested, "concentric dodecagons, each exactly cocircular"),
    graph(
        "coast",
        coast::coast,
        "a fractal continent with islands, lakes and islands in the lakes, in a frame",
    ),
    graph("coast-tiny", coast::tiny, "a coast times 2^-900, exact"),
    graph("coast-huge", coast::huge, "a coast times 2^900, exact"),
    graph("streets", polygons::streets, "city blocks between streets, one in five missing")
        .rounding("n rounded down to a multiple of 4; below 4, isolated sites"),
    graph("hilbert", curves::hilbert, "the Hilbert curve, the last turn cut off at n"),
    graph("koch", curves::koch, "Koch's snowflake on a lattice, exact")
        .rounding("n rounded down to a multiple of 3; below 3, isolated sites"),
    graph("rails", long::rails, "long near-horizontal segments with sites strewn between"),
    graph(
        "ladder",
        long::ladder,
        "parallel slanted rungs, each crossing a constant part of the Delaunay edges: n^2 steps one by one",
    ),
    graph("ulp-slopes", long::ulp_slopes, "vertical segments four ULPs apart, leaning by one"),
    graph(
        "triangulated-grid",
        lattices::triangulated,
        "the integer lattice with all edges of a triangulation: a maximal PSLG",
    ),
    graph("cocircular-chords", circles::chords, "an exactly cocircular polygon with random chords")
        .rounding("n, at most 236,196"),
    graph(
        "touching-polygons",
        touching::diamonds,
        "diamonds that share corners: boundaries touch themselves at sites",
    )
    .rounding("2k(k+1) for the largest k that fits; below 4, isolated sites"),
    graph(
        "t-junctions",
        touching::t_junctions,
        "ties that end inside rails: sites inside segments",
    )
    .rounding("n rounded down to an even number")
    .meeting(Meets::InsideOne),
    graph(
        "overlaps",
        touching::overlaps,
        "segments along lattice rows: overlapping, nested, repeated",
    )
    .meeting(Meets::Along),
    graph("crossing-soup", crossing::soup, "random segments across the unit square")
        .rounding("n rounded down to an even number")
        .meeting(Meets::Crossing),
    graph("crossing-short", crossing::short, "segments about as long as their distance")
        .rounding("n rounded down to an even number")
        .meeting(Meets::Crossing),
    graph("crossing-grid", crossing::grid, "horizontals and verticals, integers")
        .rounding("n rounded down to an even number")
        .meeting(Meets::Crossing),
    graph("crossing-star", crossing::star, "all through one point that is no site, integers")
        .rounding("n rounded down to an even number")
        .meeting(Meets::Crossing),
];
