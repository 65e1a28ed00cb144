//! Alpha filtrations, complexes and shapes, with or without weights, in any dimension; and their persistent homology.
//!
//! Balls grow around sites. The alpha complex at a squared radius holds the simplices of the Delaunay triangulation whose sites'
//! balls meet within their Voronoi regions; it has the homotopy type of the union of the balls.
//!
//! ```
//! use delone_alpha::{AlphaFiltration, AlphaParam};
//! use delone_delaunay::{Options, delaunay};
//! use delone_sites::Sites;
//!
//! let ring = [[0.0, 1.0], [2.0, 0.0], [4.0, 1.0], [5.0, 3.0], [4.0, 5.0], [2.0, 6.0], [0.0, 5.0], [-1.0, 3.0]];
//! let sites = Sites::new(&ring).unwrap();
//! let filtration = AlphaFiltration::of(&sites, &delaunay(&sites, &Options::default(), &mut ()));
//! let cut = filtration.cut(AlphaParam::Radius(1.5)).unwrap();
//! assert_eq!(filtration.betti_curves().at(cut), [1, 1]); // one component around one hole
//! ```
//!
//! # Which one do I want
//!
//! | item | paper | time | when |
//! |---|---|---|---|
//! | [`AlphaFiltration`] | \[EM94\], \[Ede92\] | O(N log N) | first: values of all N simplices |
//! | [`AlphaParam`], [`AlphaFiltration::cut`] | | O(log N) | to name one complex, by convention |
//! | [`AlphaFiltration::intervals`], [`AlphaFiltration::classify`] | \[EM94\] | O(N) | singular, regular, interior |
//! | [`AlphaFiltration::polygons`], [`Polygons::hull_arcs`] | \[EM94\] | O(N) | the boundary, in the plane |
//! | [`AlphaFiltration::betti_curves`], [`AlphaFiltration::simplex_curves`], [`AlphaFiltration::plane_measures`] | \[DE95\] | near O(N) | signatures |
//! | [`AlphaFiltration::persistence`] | \[ELZ02\], \[BKR14\] | near O(N) in the plane | what lives how long |
//!
//! # Contract
//!
//! In: a `Delaunay` or `Regular` triangulation with its sites. Constrained ones have no alpha values, and do not fit the type. Out:
//! ranks of exact values; closed balls; nothing has a tolerance. Values that are told as doubles are the nearest ones.
//! Deterministic: equal values, Betti numbers and bars of some length do not depend on how ties were broken.
//!
//! **Not here.** Triangulation (`delone-delaunay`), pictures (`delone-draw`), areas of unions of balls.

mod betti;
mod bulk;
mod filtration;
mod geometry;
mod intervals;
mod measures;
mod param;
mod persistence;
mod polygons;
mod simplices;
#[cfg(test)]
#[expect(clippy::cast_possible_truncation, reason = "the numbers of the tests are small integers")]
mod testing;

pub use delone_predicates::SquaredRadius;

pub use betti::Curves;
pub use filtration::AlphaFiltration;
pub use intervals::{Interval, Mode, Status, VertexConvention};
pub use measures::fraction;
pub use param::{AlphaParam, Critical, Cut, ParamError};
pub use persistence::{Bar, Pair, Persistence};
pub use polygons::{Polygons, Region};
pub use simplices::{SimplexId, Simplices};
