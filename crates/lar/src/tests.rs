use super::*;

fn complex(vertices: u32, cells: &[&[u32]]) -> Complex<1> {
    Complex::closure((0..vertices).map(|v| [f64::from(v)]).collect(), cells).unwrap()
}

fn betti(vertices: u32, cells: &[&[u32]]) -> [Vec<usize>; 2] {
    let complex = complex(vertices, cells);
    [Coefficients::Two, Coefficients::Rational].map(|field| complex.betti(field))
}

/// All faces of one dimension less.
fn sphere(k: u32) -> Vec<Vec<u32>> {
    (0..=k + 1).map(|out| (0..=k + 1).filter(|&v| v != out).collect()).collect()
}

fn slices(cells: &[Vec<u32>]) -> Vec<&[u32]> {
    cells.iter().map(Vec::as_slice).collect()
}

#[test]
fn small_spaces_have_their_betti_numbers() {
    for (vertices, cells, expected) in [
        (0, vec![], vec![]),
        (1, vec![], vec![1]),
        (3, vec![], vec![3]),
        (2, vec![vec![0, 1]], vec![1, 0]),
        (3, sphere(1), vec![1, 1]),
        (4, sphere(2), vec![1, 0, 1]),
        (5, sphere(3), vec![1, 0, 0, 1]),
        (5, vec![vec![0, 1, 2], vec![2, 3, 4]], vec![1, 0, 0]),
        (4, vec![vec![0, 1, 2], vec![0, 1, 3], vec![2, 3]], vec![1, 1, 0]),
    ] {
        assert_eq!(betti(vertices, &slices(&cells)), [expected.clone(), expected], "{cells:?}");
    }
}

/// Möbius' seven-vertex torus: {i, i+1, i+3} and {i, i+2, i+3} mod 7.
#[test]
fn the_torus_of_seven_vertices() {
    let mut cells = Vec::new();
    for i in 0..7u32 {
        cells.push([i, i + 1, i + 3].map(|v| v % 7).to_vec());
        cells.push([i, i + 2, i + 3].map(|v| v % 7).to_vec());
    }
    let torus = complex(7, &slices(&cells));
    assert_eq!((torus.counts(), torus.euler()), (vec![7, 21, 14], 0));
    assert_eq!(torus.betti(Coefficients::Two), [1, 2, 1]);
    assert_eq!(torus.betti(Coefficients::Rational), [1, 2, 1]);
}

/// The half of the icosahedron: over the rationals it has no second homology, over Z/2 it has.
#[test]
fn the_projective_plane_has_torsion() {
    let cells: [&[u32]; 10] = [
        &[0, 1, 4],
        &[0, 1, 5],
        &[0, 2, 3],
        &[0, 2, 5],
        &[0, 3, 4],
        &[1, 2, 3],
        &[1, 2, 4],
        &[1, 3, 5],
        &[2, 4, 5],
        &[3, 4, 5],
    ];
    let plane = complex(6, &cells);
    assert_eq!((plane.counts(), plane.euler()), (vec![6, 15, 10], 1));
    assert_eq!(plane.betti(Coefficients::Two), [1, 1, 1]);
    assert_eq!(plane.betti(Coefficients::Rational), [1, 0, 0]);
}

/// A hash as dice.
fn dice(seed: u64) -> impl FnMut(u32) -> u32 {
    let mut state = seed;
    move |below| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        u32::try_from(state >> 33).unwrap() % below
    }
}

fn random_cells(roll: &mut impl FnMut(u32) -> u32, vertices: u32) -> Vec<Vec<u32>> {
    let count = 1 + roll(12);
    let cell = |roll: &mut dyn FnMut(u32) -> u32| {
        let mut cell: Vec<u32> = (0..1 + roll(4)).map(|_| roll(vertices)).collect();
        let mut seen = Vec::new();
        cell.retain(|v| {
            !seen.contains(v) && {
                seen.push(*v);
                true
            }
        });
        cell
    };
    (0..count).map(|_| cell(roll)).collect()
}

#[test]
fn the_boundary_of_a_boundary_is_nothing() {
    let mut roll = dice(1);
    let mut entries = 0;
    for _ in 0..300 {
        let cells = random_cells(&mut roll, 8);
        let complex = complex(8, &slices(&cells));
        for k in 0..=4 {
            let (outer, inner) = (complex.boundary(k), complex.boundary(k + 1));
            entries += inner.nnz();
            let product = &outer.map(|&x| i32::from(x)) * &inner.map(|&x| i32::from(x));
            assert!(product.data().iter().all(|&entry| entry == 0), "{cells:?}");
            assert_eq!(complex.coboundary(k).to_dense(), inner.to_dense().t());
            let terms = (0..complex.cells(k).len()).map(|cell| (cell, i64::from(roll(7)) - 3));
            let chain = Chain::new(k, terms);
            assert!(chain.boundary(&complex).boundary(&complex).is_zero(), "{cells:?}");
        }
    }
    assert!(entries > 5000, "{entries}");
}

#[test]
fn betti_numbers_add_up_to_eulers_number() {
    let mut roll = dice(2);
    for _ in 0..300 {
        let cells = random_cells(&mut roll, 7);
        let complex = complex(7, &slices(&cells));
        for field in [Coefficients::Two, Coefficients::Rational] {
            let betti = complex.betti(field);
            let signed = |(k, &b): (usize, &usize)| {
                let b = i64::try_from(b).unwrap();
                if k % 2 == 0 { b } else { -b }
            };
            assert_eq!(betti.iter().enumerate().map(signed).sum::<i64>(), complex.euler());
            assert_eq!(betti[0], pieces(7, &cells), "{cells:?}");
        }
    }
}

/// Pieces, by joining names until nothing changes.
fn pieces(vertices: u32, cells: &[Vec<u32>]) -> usize {
    let mut name: Vec<u32> = (0..vertices).collect();
    for _ in 0..vertices {
        for cell in cells {
            let least = cell.iter().map(|&v| name[v as usize]).min().unwrap();
            cell.iter().for_each(|&v| name[v as usize] = least);
        }
    }
    name.sort_unstable();
    name.dedup();
    name.len()
}

#[test]
fn orientations_are_those_given() {
    let square = Complex::closure(
        vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        &[&[2, 0, 1], &[3, 0, 2], &[2, 1, 0]],
    )
    .unwrap();
    assert_eq!(square.orientations(2), [1, 1]); // 2 0 1 and 3 0 2 are turns; what came first counts
    let turned = complex(3, &[&[1, 0, 2], &[2, 0]]);
    assert_eq!((turned.orientations(2), turned.orientations(1)), (vec![-1], vec![1, -1, 1]));
    let area = Chain::new(2, square.orientations(2).into_iter().enumerate());
    // Counter-clockwise around the square; the diagonal 0-2 cancels.
    let around = area.boundary(&square);
    let named: Vec<(&[u32], i64)> =
        around.terms().map(|(edge, c)| (square.cells(1)[edge].as_slice(), c)).collect();
    assert_eq!(named, [(&[0, 1][..], 1), (&[0, 3], -1), (&[1, 2], 1), (&[2, 3], 1)]);
    assert_eq!(around.mod_2().terms().map(|(_, c)| c).collect::<Vec<_>>(), [1; 4]);
}

#[test]
fn every_cell_that_is_no_simplex_is_named() {
    let faults = Complex::closure(vec![[0.0]; 2], &[&[0, 1], &[], &[0, 0], &[5, 1]]).unwrap_err();
    assert_eq!(
        faults,
        [
            ComplexFault::Empty { cell: 1 },
            ComplexFault::Repeated { cell: 2, vertex: 0 },
            ComplexFault::NoSuchVertex { cell: 3, vertex: 5, count: 2 },
        ]
    );
}

#[test]
fn a_mesh_is_the_complex_of_its_solid_cells() {
    use delone_mesh::{Mesh, VertexId};
    let corners = [0, 1, 2].map(VertexId::new);
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let mesh = Mesh::<2>::simplex(&corners);
    assert_eq!(Complex::of_mesh(&points, &mesh, |_| true).counts(), [3, 3, 1]);
    assert_eq!(Complex::of_mesh(&points, &mesh, |_| false).counts(), [3]);
}
