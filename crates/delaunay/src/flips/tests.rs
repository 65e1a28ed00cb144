use delone_mesh::Level;
use delone_predicates::Adaptive;
use delone_probe::Counts;
use delone_sites::{Sites, scatter};

use super::*;
use crate::{Delaunay, Options, delaunay};

fn canonical(mesh: &Mesh<2>) -> Vec<u32> {
    mesh.canonical(|v| u32::try_from(v.index()).unwrap())
}

fn check(points: &[[f64; 2]]) -> (Sites<2>, Delaunay<2>) {
    let sites = Sites::new(points).unwrap();
    let expected = delaunay(&sites, &Options::default(), &mut ());
    let kernel = Adaptive::new(sites.points());
    for order in [sites.brio_order(1), sites.sorted().to_vec()] {
        let mesh = flips(&kernel, &order, &mut ());
        assert_eq!(mesh.faults(Level::Sphere, sites.len()), [], "{points:?}");
        assert_eq!(canonical(&mesh), expected.canonical(), "{points:?}");
        assert_eq!(mesh.dimension(), expected.mesh().dimension());
    }
    (sites, expected)
}

fn grid(width: u32, height: u32) -> Vec<[f64; 2]> {
    (0..width * height).map(|i| [f64::from(i / height), f64::from(i % height)]).collect()
}

#[test]
fn flips_agree_on_every_subset_of_a_grid() {
    let grid = grid(4, 3);
    for mask in 0u32..1 << 12 {
        let points: Vec<[f64; 2]> =
            (0..12).filter(|i| mask >> i & 1 == 1).map(|i| grid[i]).collect();
        check(&points);
    }
}

#[test]
fn a_site_on_an_edge_splits_two_triangles() {
    let kernel = Adaptive::new([[0.0, 0.0], [4.0, 0.0], [2.0, 3.0], [2.0, -3.0], [2.0, 0.0]]);
    let mut mesh = Mesh::from_cells(2, &[0, 1, 2, 1, 0, 3].map(VertexId::new)).unwrap();
    let (cell, p) = (CellId::new(0), VertexId::new(4));
    let mut cavity = Cavity::new();
    let made = split(&mut mesh, &kernel, cell, p, &mut cavity, &mut ());
    assert_eq!(cavity.rim().len(), 4);
    assert_eq!(mesh.ring(p, made).count(), 4);
    mesh.compact(|_, _| {});
    assert_eq!(mesh.faults(Level::Sphere, 5), []);
}

/// Random flips of strictly convex quadrilaterals: some other triangulation of the same sites.
fn shuffle(mesh: &mut Mesh<2>, kernel: &impl Kernel<2>, times: u64) {
    let facets = 3 * mesh.cell_count() as u64;
    for step in 0..times {
        let h = HalfEdge::from_index(usize::try_from(scatter(step) % facets).unwrap());
        let t = mesh.twin(h);
        let [a, b] = [mesh.origin(h), mesh.destination(h)];
        let [c, d] = [mesh.apex(h), mesh.apex(t)];
        let left = |corners: [VertexId; 3]| kernel.orient(&corners) == Sign::Positive;
        if [a, b, c, d].iter().all(|v| !v.is_ghost()) && left([a, d, c]) && left([d, b, c]) {
            mesh.flip(h);
        }
    }
}

#[test]
fn shuffled_grids_are_flipped_back() {
    for (width, height) in [(2, 2), (3, 3), (5, 4), (9, 9)] {
        let (sites, expected) = check(&grid(width, height));
        let kernel = Adaptive::new(sites.points());
        let mut mesh = expected.mesh().clone();
        shuffle(&mut mesh, &kernel, 3000);
        let mut counts = Counts::default();
        let flips = flip_to_delaunay(&mut mesh, &kernel, &mut counts);
        assert_eq!(counts.flips, flips);
        assert_eq!(canonical(&mesh), expected.canonical());
        assert_eq!(mesh.faults(Level::Sphere, sites.len()), []);
        assert_eq!(flip_to_delaunay(&mut mesh, &kernel, &mut ()), 0);
    }
}

#[test]
fn shuffled_random_sites_are_flipped_back() {
    let points: Vec<[f64; 2]> =
        (0..300u32).map(|i| [f64::from(i * 37 % 311), f64::from(i * i % 293)]).collect();
    let (sites, expected) = check(&points);
    let kernel = Adaptive::new(sites.points());
    let mut mesh = expected.mesh().clone();
    shuffle(&mut mesh, &kernel, 4000);
    assert_ne!(canonical(&mesh), expected.canonical(), "the shuffle did something");
    assert!(flip_to_delaunay(&mut mesh, &kernel, &mut ()) > 50);
    assert_eq!(canonical(&mesh), expected.canonical());
}

#[test]
fn lower_dimensions_have_nothing_to_flip() {
    let kernel = Adaptive::new([[0.0, 0.0], [1.0, 1.0]]);
    let mut mesh = flips(&kernel, &[1, 0], &mut ());
    assert_eq!(mesh.dimension(), Some(1));
    assert_eq!(flip_to_delaunay(&mut mesh, &kernel, &mut ()), 0);
}

#[test]
fn sites_in_random_order_take_fewer_than_three_flips_each() {
    let points: Vec<[f64; 2]> = (0..2000u64)
        .map(|i| [scatter(2 * i), scatter(2 * i + 1)].map(|bits| (bits >> 40) as f64))
        .collect();
    let sites = Sites::new(&points).unwrap();
    let mut counts = Counts::default();
    let kernel = Adaptive::new(sites.points());
    let as_given: Vec<u32> = (0..2000).collect(); // rounds along a curve are less random
    flips(&kernel, &as_given, &mut counts);
    // Degree 6 expected, of which a split gives 3.
    assert!((5000..6000).contains(&counts.flips), "{}", counts.flips);
}
