//! The cells of the predicates' benchmark: predicate x input x contestant.
//!
//! **Inputs.** R: uniform in the unit cube. N: near-degenerate, points rounded onto a common line (256 x 256 neighbours
//! of (1/2, 1/2) against (12, 12) and (24, 24), \[KMPSY08\]), circle, plane, sphere. G: exactly degenerate on an integer
//! grid of 2,000. W: exactly degenerate, full mantissas, exponents in +-20, so that differences are not doubles; Z: the same, exponents
//! in +-350. V and X: exponents in +-350 and +-950, not degenerate.
//!
//! **Biases.** Ours are measured on R with the static filter's bounds known beforehand, as an algorithm has them.
//! Inputs of one cell are of one kind, so branches on the stage are predictable; signs are not.

mod batch;
mod cgal;
mod constructed;
mod contestants;
mod inputs;
mod instructions;

pub use batch::batches;
pub use cgal::Cgal;
pub use constructed::constructions;
pub use contestants::{Contestant, contestants};
pub use inputs::{Input, tuples};
pub use instructions::{instructions_of, repeat};

/// A predicate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Predicate {
    /// Three points in the plane.
    Orient2d,
    /// Four points in the plane.
    InCircle,
    /// Four points in space.
    Orient3d,
    /// Five points in space.
    InSphere,
}

impl Predicate {
    /// All.
    pub const ALL: [Self; 4] = [Self::Orient2d, Self::InCircle, Self::Orient3d, Self::InSphere];

    /// Its name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Orient2d => "orient2d",
            Self::InCircle => "in_circle",
            Self::Orient3d => "orient3d",
            Self::InSphere => "in_sphere",
        }
    }
}
