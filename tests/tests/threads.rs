//! One thread and two give the same bits, on every workload of the plane, from the points on.

use std::num::NonZeroUsize;

use delone::Sites;
use delone::delaunay::divide_conquer_in_parallel;
use delone::predicates::Adaptive;
use delone::workloads::{Points, all};

/// More than are worth a pool of threads, for the sites' order and for the mesh alike.
const SITES: usize = 40_000;

#[test]
fn one_thread_and_two_agree_on_every_workload() {
    let [one, two] = [1, 2].map(|threads| NonZeroUsize::new(threads).expect("not zero"));
    let mut tried = 0;
    for workload in all() {
        let Points::Plane(points) = workload.generate(SITES, 1).points else { continue };
        let sites = Sites::new(&points).expect("finite points");
        let name = workload.name;
        assert!(Sites::new_in_parallel(&points, two).expect("finite points") == sites, "{name}");
        let kernel = Adaptive::new(sites.points());
        let mesh = |threads| divide_conquer_in_parallel(&kernel, &sites, threads);
        assert!(mesh(one) == mesh(two), "{name}");
        tried += usize::from(sites.len() > 1 << 15);
    }
    assert!(tried >= 50, "{tried} workloads have enough different sites");
}
