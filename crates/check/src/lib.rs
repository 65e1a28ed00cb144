//! The judge: decides from definitions, in exact arithmetic of its own, whether a triangulation is
//! what it claims to be.
//!
//! ```text
//!   points, cells  --> T1 T2 each cell --> T3 facets pair up --> hull: convex, wound once
//!                      = the cells tile the convex hull
//!   with segments, flags --> K2 K4 chains, K3 flags --> D2 no other facet in conflict
//!                      = (constrained) Delaunay
//!   vertices, twins, ghost --> T4 mutual, same vertices, opposite sides, ghosts outside
//!                      = a closed mesh
//! ```
//!
//! ```
//! use delone_check::{Complex, Level, Options, judge_delaunay};
//!
//! let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
//! let complex = Complex { points: &points, dimension: Some(2), cells: &[0, 1, 2, 1, 3, 2] };
//! let verdict = judge_delaunay(&complex, &Options::default());
//! assert!(verdict.ok && verdict.level == Level::Delaunay, "{verdict}");
//!
//! let other = Complex { cells: &[0, 1, 3, 0, 3, 2], ..complex }; // the other diagonal
//! assert!(judge_delaunay(&other, &Options::default()).has("wrong-tie"));
//! assert!(judge_delaunay(&other, &Options::foreign()).ok);
//! ```
//!
//! | which one do I want | for | time |
//! |---|---|---|
//! | [`judge_delaunay`] | Delaunay in any dimension, or in a flat | sorts, O(1) signs per facet |
//! | [`judge_regular`] | regular, with weights, in any dimension | the same, plus cells times hidden points |
//! | [`judge_constrained`] | constrained Delaunay in the plane | the same, plus all chains |
//! | [`judge_arranged`] | the same where segments cross, crossings being vertices | sorts, big ratios |
//! | [`judge_conforming`] | the same with Steiner points, exactly on their segments | sorts, big ratios |
//! | [`judge_conforming_doubles`] | the same, all vertices in doubles: how far off their segments these are | as `judge_constrained` |
//! | [`judge_refined`] | that, and the least angle, but for exceptions at small input angles | the same |
//! | [`judge_fill`] | what is inside, by a rule | a ray for each region |
//! | [`judge_alpha`] | alpha filtrations: every simplex's value | the first two, and 2^D determinants a simplex |
//! | [`judge_links`] | the twins and ghosts of a mesh | sorting |
//! | [`naive`] | answers by definition, for tests | polynomial of high degree |
//!
//! **Contract.** In: plain slices; any contents. Out: a [`Verdict`] with every fault and its
//! witnesses, in an order that depends on the input alone. No input makes it panic. No tolerance,
//! no randomness, no hidden retries. With [`Options::filtered`] off, and with either [`Backend`],
//! the verdict is the same. Memory: about 200 bytes per triangle.
//!
//! **What is proved how.** That the cells tile the convex hull: [the degree
//! argument](crate::Level::Triangulation), with T1 (ids, distinctness), T2 (orientation), T3
//! (facets), T5 and the ray test (boundary), T8 (vertices). T6 (connectedness) and T7 (Euler)
//! follow from these and are checked as well. Delaunay: D2, the local test, which on a tiling of
//! the hull is global. Ties: by the perturbation that raises each height `|p|^2` by an
//! infinitesimal that grows with lexicographic rank. It depends on no order of input.
//!
//! **Not here.** Carved domains;
//! predicates of the algorithms, of which nothing is used; drawing; JSON (every field of a verdict
//! is public, every fault has a text and a [kind](Fault::kind)).
//!
//! **Modules.** `exact` numbers, `space` predicates, `facets` pairing, `sites` T8, `cells` T1 T2,
//! `triangulation` T3 T6 T7, `hull` T5 and the ray, `local` D2, `alpha` A1 A2, `regular` hidden points, `chains` K2 K3 K4, `links` T4.

mod alpha;
mod arranged;
mod cells;
mod chains;
mod conforming;
mod constrained;
mod delaunay;
mod exact;
mod facets;
mod fault;
mod fill;
mod hull;
mod links;
mod local;
pub mod naive;
mod options;
mod regular;
mod scene;
mod sites;
mod space;
#[cfg(test)]
mod testing;
mod triangulation;
mod verdict;

pub use alpha::judge_alpha;
pub use arranged::{Arranged, judge_arranged};
pub use cells::Complex;
pub use conforming::{
    Angles, Binary, Conformed, Promise, SteinerPoint, judge_conforming, judge_conforming_doubles,
    judge_refined,
};
pub use constrained::judge_constrained;
pub use delaunay::judge_delaunay;
pub use fault::{Fault, Simplex, Witness};
pub use fill::{FillRule, judge_fill};
pub use links::{Links, judge_links};
pub use options::{Backend, Options, Orientation, Ties};
pub use regular::judge_regular;
pub use verdict::{Level, Verdict};
