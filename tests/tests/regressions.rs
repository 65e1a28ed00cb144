//! Every file of `regressions/` under all laws. The folder only grows.
//!
//! A file is a `.node` (points) or a `.poly` (points and segments) whose first line says which law was broken, as
//! `# law: NAME` (`judge` for what another program got wrong); the second what it was that went wrong.

use delone_laws::fuzz::{Input, Subject, targets};
use delone_tests::data::{points_of, pslg_of, regressions};
use delone_tests::laws::{constrained_laws, delaunay_laws, obey};

#[test]
fn every_regression_holds() {
    let all = regressions();
    assert!(all.len() >= 9, "{} regressions: the folder only grows", all.len());
    for (law, document) in &all {
        let known = law == "judge" || targets().iter().any(|t| t.laws().contains(&law.as_str()));
        assert!(known, "{}: no law is called `{law}`", document.name);
        if let Some(case) = points_of::<3>(document) {
            obey(&delaunay_laws(), &case);
        }
        if let Some(case) = points_of::<2>(document) {
            obey(&delaunay_laws(), &case);
        }
        if let Some(case) = pslg_of(document) {
            obey(&constrained_laws(), &case);
            // And the law that was broken, where only fuzzing asks for it.
            let asked = targets().into_iter().filter(|target| !target.is_canary());
            for mut target in asked.filter_map(|target| target.only(law)) {
                target.try_on(&Input::Plane(case.clone())).expect("the law holds now");
            }
        }
    }
}
