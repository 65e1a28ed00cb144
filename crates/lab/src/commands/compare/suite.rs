//! The built-in suite: every workload that an algorithm of this program takes.

use delone_workloads::{Kind, Workload, all};

use crate::failure::Failure;
use crate::subject::Subject;

/// Each workload without crossings: graphs and plane sets at about `n` sites, sets in space at a fifth of that, and what
/// is quadratic or needs the widest integers at a small size, so that the suite ends while one looks on.
pub(super) fn suite(n: usize, seed: u64) -> Result<Vec<Subject>, Failure> {
    // What a researcher looks at first comes first: graphs, then points of the plane, then space.
    let mut workloads: Vec<_> = all().iter().filter(|workload| !workload.crosses()).collect();
    workloads.sort_by_key(|workload| match workload.kind() {
        Kind::Pslg => (workload.name != "coast", 0),
        Kind::Points2d => (true, 1),
        Kind::Points3d => (true, 2),
    });
    workloads
        .into_iter()
        .map(|workload| {
            let input = workload.generate(sites(workload, n), seed);
            Subject::generated(workload.name, &input)
        })
        .collect()
}

/// Workloads with quadratically many cells, or coordinates over the full range of exponents.
const HEAVY: [&str; 4] = ["skew-lines", "moment-curve", "full-range", "full-range-3d"];

/// Workloads on which some algorithm flips quadratically many edges.
const FLIPPED: [&str; 1] = ["ladder"];

fn sites(workload: &Workload, n: usize) -> usize {
    if HEAVY.contains(&workload.name) {
        n / 100
    } else if FLIPPED.contains(&workload.name) {
        n / 10
    } else if workload.kind() == Kind::Points3d {
        n / 5
    } else {
        n
    }
}
