//! Segment insertion by flips: Delaunay first, then the edges that a segment crosses are flipped away.
//!
//! ```text
//!        .---u---.            .---u---.        The crossing edge uw is the diagonal of a quadrilateral x w y u. If that
//!       / \  |  / \          /       / \       is strictly convex, it is flipped to xy, which crosses ab no more, or
//!      a---x-|-y---b   ->   a---x---y---b      crosses it in place of uw. When none is left, ab is an edge, and the new
//!       \   \|/   /          \   \ /   /       edges are flipped until the triangulation is Delaunay again, segments
//!        '---w---'            '---w---'        apart.
//! ```
//!
//! **Paper.** [Slo93]; the flips back are [Law77]. Where we differ: Sloan takes crossing edges from a queue, for which no bound
//! is known. Here the upper end `u` farthest from the segment (leftmost on ties) is taken, and a flip among its edges that
//! makes one less of them: as `u` is a peak of the upper chain, such a flip exists.
//! **In, Out.** As of `cavity.rs`.
//! **Invariants.** 1. After each segment the mesh is the CDT of the sites and the segments so far. 2. Some edge at the farthest
//! upper end can be flipped, so at most (upper ends) x (lower ends) flips remove all. 3. A flip back lowers the lifted surface
//! (perturbed), so no edge comes back.
//! **Cost.** For m edges crossed O(m^2) flips at worst. Each looks about a vertex.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | the segment is an edge already | marked | `an_edge_that_is_there_is_only_marked` |
//! | a vertex comes several times among the upper ends (dangling edges) | each run of its edges is for itself | `a_dangling_edge_is_triangulated_on_both_sides` |
//! | upper ends equally far | the first | `every_segment_of_a_grid_can_be_inserted` |
//! | three ends in line | the quadrilateral is not strictly convex: not flipped | `every_segment_of_a_grid_can_be_inserted` |
//! | cocircular sites | the perturbation decides | `chew_agrees_on_small_grids` |

use std::fmt;

use delone_mesh::{CellId, HalfEdge, Mesh, VertexId};
use delone_predicates::{PlaneKernel, Side, Sign};
use delone_probe::{Event, Probe};

use crate::cavity::{Ends, way_out};

/// Inserts the subsegments of a noded PSLG into the Delaunay mesh of its sites, as [`crate::insert_segments`] does.
pub(crate) fn insert_by_flips(
    mesh: Mesh<2>,
    kernel: &impl PlaneKernel,
    sites: usize,
    subsegments: &[[u32; 2]],
    probe: &mut impl Probe,
) -> (Mesh<2>, Vec<bool>) {
    let constrained = vec![false; 3 * mesh.cell_count()];
    let mut work = Flips::new(mesh, constrained, kernel, sites);
    for ends in subsegments {
        let [a, b] = ends.map(|site| VertexId::new(site as usize));
        let inserted = work.insert([a, b], probe);
        inserted.unwrap_or_else(|blocked| panic!("a PSLG is noded: {blocked}"));
    }
    (work.mesh, work.constrained)
}

/// A CDT in the making, or under change.
#[derive(Debug)]
pub(crate) struct Flips<'k, K> {
    pub(crate) mesh: Mesh<2>,
    pub(crate) kernel: &'k K,
    /// A cell of each vertex that is there.
    pub(crate) cell_of: Vec<Option<CellId>>,
    /// By half-edge.
    pub(crate) constrained: Vec<bool>,
    /// The edges that cross the segment, in order along it: upper end, lower end.
    crossing: Vec<Ends>,
    /// The edges made for it.
    made: Vec<Ends>,
}

/// Why a segment cannot be put in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Blocked {
    /// It crosses this constrained edge.
    Crosses([VertexId; 2]),
    /// It runs through this vertex.
    Through(VertexId),
}

impl fmt::Display for Blocked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Crosses([u, v]) => {
                write!(f, "the segment crosses the constrained edge from {u:?} to {v:?}: cut both")
            }
            Self::Through(v) => write!(f, "the segment runs through {v:?}: cut it there"),
        }
    }
}

impl std::error::Error for Blocked {}

impl<'k, K: PlaneKernel> Flips<'k, K> {
    pub(crate) fn new(
        mesh: Mesh<2>,
        constrained: Vec<bool>,
        kernel: &'k K,
        vertices: usize,
    ) -> Self {
        let cell_of = mesh.cells_by_vertex(vertices);
        Self { mesh, kernel, cell_of, constrained, crossing: Vec::new(), made: Vec::new() }
    }

    /// Makes the segment a constrained edge; changes nothing if it is blocked.
    pub(crate) fn insert(&mut self, ends: Ends, probe: &mut impl Probe) -> Result<(), Blocked> {
        self.made.clear();
        if self.edge(ends).is_none() {
            self.find_crossing(ends, probe)?;
            self.remove_crossing(ends, probe);
        }
        let h = self.edge(ends).expect("Inv 2: when nothing crosses it, the segment is an edge");
        self.mark(h, true);
        probe.on(Event::Subsegment);
        self.legalize(probe);
        Ok(())
    }

    /// Makes the edge free; whether it was constrained.
    pub(crate) fn release(&mut self, ends: Ends, probe: &mut impl Probe) -> bool {
        let Some(h) = self.edge(ends).filter(|h| self.constrained[h.index()]) else { return false };
        self.mark(h, false);
        self.made.clear();
        self.made.push(ends); // no other edge can be illegal
        self.legalize(probe);
        true
    }

    /// A cell of a vertex.
    pub(crate) fn cell(&self, v: VertexId) -> CellId {
        self.cell_of[v.index()].expect("the vertex is in the mesh")
    }

    pub(crate) fn mark(&mut self, h: HalfEdge, is_constrained: bool) {
        for h in [h, self.mesh.twin(h)] {
            self.constrained[h.index()] = is_constrained;
        }
    }

    pub(crate) fn edge(&self, [a, b]: Ends) -> Option<HalfEdge> {
        self.mesh.half_edge(a, b, self.cell(a))
    }

    /// A neighbour of `a` that lies on the segment to `b`.
    fn neighbour_on(&self, [a, b]: Ends) -> Option<VertexId> {
        let onwards = self.kernel.compare_lexicographic(a, b);
        let mut around = self.mesh.ring(a, self.cell(a));
        around.by_ref().map(|h| self.mesh.destination(h)).find(|&v| {
            !v.is_ghost()
                && self.kernel.compare_lexicographic(a, v) == onwards
                && self.kernel.orient(&[a, b, v]) == Sign::Zero
        })
    }

    fn find_crossing(&mut self, [a, b]: Ends, probe: &mut impl Probe) -> Result<(), Blocked> {
        self.crossing.clear();
        if let Some(v) = self.neighbour_on([a, b]) {
            return Err(Blocked::Through(v));
        }
        let mut crossed = way_out(&self.mesh, self.kernel, self.cell(a), [a, b], probe);
        for _ in 0..=self.mesh.cell_count() {
            // From the lower end to the upper one, as seen from a.
            let ends = [self.mesh.destination(crossed), self.mesh.origin(crossed)];
            if self.constrained[crossed.index()] {
                return Err(Blocked::Crosses(ends));
            }
            probe.on(Event::EdgeCrossed);
            self.crossing.push(ends);
            let h = self.mesh.twin(crossed);
            let x = self.mesh.apex(h);
            if x == b {
                return Ok(());
            }
            assert!(!x.is_ghost(), "a segment stays inside the hull");
            probe.on(Event::Orient);
            crossed = match self.kernel.orient(&[a, b, x]) {
                Sign::Positive => self.mesh.next(h),
                Sign::Negative => self.mesh.prev(h),
                Sign::Zero => return Err(Blocked::Through(x)),
            };
        }
        panic!("a segment leaves each triangle once");
    }

    fn remove_crossing(&mut self, [a, b]: Ends, probe: &mut impl Probe) {
        let bound = self.crossing.len() * self.crossing.len();
        let mut flips = 0;
        while !self.crossing.is_empty() {
            let (first, end) = self.farthest_run([a, b]);
            // What stands before and after the edges of the run, as upper ends.
            let before = if first == 0 { a } else { self.crossing[first - 1][0] };
            let after = self.crossing.get(end).map_or(b, |edge| edge[0]);
            let (place, [x, y]) = self.flippable(first..end, before, after, probe);
            let edge = self.crossing[place];
            self.flip(edge, probe);
            flips += 1;
            assert!(flips <= bound, "Inv 2: each flip takes an edge from the farthest upper end");
            // From an upper end to a lower one, the new edge crosses the segment too.
            match (place == first, place + 1 == end) {
                (true, false) if first > 0 => self.crossing[place] = [x, y],
                (false, true) if end < self.crossing.len() => self.crossing[place] = [y, x],
                _ => drop(self.crossing.remove(place)),
            }
            self.made.push([x, y]);
        }
    }

    /// The first of the farthest runs of crossing edges with one upper end.
    fn farthest_run(&self, [a, b]: Ends) -> (usize, usize) {
        let mut first = 0;
        for place in 1..self.crossing.len() {
            let [far, here] = [first, place].map(|place| self.crossing[place][0]);
            if far != here && self.kernel.cross([a, b, far, here]) == Sign::Positive {
                first = place;
            }
        }
        let upper = self.crossing[first][0];
        let length = self.crossing[first..].iter().take_while(|edge| edge[0] == upper).count();
        (first, first + length)
    }

    /// The first edge of the run whose quadrilateral is strictly convex, and the ends of its other diagonal.
    fn flippable(
        &self,
        run: std::ops::Range<usize>,
        before: VertexId,
        after: VertexId,
        probe: &mut impl Probe,
    ) -> (usize, Ends) {
        for place in run.clone() {
            let [u, w] = self.crossing[place];
            let x = if place == run.start { before } else { self.crossing[place - 1][1] };
            let y = if place + 1 == run.end { after } else { self.crossing[place + 1][1] };
            (0..2).for_each(|_| probe.on(Event::Orient));
            if self.kernel.orient(&[x, w, y]) == Sign::Positive
                && self.kernel.orient(&[y, u, x]) == Sign::Positive
            {
                return (place, [x, y]);
            }
        }
        panic!("Inv 2: some edge at the farthest upper end can be flipped");
    }

    fn flip(&mut self, ends: Ends, probe: &mut impl Probe) {
        let h = self.edge(ends).expect("a crossing edge is an edge");
        self.flip_edge(h, probe);
    }

    /// Flips, and moves what is known of the four edges around with them.
    fn flip_edge(&mut self, h: HalfEdge, probe: &mut impl Probe) {
        let t = self.mesh.twin(h);
        let (next_h, next_t) = (self.mesh.next(h), self.mesh.next(t));
        self.constrained[h.index()] = self.constrained[next_t.index()];
        self.constrained[t.index()] = self.constrained[next_h.index()];
        self.constrained[next_h.index()] = false;
        self.constrained[next_t.index()] = false;
        self.mesh.flip(h);
        for cell in [h.cell(), t.cell()] {
            for v in self.mesh.corners(cell) {
                self.cell_of[v.index()] = Some(cell);
            }
        }
        probe.on(Event::Flip);
    }

    /// Flips the edges made, and those around what is flipped, until all are locally Delaunay.
    fn legalize(&mut self, probe: &mut impl Probe) {
        let made = std::mem::take(&mut self.made);
        let mut stack: Vec<HalfEdge> = made.iter().filter_map(|&ends| self.edge(ends)).collect();
        self.made = made;
        let mut flips = 0usize;
        while let Some(h) = stack.pop() {
            let t = self.mesh.twin(h);
            if self.constrained[h.index()] || !self.is_illegal(h, probe) {
                continue;
            }
            self.flip_edge(h, probe);
            flips += 1;
            let bound = self.mesh.cell_count().saturating_mul(self.mesh.cell_count());
            assert!(flips <= bound, "Inv 3: an edge that was flipped away does not come back");
            // Each handle around may now be another edge's.
            stack.extend([h, t, self.mesh.prev(h), self.mesh.prev(t)]);
        }
    }

    fn is_illegal(&self, h: HalfEdge, probe: &mut impl Probe) -> bool {
        let t = self.mesh.twin(h);
        if self.mesh.is_ghost(h.cell()) || self.mesh.is_ghost(t.cell()) {
            return false;
        }
        probe.on(Event::InSphere);
        self.kernel.in_sphere(self.mesh.corners(h.cell()), self.mesh.apex(t)) == Side::Positive
    }
}
