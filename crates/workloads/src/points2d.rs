//! Point sets of the plane. Each gives exactly `n` sites unless its row of the registry says otherwise.

pub(crate) mod circles;
pub(crate) mod lattices;
pub(crate) mod lines;
pub(crate) mod range;
pub(crate) mod repeats;
pub(crate) mod scatter;
pub(crate) mod worst;

/// Sites of the plane.
pub(crate) type Plane = Vec<[f64; 2]>;

#[cfg(test)]
mod tests;
