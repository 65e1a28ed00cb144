//! How to judge: with which numbers, and how strictly.

/// The options of every judge. The default is the strictest judgement of delone's own output,
/// filtered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Try floating point with a proven error bound, then 128-bit integers where they provably
    /// suffice, before big integers. `false` uses big integers alone; the verdict is the same.
    pub filtered: bool,
    /// The big integers.
    pub backend: Backend,
    /// What to demand of cospherical points.
    pub ties: Ties,
    /// What to demand of the order of a cell's vertices.
    pub orientation: Orientation,
    /// How many faults of one kind to keep; all are counted.
    pub faults_max: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            filtered: true,
            backend: Backend::Pure,
            ties: Ties::Strict,
            orientation: Orientation::Positive,
            faults_max: 20,
        }
    }
}

impl Options {
    /// For the output of another program: any Delaunay triangulation will do, in any order of
    /// vertices.
    #[must_use]
    pub fn foreign() -> Self {
        Self { ties: Ties::Weak, orientation: Orientation::Any, ..Self::default() }
    }
}

/// Who computes the big integers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Backend {
    /// `dashu-int`, pure Rust.
    Pure,
    /// GMP through `rug`.
    #[cfg(feature = "rug")]
    Gmp,
}

impl Backend {
    /// All backends that were compiled in.
    #[must_use]
    pub fn all() -> &'static [Self] {
        &[
            Self::Pure,
            #[cfg(feature = "rug")]
            Self::Gmp,
        ]
    }
}

/// What to demand when a point lies exactly on the sphere of a neighbouring cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ties {
    /// The one answer of the lexicographic perturbation.
    Strict,
    /// Any answer; the ties are counted.
    Weak,
}

/// What to demand of the order of a cell's vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orientation {
    /// Positive determinants. For points in a lower-dimensional flat, where no side is up: all of
    /// one sign.
    Positive,
    /// Anything; each cell is turned positive first.
    Any,
}
