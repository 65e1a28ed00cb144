//! Triangles of space as walls.
//!
//! A triangle misses the interior of a box if and only if a plane parts them, and if one does, then one across an axis, the
//! triangle's own, or one along an axis and an edge of the triangle: the normals of facets of the box less the triangle. Planes along
//! an axis are lines in the projection along it, so that all is decided by orientations of given points.

use delone_predicates::{Sign, orient2d, orient3d};

use crate::grow::Wall;
use crate::nudge::{is_left, leftmost};

/// A triangle that is not flat. Left is where its normal (b - a) x (c - a) points to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet {
    corners: [[f64; 3]; 3],
    /// The normal's signs, those of the projections along the axes.
    normal: [Sign; 3],
    weight: i64,
}

/// The axes of the projection along an axis, in the order that makes the sign of a triangle that of its normal.
fn others(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// The projection along an axis.
fn along(axis: usize, point: [f64; 3]) -> [f64; 2] {
    others(axis).map(|other| point[other])
}

impl Facet {
    pub(super) fn new(corners: [[f64; 3]; 3], weight: i64) -> Option<Self> {
        let normal = [0, 1, 2].map(|axis| {
            let [a, b, c] = corners.map(|corner| along(axis, corner));
            orient2d(a, b, c)
        });
        (normal != [Sign::Zero; 3]).then_some(Self { corners, normal, weight })
    }

    pub(super) fn corners(&self) -> [[f64; 3]; 3] {
        self.corners
    }

    fn sides(&self, axis: usize) -> [[[f64; 2]; 2]; 3] {
        let [a, b, c] = self.corners.map(|corner| along(axis, corner));
        [[a, b], [b, c], [c, a]]
    }

    fn side_of(&self, point: [f64; 3]) -> Sign {
        let [a, b, c] = self.corners;
        orient3d(a, b, c, point)
    }

    /// Whether a plane across an axis parts it from the interior of a box.
    fn is_beside(&self, lower: [f64; 3], upper: [f64; 3]) -> bool {
        (0..3).any(|axis| {
            let place = self.corners.map(|corner| corner[axis]);
            place.iter().all(|&c| c <= lower[axis]) || place.iter().all(|&c| c >= upper[axis])
        })
    }

    /// Whether its own plane meets the interior of a box.
    fn cuts(&self, lower: [f64; 3], upper: [f64; 3]) -> bool {
        let is_up = |axis: usize| self.normal[axis] == Sign::Positive;
        let pick = |up: bool, axis: usize| if up { upper[axis] } else { lower[axis] };
        let furthest = std::array::from_fn(|axis| pick(is_up(axis), axis));
        let opposite = std::array::from_fn(|axis| pick(!is_up(axis), axis));
        self.side_of(furthest) == Sign::Positive && self.side_of(opposite) == Sign::Negative
    }

    /// Whether a plane along an axis and one of its edges parts it from the interior of a box.
    fn is_parted(&self, axis: usize, lower: [f64; 3], upper: [f64; 3]) -> bool {
        let (lower, upper) = (along(axis, lower), along(axis, upper));
        let reaches = |a, b| orient2d(a, b, leftmost(a, b, lower, upper)) == Sign::Positive;
        self.sides(axis).into_iter().filter(|[a, b]| a != b).any(|[a, b]| match self.normal[axis] {
            Sign::Positive => !reaches(a, b),
            Sign::Negative => !reaches(b, a),
            Sign::Zero => !reaches(a, b) || !reaches(b, a),
        })
    }
}

impl Wall<3> for Facet {
    fn weight(&self) -> i64 {
        self.weight
    }

    fn meets(&self, lower: [f64; 3], upper: [f64; 3]) -> bool {
        !self.is_beside(lower, upper)
            && self.cuts(lower, upper)
            && !(0..3).any(|axis| self.is_parted(axis, lower, upper))
    }

    fn covers(&self, point: [f64; 3], axis: usize) -> bool {
        let sign = self.normal[axis];
        let left = |[a, b]: [[f64; 2]; 2]| {
            let [first, second] = others(axis);
            is_left(a, b, along(axis, point), usize::from(second < first))
        };
        match sign {
            Sign::Zero => false,
            _ => self.sides(axis).into_iter().all(|side| left(side) == (sign == Sign::Positive)),
        }
    }

    fn has_left(&self, point: [f64; 3]) -> bool {
        let moved = self.normal.iter().find(|&&sign| sign != Sign::Zero);
        match self.side_of(point) {
            Sign::Zero => moved == Some(&Sign::Positive),
            side => side == Sign::Positive,
        }
    }

    fn begins_left(&self) -> bool {
        self.normal[0] == Sign::Negative
    }
}
