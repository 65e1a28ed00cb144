//! The judge.

mod cells;
mod chains;
mod constrained;
mod delaunay;
mod exact;
mod facets;
mod fault;
mod hull;
mod links;
mod local;
pub mod naive;
mod options;
mod sites;
mod space;
#[cfg(test)]
mod testing;
mod triangulation;
mod verdict;

pub use cells::Complex;
pub use constrained::judge_constrained;
pub use delaunay::judge_delaunay;
pub use fault::{Fault, Simplex, Witness};
pub use links::{Links, judge_links};
pub use options::{Backend, Options, Orientation, Ties};
pub use verdict::{Level, Verdict};
