mod boundaries;

use delone_delaunay::Options;
use delone_sites::Pslg;

use super::*;
use crate::cavity;

fn graph(points: &[[f64; 2]], segments: &[[usize; 2]]) -> (Cdt, Pslg) {
    let pslg = Pslg::new(points, segments).unwrap();
    (cavity(&pslg, &Options::default(), &mut ()), pslg)
}

fn fill(points: &[[f64; 2]], segments: &[[usize; 2]], rule: &Fill) -> Domain {
    let (cdt, pslg) = graph(points, segments);
    Domain::new(&cdt, &pslg, rule).unwrap()
}

fn area(points: &[[f64; 2]], segments: &[[usize; 2]], rule: &Fill) -> String {
    fill(points, segments, rule).area().to_string()
}

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];

fn ring(first: usize, count: usize) -> Vec<[usize; 2]> {
    (0..count).map(|i| [first + i, first + (i + 1) % count]).collect()
}

fn and(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    [&SQUARE[..], points].concat()
}

#[test]
fn a_line_has_no_inside() {
    let line = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]];
    for rule in [Fill::Hull, Fill::EvenOdd, Fill::NonZero, Fill::Nesting, Fill::Exterior] {
        let (cdt, pslg) = graph(&line, &[[0, 2]]);
        let domain = Domain::new(&cdt, &pslg, &rule).unwrap();
        assert_eq!((domain.regions().count(), domain.area()), (1, Area::default()));
        assert_eq!(domain.kinds(), [EdgeKind::Slit, EdgeKind::Slit]);
        assert_eq!((domain.cells(&cdt).count(), domain.holes().count()), (0, 0));
        assert_eq!(area(&[], &[], &rule), "0");
    }
}

#[test]
fn regions_that_touch_in_a_vertex_are_two() {
    let bow = [[0.0, 0.0], [2.0, 1.0], [2.0, -1.0], [-2.0, 1.0], [-2.0, -1.0]];
    let segments = [[0, 1], [1, 2], [2, 0], [0, 3], [3, 4], [4, 0]];
    let domain = fill(&bow, &segments, &Fill::EvenOdd);
    assert_eq!((domain.regions().count(), domain.area().to_string()), (3, "4".to_owned()));
    assert_eq!(domain.interior_point(1).map(|p| p[0] < 0.0), Some(true)); // the left one is first
    assert!(domain.kinds().iter().all(|&kind| kind == EdgeKind::Shell));
}

#[test]
fn the_hull_is_the_whole_of_it() {
    let concave = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 2.0]];
    let domain = fill(&concave, &ring(0, 5), &Fill::Hull);
    assert_eq!((domain.regions().count(), domain.area().to_string()), (3, "16".to_owned()));
    assert_eq!((domain.depth(0), domain.depth(1), domain.depth(2)), (0, 0, 1));
    let kinds = [EdgeKind::Shell, EdgeKind::Interface];
    let counts = kinds.map(|kind| domain.kinds().iter().filter(|k| **k == kind).count());
    assert_eq!(counts, [3, 2]);
    assert_eq!(area(&concave, &ring(0, 5), &Fill::Exterior), "14");
    assert_eq!(area(&concave, &[], &Fill::Hull), "16");
    assert_eq!(area(&concave, &[], &Fill::Exterior), "0");
}

#[test]
fn slits_and_bridges_are_told_apart() {
    // A square with a triangle inside, a bridge of two pieces between them, a slit that hangs from the bridge, and one alone.
    let points = and(&[
        [6.0, 4.0],
        [8.0, 4.0],
        [7.0, 6.0], // the triangle 4 5 6
        [3.0, 2.0],
        [2.0, 6.0],
        [1.0, 8.0],
        [2.0, 8.0],
    ]);
    let mut segments = ring(0, 4);
    segments.extend(ring(4, 3));
    segments.extend([[0, 7], [7, 4], [7, 8], [9, 10]]);
    for (rule, area) in [(Fill::EvenOdd, "98"), (Fill::Nesting, "98"), (Fill::NonZero, "100")] {
        let (cdt, pslg) = graph(&points, &segments);
        let domain = Domain::new(&cdt, &pslg, &rule).unwrap();
        assert_eq!(domain.area().to_string(), area);
        let edges = |kind| domain.edges(&pslg, kind).collect::<Vec<_>>();
        assert_eq!(edges(EdgeKind::Bridge), [[0, 7], [4, 7]]);
        assert_eq!(edges(EdgeKind::Slit), [[7, 8], [9, 10]]);
        let inner = if area == "98" { EdgeKind::Hole } else { EdgeKind::Interface };
        assert_eq!(edges(inner), [[4, 5], [4, 6], [5, 6]]);
        assert_eq!(edges(EdgeKind::Shell).len(), 4);
    }
}

#[test]
fn islands_in_holes_have_shells() {
    let nested = |r: f64| [[-r, -r], [r, -r], [r, r], [-r, r]];
    let points: Vec<[f64; 2]> = [8.0, 4.0, 2.0, 1.0].into_iter().flat_map(nested).collect();
    let segments: Vec<[usize; 2]> = [0, 4, 8, 12].into_iter().flat_map(|i| ring(i, 4)).collect();
    let domain = fill(&points, &segments, &Fill::Nesting);
    assert_eq!(domain.area().to_string(), "204"); // 256 - 64 + 16 - 4
    let count = |kind| domain.kinds().iter().filter(|k| **k == kind).count();
    assert_eq!((count(EdgeKind::Shell), count(EdgeKind::Hole)), (8, 8));
    let mut depths: Vec<u32> = (0u32..5).map(|region| domain.depth(region)).collect();
    assert_eq!(depths[0], 0);
    depths.sort_unstable();
    assert_eq!(depths, [0, 1, 2, 3, 4]);
    // All counter-clockwise: wound 1, 2, 3, 4 times; the two in the middle turned: 1, 0, -1, 0.
    assert_eq!(area(&points, &segments, &Fill::NonZero), "256");
    let turned: Vec<[usize; 2]> =
        segments.iter().map(|&[a, b]| if (4..12).contains(&a) { [b, a] } else { [a, b] }).collect();
    assert_eq!(area(&points, &turned, &Fill::NonZero), "204"); // -1 counts
    assert_eq!(area(&points, &turned, &Fill::Positive), "192");
}

#[test]
fn multiplicity_counts_for_parity_only() {
    let points = and(&[[2.0, 2.0], [5.0, 2.0], [2.0, 5.0]]);
    let segments = [ring(0, 4), ring(4, 3), ring(4, 3)].concat();
    assert_eq!(area(&points, &segments, &Fill::EvenOdd), "100");
    assert_eq!(area(&points, &segments, &Fill::Nesting), "191/2");
    let thrice = [&segments[..], &ring(4, 3)].concat();
    assert_eq!(area(&points, &thrice, &Fill::EvenOdd), "191/2");
}

#[test]
fn open_boundaries_are_named_by_their_vertices() {
    // A duplicate point in front, so that input points and sites differ.
    let points = [&SQUARE[..1], &SQUARE[..]].concat();
    let segments = [[1, 2], [2, 3], [3, 4], [4, 1], [2, 4]];
    let (cdt, pslg) = graph(&points, &segments);
    let error = Domain::new(&cdt, &pslg, &Fill::EvenOdd).unwrap_err();
    let FillError::OddVertices(open) = &error else { panic!("{error}") };
    let found: Vec<_> = open.iter().map(|v| (v.point, v.at, v.excess)).collect();
    assert_eq!(found, [(2, [10.0, 0.0], 3), (4, [0.0, 10.0], 3)]);
    assert!(
        error.to_string().starts_with("the boundary is open: 3 segments end at point 2 (10, 0)")
    );
    let error = Domain::new(&cdt, &pslg, &Fill::NonZero).unwrap_err();
    let FillError::Unbalanced(open) = &error else { panic!("{error}") };
    let found: Vec<_> = open.iter().map(|v| (v.point, v.excess)).collect();
    assert_eq!(found, [(2, -1), (4, 1)]); // the diagonal goes from the one and comes to the other
    assert_eq!(error.to_string().lines().count(), 2);
    // Tags: the diagonal is an interface.
    let roles = [[Role::Boundary; 4].to_vec(), vec![Role::Interface]].concat();
    let domain = Domain::new(&cdt, &pslg, &Fill::Tagged(roles)).unwrap();
    assert_eq!(
        (domain.area().to_string(), domain.chain()),
        ("100".to_owned(), Some(&[0, 1, 1][..]))
    );
    let error = Domain::new(&cdt, &pslg, &Fill::Tagged(vec![Role::Boundary])).unwrap_err();
    assert_eq!(error, FillError::Roles { segments: 5, roles: 1 });
    // One side missing: nothing is enclosed, and no rule invents anything.
    assert_eq!(area(&SQUARE, &ring(0, 4)[..3], &Fill::Nesting), "0");
    assert_eq!(area(&SQUARE, &ring(0, 4)[..3], &Fill::EvenOdd), "0");
}

#[test]
fn seeds_remove_their_regions() {
    let points = and(&[[2.0, 2.0], [5.0, 2.0], [2.0, 5.0], [3.0, 3.0]]);
    let segments = [ring(0, 4), ring(4, 3)].concat();
    assert_eq!(area(&points, &segments, &Fill::Seeds(vec![])), "100");
    assert_eq!(area(&points, &segments, &Fill::Seeds(vec![[2.5, 2.5]])), "191/2");
    assert_eq!(area(&points, &segments, &Fill::Seeds(vec![[3.0, 3.0]])), "191/2"); // at a free vertex
    assert_eq!(area(&points, &segments, &Fill::Seeds(vec![[-1.0, 5.0], [1e300, 0.0]])), "100");
    assert_eq!(area(&points, &segments, &Fill::Seeds(vec![[9.0, 9.0], [2.5, 2.5]])), "0");
    assert_eq!(area(&points, &segments, &Fill::Seeds(vec![[9.0, 9.0]])), "9/2");
}

#[test]
fn seeds_on_segments_are_refused() {
    let seeds = vec![[5.0, 0.0], [1.0, 1.0], [f64::NAN, 0.0], [10.0, 10.0]];
    let (cdt, pslg) = graph(&SQUARE, &ring(0, 4));
    let error = Domain::new(&cdt, &pslg, &Fill::Seeds(seeds)).unwrap_err();
    let FillError::Seeds(faults) = &error else { panic!("{error}") };
    let seeds: Vec<usize> = faults
        .iter()
        .map(|fault| match *fault {
            SeedFault::NotFinite { seed } | SeedFault::OnSegment { seed, .. } => seed,
        })
        .collect();
    assert_eq!(seeds, [0, 2, 3]);
}

#[test]
fn a_region_too_narrow_for_a_double_has_no_point() {
    // Between the origin and the least double there is no room.
    let least = 5e-324;
    let narrow = [[0.0, 0.0], [least, 0.0], [0.0, least]];
    let domain = fill(&narrow, &ring(0, 3), &Fill::EvenOdd);
    assert_eq!(domain.interior_point(1), None);
    assert_eq!(domain.area().to_f64(), 0.0);
    assert!(domain.area() != Area::default());
    let wide = SQUARE.map(|p| p.map(|x| if x > 0.0 { f64::MAX } else { -f64::MAX }));
    let domain = fill(&wide, &ring(0, 4), &Fill::EvenOdd);
    assert!(domain.interior_point(1).is_some());
    assert_eq!(domain.area().to_f64(), f64::INFINITY);
}
