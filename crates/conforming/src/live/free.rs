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
//! **Paper.** Removal is \[DT03\]'s: the Delaunay triangulation of the neighbours of v alone fills its star, by some ear of it after another.
//! **Cost.** A walk; O(1) for each cell in conflict; O(k^2) for a vertex of degree k that goes.

use delone_mesh::{CellId, HalfEdge, VertexId};
use delone_predicates::{Kernel, Side, Sign};
use delone_probe::{Event, Probe};

use super::{Live, NONE, PieceId, Steiner};

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
    open: Vec<CellId>,
    /// By cell: the number of the last search that met it.
    met: Vec<u32>,
    search: u32,
}

impl Live {
    /// Where a vertex of the kernel is that is not in the mesh, by a walk from a triangle.
    pub(crate) fn locate(
        &self,
        start: CellId,
        p: VertexId,
        probe: &mut impl Probe,
    ) -> Option<Place> {
        let mut cell = start;
        let mut entered: Option<HalfEdge> = None;
        // A walk by visibility ends in a Delaunay triangulation; where constrained edges spoil that, it is given up.
        for step in 0..=self.mesh.cell_count() {
            let mut zero = None;
            let mut out = None;
            for i in 0..3 {
                let h = HalfEdge::new(cell, (i + step) % 3);
                if entered == Some(h) {
                    continue;
                }
                probe.on(Event::Orient);
                match self.kernel.orient(&[self.mesh.origin(h), self.mesh.destination(h), p]) {
                    Sign::Positive => {}
                    Sign::Negative => {
                        out = Some(h);
                        break;
                    }
                    Sign::Zero if zero.is_some() => return Some(Place::Taken),
                    Sign::Zero => zero = Some(h),
                }
            }
            match (out, zero) {
                (Some(h), _) => {
                    if let Some(piece) = self.piece_of(h) {
                        return Some(Place::Behind(piece));
                    }
                    probe.on(Event::WalkStep);
                    let twin = self.mesh.twin(h);
                    if self.mesh.is_ghost(twin.cell()) {
                        return None;
                    }
                    (cell, entered) = (twin.cell(), Some(twin));
                }
                (None, None) => return Some(Place::Inside(cell)),
                (None, Some(h)) => {
                    return Some(self.piece_of(h).map_or(Place::On(h), Place::Behind));
                }
            }
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
        region.pieces.clear();
        region.met.resize(self.mesh.cell_count(), 0);
        region.search += 1;
        let seed = match place {
            Place::Inside(cell) => cell,
            Place::On(h) => h.cell(),
            Place::Taken | Place::Behind(_) => return,
        };
        region.met[seed.index()] = region.search;
        region.open.push(seed);
        while let Some(cell) = region.open.pop() {
            for h in self.mesh.facets(cell) {
                if let Some(piece) = self.piece_of(h) {
                    region.pieces.push(piece);
                    continue;
                }
                let beyond = self.mesh.twin(h).cell();
                if region.met[beyond.index()] == region.search || self.mesh.is_ghost(beyond) {
                    continue;
                }
                region.met[beyond.index()] = region.search;
                probe.on(Event::InSphere);
                if self.kernel.in_sphere(self.mesh.corners(beyond), p) == Side::Positive {
                    region.open.push(beyond);
                }
            }
        }
    }

    /// Makes the last vertex of the kernel a vertex of the mesh, at a place inside a triangle or an edge; a cell that has it.
    pub(crate) fn insert_free(
        &mut self,
        place: Place,
        p: VertexId,
        probe: &mut impl Probe,
    ) -> CellId {
        self.steiner.push(Steiner::Free);
        probe.on(Event::SteinerPoint);
        let (a, b) = match place {
            Place::Inside(cell) => {
                self.split_triangle(cell, p);
                (cell, None)
            }
            Place::On(h) => {
                let cells = (h.cell(), Some(self.mesh.twin(h).cell()));
                self.split_edge(h, p, [NONE, NONE]);
                cells
            }
            Place::Taken | Place::Behind(_) => {
                panic!("a free point is inside a triangle or an edge")
            }
        };
        // Slots are used again at once, and flips about p leave them p.
        self.legalize(probe);
        if self.mesh.corners(a).contains(&p) { a } else { b.unwrap_or(a) }
    }

    /// Replaces a triangle by three about `p`.
    fn split_triangle(&mut self, cell: CellId, p: VertexId) {
        let mesh = &self.mesh;
        let rim = [0, 1, 2].map(|corner| HalfEdge::new(cell, corner));
        let outside = rim
            .map(|h| (mesh.origin(h), mesh.destination(h), mesh.twin(h), self.piece_at[h.index()]));
        let region = self.region_at[cell.index()];
        self.retire(cell);
        let around = outside.map(|(a, b, ..)| self.add([p, a, b], region));
        for (place, (_, _, outside, piece)) in outside.into_iter().enumerate() {
            let (cell, next) = (around[place], around[(place + 1) % 3]);
            let inside = HalfEdge::new(cell, 0);
            self.attach(inside, outside, piece);
            self.stack.push(inside);
            self.attach(HalfEdge::new(cell, 1), HalfEdge::new(next, 2), NONE);
        }
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
        let mut star = cell;
        for &(_, (outside, _)) in &polygon {
            star = self.mesh.twin(outside).cell();
            self.retire(star);
        }
        debug_assert!(self.mesh.corners(star).contains(&v), "the star is that of v");
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
            triangle.contains(&u) || self.kernel.in_sphere(&triangle, u) == Side::Negative
        })
    }
}

/// A corner of a hole, and what is outside of the side from it to the next one.
pub(super) type Corner = (VertexId, (HalfEdge, PieceId));
