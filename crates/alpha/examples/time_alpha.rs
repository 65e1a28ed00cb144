//! Times the alpha filtration and its persistence: the triangulation by the algorithm that is taken if nothing speaks for another.
//!
//! `cargo run --release -p delone-alpha --example time_alpha -- WORKLOAD N [FILE]`, for a workload of points of the plane or of
//! space. With a file: writes the sites there, as little-endian doubles, for other programs to time. `benches/alpha.py` does.
#![expect(clippy::print_stdout, clippy::disallowed_methods, reason = "it times and tells")]

use std::time::Instant;

use delone_alpha::AlphaFiltration;
use delone_delaunay::{Options, algorithms};
use delone_sites::Sites;
use delone_workloads::generate;

fn time<const D: usize>(points: &[[f64; D]], file: Option<String>) {
    let start = Instant::now();
    let sites = Sites::new(points).expect("workloads are finite");
    let triangulation = (algorithms::<D>()[0].run)(&sites, &Options::default());
    let built = start.elapsed().as_secs_f64();
    let filtration = AlphaFiltration::of(&sites, &triangulation);
    let filtered = start.elapsed().as_secs_f64();
    let memory = peak();
    let persistence = filtration.persistence();
    let persisted = start.elapsed().as_secs_f64();
    let bars = persistence.bars(&filtration).len();
    println!(
        "{} sites, {} simplices, {} values: Delaunay {built:.3} s, filtration {:.3} s, persistence {:.3} s, {bars} bars, \
         peak {memory} KiB",
        sites.len(),
        filtration.simplices().len(),
        filtration.rank_count(),
        filtered - built,
        persisted - filtered,
    );
    if let Some(file) = file {
        let bytes: Vec<u8> =
            sites.points().as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
        std::fs::write(file, bytes).expect("the file can be written");
    }
}

/// The most memory that this process has held, in KiB, where the system tells; else 0.
fn peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.split_whitespace().next()?.parse().ok()).unwrap_or(0)
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_else(|| "uniform".to_owned());
    let n = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(100_000);
    let file = arguments.next();
    let input = generate(&name, n, 1).expect("a workload of `delone gen --list`");
    if let Some(points) = input.points.plane() {
        time(points, file);
    } else if let Some(points) = input.points.space() {
        time(points, file);
    }
}
