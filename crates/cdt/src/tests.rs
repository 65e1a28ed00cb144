use delone_delaunay::{KernelKind, Options, Order};
use delone_mesh::{HalfEdge, Level};
use delone_predicates::{Adaptive, Kernel, Side, Sign};
use delone_sites::Pslg;

use super::*;

/// The local criterion, and that flags are the subsegments: a small check of its own; the judge is elsewhere.
fn check(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Cdt {
    let pslg = Pslg::new(points, segments).unwrap();
    let cdt = cavity(&pslg, &Options::default(), &mut ());
    let mesh = cdt.mesh();
    assert_eq!(mesh.faults(Level::Sphere, pslg.sites().len()), [], "{points:?} {segments:?}");
    assert_eq!(cdt.constrained_edges(), pslg.subsegments(), "{points:?} {segments:?}");
    if mesh.dimension() == Some(2) {
        let kernel = Adaptive::new(pslg.sites().points());
        for cell in mesh.solid_cells() {
            assert_eq!(
                kernel.orient(mesh.corners(cell)),
                Sign::Positive,
                "{points:?} {segments:?}"
            );
            for h in mesh.facets(cell).filter(|&h| !cdt.is_constrained(h)) {
                let other = mesh.apex(mesh.twin(h));
                if !other.is_ghost() {
                    assert_eq!(kernel.in_sphere(mesh.corners(cell), other), Side::Negative);
                }
            }
        }
    }
    for (kernel, order) in
        [(KernelKind::Exact, Order::Lexicographic), (KernelKind::Adaptive, Order::AsGiven)]
    {
        let options = Options { kernel, order, seed: 5, ..Options::default() };
        let fitting = algorithms().into_iter().filter(|row| points.len() <= row.sites_max);
        for other in fitting.map(|algorithm| (algorithm.run)(&pslg, &options)) {
            assert_eq!(
                other.mesh().faults(Level::Sphere, pslg.sites().len()),
                [],
                "{points:?} {segments:?}"
            );
            assert_eq!(other.canonical(), cdt.canonical(), "{points:?} {segments:?}");
            assert_eq!(other.constrained_edges(), cdt.constrained_edges());
        }
    }
    cdt
}

#[test]
fn an_edge_that_is_there_is_only_marked() {
    let cdt = check(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], &[[2, 0]]);
    let marked = cdt
        .mesh()
        .facets(delone_mesh::CellId::new(0))
        .filter(|&h: &HalfEdge| cdt.is_constrained(h));
    assert_eq!(marked.count(), 1);
}

#[test]
fn a_dangling_edge_is_triangulated_on_both_sides() {
    // Vertex 4 hangs from the upper chain down to the segment 0-1: both triangles at its edge are crossed.
    let points = [
        [0.0, 0.0],
        [20.0, 0.0],
        [9.0, 9.0],
        [11.0, 9.0],
        [10.0, 0.125],
        [9.0, -9.0],
        [11.0, -9.0],
        [4.0, 0.25],
        [16.0, -0.25],
        [10.0, 3.0],
        [7.0, -0.0625],
        [13.0, 0.0625],
    ];
    check(&points, &[[0, 1]]);
}

#[test]
fn every_segment_of_a_grid_can_be_inserted() {
    let grid: Vec<[f64; 2]> = (0..25).map(|i| [f64::from(i / 5), f64::from(i % 5)]).collect();
    for a in 0..25 {
        for b in a + 1..25 {
            check(&grid, &[[a, b]]);
        }
    }
}

#[test]
fn chew_agrees_on_small_grids() {
    // Every subset of a 3x3 grid, bare and with each single segment.
    for mask in 1u32..512 {
        let points: Vec<[f64; 2]> = (0..9u32)
            .filter(|i| mask >> i & 1 == 1)
            .map(|i| [f64::from(i / 3), f64::from(i % 3)])
            .collect();
        check(&points, &[]);
        for b in 1..points.len() {
            check(&points, &[[mask as usize % b, b]]);
        }
    }
}

#[test]
fn chew_agrees_on_random_sets() {
    let mut state = 7u64;
    let mut next = |below: u64| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % below
    };
    for round in 0..300 {
        let side = 3 + round % 30;
        let points: Vec<[f64; 2]> =
            (0..4 + next(40)).map(|_| [next(side) as f64, next(side) as f64]).collect();
        let mut segments: Vec<[usize; 2]> = Vec::new();
        for _ in 0..60 {
            let pair = [next(points.len() as u64) as usize, next(points.len() as u64) as usize];
            segments.push(pair);
            if Pslg::new(&points, &segments).is_err() {
                segments.pop();
            }
        }
        check(&points, &segments);
    }
}

/// Enough sites that narrow slabs are cut across: lattices, where many heights are equal, with short segments and some long ones.
#[test]
fn chew_agrees_where_it_cuts_across() {
    let mut state = 11u64;
    let mut next = |below: u64| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % below
    };
    for round in 0..60 {
        let (columns, rows) = [(8, 12), (3, 40), (14, 14), (40, 4)][round % 4];
        let spread = 1 + 6 * (round as u64 % 3); // 1: a full lattice
        let points: Vec<[f64; 2]> = (0..columns * rows)
            .map(|i| [i % columns, i / columns].map(|x| x * spread))
            .map(|[x, y]| [(x + next(spread)) as f64, (y + next(spread)) as f64])
            .collect();
        let mut segments: Vec<[usize; 2]> = Vec::new();
        for attempt in 0..(points.len() as u64 * (round as u64 % 5) / 4) {
            let a = next(points.len() as u64);
            let b = if attempt % 16 == 0 {
                next(points.len() as u64)
            } else {
                a + 1 + next(2 * columns)
            };
            segments.push([a as usize, (b as usize).min(points.len() - 1)]);
            if Pslg::new(&points, &segments).is_err() {
                segments.pop();
            }
        }
        check(&points, &segments);
    }
}

#[test]
fn a_long_segment_through_many_spikes() {
    // Heights above and below the segment fall by powers of two: chains full of dangling edges.
    for n in [5, 20, 60u32] {
        let mut points = vec![[0.0, 0.0], [f64::from(n) + 1.0, 0.0]];
        for i in 1..=n {
            let height = f64::from(i * 7 % 5 + 1) / f64::from(1u32 << (i * 11 % 20));
            points.push([f64::from(i), if i % 2 == 0 { height } else { -height }]);
        }
        check(&points, &[[0, 1]]);
    }
}

#[test]
fn a_chain_has_its_segments() {
    let points = [[0.0, 0.0], [3.0, 3.0], [1.0, 1.0], [2.0, 2.0]];
    let cdt = check(&points, &[[0, 3]]);
    assert_eq!(cdt.mesh().dimension(), Some(1));
    assert_eq!(cdt.constrained_edges(), [[0, 2], [2, 3]]);
    assert_eq!(check(&[], &[]).canonical(), []);
    assert_eq!(check(&[[1.0, 1.0]; 3], &[[0, 1]]).canonical(), [0]);
}
