//! Every predicate of both kernels against the oracle, in every class of input.

use delone::predicates::{
    Adaptive, Exact, Kernel, PlaneKernel, Sign, in_circle, in_sphere, orient2d, orient3d,
};
use delone::workloads::Rng;
use delone_tests::say;

use crate::inputs::{CLASSES, Class, points};
use crate::oracle;

/// Inputs of a class for one predicate.
fn rounds(class: Class) -> usize {
    match class {
        Class::Wild => 1200,
        _ => 4000,
    }
}

fn slices<const D: usize>(points: &[[f64; D]]) -> Vec<&[f64]> {
    points.iter().map(<[f64; D]>::as_slice).collect()
}

/// Runs `check` on `n` points at a time; it returns the sign, and each sign must come.
fn each<const D: usize>(name: &str, n: usize, mut check: impl FnMut(&[[f64; D]]) -> Sign) {
    let mut counts = [0usize; 3];
    for class in CLASSES {
        let mut rng = Rng::named(name, 1);
        for _ in 0..rounds(class) {
            let points = points::<D>(class, n, &mut rng);
            let sign = check(&points);
            counts[[Sign::Negative, Sign::Zero, Sign::Positive]
                .iter()
                .position(|&s| s == sign)
                .unwrap_or(0)] += 1;
        }
    }
    say(format!("{name}: {counts:?} negative, zero, positive, by each kernel"));
    assert!(counts.iter().all(|&count| count > 1000), "{name}: every sign comes: {counts:?}");
}

fn check_orient<const D: usize>(points: &[[f64; D]]) -> Sign {
    let ids: Vec<usize> = (0..=D).collect();
    let exact = oracle::orient(&slices(points));
    assert_eq!(Exact::new(points).orient(&ids), exact, "{points:?}");
    assert_eq!(Adaptive::new(points).orient(&ids), exact, "{points:?}");
    exact
}

fn check_lifted<const D: usize>(points: &[[f64; D]]) -> Sign {
    let ids: Vec<usize> = (0..=D).collect();
    let exact = oracle::lifted(&slices(points));
    assert_eq!(Exact::new(points).lifted(&ids, D + 1), exact, "{points:?}");
    assert_eq!(Adaptive::new(points).lifted(&ids, D + 1), exact, "{points:?}");
    exact
}

#[test]
fn orient_in_the_plane() {
    each::<2>("orient 2", 3, |points| {
        let sign = check_orient(points);
        assert_eq!(orient2d(points[0], points[1], points[2]), sign);
        sign
    });
}

#[test]
fn orient_in_space() {
    each::<3>("orient 3", 4, |points| {
        let sign = check_orient(points);
        assert_eq!(orient3d(points[0], points[1], points[2], points[3]), sign);
        sign
    });
}

#[test]
fn orient_in_four_dimensions() {
    each::<4>("orient 4", 5, check_orient);
}

#[test]
fn lifted_in_the_plane() {
    each::<2>("lifted 2", 4, |points| {
        let sign = check_lifted(points);
        assert_eq!(in_circle(points[0], points[1], points[2], points[3]), sign);
        sign
    });
}

#[test]
fn lifted_in_space() {
    each::<3>("lifted 3", 5, |points| {
        let sign = check_lifted(points);
        assert_eq!(in_sphere(points[0], points[1], points[2], points[3], points[4]), sign);
        sign
    });
}

#[test]
fn cross_in_the_plane() {
    each::<2>("cross", 4, |points| {
        let exact = oracle::cross([points[0], points[1], points[2], points[3]]);
        assert_eq!(Exact::new(points).cross([0usize, 1, 2, 3]), exact, "{points:?}");
        assert_eq!(Adaptive::new(points).cross([0usize, 1, 2, 3]), exact, "{points:?}");
        exact
    });
}
