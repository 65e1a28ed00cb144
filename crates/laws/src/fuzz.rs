//! Fuzzing: cases by number, laws tried on them, failures in buckets, tallies that add up in any order.
//!
//! **Invariants.** 1. Case `k` of a target is a pure function of the seed and `k`. 2. A tally's digest is a sum over its cases,
//! so that shards merged in any order say what one process says. 3. A bucket keeps its first case, that of the least `k`.

mod attempt;
mod extra;
mod file;
mod hash;
mod table;
mod tally;
mod target;

pub use attempt::{Broken, attempt};
pub use file::File;
pub use table::{target, targets};
pub use tally::{Finding, MergeError, Shard, Tally};
pub use target::{Input, Subject, Target};

#[cfg(test)]
mod tests;
