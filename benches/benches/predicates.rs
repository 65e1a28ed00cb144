//! criterion's statistics of the cells of `delone_benches::predicates`: time for 1,000 calls.
//!
//! A cell is `orient2d/G/robust` and the like; criterion takes a part of such a name as an argument.

use std::time::Duration;

use criterion::{Criterion, Throughput};
use delone_benches::predicates::{Input, Predicate, contestants, tuples};

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
            let mut group = criterion.benchmark_group(format!("{}/{input:?}", predicate.name()));
            group.throughput(Throughput::Elements(CALLS as u64));
            for contestant in contestants(predicate, &tuples(predicate, input, CALLS)) {
                group.bench_function(contestant.name, |bencher| bencher.iter(&contestant.run));
            }
        }
    }
    criterion.final_summary();
}
