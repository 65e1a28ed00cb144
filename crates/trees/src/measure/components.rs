//! Connected components of black leaves.

use super::Joined;
use crate::orth::Index;
use crate::{Cell, Colour, OrthTree};

/// Which component each black leaf is in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Components {
    /// How many components there are.
    pub count: usize,
    /// For each black leaf, in Morton's order, its component; components are numbered as they first come.
    pub of_black: Vec<usize>,
}

impl<const N: usize> OrthTree<N> {
    /// The connected components of the black leaves.
    ///
    /// ```
    /// use delone_trees::{Joined, OrthTree};
    ///
    /// let tree = OrthTree::<2>::from_text("(BWWB")?;
    /// assert_eq!(tree.components(Joined::ByFacets).of_black, [0, 1]);
    /// assert_eq!(tree.components(Joined::AtCorners).count, 1);
    /// # Ok::<(), delone_trees::CodeFault>(())
    /// ```
    #[must_use]
    pub fn components(&self, joined: Joined) -> Components {
        let steps = joined.steps();
        let index = Index::new(self);
        let mut leader: Vec<usize> = (0..self.colours().len()).collect();
        let black = |(at, (cell, colour)): (usize, (Cell<N>, Colour))| {
            (colour == Colour::Black).then_some((at, cell))
        };
        for (at, cell) in self.cells().enumerate().filter_map(black) {
            // Neighbours that are smaller find this one themselves.
            for beyond in steps.iter().filter_map(|&steps| cell.neighbour(steps)) {
                let found = index.find(beyond);
                if found.colour == Colour::Black {
                    unite(&mut leader, at, found.at);
                }
            }
        }
        let mut number = vec![usize::MAX; leader.len()];
        let mut components = Components { count: 0, of_black: Vec::new() };
        for (at, _) in self.cells().enumerate().filter_map(black) {
            let first = find(&mut leader, at);
            if number[first] == usize::MAX {
                number[first] = components.count;
                components.count += 1;
            }
            components.of_black.push(number[first]);
        }
        components
    }
}

/// The leader of a node's set; halves the way to it.
fn find(leader: &mut [usize], mut at: usize) -> usize {
    while leader[at] != at {
        leader[at] = leader[leader[at]];
        at = leader[at];
    }
    at
}

fn unite(leader: &mut [usize], a: usize, b: usize) {
    let (a, b) = (find(leader, a), find(leader, b));
    leader[a.max(b)] = a.min(b);
}
