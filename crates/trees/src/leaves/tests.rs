use std::collections::{BTreeMap, BTreeSet};

use delone_predicates::{Sign, in_circle, orient2d};
use proptest::prelude::*;

use super::{Leaves, TrianglesFault};
use crate::testing::{raster, tree};
use crate::{Cell, Frame, Joined, OrthTree, Raster};

const BOTH: [Joined; 2] = [Joined::ByFacets, Joined::AtCorners];

/// Whether closed cells meet in a face of at least this dimension, by their corners.
fn touch<const N: usize>(a: Cell<N>, b: Cell<N>, joined: Joined, depth: u8) -> bool {
    let ((a, a_side), (b, b_side)) = (a.scaled(depth), b.scaled(depth));
    let shared = |axis: usize| {
        let low = a[axis].max(b[axis]);
        let high = (a[axis] + a_side).min(b[axis] + b_side);
        high.checked_sub(low)
    };
    let common: Option<Vec<u32>> = (0..N).map(shared).collect();
    common.is_some_and(|common| {
        let flat = common.iter().filter(|&&length| length == 0).count();
        flat == 1 || (flat > 0 && joined == Joined::AtCorners)
    })
}

fn queries_are_as_defined<const N: usize>(tree: &OrthTree<N>, lower: [u32; N], upper: [u32; N]) {
    let leaves = tree.leaves();
    let depth = tree.depth();
    assert_eq!(leaves.tree(), *tree);
    let cells: Vec<Cell<N>> = leaves.cells().collect();
    for (at, &cell) in cells.iter().enumerate() {
        for joined in BOTH {
            let near = |&other: &usize| touch(cell, cells[other], joined, depth);
            let expected: Vec<usize> = (0..cells.len()).filter(near).collect();
            assert_eq!(leaves.neighbours(at, joined), expected, "{cell:?}");
        }
    }
    let meets = |&leaf: &usize| {
        let (anchor, side) = cells[leaf].scaled(depth);
        (0..N).all(|axis| anchor[axis] <= upper[axis] && anchor[axis] + side > lower[axis])
    };
    let expected: Vec<usize> = match (0..N).all(|axis| lower[axis] <= upper[axis]) {
        true => (0..cells.len()).filter(meets).collect(),
        false => Vec::new(),
    };
    assert_eq!(leaves.within(lower, upper, depth), expected);
}

/// Leaves cut one by one where a neighbour is too small, until none is.
fn cut_until_balanced<const N: usize>(tree: &OrthTree<N>, joined: Joined) -> BTreeSet<Vec<u32>> {
    let depth = tree.depth();
    let mut cells: Vec<Cell<N>> = tree.leaves().cells().collect();
    loop {
        let too_large = |a: &Cell<N>| {
            cells.iter().any(|b| b.level() > a.level() + 1 && touch(*a, *b, joined, depth))
        };
        let Some(at) = cells.iter().position(too_large) else { break };
        let cell = cells.swap_remove(at);
        cells.extend((0..1 << N).map(|son| cell.son(son)));
    }
    cells.iter().map(named).collect()
}

fn named<const N: usize>(cell: &Cell<N>) -> Vec<u32> {
    cell.anchor().into_iter().chain([u32::from(cell.level())]).collect()
}

fn balance_is_coarsest<const N: usize>(tree: &OrthTree<N>) {
    let leaves = tree.leaves();
    for joined in BOTH {
        let balanced = leaves.balanced(joined);
        assert!(balanced.is_balanced(joined));
        assert_eq!(balanced.tree(), *tree);
        assert!(balanced.keys.is_sorted());
        let found: BTreeSet<Vec<u32>> = balanced.cells().map(|cell| named(&cell)).collect();
        assert_eq!(found, cut_until_balanced(tree, joined));
        assert_eq!(balanced.balanced(joined), balanced);
        assert_eq!(leaves.is_balanced(joined), leaves == balanced);
    }
}

/// The tree of a few dots, so that small leaves are beside large ones.
fn dots<const N: usize>(depth: u8, seeds: &[u64]) -> OrthTree<N> {
    let side = 1u64 << depth;
    let place = |seed: u64| -> [u32; N] {
        std::array::from_fn(|axis| u32::try_from((seed >> (8 * axis)) % side).unwrap())
    };
    let dots: Vec<[u32; N]> = seeds.iter().map(|&seed| place(seed)).collect();
    OrthTree::from_raster(&Raster::new(depth, |place| dots.contains(&place)).unwrap())
}

proptest! {
    #[test]
    fn boxes_have_the_leaves_that_meet_them(
        plane in tree::<2>(4), space in tree::<3>(2), line in tree::<1>(5),
        corners in prop::array::uniform2(prop::array::uniform3(0u32..16)),
    ) {
        let [a, b] = corners;
        queries_are_as_defined(&line, [a[0]], [b[0]]);
        queries_are_as_defined(&plane, [a[0], a[1]], [b[0], b[1]]);
        queries_are_as_defined(&space, a, b);
    }

    #[test]
    fn balance_is_the_coarsest(
        seeds in prop::collection::vec(any::<u64>(), 1..4), noise in raster::<2>(4),
    ) {
        balance_is_coarsest(&dots::<1>(6, &seeds));
        balance_is_coarsest(&dots::<2>(5, &seeds));
        balance_is_coarsest(&dots::<3>(3, &seeds));
        balance_is_coarsest(&OrthTree::from_raster(&noise));
    }

    #[test]
    fn triangles_conform_and_have_the_angles_of_the_templates(
        seeds in prop::collection::vec(any::<u64>(), 1..5), depth in 0u8..7,
    ) {
        let tree = dots::<2>(depth, &seeds);
        let frame = Frame::around(&[[0.0, 0.0], [1024.0, 1024.0]], depth).unwrap();
        for joined in BOTH {
            check(&tree.leaves().balanced(joined), &tree, &frame);
        }
    }
}

fn check(leaves: &Leaves<2>, tree: &OrthTree<2>, frame: &Frame<2>) {
    let mesh = leaves.triangles(frame).unwrap();
    let mut sides: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    let mut twice = [0.0; 2];
    for (corners, &inside) in mesh.triangles.iter().zip(&mesh.inside) {
        let [a, b, c] = corners.map(|v| mesh.points[v as usize]);
        assert_eq!(orient2d(a, b, c), Sign::Positive);
        twice[usize::from(inside)] += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        for [p, q, r] in [[a, b, c], [b, c, a], [c, a, b]] {
            // At q: not obtuse, and tan >= 1/2: 2 cross >= dot. Whole numbers, exactly.
            let (u, v) = ([p[0] - q[0], p[1] - q[1]], [r[0] - q[0], r[1] - q[1]]);
            let dot = u[0] * v[0] + u[1] * v[1];
            let cross = (u[0] * v[1] - u[1] * v[0]).abs();
            assert!(dot >= 0.0 && 2.0 * cross >= dot, "angle at {q:?}");
        }
        let [a, b, c] = *corners;
        for (side, apex) in [([a, b], c), ([b, c], a), ([c, a], b)] {
            assert_eq!(sides.insert(side, apex), None, "a side of one triangle only");
        }
    }
    // All of the square, and the black part; every side inside has a twin, and no apex is inside the other's circle.
    let black = tree.volume(frame.depth()).unwrap() as f64 * frame.resolution().powi(2);
    assert_eq!((twice[0] + twice[1], twice[1]), (2.0 * 1024.0 * 1024.0, 2.0 * black));
    for (&[a, b], &apex) in &sides {
        let [p, q] = [a, b].map(|v| mesh.points[v as usize]);
        let at_border = (0..2).any(|i| p[i] == q[i] && (p[i] == 0.0 || p[i] == 1024.0));
        match sides.get(&[b, a]) {
            None => assert!(at_border, "{p:?} {q:?} has no twin"),
            Some(&other) => {
                let [apex, other] = [apex, other].map(|v| mesh.points[v as usize]);
                assert_ne!(in_circle(p, q, apex, other), Sign::Positive, "not Delaunay");
            }
        }
    }
}

#[test]
fn leaves_are_found_by_the_cells_that_they_hold() {
    let leaves = OrthTree::<2>::from_text("(W(WBWBWW").unwrap().leaves();
    let holder = |x, y, level| leaves.holder(Cell::new([x, y], level).unwrap());
    assert_eq!(holder(0, 0, 0), None);
    assert_eq!(holder(0, 0, 1), Some(0));
    assert_eq!(holder(1, 0, 1), None);
    assert_eq!(holder(3, 0, 2), Some(2));
    assert_eq!(holder(7, 1, 3), Some(2));
    assert_eq!(holder(7, 7, 3), Some(6));
}

#[test]
fn what_is_not_balanced_is_not_triangulated() {
    let leaves = OrthTree::<2>::from_text("(W(WW(BWWWWWW").unwrap().leaves();
    let frame = Frame::around(&[[0.0, 0.0], [1.0, 1.0]], 3).unwrap();
    assert_eq!(leaves.triangles(&frame), Err(TrianglesFault::Unbalanced { leaf: 0 }));
    let shallow = Frame::around(&[[0.0, 0.0], [1.0, 1.0]], 2).unwrap();
    assert_eq!(leaves.triangles(&shallow), Err(TrianglesFault::TooFine { leaf: 3 }));
    assert!(leaves.balanced(Joined::ByFacets).triangles(&frame).is_ok());
}
