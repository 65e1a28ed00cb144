//! Subdivisions by their leaves alone: linear trees, not in normal form.
//!
//! **Paper.** \[Gar82\] for trees as sorted leaves; here white ones too, so that a leaf may be cut without changing the set.
//!
//! **In / Out.** A tree; its leaves in Morton's order, their neighbours, those that meet a box, the 2:1 balanced refinement.
//!
//! **Invariants.** 1. Leaves are disjoint, cover the root, and are in Morton's order.
//!
//! **Cost.** O(log n) for the leaf that holds a cell; O((k + 1) 2^N level log n) for the k leaves in a box.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a cell that is cut | no leaf holds it | `leaves_are_found_by_the_cells_that_they_hold` |
//! | a box of one cell; of all | its leaf; all leaves | `boxes_have_the_leaves_that_meet_them` |

mod balance;
mod triangles;

use crate::{Cell, Colour, DEPTH_MAX, Joined, Key, OrthTree};
pub use triangles::{Triangles, TrianglesFault};

#[cfg(test)]
mod tests;

/// The leaves of a tree of 2^N sons, in Morton's order.
///
/// ```
/// use delone_trees::{Cell, Joined, OrthTree};
///
/// let leaves = OrthTree::<2>::from_text("((BWWBWWW")?.leaves();
/// assert_eq!(leaves.len(), 7);
/// let corner = Cell::new([7, 0], 3).and_then(|cell| leaves.holder(cell));
/// assert_eq!(corner.map(|leaf| leaves.cell(leaf).level()), Some(1));
/// assert_eq!(leaves.neighbours(4, Joined::ByFacets), [1, 3, 6]);
/// # Ok::<(), delone_trees::CodeFault>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leaves<const N: usize> {
    keys: Vec<Key<N>>,
    black: Vec<bool>,
}

impl<const N: usize> OrthTree<N> {
    /// The leaves, white and black.
    #[must_use]
    pub fn leaves(&self) -> Leaves<N> {
        let leaves = self.cells().filter(|&(_, colour)| colour != Colour::Gray);
        let (keys, black) =
            leaves.map(|(cell, colour)| (Key::of(cell), colour == Colour::Black)).unzip();
        Leaves { keys, black }
    }
}

impl<const N: usize> Leaves<N> {
    /// Keys that cover the root, in Morton's order.
    pub(crate) fn new(keys: Vec<Key<N>>, black: Vec<bool>) -> Self {
        Self { keys, black }
    }

    /// How many.
    #[must_use]
    pub fn len(&self) -> usize {
        self.keys.len()
    }

    /// Never: the root is a leaf if it is not cut.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.keys.is_empty()
    }

    /// A leaf, from 0 in Morton's order.
    ///
    /// # Panics
    /// If there are not as many.
    #[must_use]
    pub fn cell(&self, leaf: usize) -> Cell<N> {
        self.keys[leaf].cell()
    }

    /// Whether a leaf is inside.
    ///
    /// # Panics
    /// If there are not as many.
    #[must_use]
    pub fn is_black(&self, leaf: usize) -> bool {
        self.black[leaf]
    }

    /// All leaves.
    pub fn cells(&self) -> impl Iterator<Item = Cell<N>> + Clone + '_ {
        self.keys.iter().map(|key| key.cell())
    }

    /// The tree: leaves of one colour united.
    #[must_use]
    pub fn tree(&self) -> OrthTree<N> {
        let mut next = 0;
        OrthTree::grown(|cell| {
            if self.keys[next] != Key::of(cell) {
                return Colour::Gray;
            }
            next += 1;
            Colour::of(self.black[next - 1])
        })
    }

    /// The leaf that is the cell or that it is a part of; none if it is cut.
    #[must_use]
    pub fn holder(&self, cell: Cell<N>) -> Option<usize> {
        self.holder_of(Key::of(cell))
    }

    fn holder_of(&self, key: Key<N>) -> Option<usize> {
        let leaf = self.keys.partition_point(|leaf| leaf.span()[0] <= key.span()[0]) - 1;
        (self.keys[leaf].level() <= key.level()).then_some(leaf)
    }

    /// The leaves that share a facet with a leaf, or also a lower face, in Morton's order.
    ///
    /// # Panics
    /// If there are not as many.
    #[must_use]
    pub fn neighbours(&self, leaf: usize, joined: Joined) -> Vec<usize> {
        let key = self.keys[leaf];
        let mut found = Vec::new();
        for step in joined.steps::<N>() {
            let Some(beyond) = key.neighbour(step) else { continue };
            let mut pending = vec![beyond];
            while let Some(part) = pending.pop() {
                match self.holder_of(part) {
                    Some(leaf) => found.push(leaf),
                    None => pending.extend(sons_towards(part.cell(), step).map(Key::of)),
                }
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The leaves that meet a box of cells of a level, both corners included, in Morton's order. A box that is empty, or beyond
    /// the root, meets none.
    #[must_use]
    pub fn within(&self, lower: [u32; N], upper: [u32; N], level: u8) -> Vec<usize> {
        let mut found = Vec::new();
        if level > DEPTH_MAX || (0..N).any(|axis| lower[axis] > upper[axis]) {
            return found;
        }
        let shift = DEPTH_MAX - level;
        let meets = |cell: Cell<N>| {
            let (anchor, side) = cell.scaled(DEPTH_MAX);
            (0..N).all(|axis| {
                let first = u64::from(lower[axis]) << shift;
                let last = (u64::from(upper[axis]) + 1) << shift;
                u64::from(anchor[axis]) < last && u64::from(anchor[axis]) + u64::from(side) > first
            })
        };
        let mut pending = vec![Cell::ROOT];
        while let Some(cell) = pending.pop() {
            if !meets(cell) {
                continue;
            }
            match self.holder(cell) {
                Some(leaf) => found.push(leaf),
                None => pending.extend((0..1 << N).rev().map(|son| cell.son(son))),
            }
        }
        found
    }
}

/// The sons on the side of a cell from which the steps came.
fn sons_towards<const N: usize>(cell: Cell<N>, step: [i8; N]) -> impl Iterator<Item = Cell<N>> {
    let fits = move |son: &usize| {
        (0..N).all(|axis| step[axis] == 0 || (step[axis] < 0) == (son >> axis & 1 == 1))
    };
    (0..1usize << N).filter(fits).map(move |son| cell.son(son))
}
