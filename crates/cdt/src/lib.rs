//! Constrained Delaunay triangulations in the plane: one canonical answer, whatever the algorithm.
//!
//! ```
//! use delone_cdt::cavity;
//! use delone_delaunay::Options;
//! use delone_sites::Pslg;
//!
//! let kite = [[0.0, 0.0], [3.0, 1.0], [6.0, 0.0], [3.0, -1.0]];
//! let pslg = Pslg::new(&kite, &[[0, 2]]).unwrap(); // the long diagonal, which is not Delaunay
//! let cdt = cavity(&pslg, &Options::default(), &mut ());
//! assert_eq!(cdt.canonical(), [0, 1, 2, 0, 2, 3]);
//! assert_eq!(cdt.constrained_edges(), [[0, 2]]);
//! ```
//!
//! # Which one do I want
//!
//! | module | paper | time | when |
//! |---|---|---|---|
//! | [`from_points()`] | \[SB15\] | that of [`cavity()`] | points and segments, to be noded on the way: the quickest |
//! | [`chew_from_points()`] | \[Che89\], \[SH76\] | that of [`chew()`] | the same by one sweep and [`chew()`] |
//! | [`chew()`] | \[Che89\] | O(n log n), whatever the segments | long segments that cross everything |
//! | [`cavity()`] | \[SB15\] | Delaunay, then expected O(1) for each edge crossed | short segments, as on maps |
//! | [`flips()`] | \[Slo93\], \[Law77\] | Delaunay, then O(m^2) flips for m edges crossed | to compare |
//! | [`insert_segments`] | \[SB15\] | the second half of it | your own kernel or Delaunay mesh |
//!
//! | and then | what it is | time |
//! |---|---|---|
//! | [`Regions`] | what the segments cut the plane into | O(n) |
//! | [`Domain`] | which regions are inside, by a [`Fill`] rule; exact areas, kinds of edges, points in holes | O(n) |
//! | [`Dynamic`] | vertices and segments put in and taken out, the rest adapting | near what changes |
//! | [`triangulate2d`] | `(V, EV)` to `(V, [EV, FV])`: the inside of a soup of edges | that of [`cavity()`] |
//!
//! # Contract
//!
//! In: [`delone_sites::Pslg`], noded. Out: [`Cdt`], a mesh whose edges contain every segment, Delaunay up to visibility.
//! The whole convex hull is triangulated. Deterministic: same points and segments, same cells. Nothing fails.
//!
//! **Not here.** Noding and refusal of crossings (`delone-sites`), judgement (`delone-check`).

mod area;
mod cavity;
mod chain;
mod chew;
mod domain;
mod dynamic;
mod fill;
mod flips;
mod from_points;
mod naive;
mod regions;
mod registry;
mod result;
mod triangulate2d;

pub use area::Area;
pub use cavity::insert_segments;
pub use domain::{Domain, EdgeKind, Fill, FillError, Inside, OpenVertex, Role, SeedFault};
pub use dynamic::{Dynamic, Kept};
pub use flips::Blocked;
pub use from_points::{chew_from_points, from_points};
pub use regions::{RegionId, Regions};
pub use registry::{Algorithm, FromPoints, algorithms, cavity, cdt_of_arrangement, chew, flips};
pub use result::{Cdt, constrained_half_edges};
pub use triangulate2d::{Interior, InteriorError, triangulate2d};

#[cfg(test)]
#[expect(clippy::cast_possible_truncation, reason = "the numbers of the tests are small")]
mod tests;
