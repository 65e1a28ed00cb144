//! spade 2.15: Delaunay cells of ours equal spade's, by incremental insertion, within its documented range.
//!
//! Its `bulk_load` is not compared: it is known to be wrong within that range (`regressions/spade-bulk-load.node`).
//! spade breaks ties by the order of insertion, so cells are compared, not triangles. All sites in one line are left out:
//! spade has no cells then. Where we differ the judge and CGAL have the word.

use delone::cdt::cavity;
use delone::delaunay::{Options, delaunay};
use delone_tests::case::Case;
use delone_tests::cells::delaunay_cells;
use delone_tests::corpus::{Size, plane, pslgs};
use delone_tests::{id, say};
use spade::handles::FixedVertexHandle;
use spade::{
    ConstrainedDelaunayTriangulation, DelaunayTriangulation, Point2, Triangulation,
    validate_coordinate,
};

fn in_range(case: &Case<2>) -> bool {
    case.points.iter().flatten().all(|&x| validate_coordinate(x).is_ok())
}

/// The triangles, by order of insertion.
fn triangles(triangulation: &impl Triangulation<Vertex = Point2<f64>>) -> Vec<u32> {
    let faces = triangulation.inner_faces();
    let mut all: Vec<[u32; 3]> = faces.map(|f| f.vertices().map(|v| id(v.fix().index()))).collect();
    all.iter_mut().for_each(|t| t.sort_unstable());
    all.sort_unstable();
    all.concat()
}

/// Inserts all sites; their handles.
fn insert(
    into: &mut impl Triangulation<Vertex = Point2<f64>>,
    points: &[[f64; 2]],
) -> Vec<FixedVertexHandle> {
    points.iter().map(|&[x, y]| into.insert(Point2::new(x, y)).expect("in range")).collect()
}

#[test]
fn delaunay_cells_are_those_of_spade() {
    let (mut compared, mut left_out) = (0, 0);
    for case in plane(Size::Small).into_iter().chain(plane(Size::Middle)) {
        let sites = case.sites();
        let ours = delaunay(&sites, &Options::default(), &mut ());
        if !in_range(&case) || ours.mesh().dimension() != Some(2) {
            left_out += 1;
            continue;
        }
        let mut theirs = DelaunayTriangulation::<Point2<f64>>::new();
        insert(&mut theirs, sites.points());
        let cells = |triangles: &[u32]| delaunay_cells(sites.points(), triangles, 3, &[]);
        assert_eq!(cells(&ours.canonical()), cells(&triangles(&theirs)), "{}", case.name);
        compared += 1;
    }
    say(format!("spade, Delaunay: {compared} compared, {left_out} out of its range or in line"));
    assert!(compared > 100);
}

#[test]
fn constrained_cells_are_those_of_spade() {
    let (mut compared, mut left_out) = (0, 0);
    for case in pslgs(Size::Small).into_iter().chain(pslgs(Size::Middle)) {
        let pslg = case.pslg();
        let points = pslg.sites().points();
        let ours = cavity(&pslg, &Options::default(), &mut ());
        if !in_range(&case) || ours.mesh().dimension() != Some(2) {
            left_out += 1;
            continue;
        }
        let mut theirs = ConstrainedDelaunayTriangulation::<Point2<f64>>::new();
        let handles = insert(&mut theirs, points);
        for [a, b] in pslg.subsegments() {
            theirs.add_constraint(handles[*a as usize], handles[*b as usize]);
        }
        let edges = ours.constrained_edges();
        let cells = |triangles: &[u32]| delaunay_cells(points, triangles, 3, &edges);
        assert_eq!(cells(&ours.canonical()), cells(&triangles(&theirs)), "{}", case.name);
        assert_eq!(theirs.num_constraints(), edges.len(), "{}", case.name);
        compared += 1;
    }
    say(format!("spade, CDT: {compared} compared, {left_out} out of its range or in line"));
    assert!(compared > 50);
}
