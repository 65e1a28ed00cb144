use delone_delaunay::Options;
use delone_predicates::Adaptive;
use delone_sites::{Pslg, scatter};

use super::*;
use crate::cavity;

fn from_scratch(points: &[[f64; 2]], segments: &[[u32; 2]]) -> Cdt {
    let segments: Vec<[usize; 2]> = segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
    cavity(&Pslg::new(points, &segments).unwrap(), &Options::default(), &mut ())
}

/// What is there, to be built from scratch: vertices and segments.
struct Present {
    points: Vec<[f64; 2]>,
    vertices: Vec<bool>,
    segments: Vec<[u32; 2]>,
}

impl Present {
    fn matches<K: PlaneKernel>(&self, dynamic: &Dynamic<'_, K>) {
        let ids: Vec<usize> = (0..self.points.len()).filter(|&v| self.vertices[v]).collect();
        let points: Vec<[f64; 2]> = ids.iter().map(|&v| self.points[v]).collect();
        let place = |v: u32| u32::try_from(ids.binary_search(&(v as usize)).unwrap()).unwrap();
        let segments: Vec<[u32; 2]> = self.segments.iter().map(|s| s.map(place)).collect();
        let expected = from_scratch(&points, &segments);
        let back = |place: &u32| u32::try_from(ids[*place as usize]).unwrap();
        let cells: Vec<u32> = expected.canonical().iter().map(back).collect();
        let edges: Vec<[u32; 2]> =
            expected.constrained_edges().iter().map(|s| s.map(|v| back(&v))).collect();
        let now = dynamic.cdt();
        let told = || format!("{:?} {ids:?} {:?}", self.points, self.segments);
        assert_eq!(now.canonical(), cells, "{}", told());
        assert_eq!(now.constrained_edges(), edges, "{}", told());
        assert!(now.mesh().faults(delone_mesh::Level::Sphere, self.points.len()).is_empty());
    }

    /// Puts a segment in. Vertices in the way go, so that they come again to split it.
    fn connect<K: PlaneKernel>(&mut self, dynamic: &mut Dynamic<'_, K>, ends: [u32; 2]) {
        while let Err(blocked) = dynamic.insert_segment(ends, &mut ()) {
            let Blocked::Through(x) = blocked else { return };
            let x = u32::try_from(x.index()).unwrap();
            if dynamic.remove_vertex(x, &mut ()).is_err() {
                return;
            }
            self.vertices[x as usize] = false;
        }
        if !self.segments.contains(&ends) {
            self.segments.push(ends);
        }
    }

    /// The segment that a vertex lies on splits.
    fn split_at(&mut self, v: u32) {
        let p = self.points[v as usize];
        let on = |&[a, b]: &[u32; 2]| {
            let [a, b] = [a, b].map(|v| self.points[v as usize]);
            let turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            let between = |x: usize| a[x].min(b[x]) <= p[x] && p[x] <= a[x].max(b[x]);
            turn == 0.0 && between(0) && between(1)
        };
        if let Some(place) = self.segments.iter().position(on) {
            let [a, b] = self.segments.swap_remove(place);
            self.segments.extend([[a.min(v), a.max(v)], [b.min(v), b.max(v)]]);
        }
    }
}

/// Vertices and segments come and go; after each step the CDT is that from scratch.
#[test]
fn vertices_come_and_go() {
    let mut state = 5u64;
    let mut roll = |below: usize| {
        state = scatter(state);
        usize::try_from(state % below as u64).unwrap()
    };
    let [mut put, mut split, mut taken, mut kept, mut flat] = [0; 5];
    for round in 0..150 {
        let side = 3 + round % 3;
        let mut points: Vec<[f64; 2]> = (0..2 * side * side)
            .map(|_| [(); 2].map(|()| f64::from(u32::try_from(roll(side)).unwrap())))
            .collect();
        points.sort_by(|p, q| p.partial_cmp(q).unwrap());
        points.dedup();
        let kernel = Adaptive::new(&points);
        let count = points.len();
        let Some(mut dynamic) = Dynamic::new(from_scratch(&points, &[]), &kernel, count) else {
            continue;
        };
        let mut present =
            Present { points: points.clone(), vertices: vec![true; count], segments: Vec::new() };
        for _ in 0..80 {
            let v = u32::try_from(roll(count)).unwrap();
            let w = u32::try_from(roll(count)).unwrap();
            match roll(9) {
                0..=2 if v != w && dynamic.holds(v) && dynamic.holds(w) => {
                    let ends = [v.min(w), v.max(w)];
                    present.connect(&mut dynamic, ends);
                }
                3 if !present.segments.is_empty() => {
                    let place = roll(present.segments.len());
                    let ends = present.segments.swap_remove(place);
                    assert!(dynamic.remove_segment(ends, &mut ()));
                }
                4..=6 => {
                    let before = present.segments.len();
                    let comes = dynamic.insert_vertex(v, &mut ());
                    assert_eq!(comes, !present.vertices[v as usize]);
                    if comes {
                        present.split_at(v);
                    }
                    put += usize::from(comes);
                    split += present.segments.len() - before;
                    present.vertices[v as usize] = true;
                }
                _ => match dynamic.remove_vertex(v, &mut ()) {
                    Ok(goes) => {
                        assert_eq!(goes, present.vertices[v as usize]);
                        assert!(present.segments.as_flattened().iter().all(|&end| end != v));
                        taken += usize::from(goes);
                        present.vertices[v as usize] = false;
                    }
                    Err(Kept::Constrained(ends)) => {
                        let mut ends = ends.map(|v| u32::try_from(v.index()).unwrap());
                        ends.sort_unstable();
                        assert!(present.segments.contains(&ends));
                        kept += 1;
                    }
                    Err(Kept::Flat) => flat += 1,
                },
            }
            present.matches(&dynamic);
        }
    }
    let told = format!("{put} {split} {taken} {kept} {flat}");
    assert!(put > 500 && split > 50 && taken > 500 && kept > 300 && flat > 10, "{told}");
}

#[test]
fn a_vertex_splits_a_constrained_edge() {
    let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 3.0], [2.0, -3.0], [1.0, 0.0], [3.0, 1.5]];
    let kernel = Adaptive::new(&points);
    let bare = from_scratch(&points[..4], &[[0, 1], [1, 2]]);
    let mut dynamic = Dynamic::new(bare, &kernel, 6).unwrap();
    assert!(dynamic.insert_vertex(4, &mut ()), "inside the hull");
    assert_eq!(dynamic.cdt().constrained_edges(), [[0, 4], [1, 2], [1, 4]]);
    assert!(dynamic.insert_vertex(5, &mut ()), "on the hull");
    assert_eq!(dynamic.cdt().constrained_edges(), [[0, 4], [1, 4], [1, 5], [2, 5]]);
    assert!(!dynamic.insert_vertex(5, &mut ()));
}

/// A corner of the hull with neighbours in line: two, and more.
#[test]
fn an_ear_goes() {
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [1.5, 2.0], [1.5, -9.0]];
    let kernel = Adaptive::new(&points);
    let mut dynamic = Dynamic::new(from_scratch(&points, &[[1, 2]]), &kernel, 6).unwrap();
    assert_eq!(dynamic.remove_vertex(4, &mut ()), Ok(true));
    assert_eq!(dynamic.cdt().canonical(), [0, 1, 5, 1, 2, 5, 2, 3, 5]);
    assert_eq!(dynamic.cdt().constrained_edges(), [[1, 2]]);
    assert_eq!(dynamic.remove_vertex(0, &mut ()), Ok(true));
    assert_eq!(dynamic.cdt().canonical(), [1, 2, 5, 2, 3, 5]);
    assert!(dynamic.insert_vertex(4, &mut ()) && dynamic.insert_vertex(0, &mut ()));
    assert_eq!(dynamic.cdt().canonical(), from_scratch(&points, &[[1, 2]]).canonical());
}

#[test]
fn what_keeps_a_vertex_is_named() {
    let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 2.0]];
    let kernel = Adaptive::new(&points);
    let mut dynamic = Dynamic::new(from_scratch(&points, &[[0, 1]]), &kernel, 4).unwrap();
    let before = dynamic.cdt();
    let [v0, v1] = [0, 1].map(VertexId::new);
    assert_eq!(dynamic.remove_vertex(1, &mut ()), Err(Kept::Constrained([v1, v0])));
    assert_eq!(dynamic.remove_vertex(3, &mut ()), Err(Kept::Flat));
    assert_eq!(dynamic.cdt(), before);
    assert_eq!(
        Kept::Constrained([v1, v0]).to_string(),
        "the segment from v1 to v0 ends here: take it out first"
    );
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
                    .is_ok_and(|pslg| pslg.chains().iter().last().unwrap().len() == 1);
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
