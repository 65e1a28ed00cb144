//! What can be wrong with a triangulation, each with its witnesses.

mod text;

/// An input point as a witness: its id and coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Witness {
    /// The id of the point.
    pub id: u32,
    /// Its coordinates.
    pub at: Vec<f64>,
}

/// A simplex as a witness: its corners, in the order given or ascending for a face.
pub type Simplex = Vec<Witness>;

/// One violation. `Display` gives one sentence with indices and coordinates; [`Fault::kind`] its
/// short name.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the fields are named after what they hold")]
pub enum Fault {
    /// A coordinate is NaN or infinite.
    NotFinite { point: Witness },
    /// A weight is NaN or infinite.
    WeightNotFinite { point: Witness, weight: f64 },
    /// A flat array does not hold a whole number of simplices, or two arrays differ in length.
    BadLength { array: &'static str, length: usize, expected: String },
    /// The dimension claimed is impossible for these points.
    BadDimension { dimension: Option<usize>, ambient: usize, points: usize },
    /// A vertex id is not the id of a point.
    IdOutOfRange { cell: usize, id: u32, points: usize },
    /// A cell has a vertex twice.
    RepeatedVertex { cell: usize, vertices: Vec<u32> },
    /// The same vertices make up two cells.
    DuplicateCell { first: usize, second: usize, vertices: Vec<u32> },
    /// A cell has no volume.
    FlatCell { cell: usize, corners: Simplex },
    /// A cell is oriented negatively (or, in a flat, unlike the first).
    NegativeCell { cell: usize, corners: Simplex },
    /// A point is not in the flat spanned by a cell, so the dimension claimed is too small.
    OffFlat { point: Witness, flat: Simplex },
    /// Two cells lie on the same side of their common facet.
    FoldedFacet { facet: Simplex, cells: [usize; 2] },
    /// More than two cells share a facet.
    CrowdedFacet { facet: Simplex, cells: usize },
    /// A face of the boundary's facets is not shared by exactly two of them, with opposite
    /// orientation.
    OpenBoundary { ridge: Simplex, facets: usize },
    /// The cells (or the boundary's facets) are not connected.
    Disconnected { what: &'static str, pieces: usize },
    /// The boundary is not convex: beyond this facet lies a vertex of its neighbour.
    ReflexRidge { facet: Simplex, beyond: Witness },
    /// An interior point of a cell is not strictly inside this facet of the boundary.
    UnseenFacet { facet: Simplex, cell: Simplex },
    /// The boundary winds around an interior point more than once: the cells overlap.
    WindsAgain { facet: Simplex, cell: Simplex, times: usize },
    /// No ray in general position was found; nothing was decided.
    RayUndecided { facet: Simplex },
    /// The Euler characteristic is wrong.
    Euler { found: isize, expected: isize },
    /// A point, equal to no used point, is not used.
    UnusedPoint { point: Witness },
    /// Two used points are equal.
    DuplicatePoint { point: Witness, first: u32 },
    /// A point is strictly inside the sphere of a cell next to it.
    NotDelaunay { cell: Simplex, inside: Witness },
    /// A point is on the sphere of a cell next to it, and the perturbation puts it inside.
    WrongTie { cell: Simplex, inside: Witness },
    /// A point is no vertex, and yet in conflict with a cell.
    NotHidden { point: Witness, cell: Simplex },
    /// A point is no vertex, and yet beyond a facet of the boundary.
    BeyondHull { point: Witness, facet: Simplex },
    /// A segment has an endpoint that is not the id of a point.
    SegmentOutOfRange { segment: usize, id: u32, points: usize },
    /// A segment is not a chain of edges: none leads on from `stuck` towards the other end.
    BrokenSegment { segment: usize, ends: Simplex, stuck: Witness },
    /// An edge on an input segment is not flagged as constrained.
    MissingFlag { edge: Simplex, segment: usize },
    /// An edge on no input segment is flagged as constrained.
    ExtraFlag { edge: Simplex },
    /// What is flagged as constrained is not an edge.
    FlagNotEdge { ends: [u32; 2] },
    /// Two cells with no segment between them (or one cell, and the outside) are on different sides of the fill.
    FillLeaks { edge: Simplex },
    /// A cell is inside and should not be, or the other way.
    WrongSide { cell: Simplex, inside: bool },
    /// A Steiner point is not strictly between the ends of a segment, or on no segment.
    OffSegment { point: u32, ends: Simplex },
    /// A point that edges lead through along a segment is this far off it, to the nearest double but for its last bits.
    BesideSegment { segment: usize, ends: Simplex, point: Witness, distance: f64 },
    /// A vertex is in the closed diametral disk of a subsegment.
    EncroachedEdge { edge: Simplex, by: Witness },
    /// A cell inside has an angle that is less than the least, and is no exception.
    SmallAngle { cell: Simplex, at: Witness },
    /// A cell is said to be an exception, and touches no two segments that meet at less than 60 degrees.
    NoException { cell: Simplex },
    /// A simplex is no face of the cells, or was told before.
    ExtraSimplex { simplex: Simplex },
    /// A face of the cells was not told.
    MissingSimplex { simplex: Simplex },
    /// The value of a simplex is another.
    WrongValue { simplex: Simplex, claimed: String, value: String },
    /// A cell has the ghost vertex twice.
    TwoGhosts { cell: usize },
    /// A twin is not the number of a facet.
    TwinOutOfRange { facet: usize, twin: usize },
    /// The twin of a facet's twin is another facet.
    TwinNotMutual { facet: usize, twin: usize, back: usize },
    /// Twins have different vertices.
    TwinMismatch { facet: usize, twin: usize, vertices: [Vec<u32>; 2] },
    /// Twins see their facet from the same side.
    TwinOrientation { facet: usize, twin: usize, vertices: Vec<u32> },
    /// A facet's vertices do not occur in exactly two cells of the closed mesh.
    NotClosed { vertices: Vec<u32>, cells: usize },
    /// Beyond the outer facet of a ghost cell there is another ghost cell.
    GhostBesideGhost { cell: usize, beyond: usize },
}

impl Fault {
    /// The short name of this kind of fault, as in reports and JSON.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "not-finite",
            Self::BadLength { .. } => "bad-length",
            Self::BadDimension { .. } => "bad-dimension",
            Self::IdOutOfRange { .. } => "id-out-of-range",
            Self::RepeatedVertex { .. } => "repeated-vertex",
            Self::DuplicateCell { .. } => "duplicate-cell",
            Self::FlatCell { .. } => "flat-cell",
            Self::NegativeCell { .. } => "negative-cell",
            Self::OffFlat { .. } => "off-flat",
            Self::FoldedFacet { .. } => "folded-facet",
            Self::CrowdedFacet { .. } => "crowded-facet",
            Self::OpenBoundary { .. } => "open-boundary",
            Self::Disconnected { .. } => "disconnected",
            Self::ReflexRidge { .. } => "reflex-ridge",
            Self::UnseenFacet { .. } => "unseen-facet",
            Self::WindsAgain { .. } => "winds-again",
            Self::RayUndecided { .. } => "ray-undecided",
            Self::Euler { .. } => "euler",
            Self::UnusedPoint { .. } => "unused-point",
            Self::DuplicatePoint { .. } => "duplicate-point",
            Self::NotDelaunay { .. } => "not-delaunay",
            Self::WrongTie { .. } => "wrong-tie",
            Self::WeightNotFinite { .. } => "weight-not-finite",
            Self::NotHidden { .. } => "not-hidden",
            Self::BeyondHull { .. } => "beyond-hull",
            Self::SegmentOutOfRange { .. } => "segment-out-of-range",
            Self::BrokenSegment { .. } => "broken-segment",
            Self::MissingFlag { .. } => "missing-flag",
            Self::ExtraFlag { .. } => "extra-flag",
            Self::FlagNotEdge { .. } => "flag-not-edge",
            Self::FillLeaks { .. } => "fill-leaks",
            Self::WrongSide { .. } => "wrong-side",
            Self::OffSegment { .. } | Self::BesideSegment { .. } => "off-segment",
            Self::EncroachedEdge { .. } => "encroached-edge",
            Self::SmallAngle { .. } => "small-angle",
            Self::NoException { .. } => "no-exception",
            Self::ExtraSimplex { .. } => "extra-simplex",
            Self::MissingSimplex { .. } => "missing-simplex",
            Self::WrongValue { .. } => "wrong-value",
            Self::TwoGhosts { .. } => "two-ghosts",
            Self::TwinOutOfRange { .. } => "twin-out-of-range",
            Self::TwinNotMutual { .. } => "twin-not-mutual",
            Self::TwinMismatch { .. } => "twin-mismatch",
            Self::TwinOrientation { .. } => "twin-orientation",
            Self::NotClosed { .. } => "not-closed",
            Self::GhostBesideGhost { .. } => "ghost-beside-ghost",
        }
    }
}
