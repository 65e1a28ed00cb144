//! Seeded generators of ordinary, realistic and degenerate input.
//!
//! ```
//! use delone_workloads::{Kind, all, generate};
//!
//! let coast = generate("coast", 1_000, 7)?;
//! assert_eq!(coast.points.len(), 1_000);
//! assert_eq!(coast.segments.len(), 1_000);
//!
//! let refused = generate("cost", 1_000, 7).unwrap_err();
//! assert_eq!(refused.nearest, "coast");
//!
//! assert!(all().iter().any(|w| w.kind() == Kind::Points3d));
//! # Ok::<(), delone_workloads::UnknownWorkload>(())
//! ```
//!
//! # Which one do I want
//!
//! | I want to | take |
//! |---|---|
//! | measure speed as others do | `uniform`, `gauss`, `kuzmin`, `random-segments`, `coast` |
//! | attack predicates | `ulp-grid`, `line-inexact`, `near-collinear`, `near-cocircular`, `ulp-slopes` |
//! | attack the double range | `full-range`, `denormals`, `largest`, `scaled-tiny`, `scaled-huge`, `thin-strip` |
//! | attack tie-breaking | `grid`, `circle-exact`, `parallel-lines`, `nested-polygons`, `cocircular-chords`, `cospherical` |
//! | attack low dimension | `line-*`, `all-equal`, `coplanar`, `collinear-3d`, and any of them with n below 4 |
//! | attack worst-case cost | `ladder`, `rails`, `fan`, `comb`, `skew-lines`, `moment-curve` |
//! | attack validation | `t-junctions`, `overlaps`, `crossing-*` |
//!
//! # Contract
//!
//! - [`generate`] is a pure function of name, n and seed, with the same bits on every machine: arithmetic is `+ - * /` and
//!   `sqrt` on doubles, and integers. A test pins the fingerprint of every workload.
//! - Every workload takes every n, 0 included, and costs O(n log n) or less. How it rounds n is [`Workload::rounds`].
//! - How segments may meet is [`Workload::meets`]; a brute-force test in exact arithmetic holds each to it.
//!
//! - [`CLASSROOM`] is apart: three published lines, to draw where a rounded orientation is wrong beside them.
//!
//! Not here: reading files (`formats`), validation (`sites`), mutation and shrinking of inputs (the lab).

mod classroom;
mod fingerprint;
mod input;
mod num;
#[cfg(test)]
mod pinned;
mod points2d;
mod points3d;
mod pslg;
mod registry;
mod rng;
mod text;

pub use classroom::{CLASSROOM, Classroom};
pub use input::{Input, Points};
pub use registry::{Kind, Meets, SITES_MAX, UnknownWorkload, Workload, all, find, generate};
pub use rng::Rng;
pub use text::{Align, Layout, NoGlyph, outlines, strokes};
