//! What the methods return: a mesh, and what its Steiner points are.

use delone_cdt::Cdt;
use delone_delaunay::Fingerprint;
use delone_mesh::{CellId, HalfEdge, Mesh, VertexId};
use delone_predicates::{Constructed, Dyadic, Kernel};
use delone_sites::{Noded, Pslg};

use crate::live::{Live, Steiner, id};

/// A Steiner point on a segment: exactly `a + t (b - a)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OnSegment {
    /// The sites a and b: the ends of one of the PSLG's subsegments.
    pub ends: [u32; 2],
    /// The parameter, strictly between 0 and 1.
    pub t: Dyadic,
}

/// A triangulation of a PSLG with Steiner points: those after the sites.
#[derive(Clone, Debug)]
pub struct Conforming {
    mesh: Mesh<2>,
    kernel: Constructed<2>,
    sites: usize,
    steiner: Vec<OnSegment>,
    constrained: Vec<[u32; 2]>,
    is_complete: bool,
}

impl Conforming {
    pub(crate) fn new(live: Live, is_complete: bool) -> Self {
        let on = |steiner: &Steiner| match steiner {
            Steiner::On { segment, t } => {
                OnSegment { ends: live.segments[*segment as usize], t: t.clone() }
            }
            Steiner::Free => unreachable!("all Steiner points of this kind are on segments"),
        };
        let steiner = live.steiner.iter().map(on).collect();
        let constrained = live.pieces.iter().map(|piece| piece.ends.map(id));
        let mut constrained: Vec<[u32; 2]> =
            constrained.map(|[a, b]| [a.min(b), a.max(b)]).collect();
        constrained.sort_unstable();
        let Live { mesh, kernel, sites, .. } = live;
        Self { mesh, kernel, sites, steiner, constrained, is_complete }
    }

    /// Of sites in line.
    pub(crate) fn chain(cdt: &Cdt, pslg: &Pslg) -> Self {
        Self {
            mesh: cdt.mesh().clone(),
            kernel: pslg.kernel(),
            sites: pslg.sites().len(),
            steiner: Vec::new(),
            constrained: cdt.constrained_edges(),
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
    pub fn steiner_points(&self) -> &[OnSegment] {
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
        let count = u32::try_from(self.kernel.len()).expect("vertices are fewer than ids");
        let mut sorted: Vec<u32> = (0..count).collect();
        sorted.sort_unstable_by(|&u, &v| {
            self.kernel.compare_lexicographic(u as usize, v as usize)
        });
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
