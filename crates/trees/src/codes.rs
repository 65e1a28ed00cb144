//! Encodings of trees: depth-first text and bits, breadth-first bits, linear codes, Morton's keys.
//!
//! **Paper.** \[KE80\] for the depth-first expression: `(` for a gray node, `W` and `B` for leaves; the arity being known, nothing closes. \[Gar82\]
//! for linear codes: black leaves only, a digit for each level, `X` where the leaf is larger than the smallest cell.
//!
//! **In / Out.** A tree in normal form, and back. Codes of trees that are not in normal form are read as well.
//!
//! **Cost.** O(n) time and symbols: depth and breadth first n + leaves bits, linear codes N bits for each level of each black leaf.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a tree of one leaf | one symbol; a white one has no linear code | `one_leaf_has_codes` |
//! | a code that ends early, goes on, or has a strange symbol | refused, with the place | `broken_codes_are_refused` |
//! | keys that overlap or are not sorted | refused, with the place | `overlapping_keys_are_refused` |

mod bits;
mod linear;

use std::collections::VecDeque;

use crate::writer::{ends, son};
use crate::{CodeFault, Colour, OrthTree};
pub use bits::Bits;

#[cfg(test)]
mod tests;

impl<const N: usize> OrthTree<N> {
    /// The depth-first expression: `(`, `W`, `B`. \[KE80\]
    ///
    /// ```
    /// use delone_trees::OrthTree;
    ///
    /// let tree = OrthTree::<2>::from_text("(BWW(WBBW")?;
    /// assert_eq!(tree.to_text(), "(BWW(WBBW");
    /// assert_eq!(tree.to_bits().len(), 9 + 7); // a bit for each node, one more for each leaf
    /// # Ok::<(), delone_trees::CodeFault>(())
    /// ```
    #[must_use]
    pub fn to_text(&self) -> String {
        text_of(self.colours())
    }

    /// The tree of a depth-first expression; blanks are skipped.
    ///
    /// # Errors
    /// At the first strange symbol, or if the expression is not one whole tree.
    pub fn from_text(text: &str) -> Result<Self, CodeFault> {
        Self::new(&colours_of(text)?)
    }

    /// Depth first: 1 for gray, 0 and the colour (1 is black) for a leaf.
    #[must_use]
    pub fn to_bits(&self) -> Bits {
        Bits::of_colours(self.colours().iter().copied())
    }

    /// The tree of depth-first bits.
    ///
    /// # Errors
    /// If they are not one whole tree.
    pub fn from_bits(bits: &Bits) -> Result<Self, CodeFault> {
        Self::new(&bits.colours()?)
    }

    /// The bits of [`OrthTree::to_bits`], breadth first.
    #[must_use]
    pub fn to_level_bits(&self) -> Bits {
        let ends = ends(self.colours(), Self::ARITY);
        let mut queue = VecDeque::from([0]);
        let next = || {
            let at = queue.pop_front()?;
            let colour = self.colours()[at];
            if colour == Colour::Gray {
                queue.extend((0..Self::ARITY).map(|which| son(&ends, at, which)));
            }
            Some(colour)
        };
        Bits::of_colours(std::iter::from_fn(next))
    }

    /// The tree of breadth-first bits: the sons of the g-th gray node begin at node 1 + 2^N g.
    ///
    /// # Errors
    /// If they are not one whole tree.
    pub fn from_level_bits(bits: &Bits) -> Result<Self, CodeFault> {
        let levels = bits.colours()?;
        whole(&levels, Self::ARITY)?;
        let mut sons = Vec::with_capacity(levels.len());
        let mut next = 1;
        for &colour in &levels {
            sons.push(next);
            next += if colour == Colour::Gray { Self::ARITY } else { 0 };
        }
        let mut colours = Vec::with_capacity(levels.len());
        let mut pending = vec![0];
        while let Some(at) = pending.pop() {
            colours.push(levels[at]);
            if levels[at] == Colour::Gray {
                pending.extend((sons[at]..sons[at] + Self::ARITY).rev());
            }
        }
        Self::new(&colours)
    }
}

pub(crate) fn text_of(colours: &[Colour]) -> String {
    let symbol = |&colour: &Colour| match colour {
        Colour::White => 'W',
        Colour::Black => 'B',
        Colour::Gray => '(',
    };
    colours.iter().map(symbol).collect()
}

pub(crate) fn colours_of(text: &str) -> Result<Vec<Colour>, CodeFault> {
    let symbols = text.chars().enumerate().filter(|(_, symbol)| !symbol.is_whitespace());
    let colour = |(at, symbol)| match symbol {
        'W' => Ok(Colour::White),
        'B' => Ok(Colour::Black),
        '(' => Ok(Colour::Gray),
        _ => Err(CodeFault::Symbol { at }),
    };
    symbols.map(colour).collect()
}

/// Whether a sequence of nodes, each after the one above it, is all of one tree.
fn whole(colours: &[Colour], arity: usize) -> Result<(), CodeFault> {
    let mut missing = 1;
    for (at, &colour) in colours.iter().enumerate() {
        if missing == 0 {
            return Err(CodeFault::Trailing { at });
        }
        missing = if colour == Colour::Gray { missing + arity - 1 } else { missing - 1 };
    }
    if missing == 0 { Ok(()) } else { Err(CodeFault::Truncated { at: colours.len() }) }
}
