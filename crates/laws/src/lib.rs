//! What holds of every input, and inputs that try it: laws, structured generation, fuzzing, shrinking.
//!
//! ```
//! use delone_laws::fuzz::{Shard, Tally, target};
//!
//! let target = target("cdt").expect("there is such a target");
//! let mut tally = Tally::new(&target, 7, Shard::WHOLE);
//! (0..20).for_each(|_| tally.step(&target));
//! assert_eq!((tally.executions, tally.findings.len()), (20, 0));
//!
//! // A case is a pure function of target, seed and number, so that shards add up in any order.
//! let halves = [1, 0].map(|part| {
//!     let mut half = Tally::new(&target, 7, Shard::of(part, 2).expect("part < 2"));
//!     (0..10).for_each(|_| half.step(&target));
//!     half
//! });
//! assert_eq!(Tally::merged(&halves).expect("they fit").digest, tally.digest);
//! ```
//!
//! # Which one do I want
//!
//! | I want to | take |
//! |---|---|
//! | demand every law of one input | [`laws`] |
//! | inputs that break triangulators | [`generate`] |
//! | many inputs, counted, in shards | [`fuzz`] |
//! | inputs with pieces of your own files in them | [`corpus`] |
//! | the smallest input that still fails | [`shrink()`] |
//! | judge another program's triangles | [`foreign`] |
//! | results as plain data before the judge | [`judge`], [`cells`] |
//!
//! A law *panics* where it is broken, with the invariant in its message, as a bug in an algorithm does; [`fuzz`] catches both alike.
//!
//! Not here: clocks, files, processes (the lab); the corpus of files and opponents (the tests).

#![expect(clippy::missing_panics_doc, reason = "panicking is how a law speaks")]

pub mod case;
pub mod cells;
pub mod choices;
pub mod corpus;
pub mod exact;
pub mod foreign;
pub mod fuzz;
pub mod generate;
pub mod judge;
pub mod laws;
mod shrink;

pub use shrink::{Effort, shrink};

/// An index as an id.
#[must_use]
pub fn id(index: usize) -> u32 {
    u32::try_from(index).expect("inputs of laws have fewer than 2^32 points")
}
