//! A CDT in which Steiner points are put: on subsegments, exactly, and between them.
//!
//! ```text
//!        c                 c            A Steiner point p on the edge ab, constrained or not: its two triangles become
//!       / \               /|\           four. Then the edges opposite p are flipped while p is in conflict with the
//!      a---b     ->      a-p-b          triangle beyond; constrained edges are not. All that changes is p's star.
//!       \ /               \|/
//!        d                 d            Either triangle may be a ghost.
//! ```
//!
//! **Paper.** \[Law77\]'s flips, which insert a vertex into a Delaunay triangulation; constrained edges stop them as they stop
//! visibility.
//! **In.** The CDT of a noded PSLG. **Out.** The CDT of its vertices and the Steiner points, its segments in pieces.
//! **Invariants.** 1. After each point the mesh is the CDT. 2. A point on a subsegment is exactly on its line, and between its
//! ends: parameters are strictly between. 3. Each piece knows one of its half-edges, and both of these know the piece.
//! **Cost.** O(1) for each cell that changes. Nothing is allocated but cells.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | the subsegment is an edge of the hull | one of its triangles is a ghost and stays outside | `a_triangle_of_segments_is_split_on_the_hull` |
//! | p cocircular with a triangle | the perturbation decides | `points_on_a_grid_keep_the_cdt` |
//! | p does not round to itself | exact all the same: the kernel constructs it | `thirds_are_exact` |

use delone_cdt::{Cdt, constrained_half_edges};
use delone_mesh::{CellId, HalfEdge, Mesh, VertexId};
use delone_predicates::{Constructed, Construction, Dyadic, Kernel, Side};
use delone_probe::{Event, Probe};
use delone_sites::{Noded, Pslg};

use crate::parameter::Parameter;

#[cfg(test)]
mod tests;

mod free;

pub(crate) use free::{Place, Region};

/// The number of a piece.
pub(crate) type PieceId = u32;

/// No piece.
const NONE: PieceId = u32::MAX;

/// A subsegment: a piece of a segment, which is an edge of the mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    /// The segment.
    pub(crate) segment: u32,
    /// In the direction of the segment.
    pub(crate) ends: [VertexId; 2],
    /// One of its two half-edges.
    half: HalfEdge,
}

/// A vertex that was added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Steiner<'a> {
    /// On a segment, at this parameter.
    On { segment: u32, t: &'a Parameter },
    /// Between segments.
    Free,
}

/// The Steiner points. Most are free, and take no more than a number.
#[derive(Clone, Debug, Default)]
pub(crate) struct SteinerPoints {
    /// By Steiner point: its place in `on`, or `NONE`.
    places: Vec<u32>,
    on: Vec<(u32, Parameter)>,
}

impl SteinerPoints {
    pub(crate) fn len(&self) -> usize {
        self.places.len()
    }

    pub(crate) fn push_free(&mut self) {
        self.places.push(NONE);
    }

    pub(crate) fn push_on(&mut self, segment: u32, t: Parameter) {
        self.places.push(piece_id(self.on.len()));
        self.on.push((segment, t));
    }

    pub(crate) fn get(&self, index: usize) -> Option<Steiner<'_>> {
        let &place = self.places.get(index)?;
        let on = self.on.get(place as usize);
        Some(on.map_or(Steiner::Free, |&(segment, ref t)| Steiner::On { segment, t }))
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = Steiner<'_>> {
        (0..self.len()).filter_map(|index| self.get(index))
    }

    /// Forgets free ones that do not stay, asked by index. Those on segments stay.
    pub(crate) fn retain(&mut self, stays: impl Fn(usize) -> bool) {
        let mut index = 0;
        self.places.retain(|_| {
            index += 1;
            stays(index - 1)
        });
    }
}

/// See the module's text.
pub(crate) struct Live {
    pub(crate) mesh: Mesh<2>,
    pub(crate) kernel: Constructed<2>,
    /// The segments, each from its lexicographically smaller end.
    pub(crate) segments: Vec<[u32; 2]>,
    /// Their lengths, off by less than 2^-51 of themselves; none where squares of doubles may not tell.
    lengths: Vec<Option<f64>>,
    /// Their ends, smaller site first, in increasing order.
    named: Vec<[u32; 2]>,
    /// The number of sites; other vertices are Steiner points.
    pub(crate) sites: usize,
    pub(crate) steiner: SteinerPoints,
    pub(crate) pieces: Vec<Piece>,
    /// By half-edge.
    piece_at: Vec<PieceId>,
    /// By cell: the region that it is in.
    pub(crate) region_at: Vec<u32>,
    /// Half-edges opposite the new vertex.
    stack: Vec<HalfEdge>,
    /// The hole that a vertex leaves.
    polygon: Vec<free::Corner>,
    /// The cells in the place of the last vertex that went.
    pub(crate) made: Vec<CellId>,
}

impl Live {
    /// Takes the CDT of a graph, of dimension 2.
    pub(crate) fn new(cdt: &Cdt, graph: &Pslg) -> Self {
        let mut mesh = cdt.mesh().clone();
        // Few graphs take more than three times their cells; arrays that grow are copied each time.
        let room = 3 * mesh.cell_count();
        mesh.reserve(room);
        let ranks = graph.sites().ranks();
        let forwards = |&[a, b]: &[u32; 2]| {
            if ranks[a as usize] < ranks[b as usize] { [a, b] } else { [b, a] }
        };
        let segments: Vec<[u32; 2]> = graph.subsegments().iter().map(forwards).collect();
        let mut halves = vec![None; segments.len()];
        let mut piece_at = Vec::with_capacity(3 * room);
        piece_at.resize(3 * mesh.cell_count(), NONE);
        for (h, place) in constrained_half_edges(cdt, graph) {
            halves[place] = Some(h);
            piece_at[h.index()] = piece_id(place);
        }
        let pieces = (0u32..).zip(&segments).zip(halves).map(|((segment, ends), half)| Piece {
            segment,
            ends: ends.map(|v| VertexId::new(v as usize)),
            half: half.expect("each subsegment is an edge of the CDT"),
        });
        let pieces = pieces.collect();
        let mut region_at = Vec::with_capacity(room);
        region_at.resize(mesh.cell_count(), 0);
        let (sites, kernel) = (graph.sites().len(), graph.kernel());
        let length = |&[a, b]: &[u32; 2]| length([a, b].map(|v| kernel.position(v)));
        let lengths = segments.iter().map(length).collect();
        Self {
            mesh,
            kernel,
            segments,
            lengths,
            named: graph.subsegments().to_vec(),
            sites,
            steiner: SteinerPoints::default(),
            pieces,
            piece_at,
            region_at,
            stack: Vec::new(),
            polygon: Vec::new(),
            made: Vec::new(),
        }
    }

    /// The nearest doubles of three vertices. (Not by `map`, which the compiler does not always take apart.)
    #[inline(always)]
    pub(crate) fn positions(&self, [a, b, c]: [VertexId; 3]) -> [[f64; 2]; 3] {
        let positions = self.kernel.positions();
        [positions[a.index()], positions[b.index()], positions[c.index()]]
    }

    /// The piece that an edge is.
    #[inline]
    pub(crate) fn piece_of(&self, h: HalfEdge) -> Option<PieceId> {
        let piece = self.piece_at[h.index()];
        (piece != NONE).then_some(piece)
    }

    /// The first half-edge of the ring of a vertex, from a cell that has it.
    pub(crate) fn ring_start(&self, v: VertexId, cell: CellId) -> HalfEdge {
        HalfEdge::new(cell, (self.mesh.corner_of(cell, v) + 2) % 3)
    }

    /// The half-edge of a piece in the direction of its segment.
    pub(crate) fn half_edge(&self, piece: PieceId) -> HalfEdge {
        let Piece { ends, half, .. } = self.pieces[piece as usize];
        if self.mesh.origin(half) == ends[0] { half } else { self.mesh.twin(half) }
    }

    /// The apexes of the triangles on both sides of a piece; none for a ghost.
    pub(crate) fn apexes(&self, piece: PieceId) -> impl Iterator<Item = VertexId> + use<'_> {
        let h = self.pieces[piece as usize].half;
        [h, self.mesh.twin(h)].map(|h| self.mesh.apex(h)).into_iter().filter(|v| !v.is_ghost())
    }

    /// The Steiner point that a vertex is, if it is one.
    pub(crate) fn steiner_of(&self, v: VertexId) -> Option<Steiner<'_>> {
        let place = v.index().checked_sub(self.sites)?;
        self.steiner.get(place) // the ghost is none
    }

    /// The parameters of a piece's ends on its segment.
    pub(crate) fn parameters(&self, piece: PieceId) -> [Parameter; 2] {
        let ends = self.pieces[piece as usize].ends;
        [(0, 0.0), (1, 1.0)].map(|(end, whole)| match self.steiner_of(ends[end]) {
            Some(Steiner::On { t, .. }) => t.clone(),
            _ => Parameter::Double(whole),
        })
    }

    /// The segment between two sites.
    pub(crate) fn segment_between(&self, ends: [VertexId; 2]) -> Option<u32> {
        let [a, b] = ends.map(id);
        self.named.binary_search(&[a.min(b), a.max(b)]).ok().map(piece_id)
    }

    /// The squared length of a segment.
    pub(crate) fn squared_length(&self, segment: u32) -> Dyadic {
        let [a, b] = self.segments[segment as usize].map(|v| self.kernel.position(v));
        let along = |axis: usize| Dyadic::from(b[axis]) - Dyadic::from(a[axis]);
        [0, 1].map(along).iter().fold(Dyadic::ZERO, |sum, x| sum + x * x)
    }

    /// The length of a segment, off by less than 2^-51 of itself, where doubles may tell.
    #[inline]
    pub(crate) fn length(&self, segment: u32) -> Option<f64> {
        self.lengths[segment as usize]
    }

    /// Puts a Steiner point on a piece. The piece becomes the part before it, a new one the part after it.
    ///
    /// # Panics
    /// If the parameter is not strictly between those of the piece's ends (Inv 2).
    pub(crate) fn split_piece(
        &mut self,
        piece: PieceId,
        t: Parameter,
        probe: &mut impl Probe,
    ) -> VertexId {
        let [t0, t1] = self.parameters(piece);
        assert!(t0.is_less(&t) && t.is_less(&t1), "Inv 2: a piece is split between its ends");
        let Piece { segment, ends: [_, b], .. } = self.pieces[piece as usize];
        let [from, to] = self.segments[segment as usize];
        let p = match &t {
            Parameter::Double(t) => self.kernel.push_between([from, to], *t),
            Parameter::Long(t) => {
                let t = Dyadic::clone(t);
                self.kernel.push(&Construction::SegmentPoint { a: from, b: to, t })
            }
        };
        let p = VertexId::new(p.expect("the ends of a segment are sites") as usize);
        self.steiner.push_on(segment, t);
        let h = self.half_edge(piece);
        let second = piece_id(self.pieces.len());
        self.pieces[piece as usize].ends[1] = p;
        self.pieces.push(Piece { segment, ends: [p, b], half: h });
        self.split_edge(h, p, [piece, second]);
        probe.on(Event::Subsegment);
        probe.on(Event::SteinerPoint);
        self.legalize(probe);
        p
    }

    /// Replaces the two triangles of the edge ab of `h` by four about `p`; `pa` and `pb` are the pieces of its parts.
    fn split_edge(&mut self, h: HalfEdge, p: VertexId, [pa, pb]: [PieceId; 2]) {
        let mesh = &self.mesh;
        let t = mesh.twin(h);
        let (a, b, c, d) = (mesh.origin(h), mesh.destination(h), mesh.apex(h), mesh.apex(t));
        let rim = [mesh.next(h), mesh.prev(h), mesh.next(t), mesh.prev(t)]; // bc, ca, ad, db
        let outside = rim.map(|inside| (mesh.twin(inside), self.piece_at[inside.index()]));
        let [left, right] = [h, t].map(|h| self.region_at[h.cell().index()]);
        self.retire(h.cell());
        self.retire(t.cell());
        // Each with p first: facet 0 is opposite p.
        let around = [[p, b, c], [p, c, a], [p, a, d], [p, d, b]];
        let regions = [left, left, right, right];
        let around = [0, 1, 2, 3].map(|i| self.add(around[i], regions[i]));
        for (place, (outside, piece)) in outside.into_iter().enumerate() {
            let (cell, next) = (around[place], around[(place + 1) % 4]);
            let inside = HalfEdge::new(cell, 0);
            self.attach(inside, outside, piece);
            self.stack.push(inside);
            let spoke = [NONE, pa, NONE, pb][place]; // towards c, a, d, b
            self.attach(HalfEdge::new(cell, 1), HalfEdge::new(next, 2), spoke);
        }
    }

    /// Gives the slot of a cell away. Nobody takes it for what was there.
    fn retire(&mut self, cell: CellId) {
        self.mesh.retire(cell);
        self.mesh.set_corners(cell, &[VertexId::GHOST; 3]);
    }

    /// Whether a cell is one of these corners. Its slot may be that of another by now, or of none.
    pub(crate) fn is_still(&self, cell: CellId, corners: [VertexId; 3]) -> bool {
        self.mesh.triangle(cell) == corners
    }

    /// A new cell in a region, its edges free.
    fn add(&mut self, corners: [VertexId; 3], region: u32) -> CellId {
        let cell = self.claim(region);
        let twins = [0, 1, 2].map(|corner| HalfEdge::new(cell, corner));
        self.mesh.set_triangle(cell, corners, twins);
        cell
    }

    /// The slot of a cell in a region. What it holds is of no meaning, if its edges are known to be free.
    fn claim(&mut self, region: u32) -> CellId {
        let cell = self.mesh.claim_triangle();
        if cell.index() < self.region_at.len() {
            self.region_at[cell.index()] = region;
        } else {
            self.region_at.push(region);
            self.piece_at.extend_from_slice(&[NONE; 3]);
        }
        cell
    }

    /// Glues two half-edges, which are that piece or none (Inv 3).
    fn attach(&mut self, h: HalfEdge, twin: HalfEdge, piece: PieceId) {
        self.mesh.glue(h, twin);
        self.piece_at[h.index()] = piece;
        self.piece_at[twin.index()] = piece;
        if piece != NONE {
            self.pieces[piece as usize].half = h;
        }
    }

    /// Flips the edges on the stack, each opposite one vertex, and those that come opposite it, to Inv 1.
    fn legalize(&mut self, probe: &mut impl Probe) {
        let bound = 8 * (self.mesh.cell_count() + 8);
        let mut looked_at = 0;
        while let Some(h) = self.stack.pop() {
            looked_at += 1;
            assert!(looked_at <= bound, "Inv 1: each flip brings the new vertex a neighbour");
            if self.piece_at[h.index()] != NONE {
                continue;
            }
            let (t, p) = (self.mesh.twin(h), self.mesh.apex(h));
            // The new vertex is not beyond the hull, so that ghosts are not in conflict with it.
            if self.mesh.is_ghost(h.cell()) || self.mesh.is_ghost(t.cell()) {
                continue;
            }
            probe.on(Event::InSphere);
            if self.kernel.in_sphere(self.mesh.corners(t.cell()), p) == Side::Positive {
                probe.on(Event::Flip);
                self.flip(h);
                self.stack.push(h);
                self.stack.push(self.mesh.prev(t));
            }
        }
    }

    /// Flips a free edge. The pieces on the rim go with their edges.
    fn flip(&mut self, h: HalfEdge) {
        let t = self.mesh.twin(h);
        let (bc, ad) = (self.mesh.next(h), self.mesh.next(t));
        let [of_bc, of_ad] = [bc, ad].map(|h| self.piece_at[h.index()]);
        self.mesh.flip(h);
        self.settle(h, of_ad);
        self.settle(t, of_bc);
        self.piece_at[bc.index()] = NONE;
        self.piece_at[ad.index()] = NONE;
    }

    /// A half-edge is that piece from now on; its twin knows already.
    fn settle(&mut self, h: HalfEdge, piece: PieceId) {
        self.piece_at[h.index()] = piece;
        if piece != NONE {
            self.pieces[piece as usize].half = h;
        }
    }
}

/// The distance of two points, off by less than 2^-51 of itself; `None` where squares may under- or overflow.
fn length([a, b]: [[f64; 2]; 2]) -> Option<f64> {
    let [x, y] = [b[0] - a[0], b[1] - a[1]];
    let square = x * x + y * y;
    (1e-270..1e270).contains(&square).then(|| square.sqrt())
}

pub(crate) fn id(v: VertexId) -> u32 {
    u32::try_from(v.index()).expect("a vertex index fits 32 bits")
}

fn piece_id(index: usize) -> PieceId {
    u32::try_from(index).ok().filter(|&piece| piece != NONE).expect("pieces are fewer than ids")
}
