//! What the suites of triangulations have in common: short runs, and sites a second.

use std::time::Duration;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput};
use delone::workloads::{Input, find};

/// Short enough that a suite ends within a minute.
pub(crate) fn criterion() -> Criterion {
    Criterion::default()
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_millis(500))
        .sample_size(10)
        .without_plots()
        .configure_from_args()
}

/// A workload's input under seed 1.
pub(crate) fn input(workload: &str, n: usize) -> Input {
    find(workload).expect("a workload").generate(n, 1)
}

pub(crate) fn group<'c>(
    criterion: &'c mut Criterion,
    name: &str,
    sites: usize,
) -> BenchmarkGroup<'c, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(sites as u64));
    group
}
