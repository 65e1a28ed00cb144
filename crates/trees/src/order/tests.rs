use proptest::prelude::*;

use super::SonOrder;
use crate::testing::tree;
use crate::{Cell, CodeFault, Colour, OrthTree, Quadrant};

const ORDERS: [SonOrder; 6] = [
    SonOrder::Morton,
    SonOrder::Clockwise(Quadrant::NorthWest),
    SonOrder::Clockwise(Quadrant::NorthEast),
    SonOrder::Clockwise(Quadrant::SouthEast),
    SonOrder::Clockwise(Quadrant::SouthWest),
    SonOrder::Hilbert,
];

proptest! {
    #[test]
    fn every_order_leads_back(tree in tree::<2>(5)) {
        for order in ORDERS {
            let code = tree.colours_in(order);
            prop_assert_eq!(code.len(), tree.colours().len());
            assert_eq!(OrthTree::from_colours_in(order, &code).as_ref(), Ok(&tree));
            assert_eq!(OrthTree::from_text_in(order, &tree.to_text_in(order)).as_ref(), Ok(&tree));
        }
        prop_assert_eq!(tree.to_text_in(SonOrder::Morton), tree.to_text());
    }
}

/// The tree with one black cell.
fn dot(x: u32, y: u32, level: u8) -> OrthTree<2> {
    OrthTree::from_black(&[Cell::new([x, y], level).unwrap()]).unwrap()
}

#[test]
fn clockwise_begins_where_it_is_told() {
    let at = |x, y, start| dot(x, y, 1).to_text_in(SonOrder::Clockwise(start));
    assert_eq!(at(0, 1, Quadrant::NorthWest), "(BWWW");
    assert_eq!(at(1, 1, Quadrant::NorthWest), "(WBWW");
    assert_eq!(at(1, 0, Quadrant::NorthWest), "(WWBW");
    assert_eq!(at(0, 0, Quadrant::NorthWest), "(WWWB");
    assert_eq!(at(0, 0, Quadrant::SouthWest), "(BWWW");
    assert_eq!(at(0, 1, Quadrant::SouthEast), "(WWBW");
}

/// How many smallest cells are before the black one.
fn before(tree: &OrthTree<2>, order: SonOrder) -> usize {
    let mut missing: Vec<usize> = vec![1 << (2 * tree.depth())];
    let mut before = 0;
    for colour in tree.colours_in(order) {
        let size = missing.pop().unwrap();
        match colour {
            Colour::Black => return before,
            Colour::White => before += size,
            Colour::Gray => missing.extend([size / 4; 4]),
        }
    }
    unreachable!("there is a black cell")
}

#[test]
fn neighbours_follow_one_another_on_hilberts_curve() {
    for level in 1..5 {
        let side = 1u32 << level;
        let mut curve = vec![None; (side * side) as usize];
        for (x, y) in (0..side).flat_map(|x| (0..side).map(move |y| (x, y))) {
            curve[before(&dot(x, y, level), SonOrder::Hilbert)] = Some((x, y));
        }
        let curve: Vec<(u32, u32)> = curve.into_iter().map(Option::unwrap).collect();
        assert!(curve.windows(2).all(|w| w[0].0.abs_diff(w[1].0) + w[0].1.abs_diff(w[1].1) == 1));
        assert_eq!((curve.first(), curve.last()), (Some(&(0, 0)), Some(&(side - 1, 0))));
    }
}

#[test]
fn broken_codes_are_refused_in_every_order() {
    for order in ORDERS {
        assert_eq!(OrthTree::from_text_in(order, "(WB"), Err(CodeFault::Truncated { at: 3 }));
        assert_eq!(OrthTree::from_text_in(order, "WB"), Err(CodeFault::Trailing { at: 1 }));
    }
}
