//! Segments as walls.

use delone_predicates::{Sign, orient2d};

use crate::grow::Wall;
use crate::nudge::{is_left, leftmost};

/// A segment from the lexicographically smaller end to the larger.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) ends: [[f64; 2]; 2],
    pub(super) weight: i64,
}

impl Wall<2> for Edge {
    fn weight(&self) -> i64 {
        self.weight
    }

    fn meets(&self, lower: [f64; 2], upper: [f64; 2]) -> bool {
        let [a, b] = self.ends;
        let (bottom, top) = if a[1] < b[1] { (a[1], b[1]) } else { (b[1], a[1]) };
        if a[0] >= upper[0] || b[0] <= lower[0] || bottom >= upper[1] || top <= lower[1] {
            return false;
        }
        let (left, right) = (leftmost(a, b, lower, upper), leftmost(b, a, lower, upper));
        orient2d(a, b, left) == Sign::Positive && orient2d(a, b, right) == Sign::Negative
    }

    fn covers(&self, point: [f64; 2], axis: usize) -> bool {
        let [a, b] = self.ends;
        let other = 1 - axis;
        (a[other] <= point[other]) != (b[other] <= point[other])
    }

    fn has_left(&self, point: [f64; 2]) -> bool {
        let [a, b] = self.ends;
        is_left(a, b, point, 0)
    }

    fn begins_left(&self) -> bool {
        self.ends[0][1] < self.ends[1][1]
    }
}
