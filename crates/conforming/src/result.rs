//! What the methods return: a mesh, and what its Steiner points are.

use delone_cdt::Cdt;
use delone_delaunay::Fingerprint;
use delone_mesh::{CellId, HalfEdge, Mesh, VertexId};
use delone_predicates::{Constructed, Dyadic, Kernel};
use delone_sites::{Noded, Pslg};

use crate::live::{Live, Piece, Steiner, id};

/// A vertex that was added.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SteinerPoint {
    /// On a subsegment of the PSLG: exactly `a + t (b - a)`.
    On {
        /// The subsegment, by index.
        subsegment: u32,
        /// The sites a and b, its ends.
        ends: [u32; 2],
        /// The parameter, strictly between 0 and 1.
        t: Dyadic,
    },
    /// Between segments, exactly at its position in doubles.
    Free,
    /// Between segments that are so close that doubles are too coarse for a place between them.
    FreeExactly {
        /// The place.
        at: Box<[Dyadic; 2]>,
    },
}

/// A triangulation of a PSLG with Steiner points: those after the sites.
#[derive(Clone, Debug)]
pub struct Conforming {
    mesh: Mesh<2>,
    kernel: Constructed<2>,
    sites: usize,
    steiner: Vec<SteinerPoint>,
    constrained: Vec<[u32; 2]>,
    /// The subsegment of the graph that each of these is part of.
    parents: Vec<u32>,
    is_complete: bool,
}

/// The ends of pieces, smaller first, in increasing order, and the segment of each. By the smaller end they are counted, not compared.
fn sorted(pieces: &[Piece], vertices: usize) -> (Vec<[u32; 2]>, Vec<u32>) {
    let ends = |piece: &Piece| {
        let [a, b] = piece.ends.map(id);
        [a.min(b), a.max(b)]
    };
    let mut starts = vec![0usize; vertices + 2];
    pieces.iter().for_each(|piece| starts[ends(piece)[0] as usize + 2] += 1);
    let mut sum = 0;
    for start in &mut starts {
        sum += *start;
        *start = sum;
    }
    let mut sorted = vec![([0; 2], 0); pieces.len()];
    for piece in pieces {
        let ends = ends(piece);
        let place = &mut starts[ends[0] as usize + 1];
        sorted[*place] = (ends, piece.segment);
        *place += 1;
    }
    sorted.chunk_by_mut(|a, b| a.0[0] == b.0[0]).for_each(<[_]>::sort_unstable);
    sorted.into_iter().unzip()
}

impl Conforming {
    pub(crate) fn new(live: Live, is_complete: bool) -> Self {
        let on = |(v, steiner): (u32, Steiner<'_>)| match steiner {
            Steiner::On { segment, t } => {
                let ends = live.segments[segment as usize];
                SteinerPoint::On { subsegment: segment, ends, t: t.exact() }
            }
            Steiner::Free if live.kernel.is_exact_position(v) => SteinerPoint::Free,
            Steiner::Free => SteinerPoint::FreeExactly { at: Box::new(live.kernel.exact(v).x) },
        };
        let mut steiner = Vec::with_capacity(live.steiner.len());
        steiner.extend((0..).skip(live.sites).zip(live.steiner.iter()).map(on));
        let (constrained, parents) = sorted(&live.pieces, live.kernel.len());
        let Live { mesh, kernel, sites, .. } = live;
        Self { mesh, kernel, sites, steiner, constrained, parents, is_complete }
    }

    /// Of sites in line.
    pub(crate) fn chain(cdt: &Cdt, pslg: &Pslg) -> Self {
        Self {
            mesh: cdt.mesh().clone(),
            kernel: pslg.kernel(),
            sites: pslg.sites().len(),
            steiner: Vec::new(),
            constrained: cdt.constrained_edges(),
            parents: (0u32..).take(pslg.subsegments().len()).collect(),
            is_complete: true,
        }
    }

    /// The mesh; vertex `i` is site `i`, or Steiner point `i - n` of n sites.
    #[must_use]
    pub const fn mesh(&self) -> &Mesh<2> {
        &self.mesh
    }

    /// The vertices, exactly.
    #[must_use]
    pub const fn kernel(&self) -> &Constructed<2> {
        &self.kernel
    }

    /// The double nearest to each vertex: for sites, the vertex itself.
    #[must_use]
    pub fn positions(&self) -> &[[f64; 2]] {
        self.kernel.positions()
    }

    /// How many vertices are sites: the first.
    #[must_use]
    pub const fn site_count(&self) -> usize {
        self.sites
    }

    /// The Steiner points, in the order in which they were added.
    #[must_use]
    pub fn steiner_points(&self) -> &[SteinerPoint] {
        &self.steiner
    }

    /// Whether all is done; else a limit was reached, and the mesh is a constrained Delaunay triangulation that does not
    /// conform yet.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.is_complete
    }

    /// The solid cells by index.
    pub fn cells(&self) -> impl Iterator<Item = CellId> + Clone + '_ {
        self.mesh.solid_cells()
    }

    /// The subsegments as pairs of vertices, smaller first, in increasing order.
    #[must_use]
    pub fn constrained_edges(&self) -> &[[u32; 2]] {
        &self.constrained
    }

    /// For each of [`Conforming::constrained_edges`] the subsegment of the PSLG that it is part of: with its chains, the way to
    /// the input segments and whatever they carry.
    #[must_use]
    pub fn parents(&self) -> &[u32] {
        &self.parents
    }

    /// Whether the edge of `h` is a subsegment.
    #[must_use]
    pub fn is_constrained(&self, h: HalfEdge) -> bool {
        let ends = [self.mesh.origin(h), self.mesh.destination(h)];
        if ends.contains(&VertexId::GHOST) {
            return false;
        }
        let [a, b] = ends.map(id);
        self.constrained.binary_search(&[a.min(b), a.max(b)]).is_ok()
    }

    /// The solid cells as sorted vertex ids, in lexicographic order; flat.
    #[must_use]
    pub fn canonical(&self) -> Vec<u32> {
        self.mesh.canonical(id)
    }

    /// A hash of vertices, cells and subsegments that depends on positions only, not on the order of input. Vertices are
    /// hashed as the doubles nearest to them.
    #[must_use]
    pub fn fingerprint(&self) -> Fingerprint {
        let mut sorted: Vec<u32> = (0u32..).take(self.kernel.len()).collect();
        sorted.sort_unstable_by(|&u, &v| self.kernel.compare_lexicographic(u as usize, v as usize));
        let mut ranks = vec![0; sorted.len()];
        let mut hash = Fingerprint::new();
        for (rank, &v) in (0u32..).zip(&sorted) {
            ranks[v as usize] = rank;
            self.kernel.position(v).iter().for_each(|x| hash.word(x.to_bits()));
        }
        hash.ids(&self.mesh.canonical(|v| ranks[v.index()]));
        let ranked = |&[a, b]: &[u32; 2]| {
            let [a, b] = [a, b].map(|v| ranks[v as usize]);
            [a.min(b), a.max(b)]
        };
        let mut edges: Vec<[u32; 2]> = self.constrained.iter().map(ranked).collect();
        edges.sort_unstable();
        hash.ids(edges.as_flattened());
        hash
    }
}
