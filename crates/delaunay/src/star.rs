//! The star of a vertex: the cells that have it.

use delone_mesh::{Cavity, CellId, Mesh, VertexId};

/// Makes `star` the cells that have `vertex`, of which `cell` is one, and its rim the facets opposite it.
pub(crate) fn gather_star<const D: usize>(
    mesh: &Mesh<D>,
    vertex: VertexId,
    cell: CellId,
    star: &mut Cavity<D>,
) {
    star.dig(mesh, cell, |cell| mesh.corners(cell).contains(&vertex));
}

/// The vertices of the star's rim but the ghost: the neighbours of the vertex, sorted.
pub(crate) fn neighbours<const D: usize>(mesh: &Mesh<D>, star: &Cavity<D>) -> Vec<VertexId> {
    let mut found = Vec::new();
    for facet in star.rim() {
        let corners = mesh.corners(facet.cell()).iter().enumerate();
        found.extend(corners.filter(|&(corner, _)| corner != facet.corner()).map(|(_, &v)| v));
    }
    found.retain(|vertex| !vertex.is_ghost());
    found.sort_unstable();
    found.dedup();
    found
}
