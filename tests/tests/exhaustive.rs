//! Exhaustive small worlds: every input of a kind, against the definition.
//!
//! | world | inputs | against |
//! |---|---|---|
//! | subsets of the 4 x 3 grid | all 4,096 | the judge, `naive::delaunay` |
//! | subsets of the 3 x 3 x 2 grid that touch x = 0, y = 0 and z = 0 (the others are translates) | one in twelve; all with `DELONE_LONG=1` | the judge; every 16th `naive::delaunay` |
//! | subsets of the 3 x 3 x 3 grid | 1,500 random ones | the judge; those of at most 10 sites `naive::delaunay` |
//! | segments on the 3 x 3 grid | all 36, all 630 pairs, every 5th of the 7,140 triples (all with `DELONE_LONG=1`) | `naive::constrained`, the judge |
//! | triangulations of the 3 x 3 grid | all 64, all edges given; each again without each edge | `naive::constrained` |
//! | sets of segments on the 3 x 3 grid | 600 random maximal ones, thinned | `naive::constrained`, the judge |
//! | plane graphs on the 3 x 3 grid | every set of inner edges, with a choice of hull edges (all of them with `DELONE_LONG=1`) | each other, all algorithms |
//! | crossing segments on the 3 x 3 grid | all pairs, every 15th triple (all with `DELONE_LONG=1`) | each other, all algorithms |
//!
//! A set of segments must be refused exactly if two of them cross at a point that is no site: decided here by integers.

use delone::cdt::{algorithms as constrained_algorithms, cavity, cdt_of_arrangement};
use delone::check::naive;
use delone::delaunay::{Options, algorithms, delaunay};
use delone::sites::{Arrangement, Pslg};
use delone::workloads::Rng;
use delone_tests::case::Case;
use delone_tests::judge::{Rigour, accept_constrained, accept_delaunay};

fn subset<const D: usize>(grid: &[[f64; D]], mask: u32) -> Case<D> {
    let points = (0u32..).zip(grid).filter(|(i, _)| mask >> i & 1 == 1).map(|(_, &p)| p).collect();
    Case::of_points(format!("subset {mask:#b}"), points)
}

fn check_delaunay<const D: usize>(case: &Case<D>, by_definition: bool) {
    let sites = case.sites();
    let result = delaunay(&sites, &Options::default(), &mut ());
    accept_delaunay(case, &sites, &result, Rigour::Once);
    for algorithm in algorithms::<D>() {
        if algorithm.sites_max == usize::MAX || (by_definition && sites.len() <= 12) {
            let other = (algorithm.run)(&sites, &Options::default());
            assert_eq!(other.canonical(), result.canonical(), "{}: {}", case.name, algorithm.name);
        }
    }
    if by_definition {
        let definition = naive::delaunay(&case.points).concat();
        assert_eq!(result.canonical(), definition, "{}", case.name);
    }
}

fn lattice<const D: usize>(sides: [u32; D]) -> Vec<[f64; D]> {
    let point = |mut i: u32| {
        let mut p = [0.0; D];
        for axis in (0..D).rev() {
            p[axis] = f64::from(i % sides[axis]);
            i /= sides[axis];
        }
        p
    };
    (0..sides.iter().product()).map(point).collect()
}

#[test]
fn every_subset_of_a_four_by_three_grid() {
    let grid = lattice([4, 3]);
    (0..1 << 12).for_each(|mask| check_delaunay(&subset(&grid, mask), true));
}

#[test]
fn every_subset_of_a_three_by_three_by_two_grid() {
    let grid = lattice([3, 3, 2]);
    let mut count = 0;
    for mask in 0..1u32 << 18 {
        let case = subset(&grid, mask);
        let touches = |axis: usize| case.points.iter().any(|p| p[axis] == 0.0);
        if (0..3).all(touches) && (delone_tests::long() || mask % 12 == 5) {
            check_delaunay(&case, count % 16 == 0);
            count += 1;
        }
    }
    assert!(count > 10_000, "{count}");
}

#[test]
fn random_subsets_of_a_three_by_three_by_three_grid() {
    let (grid, mut rng) = (lattice([3, 3, 3]), Rng::named("27", 1));
    for _ in 0..1500 {
        let dense = rng.below(5) + 1;
        let mask = (0..27).filter(|_| rng.below(6) < dense).fold(0u32, |mask, i| mask | 1 << i);
        check_delaunay(&subset(&grid, mask), mask.count_ones() <= 10);
    }
}

/// The 3 x 3 grid: site `3 x + y`.
fn square() -> Vec<[f64; 2]> {
    lattice([3, 3])
}

fn all_segments() -> Vec<[u32; 2]> {
    (0..9).flat_map(|b| (0..b).map(move |a| [a, b])).collect()
}

/// The sign of the turn a, b, c on the grid.
fn turn(a: u32, b: u32, c: u32) -> i32 {
    let [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(|v| [v / 3, v % 3].map(u32::cast_signed));
    ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)).signum()
}

/// Whether two segments meet in one point inside both that is no point of the grid: in twelfths, all crossings of
/// segments of this grid have integer coordinates.
fn cross([a, b]: [u32; 2], [c, d]: [u32; 2]) -> bool {
    if turn(a, b, c) * turn(a, b, d) >= 0 || turn(c, d, a) * turn(c, d, b) >= 0 {
        return false;
    }
    (0..9).all(|v| turn(a, b, v) != 0 || turn(c, d, v) != 0)
}

fn check_segments(segments: &[[u32; 2]]) -> bool {
    let case = Case::new(format!("segments {segments:?}"), square(), segments.to_vec());
    let pslg = case.try_pslg();
    let crossing =
        segments.iter().enumerate().any(|(i, &s)| segments[..i].iter().any(|&t| cross(s, t)));
    assert_eq!(pslg.is_none(), crossing, "{}: refused, or crossing", case.name);
    let Some(pslg) = pslg else { return false };
    let result = cavity(&pslg, &Options::default(), &mut ());
    accept_constrained(&case, &pslg, &result, Rigour::Once);
    let definition = naive::constrained(&case.points, segments).concat();
    assert_eq!(result.canonical(), definition, "{}", case.name);
    true
}

#[test]
fn every_segment_and_pair_of_segments() {
    let all = all_segments();
    let mut taken = 0;
    for (i, &s) in all.iter().enumerate() {
        assert!(check_segments(&[s]));
        taken += all[..i].iter().filter(|&&t| check_segments(&[t, s])).count();
    }
    assert!(taken > 400 && taken < 630, "{taken} of 630 pairs do not cross");
}

#[test]
fn triples_of_segments() {
    let all = all_segments();
    let (mut number, mut taken) = (0, 0);
    for i in 0..all.len() {
        for j in 0..i {
            for k in 0..j {
                number += 1;
                if number % 5 == 0 || delone_tests::long() {
                    taken += usize::from(check_segments(&[all[i], all[j], all[k]]));
                }
            }
        }
    }
    assert_eq!(number, 7140);
    assert!(taken > 500, "{taken}");
}

/// Segments without a site inside them.
fn primitive() -> Vec<[u32; 2]> {
    let inside =
        |[a, b]: [u32; 2], v: u32| v != a && v != b && turn(a, b, v) == 0 && (a < v) == (v < b);
    all_segments().into_iter().filter(|&s| (0..9).all(|v| !inside(s, v))).collect()
}

/// Calls `found` with every maximal set of primitive segments that do not cross: the triangulations with all nine sites.
fn for_each_triangulation(mut found: impl FnMut(&[[u32; 2]])) {
    let all = primitive();
    let mut chosen = vec![(0, true); 0];
    // Depth-first over "with" and "without" for each segment in turn.
    loop {
        while chosen.len() < all.len() {
            let next = all[chosen.len()];
            let fits =
                chosen.iter().all(|&(i, with): &(usize, bool)| !with || !cross(all[i], next));
            chosen.push((chosen.len(), fits));
        }
        let set: Vec<[u32; 2]> = chosen.iter().filter(|c| c.1).map(|c| all[c.0]).collect();
        // A triangulation of 9 sites, 8 of them on the hull, has 3 * 9 - 3 - 8 edges.
        if set.len() == 16 {
            found(&set);
        }
        while chosen.last().is_some_and(|c| !c.1) {
            chosen.pop();
        }
        match chosen.last_mut() {
            Some(last) => last.1 = false,
            None => return,
        }
    }
}

#[test]
fn every_triangulation_and_every_one_less_an_edge() {
    let mut count = 0;
    for_each_triangulation(|edges| {
        count += 1;
        assert!(check_segments(edges));
        for without in 0..edges.len() {
            let mut rest = edges.to_vec();
            rest.remove(without);
            assert!(check_segments(&rest));
        }
    });
    assert_eq!(count, 64, "the 3 x 3 grid has 64 unimodular triangulations");
}

/// All algorithms on one set of segments of the square, each also as if segments could cross.
fn check_agreement(segments: &[[u32; 2]]) {
    let segments: Vec<[usize; 2]> = segments.iter().map(|s| s.map(|v| v as usize)).collect();
    let graph = Arrangement::new(&square(), &segments).expect("finite points");
    let first = cdt_of_arrangement(&graph, &mut ());
    let pslg = Pslg::new(&square(), &segments).ok();
    for algorithm in constrained_algorithms() {
        let crossed = (algorithm.run_crossed)(&graph, &mut ());
        assert_eq!(crossed.canonical(), first.canonical(), "{}: {segments:?}", algorithm.name);
        assert_eq!(crossed.constrained_edges(), graph.subsegments(), "{}", algorithm.name);
        if let Some(pslg) = &pslg {
            let other = (algorithm.run)(pslg, &Options::default());
            assert_eq!(other.canonical(), first.canonical(), "{}: {segments:?}", algorithm.name);
            assert_eq!(other.constrained_edges(), pslg.subsegments(), "{}", algorithm.name);
        }
    }
}

/// Calls `found` with every set of the segments of which no two cross.
fn for_each_plane_set(all: &[[u32; 2]], mut found: impl FnMut(&[[u32; 2]])) {
    let mut stack: Vec<(usize, Vec<[u32; 2]>)> = vec![(0, Vec::new())];
    while let Some((next, set)) = stack.pop() {
        let Some(&segment) = all.get(next) else {
            found(&set);
            continue;
        };
        if set.iter().all(|&other| !cross(segment, other)) {
            let mut with = set.clone();
            with.push(segment);
            stack.push((next + 1, with));
        }
        stack.push((next + 1, set));
    }
}

#[test]
fn all_algorithms_on_every_plane_graph() {
    let on_hull = |&[a, b]: &[u32; 2]| {
        let sides: Vec<i32> = (0..9).map(|v| turn(a, b, v)).collect();
        sides.iter().all(|&side| side >= 0) || sides.iter().all(|&side| side <= 0)
    };
    let (hull, inner): (Vec<[u32; 2]>, Vec<[u32; 2]>) = primitive().into_iter().partition(on_hull);
    assert_eq!((hull.len(), inner.len()), (8, 20));
    let (mut count, mut maximal) = (0u32, 0);
    for_each_plane_set(&inner, |set| {
        count += 1;
        maximal += u32::from(set.len() == 8);
        let masks = if delone_tests::long() { 0..256 } else { count % 256..count % 256 + 1 };
        for mask in masks {
            let chosen = (0..8usize).filter(|i| mask >> i & 1 == 1).map(|i| hull[i]);
            check_agreement(&set.iter().copied().chain(chosen).collect::<Vec<_>>());
        }
    });
    assert_eq!(maximal, 64, "the inner edges of the 64 triangulations are among the {count} sets");
}

#[test]
fn all_algorithms_on_crossing_segments() {
    let all = all_segments();
    let (mut number, mut crossing) = (0, 0);
    for i in 0..all.len() {
        for j in 0..i {
            check_agreement(&[all[i], all[j]]);
            crossing += u32::from(cross(all[i], all[j]));
            for k in 0..j {
                number += 1;
                if number % 15 == 0 || delone_tests::long() {
                    check_agreement(&[all[i], all[j], all[k]]);
                }
            }
        }
    }
    assert!(crossing > 0 && crossing < 630, "{crossing} of 630 pairs cross");
}

#[test]
fn random_sets_of_segments() {
    let mut rng = Rng::named("segments", 1);
    for _ in 0..600 {
        let mut all = all_segments();
        rng.shuffle(&mut all);
        let mut set: Vec<[u32; 2]> = Vec::new();
        for s in all {
            if set.iter().all(|&t| !cross(s, t)) {
                set.push(s);
            }
        }
        let thin = rng.below(4);
        set.retain(|_| rng.below(4) >= thin);
        assert!(check_segments(&set));
    }
}
