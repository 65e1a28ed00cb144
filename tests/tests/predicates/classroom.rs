//! The published lines of [KMPSY08]: plain doubles are wrong near each, the kernels are not.

use delone::predicates::{Adaptive, Exact, Kernel, Naive, Sign};
use delone::workloads::CLASSROOM;
use delone_tests::say;

use crate::oracle;

#[test]
fn naive_orientations_are_wrong_in_the_classroom() {
    for (number, case) in CLASSROOM.iter().enumerate() {
        let [q, r] = case.far;
        let (mut wrong, mut signs) = (0, [0; 3]);
        let every = 7; // of the 65,536: prime to the side
        for p in case.square(256).step_by(every) {
            let points = [q, r, p];
            let simplex = [0usize, 1, 2];
            let expected = oracle::orient(&[&q, &r, &p]);
            assert_eq!(Adaptive::new(points).orient(&simplex), expected, "{points:?}");
            assert_eq!(Exact::new(points).orient(&simplex), expected, "{points:?}");
            wrong += usize::from(Naive::new(points).orient(&simplex) != expected);
            signs[usize::try_from(expected as i8 + 1).expect("-1 to 1")] += 1;
        }
        say(format!("line {number}: {wrong} naive orientations wrong; {signs:?} by sign"));
        assert!(wrong > 1000, "line {number}: {wrong}");
        assert!(signs[0] > 1000 && signs[2] > 1000, "line {number}: {signs:?}");
        let zero = Naive::new([q, r, case.near]).orient(&[0usize, 1, 2]);
        assert!(number > 0 || zero == Sign::Zero, "the corner is on the first line");
    }
}
