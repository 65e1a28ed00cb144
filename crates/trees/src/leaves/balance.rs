//! 2:1 balance: neighbours differ by one level at most.
//!
//! **Paper.** \[SSB08\]: the coarsest balanced refinement, from the smallest leaves up.
//!
//! **In / Out.** Leaves; those of the coarsest refinement in which neighbours, through facets or also at corners, differ by at most one
//! level. It is unique.
//!
//! **Invariants.** 1. When level l is done, no gray node of level l or deeper is missing: what it asks for is of level l - 1.
//!
//! **Cost.** O(m 3^N log m) for m leaves of the result.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | balanced already | nothing is cut | `balance_is_the_coarsest` |

use super::Leaves;
use crate::{Cell, DEPTH_MAX, Joined, Key};

impl<const N: usize> Leaves<N> {
    /// Whether neighbours differ by at most one level.
    #[must_use]
    pub fn is_balanced(&self, joined: Joined) -> bool {
        let level = |leaf: usize| self.keys[leaf].level();
        (0..self.len()).all(|leaf| {
            self.neighbours(leaf, joined)
                .iter()
                .all(|&other| level(leaf).abs_diff(level(other)) <= 1)
        })
    }

    /// The coarsest refinement whose neighbours differ by at most one level.
    ///
    /// ```
    /// use delone_trees::{Joined, OrthTree};
    ///
    /// let leaves = OrthTree::<2>::from_text("(W(WW(BWWWWWW")?.leaves();
    /// let balanced = leaves.balanced(Joined::ByFacets);
    /// assert!(!leaves.is_balanced(Joined::ByFacets) && balanced.is_balanced(Joined::ByFacets));
    /// assert_eq!((leaves.len(), balanced.len()), (10, 16));
    /// assert_eq!(balanced.tree(), leaves.tree());
    /// # Ok::<(), delone_trees::CodeFault>(())
    /// ```
    ///
    /// # Panics
    /// Never: a cell that is cut in the leaves and not in their refinement would be a bug.
    #[must_use]
    pub fn balanced(&self, joined: Joined) -> Self {
        let gray = self.gray_of_balance(joined);
        let mut balanced = Self { keys: Vec::new(), black: Vec::new() };
        let mut pending = vec![Key::of(Cell::<N>::ROOT)];
        while let Some(key) = pending.pop() {
            if gray[usize::from(key.level())].binary_search(&key).is_ok() {
                let cell = key.cell();
                pending.extend((0..1 << N).rev().map(|son| Key::of(cell.son(son))));
                continue;
            }
            let holder = self.holder_of(key).expect("what is cut here is cut there");
            balanced.keys.push(key);
            balanced.black.push(self.black[holder]);
        }
        balanced
    }

    /// The gray nodes of the balanced refinement, by level, sorted.
    fn gray_of_balance(&self, joined: Joined) -> Vec<Vec<Key<N>>> {
        let mut gray: Vec<Vec<Key<N>>> = vec![Vec::new(); usize::from(DEPTH_MAX) + 1];
        for cell in self.cells().filter(|cell| cell.level() > 0) {
            gray[usize::from(cell.level()) - 1].push(Key::of(above(cell, 1)));
        }
        let steps = joined.steps::<N>();
        for level in (0..gray.len()).rev() {
            gray[level].sort_unstable();
            gray[level].dedup();
            let Some(upper) = level.checked_sub(1) else { break };
            let mut asked = Vec::new();
            for cell in gray[level].iter().map(|key| key.cell()) {
                // A son's neighbour is at least twice as large only if what is four times as large is cut.
                for son in (0..1 << N).map(|son| cell.son(son)) {
                    let beyond = steps.iter().filter_map(|&step| son.neighbour(step));
                    asked.extend(beyond.map(|beyond| Key::of(above(beyond, 2))));
                }
                asked.dedup();
            }
            gray[upper].append(&mut asked); // Inv 1
        }
        gray
    }
}

/// The cell so many levels above.
fn above<const N: usize>(cell: Cell<N>, levels: u8) -> Cell<N> {
    let anchor = cell.anchor().map(|place| place >> levels);
    Cell::new(anchor, cell.level() - levels).expect("a cell is in those above it")
}
