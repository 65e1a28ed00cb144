//! Laws of predicates: filters and integers say what numbers of any length say; and the law that does not hold.

use delone::predicates::{Adaptive, Dyadic, Exact, ExactOver, Kernel, Naive, Sign};
use delone::workloads::Rng;

use crate::case::Case;
use crate::laws::Law;

/// Simplices of a case that predicates are asked about.
const SIMPLICES_MAX: usize = 40;

/// Filters and integers say what numbers of any length say.
pub(in crate::fuzz) fn of_predicates<const D: usize>() -> Vec<Law<D>> {
    vec![Law { name: "signs", hold: |case| agree(case, &Adaptive::new(&case.points[..])) }]
}

/// A law that does not hold: that doubles are enough. A fuzzer that does not break it is blind.
pub(in crate::fuzz) fn canary() -> Vec<Law<2>> {
    vec![Law { name: "canary", hold: |case| agree(case, &Naive::new(&case.points[..])) }]
}

fn agree<const D: usize>(case: &Case<D>, kernel: &impl Kernel<D>) -> usize {
    if case.points.len() < D + 2 {
        return 0;
    }
    let fixed = Exact::new(&case.points[..]);
    let any = ExactOver::<Dyadic, _>::new(&case.points[..]);
    let mut rng = Rng::named("signs", 1);
    for _ in 0..SIMPLICES_MAX {
        let mut vertices: Vec<usize> = (0..case.points.len()).collect();
        rng.shuffle(&mut vertices);
        let (mut simplex, q) = (vertices[..=D].to_vec(), vertices[D + 1]);
        let sign = any.orient(&simplex);
        assert_eq!(fixed.orient(&simplex), sign, "{}: exact orient {simplex:?}", case.name);
        assert_eq!(kernel.orient(&simplex), sign, "{}: orient {simplex:?}", case.name);
        match sign {
            Sign::Zero => continue,
            Sign::Negative => simplex.swap(0, 1),
            Sign::Positive => {}
        }
        let sign = any.lifted(&simplex, q);
        assert_eq!(fixed.lifted(&simplex, q), sign, "{}: exact lifted {simplex:?}", case.name);
        assert_eq!(kernel.lifted(&simplex, q), sign, "{}: lifted {simplex:?} {q}", case.name);
    }
    SIMPLICES_MAX
}
