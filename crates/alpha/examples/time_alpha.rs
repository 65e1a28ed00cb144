//! Times the alpha filtration and its persistence on uniform sites.
//!
//! `cargo run --release -p delone-alpha --example time_alpha -- WORKLOAD N`, for a workload of points of the plane or of space.
#![expect(clippy::print_stdout, clippy::disallowed_methods, reason = "it times and tells")]

use std::time::Instant;

use delone_alpha::AlphaFiltration;
use delone_delaunay::{Options, delaunay};
use delone_sites::Sites;
use delone_workloads::generate;

fn time<const D: usize>(points: &[[f64; D]]) {
    let start = Instant::now();
    let sites = Sites::new(points).expect("workloads are finite");
    let triangulation = delaunay(&sites, &Options::default(), &mut ());
    let built = start.elapsed().as_secs_f64();
    let filtration = AlphaFiltration::of(&sites, &triangulation);
    let filtered = start.elapsed().as_secs_f64();
    let persistence = filtration.persistence();
    let persisted = start.elapsed().as_secs_f64();
    let bars = persistence.bars(&filtration).len();
    println!(
        "{} sites, {} simplices, {} values: Delaunay {built:.3} s, filtration {:.3} s, persistence {:.3} s, {bars} bars",
        sites.len(),
        filtration.simplices().len(),
        filtration.rank_count(),
        filtered - built,
        persisted - filtered,
    );
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_else(|| "uniform".to_owned());
    let n = arguments.next().and_then(|n| n.parse().ok()).unwrap_or(100_000);
    let input = generate(&name, n, 1).expect("a workload of `delone gen --list`");
    if let Some(points) = input.points.plane() {
        time(points);
    } else if let Some(points) = input.points.space() {
        time(points);
    }
}
