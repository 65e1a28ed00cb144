//! Vertices come and go in a CDT.
//!
//! ```text
//!      b---c           b---c        p comes: the cells in conflict with it that no constrained edge hides from it go,
//!     / \ p|\         / \ /|\       and p is joined to the rim of the hole. v goes: its neighbours, triangulated alone,
//!    a---\-|-d  ->   a---p-|-d      have cells in conflict with v; they fill its star, facet for facet.
//!     \ . \|/         \ / \|/
//!      f---e           f---e
//! ```
//!
//! **Paper.** Insertion is \[Bow81\]'s, stopped at constrained edges as in \[SB15\]; removal is after \[DT03\], whose argument holds
//! in a CDT too: all neighbours of v see v, so the triangles about v have none of them inside their circumcircles, which makes
//! them v's star in the Delaunay triangulation of v and its neighbours alone.
//! **In, Out.** As of [`crate::Dynamic`]. **Invariants.** 1. A straight walk leaves each triangle once. 2. The region dug is
//! connected through edges that are free, or is cut by the one edge that holds p.
//! **Cost.** Insertion: the straight walk from a vertex that is there, O(sqrt n) on evenly spread vertices; then O(1) for each
//! cell gone. Removal: O(k log k) expected for k neighbours.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | the walk runs through a vertex, or along an edge | it starts anew from that vertex | `vertices_come_and_go` |
//! | p inside a constrained edge | dug from both sides; the two parts are constrained | `a_vertex_splits_a_constrained_edge` |
//! | p outside the hull, or on it | the ghosts are cells like others | `vertices_come_and_go` |
//! | v has constrained edges | refused, one is named | `what_keeps_a_vertex_is_named` |
//! | v's neighbours are in line, other vertices are not | its star becomes ghosts | `an_ear_goes` |
//! | all vertices but v are in line | refused | `what_keeps_a_vertex_is_named` |

use std::collections::BTreeSet;
use std::fmt;

use delone_delaunay::{Coin, bowyer_watson, dig_conflicts, in_conflict, walk};
use delone_mesh::{Cavity, CellId, HalfEdge, Mesh, VertexId};
use delone_predicates::{PlaneKernel, Sign};
use delone_probe::{Event, Probe};

use super::Dynamic;

/// Why a vertex cannot be taken out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kept {
    /// This constrained edge ends at it.
    Constrained([VertexId; 2]),
    /// All other vertices are in line.
    Flat,
}

impl fmt::Display for Kept {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constrained([u, v]) => {
                write!(f, "the segment from {u:?} to {v:?} ends here: take it out first")
            }
            Self::Flat => {
                write!(f, "all other vertices are in line: put in one that is off the line first")
            }
        }
    }
}

impl std::error::Error for Kept {}

impl<K: PlaneKernel> Dynamic<'_, K> {
    /// Whether the vertex is there.
    ///
    /// # Panics
    /// If the kernel was said to have no such vertex.
    #[must_use]
    pub fn holds(&self, vertex: u32) -> bool {
        self.flips.cell_of[vertex as usize].is_some()
    }

    /// Puts a vertex in; whether it was not there before. A constrained edge that it lies on falls into two.
    ///
    /// The walk to it is O(sqrt n) on evenly spread vertices.
    ///
    /// # Panics
    /// If the kernel was said to have no such vertex, or has one that is there at the same place.
    pub fn insert_vertex(&mut self, vertex: u32, probe: &mut impl Probe) -> bool {
        if self.holds(vertex) {
            return false;
        }
        let p = VertexId::new(vertex as usize);
        let seed = self.locate(p, probe);
        let split = self.constrained_under(seed, p, probe);
        let region = self.region(seed, split, p, probe);
        let mut hole = Cavity::new();
        hole.dig(&self.flips.mesh, seed, |cell| region.binary_search(&cell).is_ok());
        probe.on(Event::Cavity { cells: region.len() });
        let ends = split.map(|h| [self.flips.mesh.origin(h), self.flips.mesh.destination(h)]);
        let outside = self.outside(&hole);
        self.flips.mesh.star(&mut hole, p);
        self.renew(&outside, probe);
        for end in ends.into_iter().flatten() {
            let half = self.flips.edge([p, end]).expect("the ends of a split edge are on the rim");
            self.flips.mark(half, true);
        }
        self.hint = p;
        true
    }

    /// Takes a vertex out; whether it was there.
    ///
    /// # Errors
    /// If constrained edges end at it: a segment is taken out by its ends, never silently. If all others are in line. Then
    /// nothing is changed.
    ///
    /// # Panics
    /// If the kernel was said to have no such vertex.
    pub fn remove_vertex(&mut self, vertex: u32, probe: &mut impl Probe) -> Result<bool, Kept> {
        let Some(cell) = self.flips.cell_of[vertex as usize] else { return Ok(false) };
        let (v, mesh) = (VertexId::new(vertex as usize), &self.flips.mesh);
        if let Some(h) = mesh.ring(v, cell).find(|h| self.flips.constrained[h.index()]) {
            return Err(Kept::Constrained([v, mesh.destination(h)]));
        }
        let around: Vec<VertexId> =
            mesh.ring(v, cell).map(|h| mesh.destination(h)).filter(|u| !u.is_ghost()).collect();
        let mut star = Cavity::new();
        star.dig(mesh, cell, |cell| mesh.corners(cell).contains(&v));
        let in_line = around[2..]
            .iter()
            .all(|&u| self.flips.kernel.orient(&[around[0], around[1], u]) == Sign::Zero);
        let outside = self.outside(&star);
        if in_line {
            if outside.iter().all(|&(h, _)| mesh.is_ghost(h.cell())) {
                return Err(Kept::Flat);
            }
            self.uncover(v, &star);
        } else {
            self.refill(v, &around, &star, probe);
        }
        self.flips.cell_of[v.index()] = None;
        self.renew(&outside, probe);
        self.hint = around[0];
        Ok(true)
    }

    /// A cell that is in conflict with `p`: it holds `p`, or is a ghost that `p` is beyond or on.
    fn locate(&self, p: VertexId, probe: &mut impl Probe) -> CellId {
        let (mesh, kernel) = (&self.flips.mesh, self.flips.kernel);
        let mut start = self.hint;
        'start: for _ in 0..=mesh.cell_count() {
            let mut crossed = match self.departure(start, p, probe) {
                Departure::Into(cell) => return cell,
                Departure::Along(next) => {
                    start = next;
                    continue;
                }
                Departure::Across(h) => h,
            };
            for _ in 0..=mesh.cell_count() {
                let ends = [mesh.origin(crossed), mesh.destination(crossed)];
                probe.on(Event::Orient);
                if kernel.orient(&[ends[0], ends[1], p]) != Sign::Negative {
                    return crossed.cell();
                }
                probe.on(Event::WalkStep);
                let h = mesh.twin(crossed);
                if mesh.is_ghost(h.cell()) {
                    return h.cell();
                }
                let x = mesh.apex(h);
                probe.on(Event::Orient);
                crossed = match kernel.orient(&[start, p, x]) {
                    Sign::Positive => mesh.next(h),
                    Sign::Negative => mesh.prev(h),
                    Sign::Zero if self.is_between([start, p], x) => {
                        start = x;
                        continue 'start;
                    }
                    // p is before x, in this triangle.
                    Sign::Zero => return h.cell(),
                };
            }
            panic!("Inv 1: a straight walk leaves each triangle once");
        }
        panic!("Inv 1: a straight walk comes nearer at each vertex that it runs through");
    }

    /// How the way from a vertex to `p` begins.
    fn departure(&self, a: VertexId, p: VertexId, probe: &mut impl Probe) -> Departure {
        let (mesh, kernel) = (&self.flips.mesh, self.flips.kernel);
        let onwards = kernel.compare_lexicographic(a, p);
        for h in mesh.ring(a, self.flips.cell(a)) {
            let (r, l) = (mesh.destination(h), mesh.apex(h));
            if r.is_ghost() {
                continue;
            }
            probe.on(Event::Orient);
            let right = kernel.orient(&[a, p, r]);
            if right == Sign::Zero && kernel.compare_lexicographic(a, r) == onwards {
                if self.is_between([a, p], r) {
                    return Departure::Along(r);
                }
                let cell = if l.is_ghost() { mesh.twin(h).cell() } else { h.cell() };
                return Departure::Into(cell); // p is on this edge
            }
            let left = |l| kernel.orient(&[a, p, l]) == Sign::Positive;
            if right == Sign::Negative && !l.is_ghost() && left(l) {
                return Departure::Across(mesh.next(h));
            }
        }
        // Out of the hull: through one of the two ghosts at a, the one that p is beyond.
        let mut ghosts = mesh.ring(a, self.flips.cell(a)).map(HalfEdge::cell);
        let beyond =
            ghosts.find(|&cell| mesh.is_ghost(cell) && in_conflict(mesh, kernel, cell, p, probe));
        Departure::Into(beyond.expect("the way leads through a triangle, along an edge or out"))
    }

    /// Whether `x`, on the line through `a` and `p` and on the same side of `a`, comes before `p`.
    fn is_between(&self, [a, p]: [VertexId; 2], x: VertexId) -> bool {
        let kernel = self.flips.kernel;
        let onwards = kernel.compare_lexicographic(a, p);
        let place = kernel.compare_lexicographic(x, p);
        assert!(place.is_ne(), "two vertices at one place: {x:?} and {p:?}");
        place == onwards
    }

    /// The constrained edge of the cell that holds `p`, if there is one.
    fn constrained_under(
        &self,
        cell: CellId,
        p: VertexId,
        probe: &mut impl Probe,
    ) -> Option<HalfEdge> {
        let (mesh, kernel) = (&self.flips.mesh, self.flips.kernel);
        if mesh.is_ghost(cell) {
            return None; // p is beyond it: the walk stops before it at a p on its edge
        }
        mesh.facets(cell).filter(|h| self.flips.constrained[h.index()]).find(|&h| {
            probe.on(Event::Orient);
            kernel.orient(&[mesh.origin(h), mesh.destination(h), p]) == Sign::Zero
        })
    }

    /// The cells in conflict with `p` that it sees, sorted. Inv 2.
    fn region(
        &self,
        seed: CellId,
        split: Option<HalfEdge>,
        p: VertexId,
        probe: &mut impl Probe,
    ) -> Vec<CellId> {
        let mesh = &self.flips.mesh;
        let mut region = BTreeSet::from([seed]);
        region.extend(split.map(|h| mesh.twin(h).cell()));
        let mut open: Vec<CellId> = region.iter().copied().collect();
        while let Some(cell) = open.pop() {
            for h in mesh.facets(cell).filter(|h| !self.flips.constrained[h.index()]) {
                let beyond = mesh.twin(h).cell();
                if !region.contains(&beyond)
                    && in_conflict(mesh, self.flips.kernel, beyond, p, probe)
                {
                    region.insert(beyond);
                    open.push(beyond);
                }
            }
        }
        region.into_iter().collect()
    }

    /// What lies beyond a hole's rim, and whether it is constrained.
    fn outside(&self, hole: &Cavity<2>) -> Vec<(HalfEdge, bool)> {
        let twins = hole.rim().map(|inside| self.flips.mesh.twin(inside));
        twins.map(|h| (h, self.flips.constrained[h.index()])).collect()
    }

    /// The neighbours of `v` among themselves take the place of its star.
    fn refill(
        &mut self,
        v: VertexId,
        around: &[VertexId],
        star: &Cavity<2>,
        probe: &mut impl Probe,
    ) {
        let ids = around.iter().map(|u| u32::try_from(u.index()).expect("a vertex has 32 bits"));
        let kernel = self.flips.kernel;
        let donor = bowyer_watson(kernel, ids.collect::<Vec<_>>(), &mut ());
        let seed = walk(&donor, kernel, CellId::new(0), v, &mut Coin::default(), probe);
        let mut graft = Cavity::new();
        dig_conflicts(&donor, kernel, seed, v, &mut graft, probe);
        self.flips.mesh.transplant(star, &donor, &graft, |vertex| vertex);
    }

    /// Each solid cell of v's star becomes a ghost; the two ghosts go. `v` is a corner of the hull, its neighbours in line.
    fn uncover(&mut self, v: VertexId, star: &Cavity<2>) {
        let mesh = &mut self.flips.mesh;
        let (ghosts, solids): (Vec<CellId>, Vec<CellId>) =
            star.cells().iter().partition(|&&cell| mesh.is_ghost(cell));
        let mut images: Vec<(CellId, CellId)> = Vec::with_capacity(solids.len());
        for &cell in &solids {
            let corner = |&u: &VertexId| if u == v { VertexId::GHOST } else { u };
            let corners: Vec<VertexId> = mesh.corners(cell).iter().map(corner).collect();
            images.push((cell, mesh.add_cell(&corners)));
        }
        images.sort_unstable();
        let image = |cell: CellId| images.binary_search_by_key(&cell, |&(old, _)| old);
        let mut pairs = Vec::with_capacity(3 * images.len());
        for &(old, new) in &images {
            for h in mesh.facets(old) {
                let twin = mesh.twin(h);
                let beyond = match image(twin.cell()) {
                    Ok(place) => HalfEdge::new(images[place].1, twin.corner()),
                    // From a ghost of the star on to what is beyond it.
                    Err(_) if ghosts.contains(&twin.cell()) => {
                        let corner = mesh.corner_of(twin.cell(), v);
                        mesh.twin(HalfEdge::new(twin.cell(), corner))
                    }
                    Err(_) => twin,
                };
                pairs.push((HalfEdge::new(new, h.corner()), beyond));
            }
        }
        pairs.into_iter().for_each(|(h, beyond)| mesh.glue(h, beyond));
        star.cells().iter().for_each(|&cell| mesh.retire(cell));
    }

    /// After a hole was filled: flags and cells of vertices are those of the new cells, which lie inside of `outside`, and
    /// no slot is left empty.
    fn renew(&mut self, outside: &[(HalfEdge, bool)], probe: &mut impl Probe) {
        let flips = &mut self.flips;
        flips.constrained.resize(3 * flips.mesh.cell_count(), false);
        for cell in filled(&flips.mesh, outside) {
            probe.on(Event::CellMade);
            flips.mesh.facets(cell).for_each(|h| flips.constrained[h.index()] = false);
            record(&flips.mesh, &mut flips.cell_of, cell);
        }
        for &(h, is_constrained) in outside {
            flips.constrained[flips.mesh.twin(h).index()] = is_constrained;
        }
        let mut moved = Vec::new();
        flips.mesh.compact(|from, to| moved.push((from, to)));
        for &(from, to) in &moved {
            for corner in 0..3 {
                let [from, to] = [from, to].map(|cell| HalfEdge::new(cell, corner).index());
                flips.constrained[to] = flips.constrained[from];
            }
        }
        let count = flips.mesh.cell_count();
        flips.constrained.truncate(3 * count);
        for (_, to) in moved.into_iter().filter(|(_, to)| to.index() < count) {
            record(&flips.mesh, &mut flips.cell_of, to);
        }
    }
}

/// The cells inside of a rim that is known from outside.
fn filled(mesh: &Mesh<2>, outside: &[(HalfEdge, bool)]) -> Vec<CellId> {
    let mut seen: BTreeSet<CellId> = outside.iter().map(|(h, _)| h.cell()).collect();
    let mut made: Vec<CellId> = Vec::new();
    for &(h, _) in outside {
        let cell = mesh.twin(h).cell();
        if seen.insert(cell) {
            made.push(cell);
        }
    }
    let mut explored = 0;
    while let Some(&cell) = made.get(explored) {
        explored += 1;
        let beyond = mesh.facets(cell).map(|h| mesh.twin(h).cell());
        made.extend(beyond.filter(|&beyond| seen.insert(beyond)));
    }
    made
}

/// Puts a cell on record as one of each of its vertices.
fn record(mesh: &Mesh<2>, cell_of: &mut [Option<CellId>], cell: CellId) {
    for v in mesh.corners(cell).iter().filter(|v| !v.is_ghost()) {
        cell_of[v.index()] = Some(cell);
    }
}

/// How a way begins.
enum Departure {
    /// It ends in this cell, or on its edge, or beyond it if it is a ghost.
    Into(CellId),
    /// Along an edge to this vertex, and further.
    Along(VertexId),
    /// Out of the star through this edge.
    Across(HalfEdge),
}
