use super::*;
use crate::naive;
use crate::options::Orientation;
use crate::testing::{Owned, Random};

/// The verdict under every arithmetic, which must be one.
fn judged<const D: usize>(input: &Owned<D>, weights: &[f64], options: Options) -> Verdict {
    let verdict = judge_regular(&input.complex(), weights, &options);
    for filtered in [true, false] {
        for &backend in Backend::all() {
            let other = Options { filtered, backend, ..options };
            assert_eq!(judge_regular(&input.complex(), weights, &other), verdict, "{other:?}");
        }
    }
    verdict
}

/// What brute force finds.
fn regular<const D: usize>(points: &[[f64; D]], weights: &[f64]) -> Owned<D> {
    Owned::of_cells(points, &naive::regular(points, weights))
}

fn any() -> Options {
    Options { orientation: Orientation::Any, ..Options::default() }
}

fn accepted<const D: usize>(points: &[[f64; D]], weights: &[f64]) -> Owned<D> {
    let input = regular(points, weights);
    let verdict = judged(&input, weights, any());
    assert!(verdict.ok && verdict.level == Level::Regular, "{points:?} {weights:?}\n{verdict}");
    input
}

fn rejected<const D: usize>(input: &Owned<D>, weights: &[f64], kind: &str) {
    let verdict = judged(input, weights, any());
    assert!(!verdict.ok && verdict.has(kind), "expected {kind} in\n{verdict}");
    assert_ne!(verdict.level, Level::Regular);
    assert!(verdict.faults.iter().all(|fault| fault.to_string().len() > 20), "{verdict}");
}

fn weights(random: &mut Random, count: usize, most: u32) -> Vec<f64> {
    (0..count).map(|_| f64::from(random.below(most)) - 2.0).collect()
}

#[test]
fn brute_force_is_accepted_and_nothing_else_with_the_same_hidden_points_missing() {
    let mut random = Random(71);
    for round in 0..150usize {
        let points = random.grid::<2>(1 + round % 11, 2 + u32::try_from(round % 4).unwrap());
        let most = 2 + random.below(6);
        let weights = weights(&mut random, points.len(), most);
        accepted(&points, &weights);
        let space = random.grid::<3>(1 + round % 8, 3);
        accepted(&space, &weights[..weights.len().min(space.len())].repeat(9)[..space.len()]);
    }
}

#[test]
fn equal_weights_change_nothing() {
    let mut random = Random(72);
    for _ in 0..40 {
        let points = random.grid::<2>(9, 4);
        for weight in [0.0, 7.0, -5e-324, 1e308] {
            assert_eq!(naive::regular(&points, &[weight; 9]), naive::delaunay(&points));
        }
    }
}

#[test]
fn weights_from_end_to_end_of_the_doubles() {
    let points = [[0.0, 0.0], [5e-324, 0.0], [0.0, 1e308], [3.0, 3.0], [-1e308, 2.0]];
    for heavy in 0..5 {
        for weight in [5e-324, 1.0, f64::MAX, -f64::MAX] {
            let mut weights = [0.0; 5];
            weights[heavy] = weight;
            accepted(&points, &weights);
        }
    }
}

const SQUARE: [[f64; 2]; 5] = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [4.0, 4.0], [2.0, 1.0]];

#[test]
fn the_weight_of_a_point_decides_whether_it_is_hidden() {
    // The centre of the square has power 8 - 3 = 5 to go: [2, 1] is 5 from the three nearest corners' sphere.
    let weights = |w: f64| [0.0, 0.0, 0.0, 0.0, w];
    assert_eq!(accepted(&SQUARE, &weights(-2.5)).cells.len(), 12);
    let hidden = accepted(&SQUARE, &weights(-9.0));
    assert_eq!(hidden.cells.len(), 6);
    rejected(&hidden, &weights(0.0), "not-hidden");
    rejected(&accepted(&SQUARE, &weights(0.0)), &weights(-9.0), "not-delaunay");
}

#[test]
fn what_is_missing_beyond_the_hull_is_told() {
    let input = Owned::new(&SQUARE, 2, &[0, 1, 2]);
    rejected(&input, &[0.0, 0.0, 0.0, -99.0, -99.0], "beyond-hull");
}

#[test]
fn of_equal_points_only_the_heaviest_may_be_used() {
    let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [0.0, 0.0]];
    let first = Owned::new(&points, 2, &[0, 1, 2]);
    let second = Owned::new(&points, 2, &[3, 1, 2]);
    rejected(&first, &[0.0, 0.0, 0.0, 1.0], "not-hidden");
    for (input, weights) in
        [(&first, [0.0; 4]), (&second, [0.0; 4]), (&second, [0.0, 0.0, 0.0, 1.0])]
    {
        assert!(judged(input, &weights, any()).ok);
    }
    assert_eq!(naive::regular(&points, &[0.0, 0.0, 0.0, 1.0]), [[1, 2, 3]]);
    let point = Owned::new(&[[1.0, 1.0], [1.0, 1.0]], 0, &[0]);
    assert!(judged(&point, &[1.0, 0.0], any()).ok);
    rejected(&point, &[0.0, 1.0], "not-hidden");
}

#[test]
fn ties_are_as_the_perturbation_has_them() {
    let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [4.0, 4.0]];
    let other = Owned::new(&points, 2, &[0, 1, 3, 0, 3, 2]);
    rejected(&other, &[1.0; 4], "wrong-tie");
    let weak = judged(&other, &[1.0; 4], Options::foreign());
    assert!(weak.ok && weak.level == Level::WeaklyRegular, "{weak}");
    // On the segment, with the height of the segment: of rank between its ends, so it stays out of no cell.
    let line = [[0.0], [1.0], [2.0]];
    let flat = [0.0, -1.0, 0.0];
    let found = accepted(&line, &flat);
    let hidden = Owned::new(&line, 1, &[0, 2]);
    let all = Owned::new(&line, 1, &[0, 1, 1, 2]);
    assert!(found.cells == hidden.cells || found.cells == all.cells);
    let wrong = if found.cells == hidden.cells { all } else { hidden };
    rejected(&wrong, &flat, "wrong-tie");
}

#[test]
fn weights_must_be_finite_and_as_many_as_points() {
    let input = Owned::new(&SQUARE[..3], 2, &[0, 1, 2]);
    rejected(&input, &[0.0; 2], "bad-length");
    rejected(&input, &[0.0, f64::INFINITY, 0.0], "weight-not-finite");
    let nothing = Owned::<2> { points: Vec::new(), dimension: None, cells: Vec::new() };
    assert!(judged(&nothing, &[], any()).ok);
}
