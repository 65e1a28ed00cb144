//! criterion's statistics of Delaunay triangulations: `2d/uniform/divide-conquer` and the like, from sites to a mesh.

mod common;

use delone::Sites;
use delone::delaunay::{Options, algorithms};
use delone::workloads::Points;

fn main() {
    let mut criterion = common::criterion();
    for workload in ["uniform", "clusters", "grid", "circle"] {
        let Points::Plane(points) = common::input(workload, 2000).points else { continue };
        run(&mut criterion, &format!("2d/{workload}"), &points);
    }
    for workload in ["uniform-3d", "grid-3d", "sphere"] {
        let Points::Space(points) = common::input(workload, 1000).points else { continue };
        run(&mut criterion, &format!("3d/{workload}"), &points);
    }
    criterion.final_summary();
}

fn run<const D: usize>(criterion: &mut criterion::Criterion, name: &str, points: &[[f64; D]]) {
    let sites = Sites::new(points).expect("workloads are finite");
    let mut group = common::group(criterion, name, sites.len());
    for algorithm in algorithms::<D>().iter().filter(|known| sites.len() <= known.sites_max) {
        let options = Options::default();
        group.bench_function(algorithm.name, |bencher| {
            bencher.iter(|| (algorithm.run)(&sites, &options));
        });
    }
}
