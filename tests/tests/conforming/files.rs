//! The collected files: judged, and counted beside CGAL. Skipped, said aloud, where there are none. Without `DELONE_LONG=1` one in
//! ten, and only small ones.

use std::time::Instant;

use delone::check::Promise;
use delone::conforming::{ConformOptions, Limits, methods};
use delone_tests::case::Case;
use delone_tests::cgal::Cgal;
use delone_tests::data::{documents, files, pslg_of};
use delone_tests::{long, say};

use crate::{judged, promise};

/// The most sites taken.
fn sites_max() -> usize {
    if long() { 200_000 } else { 150 }
}

#[test]
fn all_methods_conform_on_files() {
    let mut cgal = Cgal::start();
    let mut ratios: [Vec<f64>; 2] = Default::default();
    let (mut seen, mut done, mut refused) = (0, 0, 0);
    for path in files("pslg") {
        for document in documents(&path) {
            let Some(case) = pslg_of(&document) else { continue };
            seen += 1;
            if case.points.len() > sites_max() || !long() && seen % 10 != 0 {
                continue;
            }
            if case.try_pslg().is_none() {
                refused += 1;
                continue;
            }
            done += 1;
            check(&case, &mut cgal, &mut ratios);
        }
    }
    say(format!("{done} graphs judged, {refused} refused: segments cross"));
    for (name, ratios) in ["delaunay", "gabriel"].iter().zip(&mut ratios) {
        ratios.sort_by(f64::total_cmp);
        if let (Some(median), n) = (ratios.get(ratios.len() / 2), ratios.len()) {
            let [low, high] = [ratios[n / 10], ratios[9 * n / 10]];
            say(format!("{name}: {n} graphs, ours / CGAL's {low:.3} {median:.3} {high:.3}"));
            assert!(*median <= 1.0, "{name}: no more Steiner points than CGAL's in the median");
        }
    }
}

fn check(case: &Case<2>, cgal: &mut Option<Cgal>, ratios: &mut [Vec<f64>; 2]) {
    let pslg = case.pslg();
    let vertices_max = 10 * pslg.sites().len() + if long() { 100_000 } else { 500 };
    let limits = Limits { vertices_max };
    let options = ConformOptions { limits, ..ConformOptions::default() };
    let mut row = format!("{} {}", case.name, pslg.sites().len());
    for (number, method) in methods().iter().enumerate() {
        let start = Instant::now();
        let result = (method.run)(&pslg, &options, &mut ());
        let seconds = start.elapsed().as_secs_f64();
        let ours = result.steiner_points().len();
        row += &format!(" | {} {ours}", method.name);
        if !result.is_complete() {
            row += " INCOMPLETE";
        }
        if result.mesh().dimension() != Some(2) {
            continue;
        }
        let promise = if result.is_complete() { promise(method) } else { Promise::Constrained };
        let verdict = judged(&pslg, &result, promise);
        assert!(verdict.ok, "{} {}: {verdict}", method.name, case.name);
        // On what takes too many, CGAL does not come back.
        let asked = number < 2 && result.is_complete() && !pslg.subsegments().is_empty();
        let Some(peer) = cgal.as_mut().filter(|_| asked) else { continue };
        let points = pslg.sites().points();
        match peer.conform(method.name, points, pslg.subsegments()) {
            Some([vertices, _]) => {
                let theirs = vertices - points.len();
                row += &format!(" ({theirs}; {seconds:.4} s, {:.4} s)", peer.seconds());
                if theirs + ours > 0 {
                    ratios[number].push(ours as f64 / theirs as f64);
                }
            }
            None => *cgal = Cgal::start(),
        }
    }
    say(row);
}
