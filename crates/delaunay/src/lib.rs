//! Delaunay triangulation in any dimension: one canonical answer, whatever the algorithm and the order.
//!
//! ```
//! use delone_delaunay::{Options, delaunay};
//! use delone_sites::Sites;
//!
//! let sites = Sites::new(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]).unwrap();
//! let triangulation = delaunay(&sites, &Options::default(), &mut ());
//! // The four corners are cocircular: the perturbation picks one of two diagonals, always the same.
//! assert_eq!(triangulation.canonical(), [0, 1, 3, 1, 2, 3]);
//! ```
//!
//! # Which one do I want
//!
//! | module | paper | time | when |
//! |---|---|---|---|
//! | [`delaunay()`] | | | always, unless you compare algorithms |
//! | [`divide_conquer()`] | \[GS85\], \[Dwy87\] | O(n log n) | the plane: the fastest, and on several threads |
//! | [`bowyer_watson()`] | \[Bow81\], \[Wat81\] | expected O(n log n) in the plane | any dimension, your own kernel |
//! | [`flips()`] | \[Law77\], \[GKS92\] | expected O(n log n) | the plane, to compare |
//! | [`sweep()`] | \[For87\] | O(n log n) | the plane, to compare |
//! | [`flip_to_delaunay`] | \[Law77\] | O(n^2) | you have some triangulation of the plane |
//! | [`regular()`] | \[ES96\] | expected O(n log n) in the plane | sites have weights |
//! | [`Dynamic`] | \[Bow81\], \[DT03\] | O(degree) after location | sites come and go |
//! | [`delaunay_unless_stopped`], [`regular_unless_stopped`] | | | it may take long, and be cancelled |
//! | [`locate()`], [`nearest_sites`], [`natural_neighbours`] | \[DPT02\], \[Sib80\] | O(1) a point if there are many | you have points to ask about |
//! | [`PowerDiagram`] | | O(n) | you want Voronoi's diagram, exactly |
//! | [`naive_delaunay`] | the definition | O(n^(D+2)) | to test the others |
//!
//! # Contract
//!
//! In: [`delone_sites::Sites`], as degenerate as they like. Out: [`Delaunay`], a mesh of the dimension of the sites' affine
//! hull. Deterministic: same points, same cells, for every order, seed and kernel. Nothing fails.
//!
//! With weights: [`delone_sites::WeightedSites`] in, [`Regular`] out, which names the hidden sites. What can be stopped says so
//! in its name. Constructions ([`PowerDiagram`]) are rational and exact, but for what is called rounded, or drawn.
//!
//! **Not here.** Constraints (`delone-cdt`), judgement (`delone-check`).

mod bowyer_watson;
mod conflict;
mod divide_conquer;
mod dynamic;
mod flat;
mod flips;
mod locate;
mod located;
mod naive;
mod natural;
mod nearest;
mod numbers;
mod queries;
mod registry;
mod regular;
mod result;
mod star;
mod sweep;
mod voronoi;

pub use bowyer_watson::bowyer_watson;
pub use conflict::{dig_conflicts, in_conflict};
pub use divide_conquer::{divide_conquer, divide_conquer_in_parallel, divide_conquer_sorted};
pub use dynamic::{Dynamic, Inserted};
pub use flips::{flip_to_delaunay, flips};
pub use locate::{Coin, walk};
pub use located::{LocateError, Located, locate};
pub use naive::{naive_delaunay, naive_mesh};
pub use natural::natural_neighbours;
pub use nearest::nearest_sites;
pub use numbers::ExactPoint;
pub use registry::{
    Algorithm, KernelKind, Options, Order, Stoppable, Stopped, algorithms, delaunay,
    delaunay_unless_stopped,
};
pub use regular::{Regular, regular, regular_unless_stopped};
pub use result::{Delaunay, Fingerprint};
pub use sweep::sweep;
pub use voronoi::{Dual, PowerDiagram, Region};

#[cfg(test)]
mod tests;
