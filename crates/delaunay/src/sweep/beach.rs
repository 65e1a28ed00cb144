//! The ghosts of the beach line, in their order along it: a treap, whose shape is that of a random tree.
//!
//! **Invariants.** 1. In order, the tree is the beach line. 2. A ghost's hash is less than those of the two below it in the
//! tree: the shape depends on nothing but which ghosts there are, and the depth is O(log n) expected. (The hash is that of a number
//! given by the algorithm; input that is made to be bad for it would have to be made for it.)
//! **Cost.** O(log n) expected for a search, O(1) expected rotations for an insertion or removal.

use delone_mesh::CellId;
use delone_sites::scatter;

type Link = Option<CellId>;

/// A ghost in the tree.
#[derive(Clone, Copy, Debug, Default)]
struct Node {
    parent: Link,
    /// What comes before, and what comes after.
    children: [Link; 2],
}

/// See the module's text.
#[derive(Debug, Default)]
pub(super) struct Beach {
    nodes: Vec<Node>,
    root: Link,
}

const BEFORE: usize = 0;
const AFTER: usize = 1;

fn hash(ghost: CellId) -> u64 {
    scatter(ghost.index() as u64)
}

impl Beach {
    /// The last ghost that something is above, and the first one that it is not above; one of them is there if any is.
    pub(super) fn search(&self, mut is_above: impl FnMut(CellId) -> bool) -> (Link, Link) {
        let (mut below, mut above) = (None, None);
        let mut place = self.root;
        while let Some(ghost) = place {
            if is_above(ghost) {
                below = place;
                place = self.child(ghost, AFTER);
            } else {
                above = place;
                place = self.child(ghost, BEFORE);
            }
        }
        (below, above)
    }

    /// Puts a ghost between two that follow each other, or before the first, or after the last.
    pub(super) fn insert(&mut self, below: Link, above: Link, ghost: CellId) {
        if self.nodes.len() <= ghost.index() {
            self.nodes.resize(ghost.index() + 1, Node::default());
        }
        // Of two that follow each other one is under the other, which has no child on this side.
        match (below, above) {
            (Some(below), _) if self.child(below, AFTER).is_none() => {
                self.hang(below, AFTER, ghost)
            }
            (_, Some(above)) => self.hang(above, BEFORE, ghost),
            (Some(_), None) => unreachable!("Inv 1: nothing comes after the last"),
            (None, None) => self.root = Some(ghost),
        }
        while let Some(parent) = self.nodes[ghost.index()].parent
            && hash(parent) > hash(ghost)
        {
            self.rotate_up(ghost); // Inv 2
        }
    }

    /// Takes a ghost out.
    pub(super) fn remove(&mut self, ghost: CellId) {
        loop {
            let children = self.nodes[ghost.index()].children;
            let Some(child) = children.into_iter().flatten().min_by_key(|&child| hash(child))
            else {
                break;
            };
            self.rotate_up(child);
        }
        let parent = self.nodes[ghost.index()].parent;
        self.replace(parent, ghost, None);
        self.nodes[ghost.index()] = Node::default();
    }

    fn child(&self, ghost: CellId, side: usize) -> Link {
        self.nodes[ghost.index()].children[side]
    }

    fn hang(&mut self, parent: CellId, side: usize, ghost: CellId) {
        debug_assert!(self.child(parent, side).is_none(), "a ghost is hung where there is none");
        self.nodes[parent.index()].children[side] = Some(ghost);
        self.nodes[ghost.index()].parent = Some(parent);
    }

    /// Makes `new` what `old` is to its parent.
    fn replace(&mut self, parent: Link, old: CellId, new: Link) {
        match parent {
            None => self.root = new,
            Some(parent) => {
                let side = usize::from(self.child(parent, AFTER) == Some(old));
                self.nodes[parent.index()].children[side] = new;
            }
        }
    }

    /// ```text
    ///       parent          child      Or the mirror image.
    ///       /    \          /   \
    ///    child    z   ->   x   parent
    ///    /   \                 /    \
    ///   x     y               y      z
    /// ```
    fn rotate_up(&mut self, child: CellId) {
        let parent = self.nodes[child.index()].parent.expect("the root does not go up");
        let side = usize::from(self.child(parent, AFTER) == Some(child));
        let inner = self.child(child, 1 - side);
        let above = self.nodes[parent.index()].parent;
        self.replace(above, parent, Some(child));
        self.nodes[child.index()].parent = above;
        self.nodes[child.index()].children[1 - side] = Some(parent);
        self.nodes[parent.index()].parent = Some(child);
        self.nodes[parent.index()].children[side] = inner;
        if let Some(inner) = inner {
            self.nodes[inner.index()].parent = Some(parent);
        }
    }
}

#[cfg(test)]
mod tests;
