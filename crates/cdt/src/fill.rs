//! The constrained Delaunay triangulation of one side of a segment's cavity, by randomized incremental insertion.
//!
//! ```text
//!      3---2            Corners 0 .. m-1 counter-clockwise, the segment being the side from the last to the first.
//!     /     \     1     The corners between are taken out in random order, and put back in the reverse order: corner u
//!    4       \   / \    comes between its neighbours w and v on the current chain; the triangles behind the chain's
//!     \       \ /   |   side w-v that are in conflict with u, or that u does not see the right way round, go, and u is
//!  m-1 ----------- 0    joined to what they leave.
//! ```
//!
//! **Paper.** [SB15], section 4: expected time linear in the number of corners.
//! **In.** The corners as vertices; one vertex may come at several corners (a dangling edge inside the cavity), and then
//! *corners*, not vertices, are told apart. All are strictly on the left of the segment but its two ends.
//! **Out.** Triangles over corners, and for each of their sides what lies beyond: a triangle, a side of the polygon, or
//! the segment.
//! **Invariants.** 1. `behind[w]` is the triangle side that lies on the current chain's side from `w`. 2. A corner is
//! never taken out while it is strictly lower than both its neighbours, so each chain on the way is free of
//! overlaps that would make the removal test meaningless ([SB15] section 4.2; without it, wrong on spiky cavities).
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a vertex at several corners | is never in conflict with a triangle of its own | `a_dangling_edge_is_triangulated_on_both_sides` |
//! | cocircular corners | the perturbation decides | `every_segment_of_a_grid_can_be_inserted` |
//! | `u`, `v`, `w` in line | the triangle behind goes | `every_segment_of_a_grid_can_be_inserted` |

use delone_mesh::VertexId;
use delone_predicates::{PlaneKernel, Side, Sign};
use delone_probe::{Event, Probe};
use delone_sites::scatter;

/// What lies beyond a side of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Beyond {
    /// A side of another triangle: index and corner opposite.
    Triangle(usize, usize),
    /// The polygon's side from this corner to the next.
    Side(usize),
    /// The segment.
    Segment,
}

/// A triangle over corners of the polygon, counter-clockwise; `beyond[i]` is opposite `corners[i]`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    pub(crate) corners: [usize; 3],
    pub(crate) beyond: [Beyond; 3],
    pub(crate) alive: bool,
}

/// Scratch space, and the result of the last [`Filler::fill`].
#[derive(Debug, Default)]
pub(crate) struct Filler {
    /// The triangles; those not alive are to be skipped.
    pub(crate) triangles: Vec<Triangle>,
    next: Vec<usize>,
    previous: Vec<usize>,
    order: Vec<usize>,
    behind: Vec<Option<(usize, usize)>>,
    stack: Vec<(usize, usize, Beyond)>,
}

impl Filler {
    /// Triangulates the polygon. `random` seeds the order, which the result does not depend on.
    pub(crate) fn fill(
        &mut self,
        kernel: &impl PlaneKernel,
        polygon: &[VertexId],
        random: u64,
        probe: &mut impl Probe,
    ) {
        let last = polygon.len() - 1;
        self.take_out(kernel, polygon, random);
        self.triangles.clear();
        self.behind.clear();
        self.behind.resize(polygon.len(), None);
        let middle = self.order[0];
        self.triangles.push(Triangle {
            corners: [0, middle, last],
            beyond: [Beyond::Side(middle), Beyond::Segment, Beyond::Side(0)],
            alive: true,
        });
        self.behind[0] = Some((0, 2));
        self.behind[middle] = Some((0, 0));
        for place in 1..self.order.len() {
            self.put_back(kernel, polygon, self.order[place], probe);
        }
    }

    /// Chooses the order: `order[0]` stays in; the others are taken out from the last to the second. Each corner taken
    /// out keeps the neighbours it had then.
    fn take_out(&mut self, kernel: &impl PlaneKernel, polygon: &[VertexId], mut random: u64) {
        let last = polygon.len() - 1;
        let (a, b) = (polygon[last], polygon[0]);
        let is_lower =
            |i: usize, j: usize| kernel.cross([a, b, polygon[i], polygon[j]]) == Sign::Positive;
        self.next.clear();
        self.next.extend(1..=polygon.len());
        self.previous.clear();
        self.previous.extend((0..polygon.len()).map(|i| i.wrapping_sub(1)));
        self.order.clear();
        self.order.extend(1..last);
        for place in (1..self.order.len()).rev() {
            let corner = loop {
                let pick = below(&mut random, place + 1);
                let corner = self.order[pick];
                let (w, v) = (self.previous[corner], self.next[corner]);
                if !(is_lower(corner, w) && is_lower(corner, v)) {
                    self.order.swap(pick, place); // Inv 2
                    break corner;
                }
            };
            let (w, v) = (self.previous[corner], self.next[corner]);
            self.next[w] = v;
            self.previous[v] = w;
        }
    }

    /// Puts corner `u` back between the neighbours that it had when it was taken out.
    fn put_back(
        &mut self,
        kernel: &impl PlaneKernel,
        polygon: &[VertexId],
        u: usize,
        probe: &mut impl Probe,
    ) {
        let (w, v) = (self.previous[u], self.next[u]);
        let (t, corner) =
            self.behind[w].expect("Inv 1: each side of the chain has a triangle behind it");
        let mut fan_end: Option<usize> = None;
        self.stack.push((w, v, Beyond::Triangle(t, corner)));
        while let Some((p, q, beyond)) = self.stack.pop() {
            if let Beyond::Triangle(t, c) = beyond {
                let Triangle { corners, beyond, .. } = self.triangles[t];
                if must_go(kernel, polygon, [u, q, p], corners[c], probe) {
                    self.triangles[t].alive = false;
                    let x = corners[c];
                    self.stack.push((x, q, beyond[(c + 1) % 3]));
                    self.stack.push((p, x, beyond[(c + 2) % 3]));
                    continue;
                }
            }
            fan_end = Some(self.join(u, p, q, beyond, fan_end));
        }
        let fan_end = fan_end.expect("a fan has a triangle");
        self.triangles[fan_end].beyond[2] = Beyond::Side(u);
        self.behind[u] = Some((fan_end, 2));
    }

    /// Adds the triangle u, q, p, next in the fan about `u` after `before`.
    fn join(
        &mut self,
        u: usize,
        p: usize,
        q: usize,
        beyond: Beyond,
        before: Option<usize>,
    ) -> usize {
        let new = self.triangles.len();
        let towards_p = match before {
            Some(before) => {
                self.triangles[before].beyond[2] = Beyond::Triangle(new, 1);
                Beyond::Triangle(before, 2)
            }
            None => {
                self.behind[p] = Some((new, 1));
                Beyond::Side(p)
            }
        };
        match beyond {
            Beyond::Triangle(t, c) => self.triangles[t].beyond[c] = Beyond::Triangle(new, 0),
            Beyond::Side(k) => self.behind[k] = Some((new, 0)),
            Beyond::Segment => {}
        }
        let beyond = [beyond, towards_p, Beyond::Segment]; // the last is overwritten by the next in the fan
        self.triangles.push(Triangle { corners: [u, q, p], beyond, alive: true });
        new
    }
}

/// Whether the triangle q, p, x behind the side `p` to `q` cannot stay when `u` comes.
fn must_go(
    kernel: &impl PlaneKernel,
    polygon: &[VertexId],
    [u, q, p]: [usize; 3],
    x: usize,
    probe: &mut impl Probe,
) -> bool {
    let triangle = [u, q, p].map(|corner| polygon[corner]);
    probe.on(Event::Orient);
    if kernel.orient(&triangle) != Sign::Positive {
        return true;
    }
    let x = polygon[x];
    if triangle.contains(&x) {
        return false;
    }
    probe.on(Event::InSphere);
    kernel.in_sphere(&triangle, x) == Side::Positive
}

/// A number below `count`, the next of the stream.
fn below(stream: &mut u64, count: usize) -> usize {
    *stream = scatter(*stream);
    let scaled = u128::from(*stream) * count as u128;
    usize::try_from(scaled >> 64).expect("a number below a usize is one")
}
