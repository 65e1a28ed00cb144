//! Points moved by (ε, ε², ..) for an infinitesimal ε: they are on no segment and on no triangle.

use delone_predicates::{Sign, orient2d};

/// Whether a point of the plane, moved so that its coordinate `major` moves by far the most, is to the left of the line from
/// `a` to another point `b`.
///
/// On the line the cross product of b - a and the move δ decides: d_0 δ_1 - d_1 δ_0.
pub(crate) fn is_left(a: [f64; 2], b: [f64; 2], point: [f64; 2], major: usize) -> bool {
    match (orient2d(a, b, point), major) {
        (Sign::Positive, _) => true,
        (Sign::Negative, _) => false,
        (Sign::Zero, 0) => b[1] < a[1] || (b[1] == a[1] && b[0] > a[0]),
        (Sign::Zero, _) => b[0] > a[0] || (b[0] == a[0] && b[1] < a[1]),
    }
}

/// The corner of a rectangle that is furthest to the left of the direction from `a` to `b`.
pub(crate) fn leftmost(a: [f64; 2], b: [f64; 2], lower: [f64; 2], upper: [f64; 2]) -> [f64; 2] {
    [if b[1] > a[1] { lower[0] } else { upper[0] }, if b[0] > a[0] { upper[1] } else { lower[1] }]
}
