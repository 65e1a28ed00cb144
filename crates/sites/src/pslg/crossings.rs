//! Whether segments cross, and where.

use delone_predicates::{Sign, orient2d};

use super::{Crossing, Planar, Pslg, by_sweep};
use crate::boxes::{Box2, BoxTree};

impl Pslg {
    /// Every crossing, by input indices of segments; quick if there are none.
    pub(super) fn crossings(&self, planar: Planar) -> Vec<Crossing> {
        let is_planar =
            planar == Planar::Known || by_sweep(&self.sites, &self.subsegments).is_some();
        if is_planar { Vec::new() } else { self.list_crossings() }
    }

    /// Every pair of input segments that cross, by index. O(those near each other): for input that is refused.
    fn list_crossings(&self) -> Vec<Crossing> {
        let parents = self.parents();
        let mut crossings = Vec::new();
        for [piece, other] in self.crossing_pieces() {
            let [[a, b], [c, d]] = [piece, other].map(|piece| self.ends(piece));
            for &s in &parents[piece as usize] {
                for &t in &parents[other as usize] {
                    let segments = [s.min(t), s.max(t)];
                    crossings.push(Crossing { segments, near: near(a, b, c, d) });
                }
            }
        }
        crossings.sort_unstable_by_key(|crossing| crossing.segments);
        crossings
    }

    fn ends(&self, piece: u32) -> [[f64; 2]; 2] {
        self.subsegments[piece as usize].map(|site| self.sites.points()[site as usize])
    }

    /// Every pair of subsegments that cross, the smaller first.
    pub(crate) fn crossing_pieces(&self) -> Vec<[u32; 2]> {
        let pieces = (0u32..).take(self.subsegments.len());
        let boxes: Vec<Box2> =
            pieces.clone().map(|piece| self.ends(piece)).map(|[a, b]| Box2::of(a, b)).collect();
        let tree = BoxTree::new(&boxes);
        let mut pairs = Vec::new();
        for piece in pieces {
            let [a, b] = self.ends(piece);
            tree.for_each_near(a, b, |other| {
                let [c, d] = self.ends(other);
                if piece < other && cross(a, b, c, d) {
                    pairs.push([piece, other]);
                }
            });
        }
        pairs
    }
}

/// Whether the interiors of `ab` and `cd` meet in one point.
pub(super) fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> bool {
    orient2d(a, b, c) * orient2d(a, b, d) == Sign::Negative
        && orient2d(c, d, a) * orient2d(c, d, b) == Sign::Negative
}

/// The crossing of the lines, rounded: for messages.
fn near(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> [f64; 2] {
    let cross = |u: [f64; 2], v: [f64; 2]| u[0] * v[1] - u[1] * v[0];
    let minus = |u: [f64; 2], v: [f64; 2]| [u[0] - v[0], u[1] - v[1]];
    let t = cross(minus(c, a), minus(d, c)) / cross(minus(b, a), minus(d, c));
    let t = if t.is_finite() { t.clamp(0.0, 1.0) } else { 0.5 };
    [0, 1].map(|axis| a[axis] * (1.0 - t) + b[axis] * t)
}
