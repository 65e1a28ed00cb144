//! Times the reading of a PSLG and the algorithms on it: nanoseconds a site, the median of several runs and the best one.
//!
//! ```sh
//! cargo run --release -p delone-cdt --example time_cdt -- [WORKLOAD] [SITES] [RUNS] [PART OF A ROW'S NAME] [SEGMENTS]
//! ```
#![expect(clippy::print_stdout, clippy::disallowed_methods, reason = "it prints times")]

use std::time::Instant;

use delone_cdt::{algorithms, chew_from_points, from_points};
use delone_delaunay::Options;
use delone_sites::{Pslg, Sites};
use delone_workloads::{Points, generate};

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let word = |i: usize, default: &str| words.get(i).map_or(default, |w| w).to_owned();
    let (workload, n) = (word(0, "random-segments"), word(1, "100000"));
    let (runs, part) = (word(2, "3").parse().expect("a number"), word(3, ""));
    let input = generate(&workload, n.parse().expect("a number"), 1).expect("a workload");
    let Points::Plane(points) = input.points else { panic!("{workload} is not planar") };
    let mut segments: Vec<[usize; 2]> =
        input.segments.iter().map(|ends| ends.map(|id| id as usize)).collect();
    segments.truncate(words.get(4).map_or(usize::MAX, |text| text.parse().expect("a number")));
    println!("{workload}: {} points, {} segments", points.len(), segments.len());
    let asked = |name: &str| name.contains(&part);
    if asked("Sites::new") {
        time("Sites::new", runs, points.len(), || Sites::new(&points).expect("finite points"));
    }
    if asked("from_points") {
        time("from_points", runs, points.len(), || {
            from_points(&points, &segments, &mut ()).expect("no crossings")
        });
    }
    if asked("chew_from_points") {
        time("chew_from_points", runs, points.len(), || {
            chew_from_points(&points, &segments, &mut ()).expect("no crossings")
        });
    }
    let chosen: Vec<_> =
        algorithms().into_iter().filter(|a| asked(a.name) && a.name != "naive").collect();
    if chosen.is_empty() && !asked("Pslg::new") {
        return;
    }
    let pslg = time("Pslg::new", runs, points.len(), || {
        Pslg::new(&points, &segments).expect("no crossings")
    });
    for algorithm in chosen {
        time(algorithm.name, runs, points.len(), || (algorithm.run)(&pslg, &Options::default()));
    }
}

fn time<T>(name: &str, runs: usize, count: usize, mut run: impl FnMut() -> T) -> T {
    #[expect(clippy::cast_precision_loss, reason = "a small number")]
    let count = count as f64;
    let mut times = Vec::new();
    loop {
        let start = Instant::now();
        let result = run();
        times.push(start.elapsed().as_secs_f64() * 1e9 / count);
        if times.len() >= runs {
            times.sort_by(f64::total_cmp);
            println!("{name:16} {:6.0} ns (best {:6.0})", times[times.len() / 2], times[0]);
            return result;
        }
    }
}
