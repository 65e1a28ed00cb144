//! Distilled sums against long sums: the same sign or none.

use super::*;
use crate::exact::long;
use crate::exact::testing::Random;

/// How many of `count` orientations were decided, and how many were zero; each decided one is right.
fn decided(count: usize, mut points: impl FnMut() -> [f64; 6]) -> [usize; 2] {
    let mut counts = [0; 2];
    for _ in 0..count {
        let values = points();
        let [a, b, c] = [&values[0..2], &values[2..4], &values[4..6]];
        let exact = long::orient(&[a, b, c], &[0, 1]);
        if let Some(sign) = orient2d(&values) {
            assert_eq!(sign, exact, "{values:?}");
            counts[0] += 1;
        }
        counts[1] += usize::from(exact == Sign::Zero);
    }
    counts
}

#[test]
fn distilled_sums_decide_wide_exponents_right() {
    let mut random = Random(5);
    let [decided, _] = decided(4000, || std::array::from_fn(|_| random.wide(449)));
    assert!(decided > 3900, "{decided} of 4000");
}

#[test]
fn distilled_sums_decide_points_of_a_line() {
    let mut random = Random(6);
    let [decided, zero] = decided(4000, || {
        let [a, b, c] = [0; 3].map(|_| random.wide(350));
        [a, 4.0 * a, b, 4.0 * b, c, 4.0 * c]
    });
    assert_eq!(zero, 4000);
    assert!(decided > 3900, "{decided} of 4000");
}

#[test]
fn distilled_sums_near_a_line_are_right() {
    let mut random = Random(7);
    let [decided, _] = decided(20_000, || {
        // Third points of a line through the others, up to the rounding of their coordinates.
        let [ax, ay, bx, by, t] = [0; 5].map(|_| random.wide(20));
        [ax, ay, bx, by, ax + t * (bx - ax), ay + t * (by - ay)]
    });
    assert!(decided > 15_000, "{decided} of 20000");
}

#[test]
fn distilled_sums_leave_numbers_beyond_the_range_alone() {
    let mut random = Random(8);
    for value in [5e-324, 2f64.powi(-451), 2f64.powi(450), f64::MAX] {
        let mut values: [f64; 6] = std::array::from_fn(|_| random.wide(3));
        for place in 0..6 {
            let kept = std::mem::replace(&mut values[place], value);
            assert_eq!(orient2d(&values), None);
            values[place] = kept;
        }
    }
    decided(20_000, || std::array::from_fn(|_| random.any()));
    decided(20_000, || std::array::from_fn(|_| random.power()));
}
