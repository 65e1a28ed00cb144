use super::*;
use crate::{Options, delaunay, regular};

fn diagram_of<const D: usize>(points: &[[f64; D]]) -> (Delaunay<D>, Sites<D>) {
    let sites = Sites::new(points).unwrap();
    (delaunay(&sites, &Options::default(), &mut ()), sites)
}

fn polygon_area(polygon: &[[f64; 2]]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(p, q)| (p[0] * q[1] - p[1] * q[0]) / 2.0).sum()
}

#[test]
fn a_square_has_one_vertex_twice() {
    let (triangulation, sites) = diagram_of(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
    let diagram = PowerDiagram::of_delaunay(&triangulation, &sites).unwrap();
    let vertices: Vec<ExactPoint<2>> =
        triangulation.cells().map(|cell| diagram.vertex(cell)).collect();
    assert_eq!(vertices.len(), 2);
    assert_eq!(vertices[0], vertices[1]);
    assert_eq!(vertices[0].rounded(), [1.0, 1.0]);
    let segments = diagram.edges().filter(|(_, dual)| matches!(dual, Dual::Segment(_)));
    assert_eq!((segments.count(), diagram.edges().count()), (1, 5));
}

#[test]
fn rays_go_straight_away_from_the_hull() {
    let (triangulation, sites) =
        diagram_of(&[[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]]);
    let diagram = PowerDiagram::of_delaunay(&triangulation, &sites).unwrap();
    let mut rays: Vec<[i32; 3]> = triangulation
        .mesh()
        .ghost_cells()
        .map(|ghost| diagram.direction(ghost).map(|x| i32::try_from(x).unwrap()))
        .collect();
    rays.sort_unstable();
    assert_eq!(rays, [[-9, 0, 0], [0, -9, 0], [0, 0, -9], [9, 9, 9]]);
    let ghost = triangulation.mesh().ghost_cells().next().unwrap();
    assert!(diagram.direction_rounded(ghost).iter().all(|x| x.abs() <= 1.0));
}

#[test]
fn regions_of_the_hull_are_unbounded() {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 1.0]];
    let (triangulation, sites) = diagram_of(&points);
    let diagram = PowerDiagram::of_delaunay(&triangulation, &sites).unwrap();
    let mesh = triangulation.mesh();
    for site in 0..4 {
        let Some(Region::Unbounded { first, cells, last }) = diagram.region(site) else {
            panic!("site {site} is on the hull")
        };
        assert!(mesh.is_ghost(first) && mesh.is_ghost(last) && first != last);
        assert!(!cells.is_empty() && cells.iter().all(|&cell| !mesh.is_ghost(cell)));
    }
    let Some(Region::Bounded(cells)) = diagram.region(4) else { panic!("site 4 is inside") };
    let corners: Vec<[f64; 2]> = cells.iter().map(|&cell| diagram.vertex(cell).rounded()).collect();
    // The same region, cut from a window, whose corners start elsewhere.
    let polygon = diagram.polygon(4, [[-9.0, -9.0], [9.0, 9.0]]);
    assert!(polygon_area(&corners) > 0.0, "counter-clockwise");
    assert!((polygon_area(&corners) - polygon_area(&polygon)).abs() < 1e-12);
    assert_eq!(diagram.region(9), None);
}

#[test]
fn polygons_tile_the_window() {
    let points: Vec<[f64; 2]> =
        (0..60u32).map(|i| [i * 37 % 61, i * i % 53].map(f64::from)).collect();
    let window = [[-10.0, -10.0], [80.0, 70.0]];
    let total = |areas: f64| assert!((areas - 7200.0).abs() < 1e-8, "{areas}");
    let (triangulation, sites) = diagram_of(&points);
    let diagram = PowerDiagram::of_delaunay(&triangulation, &sites).unwrap();
    total((0..60).map(|site| polygon_area(&diagram.polygon(site, window))).sum());
    let weights: Vec<f64> = (0..60u32).map(|i| f64::from(i * 7 % 90)).collect();
    let sites = WeightedSites::new(&points, &weights).unwrap();
    let triangulation = regular(&sites, &Options::default(), &mut ());
    let diagram = PowerDiagram::of_regular(&triangulation, &sites).unwrap();
    total((0..60).map(|site| polygon_area(&diagram.polygon(site, window))).sum());
}

#[test]
fn a_hidden_site_has_no_region() {
    let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0]];
    let sites = WeightedSites::new(&points, &[0.0, 0.0, 0.0, -9.0]).unwrap();
    let triangulation = regular(&sites, &Options::default(), &mut ());
    let diagram = PowerDiagram::of_regular(&triangulation, &sites).unwrap();
    assert_eq!(diagram.region(3), None);
    assert!(diagram.polygon(3, [[0.0, 0.0], [1.0, 1.0]]).is_empty());
}

#[test]
fn flat_sites_have_no_diagram() {
    let (triangulation, sites) = diagram_of(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]);
    assert!(PowerDiagram::of_delaunay(&triangulation, &sites).is_none());
}
