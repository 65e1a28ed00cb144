//! Where cells are in a code.

use crate::writer::{ends, son};
use crate::{Cell, Colour, OrthTree};

/// A code with the ends of its subtrees: cells are found in O(2^N level).
#[derive(Debug)]
pub(crate) struct Index<'t, const N: usize> {
    tree: &'t OrthTree<N>,
    ends: Vec<usize>,
}

/// A node: the cell asked for, or the leaf that it is a part of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    pub(crate) at: usize,
    pub(crate) level: u8,
    pub(crate) colour: Colour,
}

impl<'t, const N: usize> Index<'t, N> {
    pub(crate) fn new(tree: &'t OrthTree<N>) -> Self {
        Self { tree, ends: ends(tree.colours(), OrthTree::<N>::ARITY) }
    }

    pub(crate) fn find(&self, cell: Cell<N>) -> Found {
        let colours = self.tree.colours();
        let mut at = 0;
        for level in 0..cell.level() {
            if colours[at] != Colour::Gray {
                return Found { at, level, colour: colours[at] };
            }
            at = son(&self.ends, at, cell.branch(level));
        }
        Found { at, level: cell.level(), colour: colours[at] }
    }
}
