//! The Euler number by what is around vertices.

use super::Joined;
use crate::orth::Index;
use crate::{Cell, Colour, OrthTree};

impl<const N: usize> OrthTree<N> {
    /// The Euler number: in the plane, pieces less holes; in space, pieces less tunnels plus voids.
    ///
    /// ```
    /// use delone_trees::{Joined, OrthTree};
    ///
    /// let ring = OrthTree::<2>::from_text("((BBBW(BBWB(BWBB(WBBB")?;
    /// assert_eq!(ring.euler(Joined::ByFacets), 0);
    /// # Ok::<(), delone_trees::CodeFault>(())
    /// ```
    ///
    /// # Panics
    /// Never: a sum of shares that is not whole would be a bug.
    #[must_use]
    pub fn euler(&self, joined: Joined) -> i64 {
        let depth = self.depth();
        let index = Index::new(self);
        let shares = self.corners(depth).into_iter().map(|vertex| {
            let black = |which: usize| {
                let cell = cell_at(vertex, which, depth);
                cell.is_some_and(|cell| index.find(cell).colour == Colour::Black)
            };
            let around = (0..Self::ARITY).filter(|&which| black(which));
            share::<N>(around.fold(0, |pattern, which| pattern | 1 << which), joined)
        });
        let sum: i64 = shares.sum();
        assert_eq!(sum & ((1 << N) - 1), 0, "shares of whole faces are whole");
        sum >> N
    }

    /// The corners of all leaves, sorted, each once, in cells of a level.
    fn corners(&self, depth: u8) -> Vec<[u32; N]> {
        let mut corners = Vec::new();
        for (cell, _) in self.cells().filter(|&(_, colour)| colour != Colour::Gray) {
            let (lower, side) = cell.scaled(depth);
            let upper = |corner: usize, axis: usize| if corner >> axis & 1 == 1 { side } else { 0 };
            let corner = |c: usize| std::array::from_fn(|axis| lower[axis] + upper(c, axis));
            corners.extend((0..Self::ARITY).map(corner));
        }
        corners.sort_unstable();
        corners.dedup();
        corners
    }
}

/// The cell of a level on the given sides of a vertex, if it is in the root.
fn cell_at<const N: usize>(vertex: [u32; N], which: usize, depth: u8) -> Option<Cell<N>> {
    let mut anchor = vertex;
    for (axis, place) in anchor.iter_mut().enumerate() {
        *place = if which >> axis & 1 == 1 { *place } else { place.checked_sub(1)? };
    }
    Cell::new(anchor, depth)
}

/// 2^N times a vertex's share of the Euler number, for a pattern of black cells around it. Each face at the vertex is a set of
/// axes that it spans, and sides on them; it is there if one cell around it is black (closed) or all are (open).
fn share<const N: usize>(pattern: u32, joined: Joined) -> i64 {
    let arity = 1usize << N;
    let mut share = 0;
    for spanned in 0..arity {
        // Sides on the axes that are spanned: the subsets of that set.
        for sides in (0..arity).filter(|sides| sides & !spanned == 0) {
            let mut around = (0..arity).filter(|cell| cell & spanned == sides);
            let black = |cell: usize| pattern >> cell & 1 == 1;
            let there = match joined {
                Joined::AtCorners => around.any(black),
                Joined::ByFacets => around.all(black),
            };
            let weight = 1i64 << (N - spanned.count_ones() as usize);
            let codimension = if joined == Joined::ByFacets { N } else { 0 };
            let odd = (spanned.count_ones() as usize + codimension) % 2 == 1;
            share += if !there {
                0
            } else if odd {
                -weight
            } else {
                weight
            };
        }
    }
    share
}
