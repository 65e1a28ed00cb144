//! The corpus, and small grids.

use delone::Sites;
use delone::cdt::cavity;
use delone::delaunay::{Options, delaunay};
use delone::workloads::Rng;
use delone_tests::case::Case;
use delone_tests::cells::delaunay_cells;
use delone_tests::cgal::{Answer, Cgal};
use delone_tests::corpus::{Size, plane, pslgs, space};
use delone_tests::say;

use crate::equals_cgal;

fn compare_all<const D: usize>(cases: Vec<Case<D>>) {
    let Some(mut cgal) = Cgal::start() else { return };
    let count = cases.len();
    for case in cases {
        let sites = case.sites();
        let ours = delaunay(&sites, &Options::default(), &mut ());
        assert!(equals_cgal(&case.name, sites.points(), &ours, &mut cgal), "{}", case.name);
    }
    say(format!("CGAL, {D} dimensions: {count} equal, cell for cell"));
}

#[test]
fn point_sets_of_the_plane() {
    compare_all([plane(Size::Small), plane(Size::Middle)].concat());
}

#[test]
fn point_sets_of_space() {
    compare_all([space(Size::Small), space(Size::Middle)].concat());
}

/// Random subsets of a grid: the masks that 4,096 subsets of a 4 x 3 grid are, and as many of a 3 x 3 x 3 one.
#[test]
fn subsets_of_small_grids() {
    let Some(mut cgal) = Cgal::start() else { return };
    let flat: Vec<[f64; 2]> = (0..12u8).map(|i| [i / 3, i % 3].map(f64::from)).collect();
    let cube: Vec<[f64; 3]> = (0..27u8).map(|i| [i / 9, i / 3 % 3, i % 3].map(f64::from)).collect();
    let mut rng = Rng::named("grids", 1);
    for mask in 0..1u32 << 12 {
        check(&flat, mask, &mut cgal);
        let dense = rng.below(5) + 1;
        let mask = (0..27).filter(|_| rng.below(6) < dense).fold(0u32, |mask, i| mask | 1 << i);
        check(&cube, mask, &mut cgal);
    }
}

fn check<const D: usize>(grid: &[[f64; D]], mask: u32, cgal: &mut Cgal) {
    let points: Vec<[f64; D]> =
        (0u32..).zip(grid).filter(|(i, _)| mask >> i & 1 == 1).map(|(_, &p)| p).collect();
    let sites = Sites::new(&points).expect("finite");
    let ours = delaunay(&sites, &Options::default(), &mut ());
    assert!(equals_cgal(&format!("subset {mask:#b}"), &points, &ours, cgal));
}

#[test]
fn graphs() {
    let Some(mut cgal) = Cgal::start() else { return };
    let mut count = 0;
    for case in pslgs(Size::Small).into_iter().chain(pslgs(Size::Middle)) {
        assert!(constrained_equals_cgal(&case, &mut cgal), "{}: refused", case.name);
        count += 1;
    }
    say(format!("CGAL, constrained: {count} equal, cell for cell"));
}

/// Demands that CGAL finds the same constrained Delaunay triangulation; whether it answered.
pub(crate) fn constrained_equals_cgal(case: &Case<2>, cgal: &mut Cgal) -> bool {
    let pslg = case.pslg();
    let points = pslg.sites().points();
    let ours = cavity(&pslg, &Options::default(), &mut ());
    let Answer::Cells { cells, .. } = cgal.cdt(points, pslg.subsegments()) else {
        return false;
    };
    let corners = ours.mesh().corner_count();
    let edges = ours.constrained_edges();
    let united = |cells: &[u32]| delaunay_cells(points, cells, corners, &edges);
    assert_eq!(united(&ours.canonical()), united(&cells), "{}: Delaunay cells", case.name);
    assert_eq!(ours.canonical(), cells, "{}: ties", case.name);
    true
}
