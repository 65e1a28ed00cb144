//! The rules.

/// What is inside.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum Fill {
    /// The whole convex hull.
    #[default]
    Hull,
    /// What an odd number of segments separates from infinity, each counted as often as it is given.
    EvenOdd,
    /// What the segments wind around, whichever way; they have directions.
    NonZero,
    /// What the segments wind around counter-clockwise more often than clockwise.
    Positive,
    /// What lies at odd depth: depth is the fewest segments on any way from infinity, each counted once.
    Nesting,
    /// Everything that is not reached from infinity without crossing a segment.
    Exterior,
    /// That, less the regions in which these points lie.
    Seeds(Vec<[f64; 2]>),
    /// Even-odd by the segments that are boundaries; a role for each input segment.
    Tagged(Vec<Role>),
}

/// What an input segment is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// It bounds: on its two sides, inside and outside.
    Boundary,
    /// It is an edge of the triangulation, and separates regions, but does not bound.
    Interface,
}
