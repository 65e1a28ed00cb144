//! The built-in suite: every workload that an algorithm of this program takes.

use delone_workloads::all;

use crate::failure::Failure;
use crate::subject::Subject;

/// Each workload without crossings, at about `n` sites.
pub(super) fn suite(n: usize, seed: u64) -> Result<Vec<Subject>, Failure> {
    // What a researcher looks at first comes first: graphs, then points of the plane, then space.
    let mut workloads: Vec<_> = all().iter().filter(|workload| !workload.crosses()).collect();
    workloads.sort_by_key(|workload| std::cmp::Reverse(workload.kind()));
    workloads.sort_by_key(|workload| workload.name != "coast");
    workloads
        .into_iter()
        .map(|workload| Subject::generated(workload.name, &workload.generate(n, seed)))
        .collect()
}
