//! Steiner points between segments: located, put in, and taken out again.
//!
//! ```text
//!      c---b             c---b         Three neighbours a, b, c of v in a row that turn left, with no other neighbour in the
//!     / \ /|            /   /|         circle through them (perturbed), are an ear of what fills the star of v when v is
//!    d---v |     ->    d   / |         gone: it is cut off, until three neighbours are left.
//!     \ / \|            \  / |
//!      e---a             e-a-'
//! ```
//!
//! **Paper.** A point inside a triangle is put in as by \[Bow81\]: all that is in conflict with it, as far as it sees, is replaced by its star. On an
//! edge, by \[Law77\]'s flips. Removal is \[DT03\]'s: the Delaunay triangulation of the neighbours of v alone fills its star, by some ear of it after another.
//! **Cost.** A walk; O(1) for each cell in conflict; O(k^2) for a vertex of degree k that goes.

use delone_mesh::{CellId, HalfEdge, VertexId};
use delone_predicates::{Kernel, Side as InCircle, Sign};
use delone_probe::{Event, Probe};

use super::{Live, NONE, PieceId};

/// Where a point is, seen from a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// Inside this triangle.
    Inside(CellId),
    /// Inside this free edge.
    On(HalfEdge),
    /// A vertex is there.
    Taken,
    /// The walk came to this piece, and the point is beyond it or on it.
    Behind(PieceId),
}

/// The triangles in conflict with a point, as far as constrained edges let it see, and the pieces at their rim.
#[derive(Debug, Default)]
pub(crate) struct Region {
    pub(crate) pieces: Vec<PieceId>,
    /// The triangles; when the region is replaced, those in their place, one for each side.
    cells: Vec<CellId>,
    /// Counter-clockwise.
    rim: Vec<Side>,
    /// Edges not yet looked at, each with its ends.
    stack: Vec<(HalfEdge, [VertexId; 2])>,
}

/// A side of the rim, seen from inside.
#[derive(Clone, Copy, Debug)]
struct Side {
    start: VertexId,
    twin: HalfEdge,
    piece: PieceId,
}

impl Region {
    fn begin(&mut self, cell: CellId, [a, b, c]: [VertexId; 3]) {
        self.pieces.clear();
        self.rim.clear();
        self.stack.clear();
        self.cells.clear();
        self.cells.push(cell);
        let edge = |corner, ends| (HalfEdge::new(cell, corner), ends);
        self.stack.extend([edge(2, [a, b]), edge(1, [c, a]), edge(0, [b, c])]);
    }

    /// How many sides it has.
    pub(crate) fn sides(&self) -> usize {
        self.rim.len()
    }

    /// The triangle over a side, counter-clockwise, that is in its place; its corners are that for which it was replaced and this edge.
    pub(crate) fn replacement(&self, side: usize) -> (CellId, [VertexId; 2]) {
        let next = if side + 1 < self.rim.len() { side + 1 } else { 0 };
        (self.cells[side], [self.rim[side].start, self.rim[next].start])
    }
}

impl Live {
    /// Where a vertex of the kernel is that is not in the mesh, by a walk from a triangle.
    pub(crate) fn locate(
        &self,
        start: CellId,
        p: VertexId,
        probe: &mut impl Probe,
    ) -> Option<Place> {
        let (mut cell, [a, b, c]) = (start, self.mesh.triangle(start));
        let edge = |corner, ends| (HalfEdge::new(start, corner), ends);
        let mut ways = [edge(0, [b, c]), edge(1, [c, a]), edge(2, [a, b])];
        let mut first = 0;
        // A walk by visibility ends in a Delaunay triangulation; where constrained edges spoil that, it is given up.
        for step in 0..=self.mesh.cell_count() {
            let (mut out, mut zero) = (None, None);
            for &(h, [a, b]) in &ways[first..] {
                probe.on(Event::Orient);
                match self.kernel.orient(&[a, b, p]) {
                    Sign::Positive => {}
                    Sign::Negative => {
                        out = Some((h, [a, b]));
                        break;
                    }
                    Sign::Zero if zero.is_some() => return Some(Place::Taken),
                    Sign::Zero => zero = Some(h),
                }
            }
            let Some((h, [a, b])) = out else {
                let on = |h| self.piece_of(h).map_or(Place::On(h), Place::Behind);
                return Some(zero.map_or(Place::Inside(cell), on));
            };
            if let Some(piece) = self.piece_of(h) {
                return Some(Place::Behind(piece));
            }
            probe.on(Event::WalkStep);
            let twin = self.mesh.twin(h);
            let apex = self.mesh.apex(twin);
            if apex.is_ghost() {
                return None;
            }
            let onwards = [(self.mesh.next(twin), [a, apex]), (self.mesh.prev(twin), [apex, b])];
            (cell, first) = (twin.cell(), 1);
            (ways[1], ways[2]) = (onwards[step % 2], onwards[1 - step % 2]);
        }
        None
    }

    /// Finds what is in conflict with `p`, which is at that place.
    pub(crate) fn search(
        &self,
        place: Place,
        p: VertexId,
        region: &mut Region,
        probe: &mut impl Probe,
    ) {
        let seed = match place {
            Place::Inside(cell) => cell,
            Place::On(h) => h.cell(),
            Place::Taken | Place::Behind(_) => return region.pieces.clear(),
        };
        region.begin(seed, self.mesh.triangle(seed));
        let Region { pieces, cells, rim, stack } = region;
        while let Some((h, [a, b])) = stack.pop() {
            let (twin, piece) = (self.mesh.twin(h), self.piece_at[h.index()]);
            let apex = self.mesh.apex(twin);
            if piece != NONE {
                pieces.push(piece);
            } else if !apex.is_ghost() && self.is_in_conflict([apex, b, a], p, probe) {
                cells.push(twin.cell());
                assert!(cells.len() <= self.mesh.cell_count(), "the region is a tree of triangles");
                stack.push((self.mesh.prev(twin), [apex, b]));
                stack.push((self.mesh.next(twin), [a, apex]));
                continue;
            }
            rim.push(Side { start: a, twin, piece });
        }
    }

    /// Whether a triangle has a point in its circumcircle.
    #[inline]
    fn is_in_conflict(&self, triangle: [VertexId; 3], p: VertexId, probe: &mut impl Probe) -> bool {
        probe.on(Event::InSphere);
        self.kernel.in_sphere(&triangle, p) == InCircle::Positive
    }

    /// Makes the last vertex of the kernel a vertex of the mesh, at a place inside a triangle or an edge of which `region` is what
    /// [`Live::search`] found; a cell that has it.
    pub(crate) fn insert_free(
        &mut self,
        place: Place,
        p: VertexId,
        region: &mut Region,
        probe: &mut impl Probe,
    ) -> CellId {
        self.steiner.push_free();
        probe.on(Event::SteinerPoint);
        match place {
            Place::Inside(_) => {
                probe.on(Event::Cavity { cells: region.cells.len() });
                self.star(region, p)
            }
            Place::On(h) => {
                let (a, b) = (h.cell(), self.mesh.twin(h).cell());
                self.split_edge(h, p, [NONE, NONE]);
                self.legalize(probe);
                // Slots are used again at once, and flips about p leave them p.
                if self.mesh.corners(a).contains(&p) { a } else { b }
            }
            Place::Taken | Place::Behind(_) => {
                panic!("a free point is inside a triangle or an edge")
            }
        }
    }

    /// Replaces a region by the triangles of `p` over its rim, and returns one of these.
    ///
    /// The region is star-shaped around `p`, strictly: each side of the rim has `p` on its left.
    fn star(&mut self, region: &mut Region, p: VertexId) -> CellId {
        let Region { cells, rim, .. } = region;
        // A disk of k triangles without a vertex inside has k + 2 sides.
        assert_eq!(cells.len() + 2, rim.len(), "all vertices are on the rim");
        let number = self.region_at[cells[0].index()]; // no piece is between its cells: they are of one region
        cells.extend([0, 1].map(|_| self.claim(number)));
        let last = rim.len() - 1;
        let (mut before, mut cell) = (cells[last], cells[0]);
        for (place, &Side { start, twin, piece }) in rim.iter().enumerate() {
            let next = if place == last { 0 } else { place + 1 };
            let (after, outer) = (cells[next], HalfEdge::new(cell, 0));
            let twins = [twin, HalfEdge::new(after, 2), HalfEdge::new(before, 1)];
            self.mesh.set_triangle(cell, [p, start, rim[next].start], twins);
            self.mesh.glue(outer, twin);
            self.piece_at[outer.index()..outer.index() + 3].copy_from_slice(&[piece, NONE, NONE]);
            if piece != NONE {
                self.pieces[piece as usize].half = outer;
            }
            (before, cell) = (cell, after);
        }
        cells[0]
    }

    /// Takes a free Steiner point out, which `cell` has. The cells in its place are in `made`.
    pub(crate) fn remove_free(&mut self, v: VertexId, cell: CellId, probe: &mut impl Probe) {
        self.made.clear();
        let region = self.region_at[cell.index()];
        let mut polygon = std::mem::take(&mut self.polygon);
        polygon.clear();
        for spoke in self.mesh.ring(v, cell) {
            let rim = self.mesh.next(spoke);
            let outside = (self.mesh.twin(rim), self.piece_at[rim.index()]);
            polygon.push((self.mesh.destination(spoke), outside));
        }
        for &(_, (outside, _)) in &polygon {
            let star = self.mesh.twin(outside).cell();
            debug_assert!(self.mesh.triangle(star).contains(&v), "the star is that of v");
            self.retire(star);
        }
        let mut at = 0;
        for _ in 0..polygon.len() * polygon.len() {
            let [a, b, c] = [at, at + 1, at + 2].map(|i| i % polygon.len());
            if polygon.len() > 3 && !self.is_ear(&polygon, [a, b, c], probe) {
                at = b;
                continue;
            }
            probe.on(Event::CellMade);
            let ear = self.add([a, b, c].map(|i| polygon[i].0), region);
            self.made.push(ear);
            let sides = [(2, a), (0, b), (1, c)].map(|(corner, i)| (HalfEdge::new(ear, corner), i));
            let glued = if polygon.len() > 3 { 2 } else { 3 };
            for &(inside, i) in &sides[..glued] {
                let (outside, piece) = polygon[i].1;
                self.attach(inside, outside, piece);
            }
            if glued == 3 {
                self.polygon = polygon;
                return;
            }
            polygon[a].1 = (HalfEdge::new(ear, 1), NONE);
            polygon.remove(b);
            at = if b < a { a - 1 } else { a };
        }
        panic!("a polygon has an ear that is part of its Delaunay triangulation");
    }

    /// Whether three corners of a polygon in a row are a triangle of its Delaunay triangulation.
    fn is_ear(&self, polygon: &[Corner], corners: [usize; 3], probe: &mut impl Probe) -> bool {
        let triangle = corners.map(|i| polygon[i].0);
        probe.on(Event::Orient);
        if self.kernel.orient(&triangle) != Sign::Positive {
            return false;
        }
        polygon.iter().all(|&(u, _)| {
            probe.on(Event::InSphere);
            triangle.contains(&u) || self.kernel.in_sphere(&triangle, u) == InCircle::Negative
        })
    }
}

/// A corner of a hole, and what is outside of the side from it to the next one.
pub(super) type Corner = (VertexId, (HalfEdge, PieceId));
