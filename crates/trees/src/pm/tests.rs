use proptest::prelude::*;

use crate::{Cell, Frame, PmRule, PmTree};

const RULES: [PmRule; 3] = [PmRule::Pm1, PmRule::Pm2, PmRule::Pm3];

type Int = i64;

/// Whether a + t (b - a) is in the closed box for a t of [0, 1], in whole numbers.
fn meets([a, b]: [[Int; 2]; 2], lower: [Int; 2], upper: [Int; 2]) -> bool {
    let (mut above, mut below) = (vec![(0, 1)], vec![(1, 1)]); // bounds of t, as fractions
    for axis in 0..2 {
        let way = b[axis] - a[axis];
        let (low, high) = (lower[axis] - a[axis], upper[axis] - a[axis]);
        if way == 0 && (low > 0 || high < 0) {
            return false;
        }
        if way > 0 {
            above.push((low, way));
            below.push((high, way));
        } else if way < 0 {
            above.push((-high, -way));
            below.push((-low, -way));
        }
    }
    above.iter().all(|p| below.iter().all(|q| p.0 * q.1 <= q.0 * p.1))
}

/// Whether the rule holds of what is in a cell, from its words.
fn keeps(rule: PmRule, vertices: &[usize], edges: &[[usize; 2]]) -> bool {
    let common = (0..100).any(|vertex| edges.iter().all(|edge| edge.contains(&vertex)));
    let own = |vertex: usize| edges.iter().all(|edge| edge.contains(&vertex));
    match rule {
        PmRule::Pm3 => vertices.len() <= 1,
        PmRule::Pm2 => match vertices {
            [] => common,
            [vertex] => own(*vertex),
            _ => false,
        },
        PmRule::Pm1 => match vertices {
            [] => edges.len() <= 1,
            [vertex] => own(*vertex),
            _ => false,
        },
    }
}

proptest! {
    #[test]
    fn leaves_hold_what_they_meet(
        points in prop::collection::vec(prop::array::uniform2(0i8..16), 1..8),
        pairs in prop::collection::vec([0usize..8, 0usize..8], 0..6), depth in 0u8..6,
    ) {
        let segments: Vec<[usize; 2]> = pairs.iter().map(|p| p.map(|v| v % points.len())).collect();
        let sites: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::from)).collect();
        let frame = Frame::around(&[[0.0, 0.0], [16.0, 16.0]], depth).unwrap();
        // Twice everything: the smallest cells of depth 5 have side 1/2.
        let twice = |v: usize| points[v].map(|c| 2 * Int::from(c));
        let content = |cell: Cell<2>| {
            let (anchor, side) = cell.scaled(5);
            let lower = anchor.map(Int::from);
            let upper = lower.map(|c| c + Int::from(side));
            let holds = |&v: &usize| meets([twice(v); 2], lower, upper);
            let vertices: Vec<usize> = (0..points.len()).filter(holds).collect();
            let is_met = |&e: &usize| meets(segments[e].map(twice), lower, upper);
            let edges: Vec<usize> = (0..segments.len()).filter(is_met).collect();
            (vertices, edges)
        };
        let same = |found: &[u32], expected: &[usize]| found.iter().map(|&i| i as usize).eq(expected.iter().copied());
        for rule in RULES {
            let tree = PmTree::new(&sites, &segments, &frame, rule);
            let kept = |cell: Cell<2>| {
                let (vertices, edges) = content(cell);
                let edges: Vec<[usize; 2]> = edges.iter().map(|&e| segments[e]).collect();
                keeps(rule, &vertices, &edges)
            };
            for (leaf, cell) in tree.leaves().cells().enumerate() {
                let (vertices, edges) = content(cell);
                prop_assert!(same(tree.vertices(leaf), &vertices), "{:?}", cell);
                prop_assert!(same(tree.edges(leaf), &edges), "{:?}", cell);
                prop_assert_eq!(tree.leaves().is_black(leaf), !(vertices.is_empty() && edges.is_empty()));
                prop_assert_eq!(tree.crowded().contains(&leaf), !kept(cell));
                prop_assert!(kept(cell) || cell.level() == depth);
                if cell.level() > 0 {
                    let above = Cell::new(cell.anchor().map(|c| c >> 1), cell.level() - 1).unwrap();
                    prop_assert!(!kept(above), "cut without need");
                }
            }
        }
        // Each rule asks for more than the next.
        let [pm1, pm2, pm3] = RULES.map(|rule| PmTree::new(&sites, &segments, &frame, rule).leaves().len());
        prop_assert!(pm1 >= pm2 && pm2 >= pm3);
    }
}

#[test]
fn crossings_crowd_the_smallest_cells() {
    let points = [[0.1, 0.2], [3.9, 3.7], [0.2, 3.8], [3.8, 0.1]];
    let frame = Frame::around(&[[0.0, 0.0], [4.0, 4.0]], 7).unwrap();
    let tree = PmTree::new(&points, &[[0, 1], [2, 3]], &frame, PmRule::Pm1);
    assert!(!tree.crowded().is_empty());
    for &leaf in tree.crowded() {
        assert_eq!((tree.leaves().cell(leaf).level(), tree.edges(leaf)), (7, [0, 1].as_slice()));
    }
    let star = PmTree::new(&points, &[[0, 1], [0, 2], [0, 3]], &frame, PmRule::Pm1);
    assert!(star.crowded().is_empty());
    let leaf = star.leaf_at([0.1, 0.2]).unwrap();
    assert_eq!((star.vertices(leaf), star.edges(leaf)), ([0].as_slice(), [0, 1, 2].as_slice()));
}
