//! Fractal curves that cannot cross themselves: midpoint displacement inside reserved kites.
//!
//! ```text
//!            C                 Each edge AB of the curve owns the kite A, C, B, D, and kites of different edges
//!         P / \ Q              overlap in no inner point. M is the middle of AB, or near it, moved straight away
//!          / M \               from D into A, B, C (or from C into A, B, D). P and N divide AC and AD, Q and R
//!         A-----B              divide BC and BD, all at the same fraction. A, P, M, N is the kite of AM, and
//!          \   /               M, Q, B, R that of MB.
//!         N \ / R
//!            D
//! ```
//!
//! **Invariants.** 1. C and D lie strictly on different sides of AB. 2. Kites need not be convex, but M lies in A, B, C and
//! MD passes through AB, so the path C, M, D stays in the kite and divides it (hence "straight away from D": a plain step
//! towards C let MD leave a crooked kite, and coasts crossed). 3. A, P, M, N lies on the one side of that path and
//! M, Q, B, R on the other: the two share M only, and by induction the curve never meets itself. 4. Both triangles of a
//! kite that is split have an area far above rounding errors (`SLIVER`); thinner ones are left alone.

use crate::Rng;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Twice the area below which a triangle of a kite counts as too thin to be split. Coordinates are below 8 and so off by
/// at most 2^-50 after a split, edges are shorter than 2: an area this large outweighs that a hundred times.
const SLIVER: f64 = 1e-13;

/// One edge of a curve with what it owns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kite {
    pub(crate) a: usize,
    pub(crate) b: usize,
    left: [f64; 2],
    right: [f64; 2],
}

/// Curves being refined: sites, and one kite for each edge.
#[derive(Default)]
pub(crate) struct Curves {
    pub(crate) points: Vec<[f64; 2]>,
    pub(crate) kites: Vec<Kite>,
    /// Longest first; ties by index. The length squared is a non-negative double, whose bits are in its order.
    queue: BinaryHeap<(u64, Reverse<usize>)>,
}

impl Curves {
    /// A closed polygon, counterclockwise, whose edges get kites of half-width `spread` times their length. Angles
    /// between edges must leave room for that on both sides.
    pub(crate) fn ring(&mut self, corners: &[[f64; 2]], spread: f64) {
        let first = self.points.len();
        self.points.extend_from_slice(corners);
        for i in 0..corners.len() {
            let (a, b) = (first + i, first + (i + 1) % corners.len());
            let (p, q) = (self.points[a], self.points[b]);
            let [x, y] = middle(p, q);
            let [u, v] = [spread * (q[0] - p[0]), spread * (q[1] - p[1])];
            self.add(Kite { a, b, left: [x - v, y + u], right: [x + v, y - u] });
        }
    }

    fn add(&mut self, kite: Kite) {
        self.kites.push(kite);
        self.enqueue(self.kites.len() - 1);
    }

    fn enqueue(&mut self, index: usize) {
        let Kite { a, b, left, right } = self.kites[index];
        let (p, q) = (self.points[a], self.points[b]);
        if twice_area(p, q, left) > SLIVER && twice_area(q, p, right) > SLIVER {
            let [x, y] = [q[0] - p[0], q[1] - p[1]];
            self.queue.push(((x * x + y * y).to_bits(), Reverse(index)));
        }
    }

    /// Splits longest edges until there are `sites`, or no edge is left that may be split.
    pub(crate) fn refine(&mut self, sites: usize, roughness: f64, rng: &mut Rng) {
        while self.points.len() < sites {
            let Some((_, Reverse(index))) = self.queue.pop() else { return };
            self.split(index, roughness, rng);
        }
    }

    fn split(&mut self, index: usize, roughness: f64, rng: &mut Rng) {
        const SHARE: f64 = 0.72; // of AC that goes to P; any value below 1 is sound
        let Kite { a, b, left, right } = self.kites[index];
        let (p, q) = (self.points[a], self.points[b]);
        let base = between(p, q, rng.between(0.4, 0.6));
        let shift = rng.between(-roughness, roughness);
        let m = if shift > 0.0 {
            displaced(base, [p, q], right, left, shift)
        } else {
            displaced(base, [q, p], left, right, -shift)
        };
        self.points.push(m);
        let middle = self.points.len() - 1;
        let near = |end, far| between(end, far, SHARE);
        self.kites[index] = Kite { a, b: middle, left: near(p, left), right: near(p, right) };
        self.enqueue(index);
        self.add(Kite { a: middle, b, left: near(q, left), right: near(q, right) });
    }

    /// Whether the open disk meets no kite, judged by the circle around each kite.
    pub(crate) fn is_clear(&self, centre: [f64; 2], radius: f64) -> bool {
        self.kites.iter().all(|kite| {
            let corners = [self.points[kite.a], self.points[kite.b], kite.left, kite.right];
            let hub = middle(corners[0], corners[1]);
            let reach = corners.iter().map(|&c| distance(hub, c)).fold(0.0, f64::max);
            distance(hub, centre) > radius + reach
        })
    }
}

/// From `base` on the edge p, q straight away from `behind`, by `share` of the way to the border of p, q, `ahead`.
fn displaced(
    base: [f64; 2],
    [p, q]: [[f64; 2]; 2],
    behind: [f64; 2],
    ahead: [f64; 2],
    share: f64,
) -> [f64; 2] {
    let beyond = between(base, behind, -1.0);
    let until = |a, b| {
        let (here, there) = (twice_area(a, b, base), twice_area(a, b, beyond));
        if there < here { here / (here - there) } else { f64::INFINITY }
    };
    // The ray leaves through one of the two sides, as it cannot turn back through p, q.
    let way = until(q, ahead).min(until(ahead, p));
    between(base, behind, -share * way)
}

pub(crate) fn distance(p: [f64; 2], q: [f64; 2]) -> f64 {
    let [x, y] = [q[0] - p[0], q[1] - p[1]];
    (x * x + y * y).sqrt()
}

fn between(p: [f64; 2], q: [f64; 2], t: f64) -> [f64; 2] {
    [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t]
}

fn middle(p: [f64; 2], q: [f64; 2]) -> [f64; 2] {
    between(p, q, 0.5)
}

fn twice_area(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> f64 {
    (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
}
