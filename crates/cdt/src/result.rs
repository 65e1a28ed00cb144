//! What the algorithms return: a mesh that is known to be constrained Delaunay.

use delone_delaunay::Fingerprint;
use delone_mesh::{CellId, HalfEdge, Mesh};
use delone_sites::Noded;

/// The constrained Delaunay triangulation of a noded PSLG, ties broken by the lexicographic order of its sites.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cdt {
    mesh: Mesh<2>,
    constrained: Vec<bool>,
}

impl Cdt {
    pub(crate) fn new(mesh: Mesh<2>, constrained: Vec<bool>) -> Self {
        Self { mesh, constrained }
    }

    pub(crate) fn into_parts(self) -> (Mesh<2>, Vec<bool>) {
        (self.mesh, self.constrained)
    }

    /// The mesh; vertex `i` is site `i`. Of dimension 1 or less if all sites are in line.
    #[must_use]
    pub const fn mesh(&self) -> &Mesh<2> {
        &self.mesh
    }

    /// The solid cells by index.
    pub fn cells(&self) -> impl Iterator<Item = CellId> + Clone + '_ {
        self.mesh.solid_cells()
    }

    /// Whether the edge of `h` is part of a segment. In a mesh of dimension 1 the edges are cells, and `h` is the first
    /// facet of one.
    #[must_use]
    pub fn is_constrained(&self, h: HalfEdge) -> bool {
        self.constrained[h.index()]
    }

    /// The constrained edges as pairs of sites, smaller first, in increasing order.
    #[must_use]
    pub fn constrained_edges(&self) -> Vec<[u32; 2]> {
        let ends = |h: HalfEdge| match self.mesh.dimension() {
            Some(1) => [self.mesh.vertex(h.cell(), 0), self.mesh.vertex(h.cell(), 1)],
            _ => [self.mesh.origin(h), self.mesh.destination(h)],
        };
        let marked = (0..self.constrained.len()).filter(|&index| self.constrained[index]);
        let mut edges: Vec<[u32; 2]> = marked
            .map(|index| {
                let mut pair = ends(HalfEdge::from_index(index)).map(|v| id(v.index()));
                pair.sort_unstable();
                pair
            })
            .collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// The solid cells as sorted site ids, in lexicographic order; flat, dimension + 1 ids each.
    #[must_use]
    pub fn canonical(&self) -> Vec<u32> {
        self.mesh.canonical(|vertex| id(vertex.index()))
    }

    /// A hash of sites, cells and constrained edges that depends on positions only, not on the order of input.
    #[must_use]
    pub fn fingerprint(&self, graph: &impl Noded) -> Fingerprint {
        let ranks = graph.ranks();
        let mut hash = Fingerprint::new();
        hash.sites(graph.sites());
        hash.ids(&self.mesh.canonical(|vertex| ranks[vertex.index()]));
        let ranked = |edge: [u32; 2]| {
            let [a, b] = edge.map(|site| ranks[site as usize]);
            [a.min(b), a.max(b)]
        };
        let mut edges: Vec<[u32; 2]> = self.constrained_edges().into_iter().map(ranked).collect();
        edges.sort_unstable();
        hash.ids(edges.as_flattened());
        hash
    }
}

/// The constrained half-edges of the CDT of a graph, of dimension 2, each with the place of its subsegment in
/// [`Noded::subsegments`]. O(n), and O(log d) for each at a vertex of degree d.
///
/// # Panics
/// If the CDT is not this graph's.
pub fn constrained_half_edges<'a>(
    cdt: &'a Cdt,
    graph: &'a impl Noded,
) -> impl Iterator<Item = (HalfEdge, usize)> + 'a {
    let all = graph.subsegments();
    // Subsegments are sorted: for each vertex, where those begin of which it is the smaller end.
    let mut starts = Vec::with_capacity(graph.positions().len() + 1);
    starts.push(0);
    for (place, &[low, _]) in all.iter().enumerate() {
        starts.resize(starts.len().max(low as usize + 1), place);
    }
    starts.resize(graph.positions().len() + 1, all.len());
    let marked = (0..cdt.constrained.len()).filter(|&index| cdt.constrained[index]);
    marked.map(HalfEdge::from_index).map(move |h| {
        let [a, b] = [cdt.mesh.origin(h), cdt.mesh.destination(h)].map(|v| v.index());
        let (low, high) = (a.min(b), id(a.max(b)));
        let (first, end) = (starts[low], starts[low + 1]);
        let place = all[first..end].binary_search_by_key(&high, |&[_, high]| high);
        (h, first + place.expect("a constrained edge is a subsegment of its graph"))
    })
}

fn id(index: usize) -> u32 {
    u32::try_from(index).expect("a vertex index fits 32 bits")
}
