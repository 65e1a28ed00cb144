//! criterion's statistics of the cells of `delone_benches::predicates`: time for 1,000 calls.
//!
//! Filters in batches are in the cells `batch/..`, constructed points in `constructed/..`.
//! A cell is `orient2d/G/robust` and the like; criterion takes a part of such a name as an argument.

use std::time::Duration;

use criterion::{Criterion, Throughput};
use delone_benches::predicates::{
    Contestant, Input, Predicate, batches, constructions, contestants, tuples,
};

const CALLS: usize = 1000;

fn main() {
    let mut criterion = Criterion::default()
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_millis(400))
        .sample_size(20)
        .without_plots()
        .configure_from_args();
    for predicate in Predicate::ALL {
        for input in Input::ALL {
            let name = format!("{}/{input:?}", predicate.name());
            compare(&mut criterion, name, contestants(predicate, &tuples(predicate, input, CALLS)));
        }
    }
    for (name, contestants) in batches(CALLS) {
        compare(&mut criterion, format!("batch/{name}"), contestants);
    }
    for (name, contestants) in constructions(CALLS) {
        compare(&mut criterion, format!("constructed/{name}"), contestants);
    }
    criterion.final_summary();
}

fn compare(criterion: &mut Criterion, name: String, contestants: Vec<Contestant>) {
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(CALLS as u64));
    for contestant in contestants {
        group.bench_function(contestant.name, |bencher| bencher.iter(&contestant.run));
    }
}
