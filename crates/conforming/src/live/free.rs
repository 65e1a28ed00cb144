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
use delone_predicates::{Kernel, Side, Sign};
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
    /// The triangles, in the order in which they were found.
    cells: Vec<CellId>,
    /// The half-edges between them and the rest, seen from inside.
    rim: Vec<HalfEdge>,
    /// By cell: the number of the last search that met it.
    met: Vec<u32>,
    search: u32,
    /// The rim while the region is replaced.
    outside: Vec<Outside>,
    /// By vertex of the rim: the new cell on the side that starts there.
    cell_from: Vec<Option<CellId>>,
}

/// A side of the rim from one vertex to the next, what is beyond, and the new cell inside.
#[derive(Clone, Copy, Debug)]
struct Outside {
    ends: [VertexId; 2],
    twin: HalfEdge,
    piece: PieceId,
    cell: CellId,
}

impl Region {
    fn begin(&mut self, cells: usize) {
        self.pieces.clear();
        self.cells.clear();
        self.rim.clear();
        self.met.resize(cells, 0);
        self.search += 1;
    }

    fn take(&mut self, cell: CellId) {
        self.met[cell.index()] = self.search;
        self.cells.push(cell);
    }

    fn holds(&self, cell: CellId) -> bool {
        self.met[cell.index()] == self.search
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
        region.begin(self.mesh.cell_count());
        match place {
            Place::Inside(cell) => region.take(cell),
            Place::On(h) => region.take(h.cell()),
            Place::Taken | Place::Behind(_) => return,
        }
        let mut explored = 0;
        while let Some(&cell) = region.cells.get(explored) {
            explored += 1;
            for h in self.mesh.facets(cell) {
                if let Some(piece) = self.piece_of(h) {
                    region.pieces.push(piece);
                    region.rim.push(h);
                    continue;
                }
                let beyond = self.mesh.twin(h).cell();
                if region.holds(beyond) {
                    continue;
                }
                if self.is_in_conflict(beyond, p, probe) {
                    region.take(beyond);
                } else {
                    region.rim.push(h);
                }
            }
        }
    }

    /// Whether a cell, which is no ghost, has a point in its circumcircle.
    fn is_in_conflict(&self, cell: CellId, p: VertexId, probe: &mut impl Probe) -> bool {
        if self.mesh.is_ghost(cell) {
            return false;
        }
        probe.on(Event::InSphere);
        self.kernel.in_sphere(self.mesh.corners(cell), p) == Side::Positive
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
    /// The region is star-shaped around `p`, strictly: each side of the rim has `p` on its left, so each vertex of the rim starts one side.
    fn star(&mut self, region: &mut Region, p: VertexId) -> CellId {
        region.outside.clear();
        for &h in &region.rim {
            let ends = [self.mesh.origin(h), self.mesh.destination(h)];
            let (twin, piece) = (self.mesh.twin(h), self.piece_at[h.index()]);
            region.outside.push(Outside { ends, twin, piece, cell: h.cell() });
        }
        let number = self.region_at[region.cells[0].index()]; // no piece is between its cells: they are of one region
        if region.cell_from.len() < p.index() {
            region.cell_from.resize(self.kernel.len(), None);
        }
        // A disk of k triangles without a vertex inside has k + 2 sides.
        assert_eq!(region.cells.len() + 2, region.outside.len(), "all vertices are on the rim");
        for (place, side) in region.outside.iter_mut().enumerate() {
            let [a, b] = side.ends;
            let corners = [p, a, b];
            side.cell = if let Some(&cell) = region.cells.get(place) {
                self.mesh.set_corners(cell, &corners);
                cell
            } else {
                self.add(corners, number)
            };
            self.attach(HalfEdge::new(side.cell, 0), side.twin, side.piece);
            let before = region.cell_from[a.index()].replace(side.cell);
            assert!(before.is_none(), "a vertex of the rim starts one side");
        }
        for side in &region.outside {
            let next = region.cell_from[side.ends[1].index()].take();
            let next = next.expect("the rim is closed");
            self.attach(HalfEdge::new(side.cell, 1), HalfEdge::new(next, 2), NONE);
        }
        region.outside[0].cell
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
