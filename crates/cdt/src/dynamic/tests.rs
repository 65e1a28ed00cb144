use delone_delaunay::Options;
use delone_predicates::Adaptive;
use delone_sites::{Pslg, scatter};

use super::*;
use crate::cavity;

fn from_scratch(points: &[[f64; 2]], segments: &[[u32; 2]]) -> Cdt {
    let segments: Vec<[usize; 2]> = segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
    cavity(&Pslg::new(points, &segments).unwrap(), &Options::default(), &mut ())
}

/// Segments come and go in random order; after each step the CDT is that from scratch.
#[test]
fn segments_come_and_go() {
    let mut state = 9u64;
    let mut roll = |below: usize| {
        state = scatter(state);
        usize::try_from(state % below as u64).unwrap()
    };
    let [mut put, mut taken, mut blocked] = [0; 3];
    for round in 0..60 {
        let side = 3 + round % 9;
        let mut points: Vec<[f64; 2]> = (0..18)
            .map(|_| [(); 2].map(|()| f64::from(u32::try_from(roll(side)).unwrap())))
            .collect();
        points.sort_by(|p, q| p.partial_cmp(q).unwrap());
        points.dedup();
        let kernel = Adaptive::new(&points);
        let bare = from_scratch(&points, &[]);
        let Some(mut dynamic) = Dynamic::new(bare.clone(), &kernel, points.len()) else { continue };
        let mut present: Vec<[u32; 2]> = Vec::new();
        for _ in 0..60 {
            if !present.is_empty() && roll(3) == 0 {
                let ends = present.swap_remove(roll(present.len()));
                assert!(dynamic.remove_segment(ends, &mut ()));
                assert!(!dynamic.remove_segment(ends, &mut ()));
                taken += 1;
            } else {
                let ends = [(); 2].map(|()| u32::try_from(roll(points.len())).unwrap());
                let ends = [ends[0].min(ends[1]), ends[0].max(ends[1])];
                if ends[0] == ends[1] {
                    continue;
                }
                // Whether it must be refused: noding would cut it or another one, or refuse it.
                let all: Vec<[usize; 2]> =
                    present.iter().chain([&ends]).map(|s| s.map(|v| v as usize)).collect();
                let fits = Pslg::new(&points, &all)
                    .is_ok_and(|pslg| pslg.chains().last().unwrap().len() == 1);
                assert_eq!(dynamic.insert_segment(ends, &mut ()).is_ok(), fits);
                blocked += usize::from(!fits);
                put += usize::from(fits);
                if fits && !present.contains(&ends) {
                    present.push(ends);
                }
            }
            let (now, expected) = (dynamic.cdt(), from_scratch(&points, &present));
            assert_eq!(now.canonical(), expected.canonical(), "{points:?} {present:?}");
            assert_eq!(now.constrained_edges(), expected.constrained_edges());
        }
        for ends in present {
            assert!(dynamic.remove_segment(ends, &mut ()));
        }
        assert_eq!(dynamic.cdt().canonical(), bare.canonical());
    }
    assert!(put > 500 && taken > 300 && blocked > 300, "{put} {taken} {blocked}");
}

#[test]
fn what_blocks_a_segment_is_named() {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 1.0]];
    let kernel = Adaptive::new(&points);
    let mut dynamic = Dynamic::new(from_scratch(&points, &[[1, 3]]), &kernel, 5).unwrap();
    let before = dynamic.cdt();
    let [v1, v3, v4] = [1, 3, 4].map(VertexId::new);
    assert_eq!(dynamic.insert_segment([0, 2], &mut ()), Err(Blocked::Through(v4)));
    let crosses = dynamic.insert_segment([4, 2], &mut ()).unwrap_err();
    assert!(crosses == Blocked::Crosses([v1, v3]) || crosses == Blocked::Crosses([v3, v1]));
    assert_eq!(
        dynamic.insert_segment([2, 0], &mut ()).map_err(|b| matches!(b, Blocked::Crosses(_))),
        Err(true)
    );
    assert_eq!(dynamic.cdt(), before);
    let line = [[0.0, 0.0], [1.0, 1.0]];
    assert!(Dynamic::new(from_scratch(&line, &[]), &Adaptive::new(&line), 2).is_none());
}
