use proptest::prelude::*;

use crate::testing::tree;
use crate::{BinNode, BinTree, CodeFault, OrthTree};
use BinNode::{Black, Cut, White};

const CUT_X: BinNode = Cut { axis: 0, at: 0.5 };
const CUT_Y: BinNode = Cut { axis: 1, at: 0.5 };

fn leads_back<const N: usize>(tree: &OrthTree<N>) {
    let bin = BinTree::from(tree);
    assert_eq!(BinTree::new(bin.nodes()).as_ref(), Ok(&bin), "whole, alternating, in normal form");
    let counts = bin.counts();
    assert_eq!(counts.leaves(), counts.gray + 1);
    assert!(counts.leaves() <= tree.counts().leaves());
    assert_eq!(OrthTree::try_from(&bin).as_ref(), Ok(tree));
    let depth = tree.depth();
    let raster = tree.to_raster(depth).unwrap();
    let side = 1usize << depth;
    for (at, &black) in raster.cells().iter().enumerate() {
        let mut rest = at;
        let centre = [0; N].map(|_: u8| {
            let place = u32::try_from(rest % side).unwrap();
            rest /= side;
            (f64::from(place) + 0.5) / f64::from(1u32 << depth)
        });
        assert_eq!(bin.is_black_at(centre), Some(black));
    }
}

proptest! {
    #[test]
    fn orth_trees_lead_back(
        line in tree::<1>(6), quad in tree::<2>(4), oct in tree::<3>(3), four in tree::<4>(2),
    ) {
        leads_back(&line);
        leads_back(&quad);
        leads_back(&oct);
        leads_back(&four);
    }
}

#[test]
fn nodes_out_of_turn_are_refused() {
    let refused = |nodes: &[BinNode]| BinTree::<2>::new(nodes).unwrap_err();
    assert_eq!(refused(&[CUT_Y, White, Black]), CodeFault::Axis { at: 0, expected: 0 });
    assert_eq!(
        refused(&[CUT_X, CUT_X, White, Black, Black]),
        CodeFault::Axis { at: 1, expected: 1 }
    );
    for at in [0.0, 1.0, -0.5, f64::NAN, f64::INFINITY] {
        assert_eq!(refused(&[Cut { axis: 0, at }, White, Black]), CodeFault::Hyperplane { at: 0 });
    }
    // The second cut of x is in [0, 1/2].
    let beside = [CUT_X, CUT_Y, Cut { axis: 0, at: 0.5 }, White, Black, Black, Black];
    assert_eq!(refused(&beside), CodeFault::Hyperplane { at: 2 });
    assert_eq!(refused(&[CUT_X, White]), CodeFault::Truncated { at: 2 });
}

#[test]
fn free_hyperplanes_have_no_orth_tree() {
    let third = BinTree::<2>::new(&[Cut { axis: 0, at: 0.3 }, White, Black]).unwrap();
    assert_eq!(OrthTree::try_from(&third), Err(CodeFault::Hyperplane { at: 0 }));
    let at = |x| third.is_black_at([x, 0.9]);
    assert_eq!([at(0.2), at(0.3), at(1.0), at(1.1)], [Some(false), Some(true), Some(true), None]);
}

#[test]
fn equal_sides_are_united() {
    let nodes = [CUT_X, CUT_Y, Black, Black, Cut { axis: 1, at: 0.25 }, Black, Black];
    assert_eq!(BinTree::<2>::new(&nodes).unwrap().nodes(), [Black]);
}
