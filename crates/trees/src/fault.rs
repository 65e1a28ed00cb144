//! Why a code was refused.

use std::fmt;

/// Why a code is not the code of a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CodeFault {
    /// It ends before the tree does.
    Truncated {
        /// Where.
        at: usize,
    },
    /// It goes on when the tree is complete.
    Trailing {
        /// Where.
        at: usize,
    },
    /// A gray node at the level of the smallest cells.
    TooDeep {
        /// Where.
        at: usize,
    },
    /// A symbol that means nothing.
    Symbol {
        /// Where.
        at: usize,
    },
    /// A cell that overlaps one before it, or should have come before it.
    Disorder {
        /// Where.
        at: usize,
    },
    /// A node's hyperplane is not on the axis whose turn it is.
    Axis {
        /// Where.
        at: usize,
        /// The axis whose turn it is, from 0.
        expected: usize,
    },
    /// A node's hyperplane does not cut its cell, or is not where it is needed.
    Hyperplane {
        /// Where.
        at: usize,
    },
    /// A raster of more cells than can be held, or of fewer than the tree needs.
    Raster {
        /// Levels between the root and the raster's cells.
        depth: u8,
    },
}

impl fmt::Display for CodeFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Truncated { at } => {
                write!(f, "the code ends at {at} before its tree: append what is missing")
            }
            Self::Trailing { at } => write!(f, "the tree is complete before {at}: drop the rest"),
            Self::TooDeep { at } => {
                write!(f, "node {at} is deeper than cells go: cut the tree off above it")
            }
            Self::Symbol { at } => {
                write!(f, "the symbol at {at} is none of this encoding: see its page")
            }
            Self::Disorder { at } => {
                write!(
                    f,
                    "cell {at} overlaps one before it or should precede it: sort, keep disjoint cells"
                )
            }
            Self::Axis { at, expected } => {
                write!(
                    f,
                    "node {at} is cut on the wrong axis: axes alternate, here it is {expected}"
                )
            }
            Self::Hyperplane { at } => {
                write!(
                    f,
                    "the hyperplane of node {at} is not inside its cell, or not its middle where that is needed"
                )
            }
            Self::Raster { depth } => {
                write!(
                    f,
                    "a raster of depth {depth} is too coarse for the tree or too large: choose another"
                )
            }
        }
    }
}

impl std::error::Error for CodeFault {}
