//! Depth-first codes: whether one is well-formed, writing one in normal form, and where its subtrees end.

use crate::{CodeFault, Colour};

/// A node of a depth-first code.
pub(crate) trait Node: Copy + PartialEq {
    /// Whether its sons follow.
    fn is_gray(self) -> bool;
}

impl Node for Colour {
    fn is_gray(self) -> bool {
        self == Self::Gray
    }
}

/// The code of one tree, which must be all of it.
pub(crate) fn checked(
    nodes: &[impl Node],
    arity: usize,
    depth_max: usize,
) -> Result<(), CodeFault> {
    let mut open: Vec<usize> = Vec::new();
    let mut complete = false;
    for (at, &node) in nodes.iter().enumerate() {
        if complete {
            return Err(CodeFault::Trailing { at });
        }
        if node.is_gray() {
            if open.len() == depth_max {
                return Err(CodeFault::TooDeep { at });
            }
            open.push(arity);
            continue;
        }
        complete = loop {
            let Some(sons) = open.last_mut() else { break true };
            *sons -= 1;
            if *sons > 0 {
                break false;
            }
            open.pop();
        };
    }
    if complete { Ok(()) } else { Err(CodeFault::Truncated { at: nodes.len() }) }
}

/// Takes the nodes of a tree in depth-first order and keeps them in normal form: as soon as the last son of a gray node is
/// there and all are leaves of one colour, they become that leaf.
#[derive(Debug)]
pub(crate) struct Writer<T> {
    arity: usize,
    nodes: Vec<T>,
    /// The gray nodes above the next node: where they are, how many sons they wait for.
    open: Vec<(usize, usize)>,
}

impl<T: Node> Writer<T> {
    pub(crate) fn new(arity: usize) -> Self {
        Self { arity, nodes: Vec::new(), open: Vec::new() }
    }

    pub(crate) fn push(&mut self, node: T) {
        let begun = self.nodes.is_empty() || !self.open.is_empty();
        assert!(begun, "a complete tree takes no further node");
        self.nodes.push(node);
        if node.is_gray() {
            self.open.push((self.nodes.len() - 1, self.arity));
            return;
        }
        while let Some((gray, sons)) = self.open.last_mut() {
            *sons -= 1;
            if *sons > 0 {
                return;
            }
            let gray = *gray;
            self.open.pop();
            self.merge(gray);
        }
    }

    fn merge(&mut self, gray: usize) {
        let sons = &self.nodes[gray + 1..];
        let first = sons[0];
        if sons.len() == self.arity && !first.is_gray() && sons.iter().all(|&s| s == first) {
            self.nodes.truncate(gray);
            self.nodes.push(first);
        }
    }

    pub(crate) fn finish(mut self) -> Vec<T> {
        assert!(self.open.is_empty() && !self.nodes.is_empty(), "the tree is incomplete");
        self.nodes.shrink_to_fit();
        self.nodes
    }
}

/// For each node of a well-formed code the place behind its subtree.
pub(crate) fn ends(nodes: &[impl Node], arity: usize) -> Vec<usize> {
    let mut ends = vec![0; nodes.len()];
    let mut roots: Vec<usize> = Vec::new(); // ends of subtrees to the right, the next one last
    for (at, &node) in nodes.iter().enumerate().rev() {
        let end = if node.is_gray() {
            roots.drain(roots.len() - arity..).next().expect("sons are behind")
        } else {
            at + 1
        };
        ends[at] = end;
        roots.push(end);
    }
    ends
}

/// What comes next in a well-formed code, or is pending for it.
pub(crate) fn due<T>(next: Option<T>) -> T {
    next.expect("a code is one whole tree")
}

/// The place of a gray node's son.
pub(crate) fn son(ends: &[usize], gray: usize, which: usize) -> usize {
    (0..which).fold(gray + 1, |at, _| ends[at])
}
