use delone_mesh::{CellId, FacetId, Level, Mesh, VertexId};
use delone_predicates::Adaptive;
use delone_probe::Counts;
use delone_sites::Sites;

use super::*;

mod structure;

const ORDERS: [Order; 4] = [Order::Brio, Order::Hilbert, Order::AsGiven, Order::Lexicographic];

fn check<const D: usize>(points: &[[f64; D]]) -> Delaunay<D> {
    let sites = Sites::new(points).unwrap();
    let first = delaunay(&sites, &Options::default(), &mut ());
    assert_eq!(first.mesh().faults(Level::Sphere, sites.len()), [], "{points:?}");
    for order in ORDERS {
        for kernel in [KernelKind::Adaptive, KernelKind::Exact] {
            let options = Options { order, kernel, seed: 3, ..Options::default() };
            assert_eq!(
                delaunay(&sites, &options, &mut ()).canonical(),
                first.canonical(),
                "{points:?}"
            );
        }
    }
    if first.mesh().dimension() == Some(D) {
        let naive = naive_delaunay(&Adaptive::new(sites.points()), sites.len());
        assert_eq!(first.canonical(), naive, "{points:?}");
    }
    first
}

#[test]
fn few_sites_have_their_dimension() {
    for (n, dimension) in [(0, None), (1, Some(0)), (2, Some(1)), (3, Some(2))] {
        let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        assert_eq!(check(&points[..n]).mesh().dimension(), dimension);
    }
    assert_eq!(check(&[[2.0, 2.0, 2.0]; 5]).mesh().dimension(), Some(0));
}

#[test]
fn sites_in_a_flat_are_triangulated_in_it() {
    let line: Vec<[f64; 3]> =
        [5, 1, 4, 2, 3].map(|i| [f64::from(i), f64::from(2 * i), 1.0]).to_vec();
    let chain = check(&line);
    assert_eq!(chain.mesh().dimension(), Some(1));
    assert_eq!(chain.canonical(), [0, 2, 1, 3, 2, 4, 3, 4]);
    let plane: Vec<[f64; 3]> = (0..16)
        .map(|i| [f64::from(i / 4), f64::from(i % 4), f64::from(i / 4 + 3 * (i % 4))])
        .collect();
    let in_space = check(&plane);
    assert_eq!(in_space.mesh().dimension(), Some(2));
    assert_eq!(in_space.canonical().len(), 3 * 18);
}

#[test]
fn a_grid_has_one_triangulation() {
    let square: Vec<[f64; 2]> = (0..25).map(|i| [f64::from(i / 5), f64::from(i % 5)]).collect();
    assert_eq!(check(&square).canonical().len(), 3 * 32);
    let cube: Vec<[f64; 3]> =
        (0..18).map(|i| [f64::from(i / 6), f64::from(i / 2 % 3), f64::from(i % 2)]).collect();
    check(&cube);
}

/// A triangle 0 1 2 and its ghosts; then vertex 3 somewhere.
fn triangle_and(point: [f64; 2]) -> (Mesh<2>, Adaptive<[[f64; 2]; 4]>) {
    let mesh = Mesh::simplex(&[0, 1, 2].map(VertexId::new));
    (mesh, Adaptive::new([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], point]))
}

fn ghost_at_first_edge(mesh: &Mesh<2>) -> CellId {
    mesh.twin(FacetId::new(CellId::new(0), 2)).cell()
}

#[test]
fn a_site_on_a_hull_edge_takes_its_ghost() {
    let (mesh, kernel) = triangle_and([1.0, 0.0]);
    assert!(in_conflict(&mesh, &kernel, ghost_at_first_edge(&mesh), VertexId::new(3), &mut ()));
    check(&[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 0.0]]);
}

#[test]
fn beyond_a_hull_facet_spares_the_ghost() {
    let (mesh, kernel) = triangle_and([5.0, 0.0]);
    assert!(!in_conflict(&mesh, &kernel, ghost_at_first_edge(&mesh), VertexId::new(3), &mut ()));
    check(&[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [5.0, 0.0]]);
}

#[test]
fn a_site_on_an_edge_is_found_from_both_sides() {
    let sites = Sites::new(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]).unwrap();
    let mesh = delaunay(&sites, &Options::default(), &mut ()).into_mesh();
    let kernel = Adaptive::new([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [2.0, 2.0]]);
    for start in mesh.cells() {
        let found = walk(&mesh, &kernel, start, VertexId::new(4), &mut Coin::default(), &mut ());
        assert!(
            !mesh.is_ghost(found) && in_conflict(&mesh, &kernel, found, VertexId::new(4), &mut ())
        );
    }
}

#[test]
fn every_subset_of_a_three_by_three_grid() {
    for mask in 0u32..512 {
        let points: Vec<[f64; 2]> = (0..9u32)
            .filter(|i| mask >> i & 1 == 1)
            .map(|i| [f64::from(i / 3), f64::from(i % 3)])
            .collect();
        check(&points);
    }
}

#[test]
fn every_order_of_six_sites_gives_one_mesh() {
    let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [0.0, 2.0], [2.0, 2.0], [1.0, 0.0]];
    let kernel = Adaptive::new(points);
    let mut order = [0u32, 1, 2, 3, 4, 5];
    let canonical = |order: &[u32]| {
        bowyer_watson(&kernel, order, &mut ()).canonical(|v| u32::try_from(v.index()).unwrap())
    };
    let first = canonical(&order);
    let mut counters = [0; 6];
    let mut i = 0; // Heap's algorithm
    while i < 6 {
        if counters[i] < i {
            order.swap(if i % 2 == 0 { 0 } else { counters[i] }, i);
            assert_eq!(canonical(&order), first, "{order:?}");
            counters[i] += 1;
            i = 0;
        } else {
            counters[i] = 0;
            i += 1;
        }
    }
}

#[test]
fn four_dimensions_agree_with_the_definition() {
    let points: Vec<[f64; 4]> =
        (0..10u32).map(|i| [i * i % 7, i * 3 % 5, i * i * i % 11, i % 3].map(f64::from)).collect();
    assert_eq!(check(&points).mesh().dimension(), Some(4));
}

#[test]
fn a_fingerprint_does_not_depend_on_the_order_of_input() {
    let points: Vec<[f64; 2]> =
        (0..60u32).map(|i| [f64::from(i * 37 % 61), f64::from(i * i % 53)]).collect();
    let mut reversed = points.clone();
    reversed.reverse();
    let print = |points: &[[f64; 2]]| {
        let sites = Sites::new(points).unwrap();
        delaunay(&sites, &Options::default(), &mut ()).fingerprint(&sites)
    };
    assert_eq!(print(&points), print(&reversed));
    assert_ne!(print(&points), print(&points[1..]));
    assert_eq!(print(&points).to_string().len(), 32);
}

#[test]
fn counts_are_told() {
    let points: Vec<[f64; 2]> =
        (0..200u32).map(|i| [f64::from(i * 37 % 211), f64::from(i * i % 199)]).collect();
    let sites = Sites::new(&points).unwrap();
    let mut counts = Counts::default();
    let result = delaunay(&sites, &Options::default(), &mut counts);
    assert_eq!(counts.sites, 197);
    assert_eq!(counts.cells_made - counts.cavity_cells + 4, result.mesh().cell_count() as u64);
}
