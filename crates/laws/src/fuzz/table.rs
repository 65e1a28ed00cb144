//! The table of targets.

use std::sync::Arc;

use super::extra;
use super::target::{CANARY, Kind, Target};
use crate::generate;
use crate::laws::{Law, constrained_laws, delaunay_laws, octree_laws, quadtree_laws};

/// All targets; the last is the canary, which must fail.
#[must_use]
pub fn targets() -> Vec<Target> {
    let mut all = of_points();
    all.extend(of_graphs());
    all.push(row(
        "readers",
        "files of all formats, damaged: read or refused, and sound",
        Kind::File(extra::file, extra::OF_READERS),
    ));
    all.push(row(CANARY, "must fail: that doubles are enough", plane(extra::canary())));
    all
}

fn row(name: &'static str, about: &'static str, kind: Kind) -> Target {
    Target { name, about, kind, corpus: Arc::default() }
}

fn plane(laws: Vec<Law<2>>) -> Kind {
    Kind::Plane(generate::points, laws)
}

fn space(laws: Vec<Law<3>>) -> Kind {
    Kind::Space(generate::points, laws)
}

/// One of some laws, alone: quicker, so that more cases are tried.
fn only<const D: usize>(name: &str, mut laws: Vec<Law<D>>) -> Vec<Law<D>> {
    laws.retain(|law| law.name == name);
    laws
}

fn of_points() -> Vec<Target> {
    let all = "every law of point sets";
    let signs = "signs beside those of numbers of any length";
    let alpha = "alpha values by definition, homology by two ways";
    let queries = "location, nearest sites, Voronoi's diagram, by trying everything";
    let regular = "regular triangulations: \"weights\", alone";
    let dynamic = "sites that go and come: \"removal\", alone";
    vec![
        row("delaunay-2d", all, plane(delaunay_laws())),
        row("delaunay-3d", all, space(delaunay_laws())),
        row("regular-2d", regular, plane(only("weights", delaunay_laws()))),
        row("regular-3d", regular, space(only("weights", delaunay_laws()))),
        row("dynamic-2d", dynamic, plane(only("removal", delaunay_laws()))),
        row("dynamic-3d", dynamic, space(only("removal", delaunay_laws()))),
        row("queries-2d", queries, plane(extra::of_plane_queries())),
        row("queries-3d", queries, space(extra::of_queries())),
        row("alpha-2d", alpha, plane(extra::of_alpha())),
        row("alpha-3d", alpha, space(extra::of_alpha())),
        row("predicates-2d", signs, plane(extra::of_predicates())),
        row("predicates-3d", signs, space(extra::of_predicates())),
        row("trees-3d", "every law of octrees, of tetrahedra", space(octree_laws())),
    ]
}

fn of_graphs() -> Vec<Target> {
    let graph = |laws| Kind::Plane(generate::graph, laws);
    let crossing = |laws| Kind::Plane(generate::crossing, laws);
    vec![
        row("cdt", "every law of graphs whose segments do not cross", graph(constrained_laws())),
        row(
            "agreement",
            "one triangulation by all CDT algorithms, judged: a law of \"cdt\", alone and quicker",
            graph(extra::of_agreement()),
        ),
        row(
            "dynamic-cdt",
            "vertices and segments that go and come: \"change\", alone",
            graph(only("change", constrained_laws())),
        ),
        row("conforming", "Steiner points by every method, judged", graph(extra::of_conforming())),
        row("refinement", "quality refinement, judged", graph(extra::of_refinement())),
        row(
            "crossings",
            "segments that cross, every crossing a vertex",
            crossing(extra::of_crossings()),
        ),
        row(
            "trees-2d",
            "every law of quadtrees, of what is inside a walk through segments",
            crossing(quadtree_laws()),
        ),
        row("files", "what is written is read again, bit for bit", crossing(extra::of_files())),
    ]
}

/// The target of this name.
#[must_use]
pub fn target(name: &str) -> Option<Target> {
    targets().into_iter().find(|target| target.name == name)
}
