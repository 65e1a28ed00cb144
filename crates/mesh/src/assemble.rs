//! A mesh from a list of solid cells: facets paired by their vertices, ghosts put where one is alone.
//!
//! **In.** The corners of cells, positively oriented, that tile a ball. **Out.** The sphere of these and their ghosts, or
//! what is wrong. **Cost.** A sort of all facets.

use crate::mesh::turn_round;
use crate::{CellId, FacetId, Level, Mesh, MeshFault, VertexId};

impl<const D: usize> Mesh<D> {
    /// The mesh of these solid cells, `dimension + 1` corners each, closed by ghosts.
    ///
    /// ```
    /// use delone_mesh::{Mesh, VertexId};
    /// let square = [0, 1, 2, 0, 2, 3].map(VertexId::new);
    /// let mesh = Mesh::<2>::from_cells(2, &square).unwrap();
    /// assert_eq!((mesh.solid_cells().count(), mesh.ghost_cells().count()), (2, 4));
    /// ```
    ///
    /// # Errors
    /// If a facet has more than two cells, two on one side, or the corners are no whole number of simplices. That the
    /// cells tile a ball is not looked at: [`Mesh::faults`] up to [`Level::Sphere`] does.
    ///
    /// # Panics
    /// If the dimension is over D.
    pub fn from_cells(dimension: usize, corners: &[VertexId]) -> Result<Self, Vec<MeshFault>> {
        let mut mesh = Self::bare(dimension);
        let count = dimension + 1;
        if corners.is_empty() || !corners.len().is_multiple_of(count) {
            return Err(vec![MeshFault::Lengths]);
        }
        if dimension == 0 && corners.len() == 1 {
            return Ok(Self::simplex(corners));
        }
        for cell in corners.chunks_exact(count) {
            mesh.add_cell(cell);
        }
        let solid = mesh.handle_faults(usize::MAX);
        if !solid.is_empty() {
            return Err(solid);
        }
        let outer = mesh.pair_up(mesh.cells().flat_map(|cell| mesh.facets(cell)).collect());
        let mut between = Vec::new();
        for facet in outer {
            let ghost = mesh.add_ghost(facet);
            between.extend(mesh.facets(ghost).filter(|&f| !mesh.apex(f).is_ghost()));
        }
        mesh.pair_up(between);
        let faults = mesh.faults(Level::Twins, usize::MAX);
        if faults.is_empty() { Ok(mesh) } else { Err(faults) }
    }

    /// Glues facets of equal vertex sets, two by two; returns those that are alone.
    fn pair_up(&mut self, facets: Vec<FacetId<D>>) -> Vec<FacetId<D>> {
        let mut keyed: Vec<(Vec<VertexId>, FacetId<D>)> =
            facets.into_iter().map(|facet| (self.facet_key(facet), facet)).collect();
        keyed.sort_unstable();
        let mut alone = Vec::new();
        for group in keyed.chunk_by(|a, b| a.0 == b.0) {
            match group {
                [(_, facet)] => alone.push(*facet),
                [(_, facet), (_, twin)] => self.glue(*facet, *twin),
                _ => {} // left as their own twins: a fault
            }
        }
        alone
    }

    /// The vertices of a facet, sorted.
    pub(crate) fn facet_key(&self, facet: FacetId<D>) -> Vec<VertexId> {
        let corners = self.corners(facet.cell()).iter().enumerate();
        let mut key: Vec<VertexId> =
            corners.filter(|&(corner, _)| corner != facet.corner()).map(|(_, &v)| v).collect();
        key.sort_unstable();
        key
    }

    /// Adds the ghost cell beyond a facet, and glues the two.
    fn add_ghost(&mut self, facet: FacetId<D>) -> CellId {
        let mut corners = self.corners(facet.cell()).to_vec();
        corners[facet.corner()] = VertexId::GHOST;
        turn_round(&mut corners, facet.corner());
        let ghost = self.add_cell(&corners);
        let inner = FacetId::new(ghost, self.corner_of(ghost, VertexId::GHOST));
        self.glue(facet, inner);
        ghost
    }
}
