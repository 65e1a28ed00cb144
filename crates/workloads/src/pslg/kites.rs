//! Fractal curves that cannot cross themselves: midpoint displacement inside reserved kites.
//!
//! ```text
//!            C                 Each edge AB of the curve owns the kite A, C, B, D, and kites of different edges
//!          P/ \Q               overlap in no inner point. M is the middle of AB, or near it, moved straight away
//!          / M \               from D into A, B, C (or from C into A, B, D). P stands over the middle of AM, inside
//!         A-----B              A, M, C, and Q over that of MB, inside M, B, C; N and R likewise on the side of D.
//!         N \   /R             A, P, M, N is the kite of AM; M, Q, B, R that of MB.
//!            D
//! ```
//!
//! **Invariants.** 1. C and D lie strictly on different sides of AB. 2. Kites need not be convex, but M lies in A, B, C and
//! MD passes through AB, so the path C, M, D stays in the kite and divides it (hence "straight away from D": a plain step
//! towards C let MD leave a crooked kite, and coasts crossed). 3. A, P, M, N lies on the one side of that path and
//! M, Q, B, R on the other: the two share M only, and by induction the curve never meets itself. 4. Both triangles of a
//! kite that is split have an area far above rounding errors (`SLIVER`); thinner ones are left alone.
//!
//! P upright over AM, rather than at a fixed share of AC, keeps kites from being sheared into needles over many levels.

use crate::Rng;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Twice the area below which a triangle of a kite counts as too thin to be split. Coordinates are below 8 and so off by
/// at most 2^-50 after a split, edges are shorter than 2: an area this large outweighs that a hundred times.
const SLIVER: f64 = 1e-13;

/// How far the kites of a ring reach out from the middle of their edges, relative to its distance from the centre.
pub(crate) const OUTWARDS: f64 = 0.66;

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
    /// A closed polygon, counterclockwise and star-shaped around `centre`. An edge's kite reaches from its middle most of
    /// the way to the centre, and outwards by two thirds of its distance: always inside the edge's own sector.
    pub(crate) fn ring(&mut self, corners: &[[f64; 2]], centre: [f64; 2]) {
        let first = self.points.len();
        self.points.extend_from_slice(corners);
        for i in 0..corners.len() {
            let (a, b) = (first + i, first + (i + 1) % corners.len());
            let hub = middle(self.points[a], self.points[b]);
            self.add(Kite {
                a,
                b,
                left: between(hub, centre, 0.8),
                right: between(hub, centre, -OUTWARDS),
            });
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
        let Kite { a, b, left, right } = self.kites[index];
        let (p, q) = (self.points[a], self.points[b]);
        let base = between(p, q, rng.between(0.4, 0.6));
        let share = roughness * rng.between(0.1, 1.0);
        let m = if rng.coin() {
            displaced(base, [p, q], right, left, share)
        } else {
            displaced(base, [q, p], left, right, share)
        };
        self.points.push(m);
        let middle = self.points.len() - 1;
        let kite = |[a, b]: [usize; 2], [p, q]: [[f64; 2]; 2]| {
            let (left, right) = (apex([p, q], left), apex([q, p], right));
            Kite { a, b, left, right }
        };
        self.kites[index] = kite([a, middle], [p, m]);
        self.enqueue(index);
        self.add(kite([middle, b], [m, q]));
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
    edge: [[f64; 2]; 2],
    behind: [f64; 2],
    ahead: [f64; 2],
    share: f64,
) -> [f64; 2] {
    let beyond = between(base, behind, -1.0);
    between(base, beyond, share * way_out(base, beyond, edge, ahead))
}

/// The corner of a new kite to the left of its edge p, q: straight up from the middle, by two thirds of the edge's length if
/// the triangle p, q, `ahead` has so much room, else by most of what it has.
fn apex([p, q]: [[f64; 2]; 2], ahead: [f64; 2]) -> [f64; 2] {
    let hub = middle(p, q);
    let beyond = [hub[0] - (q[1] - p[1]), hub[1] + (q[0] - p[0])];
    between(hub, beyond, (0.9 * way_out(hub, beyond, [p, q], ahead)).min(0.65))
}

/// Where the ray from `base` on p, q through `beyond` leaves the counterclockwise triangle p, q, `ahead`, in units of
/// their distance.
fn way_out(base: [f64; 2], beyond: [f64; 2], [p, q]: [[f64; 2]; 2], ahead: [f64; 2]) -> f64 {
    let until = |a, b| {
        let (here, there) = (twice_area(a, b, base), twice_area(a, b, beyond));
        if there < here { here / (here - there) } else { f64::INFINITY }
    };
    // It goes up from p, q and so leaves through one of the other two sides.
    until(q, ahead).min(until(ahead, p))
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
