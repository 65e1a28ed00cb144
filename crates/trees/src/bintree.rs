//! Trees of two sons: every inner node holds the hyperplane that cuts its cell, on one axis after the other.
//!
//! **Paper.** \[Tam84\] for cells cut in the middle; here the hyperplane may be anywhere inside the cell.
//!
//! **In / Out.** Nodes in depth-first order, the lower side first, over the cube \[0, 1\]^N; or a 2^N-tree, and back.
//!
//! **Invariants.** 1. The nodes are one whole tree in normal form: no inner node has two leaves of one colour. 2. The axis at
//! distance d from the root is d mod N, axes counted from 0. 3. Each hyperplane meets the interior of its cell.
//!
//! **Cost.** O(n); conversion O(2^N n).
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | an axis out of turn, a hyperplane beside its cell or on its side | refused | `nodes_out_of_turn_are_refused` |
//! | a hyperplane that is not the middle | no 2^N-tree | `free_hyperplanes_have_no_orth_tree` |

use crate::orth::Counts;
use crate::writer::{Node, Writer, checked, due, ends, son};
use crate::{CodeFault, Colour, DEPTH_MAX, OrthTree};

#[cfg(test)]
mod tests;

/// A node of a [`BinTree`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BinNode {
    /// A leaf that is outside.
    White,
    /// A leaf that is inside.
    Black,
    /// An inner node: x_axis = at.
    Cut {
        /// The axis, from 0.
        axis: u8,
        /// Where, from 0 to 1.
        at: f64,
    },
}

impl Node for BinNode {
    fn is_gray(self) -> bool {
        matches!(self, Self::Cut { .. })
    }
}

impl BinNode {
    fn colour(self) -> Colour {
        match self {
            Self::White => Colour::White,
            Self::Black => Colour::Black,
            Self::Cut { .. } => Colour::Gray,
        }
    }
}

/// A tree of two sons over the cube \[0, 1\]^N, in normal form.
///
/// ```
/// use delone_trees::{BinNode, BinTree, OrthTree};
///
/// let quad = OrthTree::<2>::from_text("(BWBB")?;
/// let bin = BinTree::from(&quad);
/// let right = BinNode::Cut { axis: 1, at: 0.5 };
/// assert_eq!(bin.nodes(), [BinNode::Cut { axis: 0, at: 0.5 }, BinNode::Black, right, BinNode::White, BinNode::Black]);
/// assert_eq!(OrthTree::try_from(&bin)?, quad);
/// # Ok::<(), delone_trees::CodeFault>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct BinTree<const N: usize> {
    nodes: Vec<BinNode>,
}

/// A cell, and how far from the root.
#[derive(Clone, Copy, Debug)]
struct Part<const N: usize> {
    lower: [f64; N],
    upper: [f64; N],
    distance: usize,
}

impl<const N: usize> Part<N> {
    const ROOT: Self = Self { lower: [0.0; N], upper: [1.0; N], distance: 0 };

    fn axis(&self) -> usize {
        self.distance % N
    }

    /// The middle on the axis whose turn it is.
    fn middle(&self) -> f64 {
        f64::midpoint(self.lower[self.axis()], self.upper[self.axis()])
    }

    fn cut(self, at: f64) -> [Self; 2] {
        let mut sides = [Self { distance: self.distance + 1, ..self }; 2];
        sides[0].upper[self.axis()] = at;
        sides[1].lower[self.axis()] = at;
        sides
    }

    /// Whether the cut is on the axis whose turn it is, and inside.
    fn checked(&self, node: usize, axis: u8, at: f64) -> Result<(), CodeFault> {
        let expected = self.axis();
        if usize::from(axis) != expected {
            return Err(CodeFault::Axis { at: node, expected });
        }
        let inside = self.lower[expected] < at && at < self.upper[expected];
        if inside { Ok(()) } else { Err(CodeFault::Hyperplane { at: node }) }
    }
}

impl<const N: usize> BinTree<N> {
    /// The tree of nodes in depth-first order, brought into normal form.
    ///
    /// # Errors
    /// If they are not one whole tree or deeper than N times [`DEPTH_MAX`], or at the first hyperplane that is on another axis
    /// than its distance from the root says, or not inside its cell.
    pub fn new(nodes: &[BinNode]) -> Result<Self, CodeFault> {
        checked(nodes, 2, N * usize::from(DEPTH_MAX))?;
        let mut pending = vec![Part::<N>::ROOT];
        let mut writer = Writer::new(2);
        for (place, &node) in nodes.iter().enumerate() {
            let part = due(pending.pop());
            if let BinNode::Cut { axis, at } = node {
                part.checked(place, axis, at)?;
                let [lower, upper] = part.cut(at);
                pending.extend([upper, lower]);
            }
            writer.push(node);
        }
        Ok(Self { nodes: writer.finish() })
    }

    /// The nodes in depth-first order, the lower side first.
    #[must_use]
    pub fn nodes(&self) -> &[BinNode] {
        &self.nodes
    }

    /// Nodes of each colour; inner ones are gray.
    #[must_use]
    pub fn counts(&self) -> Counts {
        Counts::of(&self.nodes.iter().map(|node| node.colour()).collect::<Vec<_>>())
    }

    /// Whether the point's leaf is black, if it is in the cube; on a hyperplane, the upper side's.
    #[must_use]
    pub fn is_black_at(&self, point: [f64; N]) -> Option<bool> {
        if !point.iter().all(|c| (0.0..=1.0).contains(c)) {
            return None;
        }
        let mut rest = self.nodes.iter();
        loop {
            match due(rest.next()) {
                BinNode::White => return Some(false),
                BinNode::Black => return Some(true),
                &BinNode::Cut { axis, at } if point[usize::from(axis)] >= at => skip(&mut rest),
                BinNode::Cut { .. } => {}
            }
        }
    }
}

/// Goes past one subtree.
fn skip<'a>(nodes: &mut impl Iterator<Item = &'a BinNode>) {
    let mut missing = 1;
    while missing > 0 {
        let node = due(nodes.next());
        missing = if node.is_gray() { missing + 1 } else { missing - 1 };
    }
}

impl<const N: usize> From<&OrthTree<N>> for BinTree<N> {
    /// Each gray node becomes cuts in the middle on N axes, as far as they are needed.
    fn from(tree: &OrthTree<N>) -> Self {
        let (colours, ends) = (tree.colours(), ends(tree.colours(), 1 << N));
        let mut writer = Writer::new(2);
        // A part of a node of the tree: the sons on the chosen sides of the axes that are cut already.
        let mut pending = vec![(0, 0, Part::<N>::ROOT)];
        while let Some((mut node, mut sides, part)) = pending.pop() {
            if part.axis() == 0 && part.distance > 0 {
                (node, sides) = (son(&ends, node, sides), 0);
            }
            match colours[node] {
                Colour::White => writer.push(BinNode::White),
                Colour::Black => writer.push(BinNode::Black),
                Colour::Gray => {
                    let (axis, at) = (part.axis(), part.middle());
                    let [lower, upper] = part.cut(at);
                    pending.push((node, sides | 1 << axis, upper));
                    pending.push((node, sides, lower));
                    writer
                        .push(BinNode::Cut { axis: u8::try_from(axis).expect("axes are few"), at });
                }
            }
        }
        Self { nodes: writer.finish() }
    }
}

impl<const N: usize> TryFrom<&BinTree<N>> for OrthTree<N> {
    type Error = CodeFault;

    /// Refused at the first hyperplane that is not the middle of its cell.
    fn try_from(tree: &BinTree<N>) -> Result<Self, CodeFault> {
        let nodes = tree.nodes();
        let mut parts = vec![Part::<N>::ROOT];
        for (place, &node) in nodes.iter().enumerate() {
            let part = due(parts.pop());
            if let BinNode::Cut { at, .. } = node {
                if at != part.middle() {
                    return Err(CodeFault::Hyperplane { at: place });
                }
                let [lower, upper] = part.cut(at);
                parts.extend([upper, lower]);
            }
        }
        let ends = ends(nodes, 2);
        let below = |root: usize, which: usize| {
            (0..N).fold(root, |node, axis| match nodes[node] {
                BinNode::Cut { .. } => son(&ends, node, which >> axis & 1),
                BinNode::White | BinNode::Black => node,
            })
        };
        let mut pending = vec![0];
        Ok(Self::grown(|_| {
            let node = due(pending.pop());
            let colour = nodes[node].colour();
            if colour == Colour::Gray {
                pending.extend((0..Self::ARITY).rev().map(|which| below(node, which)));
            }
            colour
        }))
    }
}
