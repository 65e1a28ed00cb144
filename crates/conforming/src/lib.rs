//! Triangulations with Steiner points: conforming Delaunay, and quality refinement.
//!
//! ```
//! use delone_conforming::{Missing, conform};
//! use delone_sites::Pslg;
//!
//! let kite = [[0.0, 0.0], [3.0, 1.0], [6.0, 0.0], [3.0, -1.0]];
//! let pslg = Pslg::new(&kite, &[[0, 2]]).unwrap();
//! let conforming = conform(&pslg, &Missing, &Default::default(), &mut ());
//! assert_eq!(conforming.steiner_points().len(), 1);
//! ```
//!
//! # Which one do I want
//!
//! | method | splits | guarantees | when |
//! |---|---|---|---|
//! | [`conform`] with [`Missing`] | what is no edge | Delaunay, all segments in it | fewest points |
//! | [`conform`] with [`Encroached`] | what has a vertex in its diametral disk | that all these are empty too | the strongest |
//! | [`conform_by_protection`] | before any triangulation, if gaps are not narrow | the same | to compare: \[Saa91\] |
//!
//! | refinement | points | encroachment | when |
//! |---|---|---|---|
//! | \[Ung09\], the default | [`Centre::OffCentre`] | [`Encroachment::Lens`] | fewest vertices |
//! | \[Che93\] | [`Centre::Circumcentre`] | [`Encroachment::Lens`] | to compare |
//! | \[Rup95\] | [`Centre::Circumcentre`] | [`Encroachment::Disk`] | diametral disks empty of what is inside |
//!
//! # Contract
//!
//! In: [`delone_sites::Pslg`], noded. Out: [`Conforming`]; of [`refine`], [`Refined`] around it, with regions, sides and what was left alone. A Steiner point is exactly on its segment: `a + t (b - a)` with t a
//! number of as many bits as it takes; the union of the pieces *is* the segment. Positions in doubles are for drawing and
//! export. All methods end on all input, whatever the angles and gaps; there is no bound on the points in the size of the input alone:
//! give [`Limits`] where that matters.
//!
//! **Not here.** \[ET93\], with its polynomial bound on the number of points: theoretical; not implemented. Crossings
//! (`delone-sites` refuses them). Judgement (`delone-check`).

mod apexes;
mod conform;
mod live;
mod parameter;
mod ratio;
mod refine;
mod registry;
mod result;
mod saalfeld;
mod split;
mod vector;

pub use conform::{
    ConformOptions, Criterion, Encroached, Limits, Missing, Subsegment, conform,
    conform_by_protection,
};
pub use refine::{
    Centre, Encroachment, Gap, LeftAlone, Reason, RefineOptions, Refined, SizeField, narrowest_gap,
    refine,
};
pub use registry::{Method, methods};
pub use result::{Conforming, SteinerPoint};
pub use split::Placement;

#[cfg(test)]
mod testing;
