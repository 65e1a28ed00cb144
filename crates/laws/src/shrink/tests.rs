use delone::workloads::generate;

use super::{Effort, cost, shrink};
use crate::case::Case;

fn uniform() -> Case<2> {
    let input = generate("uniform", 40, 1).unwrap();
    let segments = (1..40).map(|i| [i - 1, i]).collect();
    Case::new("case", input.points.plane().unwrap().to_vec(), segments)
}

#[test]
fn what_cannot_shrink_stays() {
    let case = Case::of_points("case", vec![[0.1, 5e-324], [3.0, -0.0]]);
    let same = shrink(&case, &mut Effort::default(), |other| *other == case);
    assert_eq!(same, case);
}

#[test]
fn nothing_shrinks_to_nothing() {
    let nothing = Case::<3>::of_points("case", vec![]);
    assert_eq!(shrink(&nothing, &mut Effort::default(), |_| true), nothing);
    assert!(shrink(&uniform(), &mut Effort::default(), |_| true).points.is_empty());
}

#[test]
fn effort_bounds_the_tests() {
    let (mut effort, mut tests) = (Effort { tests: 7 }, 0);
    shrink(&uniform(), &mut effort, |_| {
        tests += 1;
        true
    });
    assert!(tests <= 7, "{tests}");
    assert_eq!(effort.tests, 7 - tests);
}

/// A failure that needs three points to the left of one half and a segment between them: three points and a segment are left.
#[test]
fn only_what_fails_is_left() {
    let left = |case: &Case<2>, v: u32| case.points[v as usize][0] < 0.5;
    let fails = |case: &Case<2>| {
        let among = case.segments.iter().any(|&[a, b]| left(case, a) && left(case, b));
        among && case.points.iter().filter(|p| p[0] < 0.5).count() >= 3
    };
    let case = uniform();
    assert!(fails(&case));
    let small = shrink(&case, &mut Effort::default(), fails);
    assert_eq!((small.points.len(), small.segments.len()), (3, 1));
    assert!(small.points.as_flattened().iter().all(|x| [0.0, 1.0, 2.0].contains(x)), "{small:?}");
}

/// Four points on a circle far away become four points on a circle of small integers.
#[test]
fn numbers_become_small() {
    let factor = crate::exact::power_of_two(700);
    let far = [[33.0, 4.0], [32.0, 9.0], [4.0, 33.0], [-33.0, 4.0]].map(|p| p.map(|x| x * factor));
    let on_circle = |case: &Case<2>| {
        let kernel = delone::predicates::Exact::new(&case.points[..]);
        use delone::predicates::{Kernel, Sign};
        case.points.len() == 4
            && kernel.orient(&[0usize, 1, 2]) != Sign::Zero
            && kernel.lifted(&[0usize, 1, 2], 3) == Sign::Zero
    };
    let case = Case::of_points("case", far.to_vec());
    assert!(on_circle(&case));
    let small = shrink(&case, &mut Effort::default(), on_circle);
    assert!(small.points.as_flattened().iter().all(|x| x.abs() <= 33.0), "{small:?}");
}

#[test]
fn simple_numbers_cost_little() {
    let order = [0.0, 1.0, 3.0, -3.0, 33.0, 0.1, 1e300, f64::from_bits(0x3ff0_0000_0000_0001)];
    for pair in order[..6].windows(2) {
        assert!(cost(pair[0]) < cost(pair[1]), "{pair:?}");
    }
    assert!(cost(1e300) > cost(33.0) && cost(order[7]) > cost(33.0) && cost(5e-324) > cost(1.0));
}
