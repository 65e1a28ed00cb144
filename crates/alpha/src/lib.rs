//! Alpha filtrations.

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

pub use betti::Curves;
pub use filtration::AlphaFiltration;
pub use delone_predicates::SquaredRadius;

pub use intervals::{Interval, Mode, Status, VertexConvention};
pub use measures::fraction;
pub use param::{AlphaParam, Critical, Cut, ParamError};
pub use persistence::{Bar, Pair, Persistence};
pub use polygons::{Polygons, Region};
pub use simplices::{SimplexId, Simplices};
