//! Four, five and six dimensions: Qhull's cells in general position, the judge on what is as degenerate as can be.

use delone::delaunay::{Options, delaunay};
use delone::workloads::Rng;
use delone_tests::case::Case;
use delone_tests::judge::{Rigour, accept_delaunay};
use delone_tests::{qhull, say};

/// Points with coordinates that are multiples of 2^-20 in [0, 1): no five, six .. of them cospherical, as the judge sees.
fn scattered<const D: usize>(count: usize, seed: u64) -> Vec<[f64; D]> {
    let mut rng = Rng::named("dimensions", seed);
    let mut coordinate = || f64::from(u32::try_from(rng.below(1 << 20)).expect("20 bits"));
    (0..count).map(|_| std::array::from_fn(|_| coordinate() / f64::from(1 << 20))).collect()
}

fn equals_qhull<const D: usize>(sizes: &[usize]) {
    for (seed, &count) in (1..).zip(sizes) {
        let points = scattered::<D>(count, seed);
        let case = Case::of_points(format!("{count} points in {D} dimensions"), points);
        let sites = case.sites();
        let ours = delaunay(&sites, &Options::default(), &mut ());
        assert_eq!(ours.mesh().dimension(), Some(D), "{}", case.name);
        accept_delaunay(&case, &sites, &ours, Rigour::Once);
        let Some(theirs) = qhull::delaunay(sites.points()) else { continue };
        assert_eq!(ours.canonical(), theirs, "{}", case.name);
        say(format!("{}: Qhull has the same {} cells", case.name, theirs.len() / (D + 1)));
    }
}

#[test]
fn four_dimensions_equal_qhull() {
    equals_qhull::<4>(&[6, 20, 60]);
}

#[test]
fn five_dimensions_equal_qhull() {
    equals_qhull::<5>(&[7, 15, 30]);
}

#[test]
fn six_dimensions_equal_qhull() {
    equals_qhull::<6>(&[8, 12, 18]);
}

/// Corners of cubes, all cospherical, and of them subsets that lie in flats.
#[test]
fn corners_of_cubes() {
    fn check<const D: usize>(keep: impl Fn(u32) -> bool) {
        let corner = |i: u32| std::array::from_fn(|axis| f64::from(i >> axis & 1));
        let points: Vec<[f64; D]> = (0..1 << D).filter(|&i| keep(i)).map(corner).collect();
        let case = Case::of_points(format!("corners of the {D}-cube"), points);
        let sites = case.sites();
        let result = delaunay(&sites, &Options::default(), &mut ());
        accept_delaunay(&case, &sites, &result, Rigour::Once);
    }
    check::<4>(|_| true);
    check::<5>(|_| true);
    check::<6>(|i| i % 4 != 3);
    check::<5>(|i| i.count_ones() == 2); // in a hyperplane
    check::<6>(|i| i & 7 == 5); // in a flat of three dimensions
}
