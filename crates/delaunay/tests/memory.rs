//! Bytes a site at the peak beyond the sites, counted by the allocator: they are the same for any number of sites, so few are enough.

use delone_delaunay::{Options, algorithms};
use delone_sites::Sites;
use delone_workloads::{Points, generate};
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// One test alone in its process: others would allocate beside it.
#[test]
fn the_peak_is_bounded() {
    for (workload, algorithm, most) in [
        ("uniform", "divide-conquer", 80),
        ("grid", "divide-conquer", 80),
        ("circle", "divide-conquer", 80),
        ("uniform-3d", "bowyer-watson", 300),
        ("grid-3d", "bowyer-watson", 300),
        ("sphere", "bowyer-watson", 300),
    ] {
        let bytes = match generate(workload, 30_000, 1).expect("a workload").points {
            Points::Plane(points) => peak(algorithm, &points),
            Points::Space(points) => peak(algorithm, &points),
        };
        assert!(bytes <= most, "{workload}: {bytes} bytes a site");
    }
}

fn peak<const D: usize>(name: &str, points: &[[f64; D]]) -> usize {
    let sites = Sites::new(points).expect("finite points");
    let algorithms = algorithms::<D>();
    let algorithm = algorithms.iter().find(|algorithm| algorithm.name == name);
    let algorithm = algorithm.expect("an algorithm of this dimension");
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let _result = (algorithm.run)(&sites, &Options::default());
    (MEMORY.peak_usage() - before).div_ceil(sites.len())
}
