//! Laws that only fuzzing asks for: each crate's own, over the generator's cases; and the canary.
//!
//! | module | laws of |
//! |---|---|
//! | `predicates` | signs, the canary among them |
//! | `plane` | agreement of constrained triangulations, crossings, files written and read again |
//! | `steiner` | conforming triangulations, refinement |
//! | `alpha` | alpha filtrations, Betti numbers, persistence |
//! | `queries` | location, nearest sites, natural neighbours, Voronoi's diagram |
//! | `readers` | files of any bytes |

mod alpha;
mod plane;
mod predicates;
mod queries;
mod readers;
mod steiner;

pub(super) use alpha::of_alpha;
pub(super) use plane::{of_agreement, of_crossings, of_files};
pub(super) use predicates::{canary, of_predicates};
pub(super) use queries::{of_plane_queries, of_queries};
pub(super) use readers::{OF_READERS, file};
pub(super) use steiner::{of_conforming, of_refinement};
