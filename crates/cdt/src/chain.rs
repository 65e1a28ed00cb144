//! All sites in line: the triangulation is a chain of edges, and each subsegment is one of them.

use delone_mesh::{HalfEdge, Mesh};

/// The flags of a mesh of dimension 1 or less: the first facet of each cell that is a subsegment. `subsegments` are in
/// increasing order, smaller site first.
pub(crate) fn constrained_cells(mesh: &Mesh<2>, subsegments: &[[u32; 2]]) -> Vec<bool> {
    let mut constrained = vec![false; 3 * mesh.cell_count()];
    for cell in mesh.solid_cells() {
        if let [u, v] = *mesh.corners(cell) {
            let mut ends = [u, v].map(|vertex| u32::try_from(vertex.index()).expect("a site"));
            ends.sort_unstable();
            constrained[HalfEdge::new(cell, 0).index()] = subsegments.binary_search(&ends).is_ok();
        }
    }
    constrained
}
