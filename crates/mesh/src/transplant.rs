//! Transplant: a connected set of cells is removed, and the hole filled with cells of another mesh.
//!
//! **In.** A cavity of this mesh; a cavity of another mesh, its vertices renamed, with the same rim, facet for facet.
//! **Out.** This mesh with the one in the place of the other. **Invariant.** Rims match: each facet of the one, as a set of
//! vertices, is one of the other. **Cost.** A sort of either rim, and O(D) for each cell.

use crate::{Cavity, CellId, FacetId, Mesh, VertexId};

impl<const D: usize> Mesh<D> {
    /// Replaces the cells of `hole` by those of `graft` in `donor`, whose vertices are renamed by `name` (the ghost keeps
    /// its name); returns the new cells.
    ///
    /// # Panics
    /// If the two rims are not the same facets.
    pub fn transplant(
        &mut self,
        hole: &Cavity<D>,
        donor: &Self,
        graft: &Cavity<D>,
        name: impl Fn(VertexId) -> VertexId,
    ) -> Vec<CellId> {
        let rename = |v: VertexId| if v.is_ghost() { v } else { name(v) };
        let mut images: Vec<(CellId, CellId)> = Vec::with_capacity(graft.cells().len());
        for &cell in graft.cells() {
            let corners: Vec<VertexId> = donor.corners(cell).iter().map(|&v| rename(v)).collect();
            images.push((cell, self.add_cell(&corners)));
        }
        images.sort_unstable();
        let image = |facet: FacetId<D>| {
            let place = images.binary_search_by_key(&facet.cell(), |&(cell, _)| cell);
            place.ok().map(|place| FacetId::new(images[place].1, facet.corner()))
        };
        let mut rim: Vec<(Vec<VertexId>, FacetId<D>)> = Vec::with_capacity(hole.rim().len());
        for facet in graft.cells().iter().flat_map(|&cell| donor.facets(cell)) {
            let here = image(facet).expect("the cells of the graft have images");
            match image(donor.twin(facet)) {
                Some(there) => self.glue(here, there),
                None => rim.push((self.facet_key(here), here)),
            }
        }
        rim.sort_unstable();
        assert_eq!(rim.len(), hole.rim().len(), "Invariant: the rims match");
        for inside in hole.rim() {
            let found = rim.binary_search_by(|(key, _)| key.cmp(&self.facet_key(inside)));
            let place = found.unwrap_or_else(|_| panic!("Invariant: the rims match at {inside:?}"));
            self.glue(rim[place].1, self.twin(inside));
        }
        hole.cells().iter().for_each(|&cell| self.retire(cell));
        images.into_iter().map(|(_, image)| image).collect()
    }
}
