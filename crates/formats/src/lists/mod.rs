//! Small text formats of other people's test suites: numbers, counts and a keyword here and there.

pub(crate) mod boost;
pub(crate) mod cin;
pub(crate) mod clipper;
pub(crate) mod contours;
pub(crate) mod detria;
pub(crate) mod gshhg;
pub(crate) mod manifold;
pub(crate) mod p2t;
pub(crate) mod segments;
pub(crate) mod vertex_edge;

#[cfg(test)]
mod tests;

use crate::error::ReadError;
use crate::text::Tokens;

/// `count` points of two coordinates.
pub(crate) fn take_points(
    tokens: &mut Tokens<'_>,
    count: usize,
) -> Result<Vec<[f64; 2]>, ReadError> {
    let mut points = Vec::new();
    for _ in 0..count {
        points.push([tokens.number("an x coordinate")?, tokens.number("a y coordinate")?]);
    }
    Ok(points)
}
