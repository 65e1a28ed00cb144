use delone_check::Promise;
use delone_sites::Pslg;

use super::*;
use crate::testing::{judged, pslg};
use crate::{ConformOptions, Conforming, Encroached, Limits, Missing, conform};

fn gabriel(graph: &Pslg, copies_radii: bool, vertices_max: usize) -> Conforming {
    let placement = Placement { copies_radii, ..Placement::default() };
    let options = ConformOptions { placement, limits: Limits { vertices_max } };
    conform(graph, &Encroached, &options, &mut ())
}

fn fan(tips: impl Iterator<Item = [f64; 2]>) -> Pslg {
    let points: Vec<[f64; 2]> = std::iter::once([0.0, 0.0]).chain(tips).collect();
    let segments: Vec<[usize; 2]> = (1..points.len()).map(|tip| [0, tip]).collect();
    pslg(&points, &segments)
}

fn judged_both(graph: &Pslg) -> [usize; 2] {
    let options = ConformOptions::default();
    let results = [
        (conform(graph, &Missing, &options, &mut ()), Promise::Conforming),
        (conform(graph, &Encroached, &options, &mut ()), Promise::EmptyDisks),
    ];
    results.map(|(conforming, promise)| {
        let verdict = judged(graph, &conforming, promise);
        assert!(conforming.is_complete() && verdict.ok, "{verdict}");
        println!("steiner {}", conforming.steiner_points().len());
        conforming.steiner_points().len()
    })
}

/// Five segments of different lengths, 1e-6 apart and less.
#[test]
fn fans_of_the_specification() {
    let tips = (1..=5u32).map(f64::from);
    let graph = fan(tips.clone().map(|i| [1e6 * i, 7.0 * i * i]));
    let with = gabriel(&graph, true, usize::MAX);
    println!("pieces {}", with.constrained_edges().len());
    let verdict = judged(&graph, &with, Promise::EmptyDisks);
    assert!(with.is_complete() && verdict.ok, "{verdict}");
    let without = gabriel(&graph, false, 1500);
    println!("pieces {} {}", without.constrained_edges().len(), without.is_complete());
    judged_both(&fan(tips.map(|i| [1e6, i])));
    judged_both(&fan((0..2u32).map(|i| [1e8, f64::from(i)])));
    judged_both(&fan((0..2u32).map(|i| [1e16, f64::from(i)])));
    judged_both(&fan((0..3u32).map(|i| [1e16 + 5e15 * f64::from(i), 1.0 + f64::from(i)])));
}

#[test]
fn slivers_terminate() {
    judged_both(&pslg(&[[0.0, 0.0], [1e6, 1.0], [1e6, 0.0]], &[[0, 1], [1, 2], [2, 0]]));
    let zigzag = [[0.0, 0.0], [1000.0, 1.0], [0.0, 2.0], [1000.0, 3.0], [0.0, 4.0]];
    judged_both(&pslg(&zigzag, &[[0, 1], [1, 2], [2, 3], [3, 4]]));
}
