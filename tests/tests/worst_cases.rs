//! The worst cases that workloads promise, counted: twice the sites cost four times as much in the order given, and not in ours.

use delone::cdt::{Algorithm, algorithms as cdt_algorithms};
use delone::delaunay::{Options, Order, algorithms};
use delone::probe::Counts;
use delone::workloads::{Points, find};
use delone::{Pslg, Sites};

fn sites(name: &str, n: usize) -> Sites<2> {
    match find(name).unwrap().generate(n, 1).points {
        Points::Plane(points) => Sites::new(&points).unwrap(),
        Points::Space(_) => panic!("{name} is in the plane"),
    }
}

fn counts(name: &str, n: usize, algorithm: &str, order: Order) -> Counts {
    let all = algorithms::<2>();
    let algorithm = all.iter().find(|known| known.name == algorithm).unwrap();
    let mut counts = Counts::default();
    let options = Options { order, ..Options::default() };
    (algorithm.run_counted)(&sites(name, n), &options, &mut counts);
    counts
}
