//! Bytes a site, counted by the allocator: the most that an algorithm holds at once beyond the sites, and what its result keeps.
//!
//! ```sh
//! cargo run --release -p delone-delaunay --example memory_delaunay -- [ALGORITHM] [WORKLOAD] [SITES] [THREADS]
//! ```
//! `Sites::new` is on a line of its own: the most it holds beyond the points that it is given, and what it keeps.
#![expect(clippy::print_stdout, reason = "it prints bytes")]

use delone_delaunay::{Options, algorithms};
use delone_sites::Sites;
use delone_workloads::{Points, generate};
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

fn main() {
    let mut words = std::env::args().skip(1);
    let mut word = |default: &str| words.next().unwrap_or_else(|| default.to_owned());
    let (algorithm, workload) = (word("divide-conquer"), word("uniform"));
    let size = word("1000000").parse().expect("a number of sites");
    let threads = word("1").parse().expect("a number of threads, at least one");
    let options = Options { threads, ..Options::default() };
    match generate(&workload, size, 1).expect("a workload").points {
        Points::Plane(points) => tell(&algorithm, &points, &options),
        Points::Space(points) => tell(&algorithm, &points, &options),
    }
}

fn tell<const D: usize>(name: &str, points: &[[f64; D]], options: &Options) {
    let door = || Sites::new_in_parallel(points, options.threads).expect("finite points");
    let sites = told("Sites::new", points.len(), door);
    let algorithms = algorithms::<D>();
    let algorithm = algorithms.iter().find(|algorithm| algorithm.name == name);
    let algorithm = algorithm.expect("an algorithm of this dimension");
    told(name, sites.len(), || (algorithm.run)(&sites, options));
}

/// Runs it, and prints what it took and kept.
#[expect(clippy::cast_precision_loss, reason = "bytes are fewer than 2^53")]
fn told<T>(name: &str, count: usize, run: impl FnOnce() -> T) -> T {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let result = run();
    let [most, kept] = [MEMORY.peak_usage(), MEMORY.current_usage()].map(|bytes| bytes - before);
    let each = |bytes: usize| bytes as f64 / count as f64;
    println!(
        "{name:16} {count} sites: {:.1} bytes a site at the peak, {:.1} kept",
        each(most),
        each(kept)
    );
    result
}
