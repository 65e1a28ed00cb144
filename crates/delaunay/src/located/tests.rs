use super::*;
use crate::{Options, delaunay};

const ONE: NonZeroUsize = NonZeroUsize::MIN;
const TWO: NonZeroUsize = NonZeroUsize::new(2).unwrap();

/// What the point is, by barycentric signs against every solid cell.
fn naive<const D: usize>(mesh: &Mesh<D>, points: &[[f64; D]], q: [f64; D]) -> Vec<VertexId> {
    let all = [points, &[q]].concat();
    let kernel = delone_predicates::Exact::new(&all);
    let p = VertexId::new(points.len());
    for cell in mesh.solid_cells() {
        let mut corners = mesh.corners(cell).to_vec();
        let signs: Vec<Sign> = (0..=D)
            .map(|corner| {
                let vertex = std::mem::replace(&mut corners[corner], p);
                let sign = kernel.orient(&corners);
                corners[corner] = vertex;
                sign
            })
            .collect();
        if !signs.contains(&Sign::Negative) {
            let on = (0..=D).filter(|&corner| signs[corner] == Sign::Positive);
            let mut face: Vec<VertexId> = on.map(|corner| corners[corner]).collect();
            face.sort_unstable();
            return face;
        }
    }
    Vec::new()
}

fn face<const D: usize>(mesh: &Mesh<D>, located: Located<D>) -> Vec<VertexId> {
    let corners = |cell: CellId, keep: &dyn Fn(usize) -> bool| {
        let corners = mesh.corners(cell).iter().enumerate();
        corners.filter(|&(i, _)| keep(i)).map(|(_, &v)| v).collect::<Vec<_>>()
    };
    let mut face = match located {
        Located::Vertex(v) => vec![v],
        Located::Face { cell, corners: on } => corners(cell, &|i| on >> i & 1 == 1),
        Located::Facet(facet) => corners(facet.cell(), &|i| i != facet.corner()),
        Located::Cell(cell) => corners(cell, &|_| true),
        Located::Ghost(_) => Vec::new(),
    };
    face.sort_unstable();
    face
}

fn check<const D: usize>(points: &[[f64; D]], queries: &[[f64; D]]) {
    let sites = Sites::new(points).unwrap();
    let triangulation = delaunay(&sites, &Options::default(), &mut ());
    let mesh = triangulation.mesh();
    let found = locate(mesh, &sites, queries, ONE).unwrap();
    for (&q, &located) in queries.iter().zip(&found) {
        assert_eq!(face(mesh, located), naive(mesh, sites.points(), q), "{q:?}: {located:?}");
    }
    assert_eq!(found, locate(mesh, &sites, queries, TWO).unwrap(), "two threads");
}

fn lattice<const D: usize>(side: u32, count: u32, scale: f64) -> Vec<[f64; D]> {
    let point = |mut i: u32| {
        [(); D].map(|()| {
            let x = i % side;
            i /= side;
            f64::from(x) * scale
        })
    };
    (0..count).map(point).collect()
}

#[test]
fn every_face_of_a_lattice_is_told() {
    let around = |p: [f64; 2]| p.map(|x| x - 1.0);
    let queries: Vec<[f64; 2]> = lattice(11, 121, 0.5).into_iter().map(around).collect();
    check::<2>(&lattice(4, 16, 1.0), &queries);
    let around = |p: [f64; 3]| p.map(|x| x - 0.5);
    let queries: Vec<[f64; 3]> = lattice(7, 343, 0.5).into_iter().map(around).collect();
    check::<3>(&lattice(3, 27, 1.0), &queries);
}

#[test]
fn many_points_on_two_threads() {
    let sites: Vec<[f64; 2]> =
        (0..300u32).map(|i| [i * 37 % 311, i * i % 293].map(f64::from)).collect();
    let queries: Vec<[f64; 2]> =
        (0..4000u32).map(|i| [i * 97 % 331, i * i % 317].map(f64::from)).collect();
    check(&sites, &queries);
}

#[test]
fn flat_meshes_are_refused() {
    let sites = Sites::new(&[[0.0, 0.0], [1.0, 1.0]]).unwrap();
    let mesh = delaunay(&sites, &Options::default(), &mut ()).into_mesh();
    let refused = locate(&mesh, &sites, &[[0.0, 0.0]], ONE).unwrap_err();
    assert_eq!(refused, LocateError::Flat(Some(1)));
    assert!(refused.to_string().contains("dimension 1"));
    let sites = Sites::new(&[[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]]).unwrap();
    let mesh = delaunay(&sites, &Options::default(), &mut ()).into_mesh();
    let refused = locate(&mesh, &sites, &[[0.0, f64::NAN]], ONE);
    assert!(matches!(refused, Err(LocateError::Points(_))));
    assert_eq!(locate(&mesh, &sites, &[], TWO), Ok(Vec::new()));
}
