//! Validated input: distinct finite sites, noded planar straight-line graphs, insertion orders.
//!
//! ```
//! use delone_sites::{Pslg, Sites};
//!
//! let sites = Sites::new(&[[0.0, 0.0], [1.0, 0.0], [-0.0, 0.0]]).unwrap();
//! assert_eq!((sites.len(), sites.site_of()), (2, &[0, 1, 0][..]));
//!
//! let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
//! let refused = Pslg::new(&square, &[[0, 2], [1, 3]]).unwrap_err();
//! assert_eq!(refused.to_string(),
//!     "segments 0 and 1 cross near (0.5, 0.5): split them at a common vertex");
//! ```
//!
//! # Which one do I want
//!
//! | you have | use | time |
//! |---|---|---|
//! | points | [`Sites`] | O(n log n) |
//! | points with weights | [`WeightedSites`] | O(n log n) |
//! | points and segments in the plane | [`Pslg`] | O(n log n), see its page |
//! | segments that cross | [`Arrangement`] | the same, for n with the crossings |
//! | the same, with vertices that are doubles | [`Snapped`] | some times that |
//! | sites to insert one by one | [`Sites::brio_order`] | O(n log n) |
//!
//! # Contract
//!
//! Here, and nowhere later, bad input is refused: with every violation and its witness. What passes may be as degenerate
//! as it likes. Ids are `u32` in order of first appearance.
//!
//! **Not here.** Reading files: `delone-formats`.

mod arrangement;
mod boxes;
mod chains;
mod noded;
mod order;
mod pslg;
mod sites;
mod snapped;
mod sorting;
mod strips;
mod sweep;
mod weighted;

pub use arrangement::Arrangement;
pub use chains::Chains;
pub use noded::Noded;
pub use order::{Curve, scatter, sortable};
pub use pslg::{Coverage, Crossing, Piece, Pslg, PslgError, PslgFault, Unnoded};
pub use sites::{NotFinite, Sites, SitesError};
pub use snapped::Snapped;
pub use sweep::{Ends, Swept, compare_along, sweep};
pub use weighted::{WeightedSites, WeightsError};

#[cfg(test)]
#[expect(clippy::cast_possible_truncation, reason = "the numbers of the tests are small")]
mod tests;
