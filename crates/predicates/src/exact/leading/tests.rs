//! Leading terms against long sums: the same sign or none, on what they were made for and on what they must leave alone.

use super::*;
use crate::exact::long;
use crate::exact::testing::Random;

/// How many of `count` orientations and lifted determinants in D axes were decided, and how many of them were zero.
fn decided<const D: usize>(
    count: usize,
    mut point: impl FnMut(usize) -> [f64; D],
    mut weight: impl FnMut() -> Option<f64>,
) -> [[usize; 2]; 2] {
    let axes: [usize; D] = std::array::from_fn(|axis| axis);
    let mut counts = [[0; 2]; 2];
    let mut compare = |place: usize, near: Option<Sign>, exact: Sign, points: &[[f64; D]]| {
        if let Some(sign) = near {
            assert_eq!(sign, exact, "{points:?}");
            counts[place][0] += 1;
        }
        counts[place][1] += usize::from(exact == Sign::Zero);
    };
    for _ in 0..count {
        let points: Vec<[f64; D]> = (0..D + 2).map(&mut point).collect();
        let slices: Vec<&[f64]> = points.iter().map(<[f64; D]>::as_slice).collect();
        let weights: Option<Vec<f64>> = points.iter().map(|_| weight()).collect();
        let weights = weights.as_deref();
        let simplex = &slices[..=D];
        compare(0, orient(simplex, &axes), long::orient(simplex, &axes), &points);
        let exact = long::lifted(&slices, &axes, weights);
        compare(1, lifted(&slices, &axes, weights), exact, &points);
    }
    counts
}

#[test]
fn exponents_far_apart_are_decided() {
    let mut random = Random(1);
    for range in [350, 950] {
        let [[orient, _], [lifted, _]] =
            decided::<2>(300, |_| [0; 2].map(|_| random.wide(range)), || None);
        assert!(orient >= 285 && lifted >= 270, "{orient} {lifted} of 300");
        let [[orient, _], [lifted, _]] =
            decided::<3>(300, |_| [0; 3].map(|_| random.wide(range)), || None);
        assert!(orient >= 285 && lifted >= 270, "{orient} {lifted} of 300");
    }
}

#[test]
fn any_doubles_and_any_weights_have_the_sign_of_long_sums() {
    let (mut random, mut weights) = (Random(2), Random(3));
    let mut weight = || Some(weights.any());
    let [[orient, _], [lifted, _]] =
        decided::<2>(500, |_| [0; 2].map(|_| random.any()), &mut weight);
    assert!(orient > 400 && lifted > 400, "{orient} {lifted} of 500");
    decided::<3>(200, |_| [0; 3].map(|_| random.any()), &mut weight);
    decided::<5>(3, |_| [0; 5].map(|_| random.any()), &mut weight);
    decided::<2>(3000, |_| [0; 2].map(|_| random.power()), || None);
    decided::<3>(1000, |_| [0; 3].map(|_| random.power()), || None);
    let mut powers = Random(4);
    decided::<2>(1000, |_| [0; 2].map(|_| random.power()), || Some(powers.power()));
}

/// On a line or a plane through the origin that slants by `slope`, each coordinate rounded: a few roundings off a degenerate determinant.
fn slanted<const D: usize>(random: &mut Random, slope: f64) -> [f64; D] {
    let mut point = [0; D].map(|_| random.wide(200));
    point[D - 1] = point[..D - 1].iter().map(|x| slope * x).sum();
    point
}

#[test]
fn nearly_degenerate_determinants_are_left_alone() {
    let mut random = Random(5);
    // Exactly degenerate, and off by a rounding.
    for slope in [2.0, 3.0] {
        let [[orient, zeros], _] = decided::<2>(2000, |_| slanted(&mut random, slope), || None);
        assert!(orient < 20 || zeros < 1000, "{orient} decided, {zeros} zeros");
        decided::<3>(500, |_| slanted(&mut random, slope), || None);
    }
    // Turned by right angles about the origin: on a circle.
    let mut corner = [0.0; 2];
    let turned = |i: usize| {
        corner = if i == 0 { [0; 2].map(|_| random.wide(400)) } else { [-corner[1], corner[0]] };
        corner
    };
    let [_, [lifted, zeros]] = decided::<2>(1000, turned, || None);
    assert_eq!([lifted, zeros], [0, 1000]);
}

#[test]
fn errors_stay_within_the_bound_where_most_monomials_cancel() {
    // Mantissas of few bits next to full ones: the determinant is of the size of the roundings.
    let mut random = Random(6);
    let mut few = || {
        let x = f64::from(1 + random.below(3))
            * if random.below(2) == 0 { 1.0 } else { 2f64.powi(600) };
        x * (1.0 + f64::from(random.below(2)) * f64::EPSILON)
    };
    let [[orient, zeros], _] = decided::<2>(20_000, |_| [few(), few()], || None);
    assert!(orient > 10_000 && zeros > 100, "{orient} decided, {zeros} zeros");
    decided::<3>(2000, |_| [few(), few(), few()], || None);
}
