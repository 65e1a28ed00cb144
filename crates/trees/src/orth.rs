//! 2^N-trees as depth-first codes.
//!
//! **Invariants.** 1. A code is one whole tree: gray nodes are followed by their 2^N sons, others are leaves. 2. Normal form: no
//! gray node has leaves of one colour only. So equal sets of points have equal codes. 3. No node is deeper than
//! [`DEPTH_MAX`](crate::DEPTH_MAX).

mod index;

use crate::writer::{Writer, checked, due};
use crate::{Cell, CodeFault, Colour, DEPTH_MAX};
pub(crate) use index::Index;

#[cfg(test)]
mod tests;

/// A tree of 2^N sons in normal form, N = 1 to 4. A byte per node.
///
/// ```
/// use delone_trees::{Colour, OrthTree};
/// use Colour::{Black, Gray, White};
///
/// let quarter = OrthTree::<2>::new(&[Gray, Black, White, White, White])?;
/// assert_eq!(quarter.union(&quarter.complement()), OrthTree::of(Black));
/// assert_eq!(quarter.counts().leaves(), 3 * quarter.counts().gray + 1);
/// assert_eq!(quarter.volume(10), Some(512 * 512));
/// # Ok::<(), delone_trees::CodeFault>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OrthTree<const N: usize> {
    colours: Vec<Colour>,
}

/// Nodes of each colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// White leaves.
    pub white: usize,
    /// Black leaves.
    pub black: usize,
    /// Inner nodes.
    pub gray: usize,
}

impl Counts {
    pub(crate) fn of(colours: &[Colour]) -> Self {
        let mut counts = Self::default();
        for colour in colours {
            match colour {
                Colour::White => counts.white += 1,
                Colour::Black => counts.black += 1,
                Colour::Gray => counts.gray += 1,
            }
        }
        counts
    }

    /// White and black.
    #[must_use]
    pub fn leaves(self) -> usize {
        self.white + self.black
    }

    /// All.
    #[must_use]
    pub fn nodes(self) -> usize {
        self.leaves() + self.gray
    }
}

impl<const N: usize> OrthTree<N> {
    /// Sons of a gray node.
    pub const ARITY: usize = {
        assert!(1 <= N && N <= 4, "trees have one to four axes");
        1 << N
    };

    /// The tree of a depth-first code with sons in Morton's order; what is not in normal form is brought there.
    ///
    /// # Errors
    /// If the code ends early or late or is too deep.
    pub fn new(colours: &[Colour]) -> Result<Self, CodeFault> {
        checked(colours, Self::ARITY, usize::from(DEPTH_MAX))?;
        let mut writer = Self::writer();
        colours.iter().for_each(|&colour| writer.push(colour));
        Ok(Self::written(writer))
    }

    /// One leaf. Gray is taken for white.
    #[must_use]
    pub fn of(colour: Colour) -> Self {
        Self { colours: vec![Colour::of(colour == Colour::Black)] }
    }

    pub(crate) fn writer() -> Writer<Colour> {
        Writer::new(Self::ARITY)
    }

    pub(crate) fn written(writer: Writer<Colour>) -> Self {
        Self { colours: writer.finish() }
    }

    pub(crate) fn of_normal(colours: Vec<Colour>) -> Self {
        Self { colours }
    }

    /// The tree whose cells have the colours that `ask` says; gray ones are cut. Cells at [`DEPTH_MAX`] must not be gray.
    pub(crate) fn grown(mut ask: impl FnMut(Cell<N>) -> Colour) -> Self {
        let mut writer = Self::writer();
        let mut pending = vec![Cell::ROOT];
        while let Some(cell) = pending.pop() {
            let colour = ask(cell);
            writer.push(colour);
            if colour == Colour::Gray {
                pending.extend((0..Self::ARITY).rev().map(|son| cell.son(son)));
            }
        }
        Self::written(writer)
    }

    /// The depth-first code, sons in Morton's order.
    #[must_use]
    pub fn colours(&self) -> &[Colour] {
        &self.colours
    }

    /// Nodes of each colour. O(n).
    #[must_use]
    pub fn counts(&self) -> Counts {
        Counts::of(&self.colours)
    }

    /// The level of the smallest leaves. O(n).
    #[must_use]
    pub fn depth(&self) -> u8 {
        self.cells().map(|(cell, _)| cell.level()).max().unwrap_or(0)
    }

    /// All nodes with their colours, depth first, in Morton's order. O(n) for all.
    pub fn cells(&self) -> impl Iterator<Item = (Cell<N>, Colour)> + Clone + '_ {
        let mut pending = vec![Cell::ROOT];
        self.colours.iter().map(move |&colour| {
            let cell = due(pending.pop());
            if colour == Colour::Gray {
                pending.extend((0..Self::ARITY).rev().map(|son| cell.son(son)));
            }
            (cell, colour)
        })
    }

    /// The black leaves in Morton's order.
    pub fn black(&self) -> impl Iterator<Item = Cell<N>> + Clone + '_ {
        self.cells().filter(|&(_, colour)| colour == Colour::Black).map(|(cell, _)| cell)
    }
}
