use super::*;
use crate::testing::{Owned, Random};
use crate::{Level, Options, Orientation, judge_constrained, judge_delaunay};

/// The symbolic rule against actual powers of two, and both against the judge.
fn agree<const D: usize>(points: &[[f64; D]]) {
    let cells = delaunay(points);
    assert_eq!(cells, delaunay_by_epsilon(points), "{points:?}");
    for filtered in [true, false] {
        for &backend in crate::Backend::all() {
            let orientation = Orientation::Any;
            let options = Options { filtered, backend, orientation, ..Options::default() };
            let verdict = judge_delaunay(&Owned::of_cells(points, &cells).complex(), &options);
            assert!(verdict.ok, "{points:?}\n{verdict}");
            assert_eq!(verdict.level, Level::Delaunay);
        }
    }
}

#[test]
fn perturbation_is_that_of_explicit_epsilons_in_the_plane() {
    let mut random = Random(21);
    for round in 0..120 {
        let side = 2 + round % 4;
        agree::<2>(&random.grid(1 + random_size(round, 10), side));
    }
}

#[test]
fn perturbation_is_that_of_explicit_epsilons_in_space() {
    let mut random = Random(22);
    for round in 0..60 {
        agree::<3>(&random.grid(1 + random_size(round, 9), 2 + round % 2));
    }
}

fn random_size(round: u32, n: usize) -> usize {
    round as usize % n
}

#[test]
fn four_dimensions_work_too() {
    let mut random = Random(23);
    for _ in 0..6 {
        agree::<4>(&random.grid(8, 2));
    }
}

#[test]
fn every_subset_of_a_small_grid_is_agreed_on() {
    let grid: Vec<[f64; 2]> = (0u32..9).map(|i| [f64::from(i % 3), f64::from(i / 3)]).collect();
    for mask in 0u32..512 {
        let points: Vec<[f64; 2]> =
            (0..9).filter(|i| mask >> i & 1 == 1).map(|i| grid[i]).collect();
        agree(&points);
    }
}

/// Random segments of which no two cross except in a point.
pub(crate) fn noded_segments(
    random: &mut Random,
    points: &[[f64; 2]],
    tries: u32,
) -> Vec<[u32; 2]> {
    let n = u32::try_from(points.len()).unwrap();
    let space: Space<'_, 2, Pure> = Space::new(points, true);
    let orient = |a, b, c| space.orient_along(&[0, 1], &[a, b, c]);
    let crosses = |[a, b]: [u32; 2], [c, d]: [u32; 2]| {
        orient(a, b, c).times(orient(a, b, d)) == Sign::Negative
            && orient(c, d, a).times(orient(c, d, b)) == Sign::Negative
    };
    let mut segments: Vec<[u32; 2]> = Vec::new();
    for _ in 0..tries {
        let new = [random.below(n), random.below(n)];
        if segments.iter().all(|&old| !crosses(old, new)) {
            segments.push(new);
        }
    }
    segments
}

/// All edges on some segment, from the cells and small-integer coordinates.
pub(crate) fn covered(
    points: &[[f64; 2]],
    cells: &[Vec<u32>],
    segments: &[[u32; 2]],
) -> Vec<[u32; 2]> {
    let mut edges: Vec<[u32; 2]> = cells
        .iter()
        .flat_map(|c| (0..c.len()).flat_map(move |i| (0..i).map(move |j| [c[j], c[i]])))
        .collect();
    edges.sort_unstable();
    edges.dedup();
    let at = |v: u32| points[v as usize];
    edges.retain(|&[u, v]| {
        segments.iter().any(|&[a, b]| {
            let (lo, hi) = if at(a) <= at(b) { (at(a), at(b)) } else { (at(b), at(a)) };
            let on = |p: [f64; 2]| {
                let turn = (hi[0] - lo[0]) * (p[1] - lo[1]) - (hi[1] - lo[1]) * (p[0] - lo[0]);
                turn == 0.0 && lo <= p && p <= hi
            };
            lo != hi && on(at(u)) && on(at(v))
        })
    });
    edges
}

#[test]
fn constrained_by_definition_is_accepted_by_the_local_judge() {
    let mut random = Random(24);
    let mut constrained_differs = 0;
    for round in 0..250 {
        let n = 4 + round % 7;
        let points = random.grid::<2>(n, 5);
        let segments = noded_segments(&mut random, &points, 6);
        let cells = constrained(&points, &segments);
        constrained_differs += usize::from(cells != delaunay(&points));
        let owned = Owned::of_cells(&points, &cells);
        let flags = covered(&points, &cells, &segments);
        let verdict = judge_constrained(&owned.complex(), &segments, &flags, &Options::default());
        assert!(verdict.ok, "{points:?} {segments:?} {cells:?}\n{verdict}");
        assert_eq!(verdict.level, Level::Constrained);
    }
    assert!(constrained_differs > 50, "{constrained_differs}");
}

#[test]
fn without_segments_constrained_is_delaunay() {
    let mut random = Random(25);
    for _ in 0..40 {
        let points = random.grid::<2>(9, 4);
        assert_eq!(constrained(&points, &[]), delaunay(&points));
    }
}

/// A wall between a triangle and a point in its circle hides the point, so the long edge stays.
#[test]
fn a_wall_hides_what_is_behind_it() {
    let points = [[0.0, 0.0], [10.0, 0.0], [5.0, 2.0], [5.0, -1.0]];
    let wall = [[0, 1]];
    assert_eq!(constrained(&points, &wall), [[0, 1, 2], [0, 1, 3]]);
    assert_eq!(delaunay(&points), [[0, 2, 3], [1, 2, 3]]);
}

#[test]
fn low_dimensions() {
    assert!(delaunay::<2>(&[]).is_empty());
    assert_eq!(delaunay(&[[3.0, 4.0]]), [[0]]);
    assert_eq!(delaunay(&[[3.0, 4.0], [3.0, 4.0]]), [[0]]);
    assert_eq!(delaunay(&[[2.0, 2.0], [0.0, 0.0], [1.0, 1.0]]), [[0, 2], [1, 2]]);
}
