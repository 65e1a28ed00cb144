use delone::workloads::Rng;

use super::{Case, NAME, POINTS_MAX, graph, points};
use crate::choices::{Bytes, Choices};
use crate::exact::nudged;

fn cases(count: u64) -> impl Iterator<Item = Case<2>> {
    (0..count).map(|seed| points::<2>(&mut Rng::new(seed)))
}

#[test]
fn same_choices_same_case() {
    for seed in 0..50 {
        assert_eq!(graph(&mut Rng::new(seed)), graph(&mut Rng::new(seed)));
    }
    assert_eq!(points::<3>(&mut Bytes(&[])), Case::of_points(NAME, vec![]));
}

#[test]
fn every_coordinate_is_finite_and_few_points_are_made() {
    for case in cases(2000) {
        assert!(case.points.as_flattened().iter().all(|x| x.is_finite()));
        assert!(case.points.len() <= POINTS_MAX);
    }
}

#[test]
fn segments_do_not_cross_and_are_there() {
    let graphs: Vec<Case<2>> = (0..300).map(|seed| graph(&mut Rng::new(seed))).collect();
    assert!(graphs.iter().all(|case| case.try_pslg().is_some()));
    assert!(graphs.iter().filter(|case| case.segments.len() > 3).count() > 60);
}

/// Each degeneracy that the head promises occurs, in more than one case of a hundred.
#[test]
fn degeneracies_are_common() {
    let has =
        |what: fn(&[[f64; 2]]) -> bool| cases(2000).filter(|case| what(&case.points)).count() > 20;
    assert!(has(|points| pairs(points).any(|(p, q)| p == q)), "duplicates");
    assert!(has(|points| pairs(points).any(|(p, q)| p[0] == q[0] && p != q)), "shared");
    let near = |p: [f64; 2], q: [f64; 2]| p[1] == q[1] && nudged(p[0], 1) == q[0];
    assert!(has(|p| pairs(p).any(|(p, q)| p[1] == q[1] && nudged(p[0], 1) == q[0])), "nudged");
    assert!(near([1.0, 0.0], [nudged(1.0, 1), 0.0]));
    assert!(has(|points| points.iter().flatten().any(|x| x.is_subnormal())), "denormals");
    assert!(has(|points| points.iter().flatten().any(|x| x.abs() > 1e200)), "huge");
}

fn pairs(points: &[[f64; 2]]) -> impl Iterator<Item = ([f64; 2], [f64; 2])> + '_ {
    points
        .iter()
        .flat_map(|&p| points.iter().map(move |&q| (p, q)))
        .enumerate()
        .filter_map(|(place, pair)| (place % (points.len() + 1) != 0).then_some(pair))
}

#[test]
fn bytes_run_out_into_zeros() {
    let mut bytes = Bytes(&[7, 1, 2]);
    assert_eq!(bytes.below(5), 2);
    assert_eq!(bytes.below(1000), 513);
    assert_eq!((bytes.below(9), bytes.bits()), (0, 0));
    assert_eq!(Bytes(&[255]).integer(-3, 3), -3 + 255 % 7);
}
