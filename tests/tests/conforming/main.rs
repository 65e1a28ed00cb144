//! Triangulations with Steiner points: judged in exact ratios, the same in any order of input, and beside CGAL's.
//!
//! | module | inputs |
//! |---|---|
//! | `workloads` | the corpus: workloads, inputs by hand, regressions |
//! | `files` | the collected files |
//! | `refined` | the same, refined |
//! | `effort` | no input: bounds of effort, ratios |

mod effort;
mod files;
mod refined;
mod workloads;
