//! What the benchmarks share: inputs, contestants, the oracle.
//!
//! | run | for |
//! |---|---|
//! | `cargo bench -p delone-benches` | criterion's statistics: predicates, Delaunay and constrained triangulations, one by one |
//! | `cargo run --release -p delone-benches --bin predicates_table` | the table of `records/`: contestants interleaved, ratios |
//! | `cargo run --release -p delone-benches --bin triangulation_table` | triangulations beside their peers: medians, ratios, verdicts |
//! | `cargo run --release -p delone-benches --bin soak -- 100000000` | so many calls against the oracle |

pub mod adversary;
pub mod oracle;
pub mod predicates;
pub mod random;
pub mod triangulations;
