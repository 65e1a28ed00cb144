use proptest::prelude::*;

use crate::testing::tree;
use crate::{Bits, Cell, CodeFault, Colour, OrthTree};

fn every_code_leads_back<const N: usize>(tree: &OrthTree<N>) {
    let counts = tree.counts();
    let text = tree.to_text();
    assert_eq!(text.len(), counts.nodes());
    assert_eq!(OrthTree::from_text(&text).as_ref(), Ok(tree));
    for bits in [tree.to_bits(), tree.to_level_bits()] {
        assert_eq!(bits.len(), counts.nodes() + counts.leaves());
        assert_eq!(bits.bytes().len(), bits.len().div_ceil(8));
        assert_eq!(Bits::new(bits.bytes().to_vec(), bits.len()).as_ref(), Some(&bits));
    }
    assert_eq!(OrthTree::from_bits(&tree.to_bits()).as_ref(), Ok(tree));
    assert_eq!(OrthTree::from_level_bits(&tree.to_level_bits()).as_ref(), Ok(tree));
    let black: Vec<Cell<N>> = tree.black().collect();
    assert_eq!(black.len(), counts.black);
    assert_eq!(OrthTree::from_black(&black).as_ref(), Ok(tree));
    let linear = tree.to_linear();
    assert_eq!(linear.len(), counts.black * (usize::from(tree.depth()) + 1));
    assert_eq!(OrthTree::from_linear(&linear).as_ref(), Ok(tree));
}

proptest! {
    #[test]
    fn codes_lead_back(
        line in tree::<1>(7), quad in tree::<2>(5), oct in tree::<3>(3), four in tree::<4>(2),
    ) {
        every_code_leads_back(&line);
        every_code_leads_back(&quad);
        every_code_leads_back(&oct);
        every_code_leads_back(&four);
    }

    #[test]
    fn any_bytes_are_a_tree_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..9), text in "[(WBX0-4\n]{0,12}") {
        let bits = Bits::new(bytes.clone(), bytes.len() * 8).unwrap();
        if let Ok(tree) = OrthTree::<2>::from_bits(&bits) {
            prop_assert!(tree.to_bits().len() <= bits.len());
        }
        if let Ok(tree) = OrthTree::<2>::from_level_bits(&bits) {
            prop_assert!(tree.to_level_bits().len() <= bits.len());
        }
        if let Ok(tree) = OrthTree::<2>::from_text(&text) {
            prop_assert!(tree.to_text().len() <= text.len());
        }
        if let Ok(tree) = OrthTree::<2>::from_linear(&text) {
            prop_assert!(tree.to_linear().lines().count() <= text.lines().count());
        }
    }
}

#[test]
fn levels_are_read_from_the_top() {
    // Gray, then B W gray W, then the sons of the gray one.
    let tree = OrthTree::<2>::from_text("(BW(WBBWW").unwrap();
    let levels: String =
        tree.to_level_bits().iter().map(|bit| if bit { '1' } else { '0' }).collect();
    assert_eq!(levels, ["1", "01", "00", "1", "00", "00", "01", "01", "00"].concat());
}

#[test]
fn one_leaf_has_codes() {
    let (white, black) = (OrthTree::<3>::of(Colour::White), OrthTree::<3>::of(Colour::Black));
    every_code_leads_back(&white);
    every_code_leads_back(&black);
    assert_eq!((white.to_text(), white.to_linear()), ("W".into(), String::new()));
    assert_eq!((black.to_text(), black.to_linear()), ("B".into(), "\n".into()));
}

#[test]
fn broken_codes_are_refused() {
    type Quad = OrthTree<2>;
    assert_eq!(Quad::from_text("(WB?W"), Err(CodeFault::Symbol { at: 3 }));
    assert_eq!(Quad::from_text("(WBB"), Err(CodeFault::Truncated { at: 4 }));
    let half_a_leaf = Bits::new(vec![0b1000_0000], 2).unwrap();
    assert_eq!(Quad::from_bits(&half_a_leaf), Err(CodeFault::Truncated { at: 2 }));
    let two = Bits::new(vec![0b0001_0000], 4).unwrap();
    assert_eq!(Quad::from_level_bits(&two), Err(CodeFault::Trailing { at: 1 }));
    assert_eq!(Quad::from_linear("01\n04\n"), Err(CodeFault::Symbol { at: 1 }));
    assert_eq!(Quad::from_linear(&"0".repeat(32)), Err(CodeFault::Symbol { at: 0 }));
    assert_eq!(Bits::new(vec![0], 9), None);
}

#[test]
fn overlapping_keys_are_refused() {
    type Quad = OrthTree<2>;
    let refused = |text, at| assert_eq!(Quad::from_linear(text), Err(CodeFault::Disorder { at }));
    refused("1\n0\n", 1);
    refused("0\n0\n", 1);
    refused("0X\n03\n1X\n", 1);
    refused("03\n0X\n", 1);
}
