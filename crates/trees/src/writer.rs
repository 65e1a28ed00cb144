//! Depth-first codes: whether one is well-formed, writing one in normal form, and where its subtrees end.

use crate::{CodeFault, Colour};

/// The code of one tree, which must be all of it.
pub(crate) fn checked(colours: &[Colour], arity: usize, depth_max: usize) -> Result<(), CodeFault> {
    let mut open: Vec<usize> = Vec::new();
    let mut complete = false;
    for (at, &colour) in colours.iter().enumerate() {
        if complete {
            return Err(CodeFault::Trailing { at });
        }
        if colour == Colour::Gray {
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
    if complete { Ok(()) } else { Err(CodeFault::Truncated { at: colours.len() }) }
}

/// Takes the nodes of a tree in depth-first order and keeps them in normal form: as soon as the last son of a gray node is
/// there and all are leaves of one colour, they become that leaf.
#[derive(Debug)]
pub(crate) struct Writer {
    arity: usize,
    colours: Vec<Colour>,
    /// The gray nodes above the next node: where they are, how many sons they wait for.
    open: Vec<(usize, usize)>,
}

impl Writer {
    pub(crate) fn new(arity: usize) -> Self {
        Self { arity, colours: Vec::new(), open: Vec::new() }
    }

    pub(crate) fn push(&mut self, colour: Colour) {
        let begun = self.colours.is_empty() || !self.open.is_empty();
        assert!(begun, "a complete tree takes no further node");
        self.colours.push(colour);
        if colour == Colour::Gray {
            self.open.push((self.colours.len() - 1, self.arity));
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
        let sons = &self.colours[gray + 1..];
        let first = sons[0];
        if sons.len() == self.arity && first != Colour::Gray && sons.iter().all(|&s| s == first) {
            self.colours.truncate(gray);
            self.colours.push(first);
        }
    }

    pub(crate) fn finish(mut self) -> Vec<Colour> {
        assert!(self.open.is_empty() && !self.colours.is_empty(), "the tree is incomplete");
        self.colours.shrink_to_fit();
        self.colours
    }
}

/// For each node of a well-formed code the place behind its subtree.
pub(crate) fn ends(colours: &[Colour], arity: usize) -> Vec<usize> {
    let mut ends = vec![0; colours.len()];
    let mut roots: Vec<usize> = Vec::new(); // ends of subtrees to the right, the next one last
    for (at, &colour) in colours.iter().enumerate().rev() {
        let end = match colour {
            Colour::Gray => roots.drain(roots.len() - arity..).next().expect("sons are behind"),
            Colour::White | Colour::Black => at + 1,
        };
        ends[at] = end;
        roots.push(end);
    }
    ends
}

/// The place of a gray node's son.
pub(crate) fn son(ends: &[usize], gray: usize, which: usize) -> usize {
    (0..which).fold(gray + 1, |at, _| ends[at])
}
