//! The corpus.

use delone::conforming::{ConformOptions, Limits, methods};
use delone_tests::corpus::{Size, pslgs};

use crate::{judged, promise};

/// Vertices that no input of the corpus needs.
const ENOUGH: Limits = Limits { vertices_max: 20_000 };

#[test]
fn all_methods_conform_on_the_corpus() {
    let options = ConformOptions { limits: ENOUGH, ..ConformOptions::default() };
    for case in pslgs(Size::Small).into_iter().chain(pslgs(Size::Middle)) {
        let pslg = case.pslg();
        let mut counts = Vec::new();
        for method in methods() {
            let result = (method.run)(&pslg, &options, &mut ());
            counts.push(result.steiner_points().len());
            assert!(result.is_complete(), "{} {}: {counts:?}", method.name, case.name);
            if result.mesh().dimension() != Some(2) {
                assert_eq!(result.steiner_points(), [], "{}", case.name);
                continue;
            }
            let verdict = judged(&pslg, &result, promise(&method));
            assert!(verdict.ok, "{} {}: {verdict}", method.name, case.name);
        }
        assert!(counts[0] <= counts[1], "{}: {counts:?}", case.name);
    }
}

#[test]
fn order_leaves_no_trace() {
    let options = ConformOptions { limits: ENOUGH, ..ConformOptions::default() };
    for case in pslgs(Size::Small) {
        let shuffled = case.shuffled(7);
        for method in methods() {
            let print =
                [&case, &shuffled].map(|case| (method.run)(&case.pslg(), &options, &mut ()));
            let [first, second] = print.map(|result| result.fingerprint());
            assert_eq!(first, second, "{} {}", method.name, case.name);
        }
    }
}
