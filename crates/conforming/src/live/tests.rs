use delone_cdt::cavity;
use delone_check::Promise;

use super::*;
use crate::Conforming;
use crate::testing::{judged, pslg};

fn live(graph: &Pslg) -> Live {
    Live::new(&cavity(graph, &delone_delaunay::Options::default(), &mut ()), graph)
}

/// Splits random pieces at random places, and has the result judged.
fn split_at_random(graph: &Pslg, splits: usize, seed: u64) {
    let mut live = live(graph);
    let mut random = delone_workloads::Rng::new(seed);
    for _ in 0..splits {
        let pick = random.below(live.pieces.len() as u64);
        let piece = u32::try_from(pick).unwrap();
        let [t0, t1] = live.parameters(piece);
        let [t0, t1] = [t0, t1].map(|t| t.exact());
        let mut t = (t0 + &t1).half();
        for _ in 0..random.below(4) {
            t = (t + &t1).half();
        }
        live.split_piece(piece, t.into(), &mut ());
        for (piece, &Piece { half, ends, .. }) in (0u32..).zip(&live.pieces) {
            assert_eq!(live.piece_of(half), Some(piece), "Inv 3");
            assert_eq!(live.piece_of(live.mesh.twin(half)), Some(piece), "Inv 3");
            let h = live.half_edge(piece);
            assert_eq!([live.mesh.origin(h), live.mesh.destination(h)], ends, "Inv 3");
        }
    }
    let conforming = Conforming::new(live, true);
    let verdict = judged(graph, &conforming, Promise::Constrained);
    assert!(verdict.ok, "{verdict}");
}

#[test]
fn a_triangle_of_segments_is_split_on_the_hull() {
    let graph = pslg(&[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]], &[[0, 1], [1, 2], [2, 0]]);
    (0..20).for_each(|seed| split_at_random(&graph, 12, seed));
}

#[test]
fn points_on_a_grid_keep_the_cdt() {
    let points: Vec<[f64; 2]> = (0..16u8).map(|i| [i % 4, i / 4].map(f64::from)).collect();
    let rows = [0, 4, 8].map(|row| [row, row + 3]);
    let slanted = [[1, 11], [4, 13], [0, 9]];
    let graph = pslg(&points, &rows);
    (0..20).for_each(|seed| split_at_random(&graph, 20, seed));
    let graph = pslg(&points, &slanted[1..2]);
    (0..20).for_each(|seed| split_at_random(&graph, 20, seed));
}

#[test]
fn thirds_are_exact() {
    let graph = pslg(&[[0.1, 0.1], [0.4, 0.3], [0.2, 0.9], [0.7, 0.0]], &[[0, 1]]);
    let mut live = live(&graph);
    let p = live.split_piece(0, Parameter::Double(1.0 / 3.0), &mut ());
    let ends = live.segments[0].map(|v| v as usize);
    assert_eq!(live.kernel.orient(&[ends[0], p.index(), ends[1]]), delone_predicates::Sign::Zero);
    assert!(!live.kernel.is_exact_position(id(p)));
    let verdict = judged(&graph, &Conforming::new(live, true), Promise::Constrained);
    assert!(verdict.ok, "{verdict}");
}
