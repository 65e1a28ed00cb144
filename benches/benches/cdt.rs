//! criterion's statistics of constrained Delaunay triangulations: `coast/chew` and the like, from a noded graph to a mesh.

mod common;

use delone::Pslg;
use delone::cdt::algorithms;
use delone::delaunay::Options;

fn main() {
    let mut criterion = common::criterion();
    for workload in ["coast", "random-segments", "ladder", "rails", "fan"] {
        let input = common::input(workload, 1000);
        let points = input.points.plane().expect("a workload of the plane");
        let segments: Vec<[usize; 2]> =
            input.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
        let pslg = Pslg::new(points, &segments).expect("these do not cross");
        let mut group = common::group(&mut criterion, workload, points.len());
        for algorithm in algorithms().iter().filter(|known| points.len() <= known.sites_max) {
            let options = Options::default();
            group.bench_function(algorithm.name, |bencher| {
                bencher.iter(|| (algorithm.run)(&pslg, &options));
            });
        }
        group.finish();
    }
    criterion.final_summary();
}
