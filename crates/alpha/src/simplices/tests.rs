use delone_delaunay::{Options, delaunay, regular};
use delone_sites::{Sites, WeightedSites};
use delone_workloads::Rng;

use super::*;

fn simplices<const D: usize>(points: &[[f64; D]]) -> Simplices {
    let sites = Sites::new(points).unwrap();
    Simplices::of(delaunay(&sites, &Options::default(), &mut ()).mesh())
}

fn counts(simplices: &Simplices) -> Vec<usize> {
    (0..=simplices.dimension().unwrap()).map(|k| simplices.of_dimension(k).len()).collect()
}

#[test]
fn few_sites_have_few_simplices() {
    assert_eq!(simplices::<2>(&[]).dimension(), None);
    assert!(simplices::<2>(&[]).is_empty());
    assert_eq!(counts(&simplices(&[[1.0, 2.0, 3.0]])), [1]);
    assert_eq!(counts(&simplices(&[[0.0, 0.0], [2.0, 2.0], [1.0, 1.0]])), [3, 2]);
    let square = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0]];
    assert_eq!(counts(&simplices(&square)), [4, 5, 2]);
    assert_eq!(counts(&simplices(&[[0.0], [1.0], [5.0]])), [3, 2]);
}

#[test]
fn hidden_sites_are_no_vertices() {
    let points = [[0.0, 0.0], [1.0, 1.0], [4.0, 0.0], [0.0, 4.0]];
    let sites = WeightedSites::new(&points, &[0.0, -9.0, 0.0, 0.0]).unwrap();
    let simplices = Simplices::of(regular(&sites, &Options::default(), &mut ()).mesh());
    assert_eq!(counts(&simplices), [3, 3, 1]);
    assert_eq!(simplices.find(&[1]), None);
    assert_eq!(simplices.vertices(SimplexId::new(6)), [0, 2, 3]);
}

/// Every face of every cell, by definition: all subsets of the cells' vertices.
#[test]
fn simplices_are_the_faces_of_the_cells() {
    let mut rng = Rng::new(2);
    let points: Vec<[f64; 4]> = (0..30).map(|_| [0; 4].map(|_| rng.below(5) as f64)).collect();
    let sites = Sites::new(&points).unwrap();
    let triangulation = delaunay(&sites, &Options::default(), &mut ());
    let simplices = Simplices::of(triangulation.mesh());
    let mut expected: Vec<Vec<u32>> = Vec::new();
    for cell in triangulation.canonical().chunks(5) {
        for set in 1..1u32 << 5 {
            expected.push((0..5).filter(|&i| set >> i & 1 == 1).map(|i| cell[i]).collect());
        }
    }
    expected.sort_by(|a, b| a.len().cmp(&b.len()).then_with(|| a.cmp(b)));
    expected.dedup();
    assert_eq!(simplices.len(), expected.len());
    for (id, vertices) in expected.iter().enumerate() {
        let simplex = SimplexId::new(id);
        assert_eq!(simplices.vertices(simplex), vertices);
        assert_eq!(simplices.find(vertices), Some(simplex));
        for (i, &facet) in simplices.facets(simplex).iter().enumerate() {
            let mut rest = vertices.clone();
            rest.remove(i);
            assert_eq!(simplices.vertices(SimplexId::new(facet as usize)), rest, "Inv 2");
        }
    }
}
