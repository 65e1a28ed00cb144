//! Point sets of space. Each gives exactly `n` sites.

pub(crate) mod flat;
pub(crate) mod range;
pub(crate) mod solid;
pub(crate) mod spheres;

/// Sites of space.
pub(crate) type Space = Vec<[f64; 3]>;

#[cfg(test)]
mod tests;
