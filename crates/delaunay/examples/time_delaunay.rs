//! Times the algorithms, in the plane and in space: nanoseconds a site, the median of several runs and the best one, by the clock on
//! the wall and, where Linux tells it, on the processor. (That of the main thread alone: it says nothing where others
//! work for it.)
//!
//! ```sh
//! cargo run --release -p delone-delaunay --example time_delaunay -- \
//!     [--algorithms a,b] [--workloads uniform,grid] [--sizes 10000,1000000] [--threads 1,2] [--runs 5]
//! ```
//! The peak of memory is that of the program so far, with what came before, but not the input, which is dropped: run one case alone to know its own.
//! The last column hashes the cells: it must be one for all algorithms and numbers of threads.
#![expect(clippy::print_stdout, clippy::disallowed_methods, reason = "it prints times")]

use std::num::NonZeroUsize;
use std::time::Instant;

use delone_delaunay::{Options, algorithms};
use delone_sites::Sites;
use delone_workloads::{Points, generate};

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let ask = Ask {
        names: list(&words, "--algorithms", "bowyer-watson,divide-conquer"),
        threads: numbers(&words, "--threads", "1,2"),
        runs: numbers(&words, "--runs", "5")[0],
    };
    for workload in list(&words, "--workloads", "uniform,gauss,clusters,grid,circle") {
        for n in numbers(&words, "--sizes", "10000,100000,1000000") {
            match generate(&workload, n, 1).expect("a workload").points {
                Points::Plane(points) => time(&workload, points, &ask),
                Points::Space(points) => time(&workload, points, &ask),
            }
        }
    }
}

/// What to time.
struct Ask {
    names: Vec<String>,
    threads: Vec<usize>,
    runs: usize,
}

/// The words after `name`, parted at commas.
fn list(words: &[String], name: &str, default: &str) -> Vec<String> {
    let given = words.iter().skip_while(|word| *word != name).nth(1);
    given.map_or(default, |text| text).split(',').map(str::to_owned).collect()
}

fn numbers(words: &[String], name: &str, default: &str) -> Vec<usize> {
    let texts = list(words, name, default);
    texts.iter().map(|text| text.parse().expect("a number")).collect()
}

/// One workload at one size.
fn time<const D: usize>(workload: &str, points: Vec<[f64; D]>, ask: &Ask) {
    let n = points.len();
    for &threads in &ask.threads {
        let threads = NonZeroUsize::new(threads).expect("a thread");
        let sites = || Sites::new_in_parallel(&points, threads).expect("finite points");
        let (take, sites) = median(ask.runs, n, sites);
        println!("{workload:10} {:8} {:16} {take}  threads {threads}", sites.len(), "sites");
    }
    let sites = Sites::new(&points).expect("finite points");
    drop(points); // the sites have their own
    let asked = |name: &str| ask.names.iter().any(|asked| asked == name);
    for algorithm in algorithms::<D>().iter().filter(|algorithm| asked(algorithm.name)) {
        for &threads in &ask.threads {
            let threads = NonZeroUsize::new(threads).expect("a thread");
            let options = Options { threads, ..Options::default() };
            let (take, result) = median(ask.runs, n, || (algorithm.run)(&sites, &options));
            let peak = peak();
            let hash = result.fingerprint(&sites);
            println!(
                "{workload:10} {:8} {:16} {take}  threads {threads}  peak {peak}  {hash}",
                sites.len(),
                algorithm.name,
            );
            if algorithm.name != "divide-conquer" {
                break; // it has no use for threads
            }
        }
    }
}

/// The median times of `runs` runs, in nanoseconds for each of `count`, and the last result.
fn median<T>(runs: usize, count: usize, mut run: impl FnMut() -> T) -> (String, T) {
    let (mut wall, mut processor) = (Vec::new(), Vec::new());
    let count = f64::from(u32::try_from(count).expect("sites have ids of 32 bits"));
    loop {
        let (start, busy) = (Instant::now(), on_processor());
        let result = run();
        processor.push((on_processor() - busy) / count);
        wall.push(start.elapsed().as_secs_f64() * 1e9 / count);
        if wall.len() >= runs {
            wall.sort_by(f64::total_cmp);
            processor.sort_by(f64::total_cmp);
            let (middle, best) = (wall[runs / 2], wall[0]);
            let cpu = processor[runs / 2];
            let text = format!("wall {middle:5.0} ns (best {best:5.0})  cpu {cpu:5.0} ns");
            return (text, result);
        }
    }
}

/// The most memory that the program has held so far, points and sites included.
fn peak() -> String {
    let text = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.map_or_else(String::new, |size| size.trim().to_owned())
}

/// Nanoseconds that the main thread has spent on a processor; 0 if the system does not tell.
fn on_processor() -> f64 {
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    text.split(' ').next().and_then(|word| word.parse().ok()).unwrap_or(0.0)
}
