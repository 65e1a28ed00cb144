//! Planar straight-line graphs. Unless a row of the registry says otherwise, two segments share at most one end, no site
//! lies inside a segment, and no two sites are equal.

pub(crate) mod circles;
pub(crate) mod coast;
pub(crate) mod crossing;
pub(crate) mod curves;
mod kites;
pub(crate) mod lattices;
pub(crate) mod long;
pub(crate) mod polygons;
pub(crate) mod scatter;
pub(crate) mod touching;

use crate::num::{id, real};
use crate::{Input, Points};

/// A PSLG under construction.
#[derive(Default)]
pub(crate) struct Graph {
    points: Vec<[f64; 2]>,
    segments: Vec<[u32; 2]>,
}

impl Graph {
    /// Sites without segments.
    pub(crate) fn on(points: Vec<[f64; 2]>) -> Self {
        Self { points, segments: Vec::new() }
    }

    /// For an `n` below a family's smallest figure: `n` isolated sites on a parabola.
    pub(crate) fn isolated(n: usize) -> Self {
        Self::on((0..n).map(|i| [real(i), real(i * i)]).collect())
    }

    pub(crate) fn site(&mut self, p: [f64; 2]) -> usize {
        self.points.push(p);
        self.points.len() - 1
    }

    pub(crate) fn join(&mut self, a: usize, b: usize) {
        self.segments.push([id(a), id(b)]);
    }

    /// Two new sites and the segment between them.
    pub(crate) fn segment(&mut self, a: [f64; 2], b: [f64; 2]) {
        let a = self.site(a);
        let b = self.site(b);
        self.join(a, b);
    }

    /// New sites, joined one to the next.
    pub(crate) fn path(&mut self, points: impl IntoIterator<Item = [f64; 2]>) {
        let first = self.points.len();
        self.points.extend(points);
        for i in first + 1..self.points.len() {
            self.join(i - 1, i);
        }
    }

    /// New sites, joined one to the next and the last to the first; at least three.
    pub(crate) fn polygon(&mut self, points: impl IntoIterator<Item = [f64; 2]>) {
        let first = self.points.len();
        self.path(points);
        self.join(self.points.len() - 1, first);
    }

    pub(crate) fn len(&self) -> usize {
        self.points.len()
    }

    pub(crate) fn finish(self) -> Input {
        Input { points: Points::Plane(self.points), segments: self.segments }
    }
}

#[cfg(test)]
mod tests;
