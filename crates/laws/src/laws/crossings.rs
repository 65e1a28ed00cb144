//! The law of segments that cross, every crossing a vertex.

use delone::cdt::{algorithms, cdt_of_arrangement};
use delone::check::{Arranged, Level, Options, judge_arranged};
use delone::sites::{Arrangement, Noded};

use crate::case::Case;
use crate::id;
use crate::judge::solid_cells;

/// Every algorithm under the constructed kernel gives one triangulation, which the judge proves in ratios of its own; how many
/// crossings became vertices, and one.
#[must_use]
pub fn crossings(case: &Case<2>) -> usize {
    let segments: Vec<[usize; 2]> =
        case.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
    let graph = Arrangement::new(&case.points, &segments).expect("points are finite");
    let first = cdt_of_arrangement(&graph, &mut ());
    let count = graph.positions().len();
    for algorithm in algorithms().iter().filter(|algorithm| count <= algorithm.sites_max) {
        let other = (algorithm.run_crossed)(&graph, &mut ());
        assert_eq!(other.canonical(), first.canonical(), "{}: {}", case.name, algorithm.name);
        assert_eq!(other.constrained_edges(), graph.subsegments(), "{}", algorithm.name);
    }
    if first.mesh().dimension() == Some(2) {
        let vertices: Vec<u32> = (0..id(count)).collect();
        let arranged = Arranged {
            points: graph.sites().points(),
            crossings: graph.crossings(),
            cells: &solid_cells(first.mesh(), &vertices),
            segments: graph.segments(),
            constrained: &first.constrained_edges(),
        };
        let verdict = judge_arranged(&arranged, &Options::default());
        assert!(verdict.ok && verdict.level == Level::Constrained, "{}: {verdict}", case.name);
    }
    1 + count - graph.sites().len()
}
