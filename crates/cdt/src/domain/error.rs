//! Why a rule has no answer.

use std::fmt;

/// A vertex where the chain of the input does not close.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpenVertex {
    /// The first input point at the vertex; crossings are numbered after the input points.
    pub point: u32,
    /// Where it is.
    pub at: [f64; 2],
    /// How many segments end here, if parity counts; else how many more come than go.
    pub excess: i64,
}

/// What is wrong with a seed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SeedFault {
    /// It has no position.
    NotFinite {
        /// The seed, by index.
        seed: usize,
    },
    /// It lies on a segment, so it belongs to no region.
    OnSegment {
        /// The seed, by index.
        seed: usize,
        /// Where it is.
        at: [f64; 2],
        /// The ends of the subsegment.
        ends: [[f64; 2]; 2],
    },
}

/// Why a rule has no answer: every violation.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum FillError {
    /// An odd number of segments ends at these vertices: nothing has them as its boundary.
    OddVertices(Vec<OpenVertex>),
    /// At these vertices not as many segments come as go: nothing has them as its oriented boundary.
    Unbalanced(Vec<OpenVertex>),
    /// Seeds that are in no region.
    Seeds(Vec<SeedFault>),
    /// There must be one role for each input segment.
    Roles {
        /// The input segments.
        segments: usize,
        /// The roles.
        roles: usize,
    },
}

impl fmt::Display for SeedFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { seed } => {
                write!(f, "seed {seed} is not finite: give finite coordinates")
            }
            Self::OnSegment { seed, at: [x, y], ends: [[a, b], [c, d]] } => write!(
                f,
                "seed {seed} at ({x}, {y}) lies on the segment from ({a}, {b}) to ({c}, {d}): move it into a region"
            ),
        }
    }
}

impl fmt::Display for FillError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<String> = match self {
            Self::OddVertices(all) => {
                let line = |OpenVertex { point, at: [x, y], excess }: &OpenVertex| {
                    format!(
                        "the boundary is open: {excess} segments end at point {point} ({x}, {y}), an odd number; \
                         close it, or fill by nesting"
                    )
                };
                all.iter().map(line).collect()
            }
            Self::Unbalanced(all) => {
                let line = |OpenVertex { point, at: [x, y], excess }: &OpenVertex| {
                    let (more, less) = if *excess > 0 { ("come", "go") } else { ("go", "come") };
                    let count = excess.unsigned_abs();
                    format!(
                        "the boundary is not oriented: {count} more segments {more} than {less} at point {point} \
                         ({x}, {y}); turn them, or fill by even-odd"
                    )
                };
                all.iter().map(line).collect()
            }
            Self::Seeds(all) => all.iter().map(ToString::to_string).collect(),
            Self::Roles { segments, roles } => {
                vec![format!("{roles} roles for {segments} segments: give one for each")]
            }
        };
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for FillError {}
