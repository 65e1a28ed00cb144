//! The corpus.

use delone::conforming::{ConformOptions, Limits, methods};
use delone_tests::corpus::{Size, pslgs};
use delone_tests::judge;

/// With vertices that no input of the corpus needs.
fn enough() -> ConformOptions {
    ConformOptions { limits: Limits { vertices_max: 100_000 }, ..ConformOptions::default() }
}

#[test]
fn all_methods_conform_on_the_corpus() {
    for case in pslgs(Size::Small).into_iter().chain(pslgs(Size::Middle)) {
        let pslg = case.pslg();
        let mut counts = Vec::new();
        for method in methods() {
            let result = (method.run)(&pslg, &enough(), &mut ());
            counts.push(result.steiner_points().len());
            let name = format!("{} {}", method.name, case.name);
            assert!(result.is_complete(), "{name}: {counts:?}");
            if result.mesh().dimension() != Some(2) {
                assert_eq!(result.steiner_points(), [], "{}", case.name);
                continue;
            }
            let verdict = judge::conforming(&pslg, &result, judge::promise(&method, &result));
            assert!(verdict.ok, "{name}: {verdict}");
        }
        assert!(counts[0] <= counts[1], "{}: {counts:?}", case.name);
    }
}

#[test]
fn order_leaves_no_trace() {
    for case in pslgs(Size::Small) {
        let shuffled = case.shuffled(7);
        for method in methods() {
            let options = enough();
            let print =
                [&case, &shuffled].map(|case| (method.run)(&case.pslg(), &options, &mut ()));
            let [first, second] = print.map(|result| result.fingerprint());
            assert_eq!(first, second, "{} {}", method.name, case.name);
        }
    }
}
