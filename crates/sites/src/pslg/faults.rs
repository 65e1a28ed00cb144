//! What can be wrong with a planar straight-line graph, with indices and coordinates.

use std::fmt;

use crate::{NotFinite, SitesError};

/// Two input segments that cross in their interiors, away from any site.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The two segments, by input index.
    pub segments: [u32; 2],
    /// Where, in doubles, rounded.
    pub near: [f64; 2],
}

/// One thing wrong with a planar straight-line graph.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PslgFault {
    /// A coordinate is NaN or infinite.
    NotFinite(NotFinite),
    /// A segment names a point that is not there.
    NoSuchPoint {
        /// The segment, by input index.
        segment: usize,
        /// What it names.
        point: usize,
        /// How many points there are.
        count: usize,
    },
    /// Two segments cross.
    Crossing(Crossing),
    /// A point equals an earlier one. Refused by [`Pslg::strict`](crate::Pslg::strict) only.
    DuplicatePoint {
        /// The point, by input index.
        point: usize,
        /// The first of its position.
        first: usize,
        /// Where.
        at: [f64; 2],
    },
    /// Both ends of a segment are one position. Refused by [`Pslg::strict`](crate::Pslg::strict) only.
    ZeroLength {
        /// The segment, by input index.
        segment: usize,
        /// Where.
        at: [f64; 2],
    },
    /// A point lies inside a segment. Refused by [`Pslg::strict`](crate::Pslg::strict) only.
    Junction {
        /// The segment, by input index.
        segment: usize,
        /// The point, by input index.
        point: usize,
        /// Where.
        at: [f64; 2],
    },
    /// Two segments have more than a point in common. Refused by [`Pslg::strict`](crate::Pslg::strict) only.
    Overlap {
        /// The two segments, by input index. Of more than two on one piece, each with the next.
        segments: [usize; 2],
        /// The ends of the first piece that they share; of the segment, if they are the same.
        piece: [[f64; 2]; 2],
        /// Whether they are one and the same segment.
        same: bool,
    },
    /// More points or segments than ids.
    TooMany(usize),
}

/// Why a planar straight-line graph was refused: every fault.
#[derive(Clone, Debug, PartialEq)]
pub struct PslgError(pub Vec<PslgFault>);

impl fmt::Display for PslgFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite(fault) => fault.fmt(f),
            Self::NoSuchPoint { segment, point, count } => {
                write!(
                    f,
                    "segment {segment} names point {point}, but there are {count} points: indices go from 0"
                )
            }
            Self::Crossing(Crossing { segments: [a, b], near: [x, y] }) => write!(
                f,
                "segments {a} and {b} cross near ({x}, {y}): split them at a common vertex"
            ),
            Self::DuplicatePoint { point, first, at: [x, y] } => {
                write!(f, "point {point} at ({x}, {y}) equals point {first}: list it once")
            }
            Self::ZeroLength { segment, at: [x, y] } => {
                write!(f, "segment {segment} has no length, at ({x}, {y}): leave it out")
            }
            Self::Junction { segment, point, at: [x, y] } => write!(
                f,
                "point {point} at ({x}, {y}) lies inside segment {segment}: split the segment there"
            ),
            Self::Overlap { segments: [a, b], same: true, piece: [[x, y], [u, v]] } => write!(
                f,
                "segments {a} and {b} are the same, from ({x}, {y}) to ({u}, {v}): list it once"
            ),
            Self::Overlap { segments: [a, b], same: false, piece: [[x, y], [u, v]] } => write!(
                f,
                "segments {a} and {b} overlap, from ({x}, {y}) to ({u}, {v}): split them there"
            ),
            Self::TooMany(count) => {
                write!(f, "{count} points or segments are more than ids can name")
            }
        }
    }
}

impl fmt::Display for PslgError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<String> = self.0.iter().map(ToString::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for PslgError {}

impl From<SitesError> for PslgError {
    fn from(error: SitesError) -> Self {
        match error {
            SitesError::NotFinite(all) => Self(all.into_iter().map(PslgFault::NotFinite).collect()),
            SitesError::TooMany(count) => Self(vec![PslgFault::TooMany(count)]),
        }
    }
}
