use proptest::prelude::*;

use crate::testing::{is_normal, tree};
use crate::{Cell, CodeFault, Colour, DEPTH_MAX, OrthTree};
use Colour::{Black, Gray, White};

fn counts_and_places_agree<const N: usize>(tree: &OrthTree<N>) {
    let counts = tree.counts();
    assert_eq!(counts.leaves(), ((1 << N) - 1) * counts.gray + 1);
    assert_eq!(counts.nodes(), tree.colours().len());
    assert!(is_normal(tree.colours(), 1 << N));
    let mut covered = 0u128;
    let mut end = 0;
    for (cell, _) in tree.cells().filter(|&(_, colour)| colour != Gray) {
        let below = N * usize::from(DEPTH_MAX - cell.level());
        assert_eq!(cell.key() << below, end, "leaves follow one another in Morton's order");
        end += 1 << below;
        covered += 1 << below;
        assert_eq!(Cell::of_key(cell.level(), cell.key()), Some(cell));
    }
    assert_eq!(covered, 1 << (N * usize::from(DEPTH_MAX)));
}

proptest! {
    #[test]
    fn leaves_are_as_many_as_the_gray_nodes_say(
        line in tree::<1>(7), quad in tree::<2>(5), oct in tree::<3>(3), four in tree::<4>(2),
    ) {
        counts_and_places_agree(&line);
        counts_and_places_agree(&quad);
        counts_and_places_agree(&oct);
        counts_and_places_agree(&four);
    }
}

#[test]
fn sons_of_one_colour_become_their_parent_at_every_level() {
    let kept = [Gray, Gray, Black, White, Black];
    assert_eq!(OrthTree::<1>::new(&kept).unwrap().colours(), kept);
    let deep = [Gray, Gray, Black, Gray, Black, Black, Black];
    assert_eq!(OrthTree::<1>::new(&deep).unwrap(), OrthTree::of(Black));
}

#[test]
fn what_is_no_tree_is_refused() {
    type Quad = OrthTree<2>;
    assert_eq!(Quad::new(&[]), Err(CodeFault::Truncated { at: 0 }));
    assert_eq!(Quad::new(&[Gray, White]), Err(CodeFault::Truncated { at: 2 }));
    assert_eq!(Quad::new(&[White, White]), Err(CodeFault::Trailing { at: 1 }));
    let deep = |levels: usize| {
        let mut code = vec![Gray; levels];
        code.push(Black);
        code.extend(vec![White; levels]);
        OrthTree::<1>::new(&code)
    };
    assert_eq!(deep(31).unwrap().depth(), DEPTH_MAX);
    assert_eq!(deep(32), Err(CodeFault::TooDeep { at: 31 }));
}
