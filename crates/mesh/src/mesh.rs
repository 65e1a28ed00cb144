//! The mesh itself: two flat arrays, read by handle.

use crate::{CellId, FacetId, Level, VertexId};

/// A triangulated sphere of dimension up to D: the D+1 vertices of each cell, and the twin of each of its facets.
///
/// A mesh of dimension k < D (all sites in a k-flat) uses the first k+1 corners of each cell; the rest of its slots hold
/// nothing. See the crate's text for the ghosts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mesh<const D: usize> {
    pub(crate) dimension: Option<usize>,
    pub(crate) vertices: Vec<VertexId>,
    pub(crate) twins: Vec<FacetId<D>>,
    /// Slots of retired cells, to be used again. Empty outside construction.
    pub(crate) free: Vec<CellId>,
}

impl<const D: usize> Default for Mesh<D> {
    fn default() -> Self {
        Self { dimension: None, vertices: Vec::new(), twins: Vec::new(), free: Vec::new() }
    }
}

impl<const D: usize> Mesh<D> {
    /// Makes room for so many cells in all, and for no more: arrays that grow by themselves hold twice as much while they move.
    pub fn reserve(&mut self, cells: usize) {
        let facets = cells.saturating_mul(D + 1).saturating_sub(self.vertices.len());
        self.vertices.reserve_exact(facets);
        self.twins.reserve_exact(facets);
    }

    /// The mesh of no vertices: no cells, no dimension.
    #[must_use]
    pub fn empty() -> Self {
        Self::default()
    }

    /// A mesh of this dimension without cells, for an algorithm to fill with [`Mesh::add_cell`] and [`Mesh::glue`].
    ///
    /// # Panics
    /// If the dimension is over D.
    #[must_use]
    pub fn bare(dimension: usize) -> Self {
        assert!(dimension <= D, "a mesh of R^{D} has at most {D} dimensions");
        Self { dimension: Some(dimension), ..Self::default() }
    }

    /// The two-sided simplex: `corners` as one solid cell, positively oriented by the caller, and its ghosts; dimension
    /// `corners.len() - 1`.
    ///
    /// # Panics
    /// If there is no corner, or more than D+1.
    #[must_use]
    pub fn simplex(corners: &[VertexId]) -> Self {
        let count = corners.len();
        assert!((1..=D + 1).contains(&count), "a simplex of R^{D} has 1 to {} corners", D + 1);
        let mut mesh = Self { dimension: Some(count - 1), ..Self::default() };
        let solid = mesh.add_cell(corners);
        // The ghost across facet i: corner i becomes GHOST, and two others change places to turn it round. On a line
        // and at a point there are not two others; there the ghost stands in the other place.
        for i in 0..count {
            let mut ghost = corners.to_vec();
            ghost[i] = VertexId::GHOST;
            turn_round(&mut ghost, i);
            mesh.add_cell(&ghost);
        }
        for i in 0..count {
            for j in 0..count {
                let here = CellId::new(1 + i);
                let vertex = if i == j { VertexId::GHOST } else { corners[j] };
                let facet = FacetId::new(here, mesh.corner_of(here, vertex));
                if i == j {
                    mesh.glue(facet, FacetId::new(solid, i));
                } else {
                    let there = CellId::new(1 + j);
                    mesh.glue(facet, FacetId::new(there, mesh.corner_of(there, corners[i])));
                }
            }
        }
        mesh
    }

    /// A mesh from its arrays: for each cell D+1 vertices and D+1 twins, of which a mesh of lower dimension uses the first
    /// ones.
    ///
    /// # Panics
    /// If the lengths are not one multiple of D+1. In debug builds, if the arrays are no mesh up to [`Level::Twins`].
    #[must_use]
    pub fn from_parts(dimension: usize, vertices: Vec<VertexId>, twins: Vec<FacetId<D>>) -> Self {
        assert!(vertices.len() == twins.len() && vertices.len().is_multiple_of(D + 1));
        assert!(dimension <= D, "a mesh of R^{D} has dimension up to {D}");
        let mesh = Self { dimension: Some(dimension), vertices, twins, free: Vec::new() };
        debug_assert_eq!(mesh.faults(Level::Twins, usize::MAX), []);
        mesh
    }

    /// The mesh of some sites in line: a circle of segments, through the sites in their order along the line and the
    /// ghost; a point and its ghost for one site; nothing for none.
    ///
    /// # Panics
    /// If D is 0.
    #[must_use]
    pub fn chain(line: &[VertexId]) -> Self {
        assert!(D >= 1, "a chain has a line to lie in");
        match line {
            [] => return Self::empty(),
            [_] => return Self::simplex(line),
            _ => {}
        }
        let mut mesh = Self { dimension: Some(1), ..Self::default() };
        for pair in line.windows(2) {
            mesh.add_cell(pair);
        }
        mesh.add_cell(&[line[line.len() - 1], VertexId::GHOST]);
        mesh.add_cell(&[VertexId::GHOST, line[0]]);
        for (cell, next) in mesh.cells().zip(mesh.cells().cycle().skip(1)) {
            // The vertex between is opposite the other one of either.
            mesh.glue(FacetId::new(cell, 0), FacetId::new(next, 1));
        }
        mesh
    }

    /// The mesh of lower dimension K as one of dimension K in R^D.
    ///
    /// # Panics
    /// If K is over D.
    #[must_use]
    pub fn embed<const K: usize>(mesh: &Mesh<K>) -> Self {
        assert!(K <= D, "a mesh of R^{K} does not go into R^{D}");
        let mut embedded = Self { dimension: mesh.dimension, ..Self::default() };
        for cell in mesh.cells() {
            embedded.add_cell(mesh.corners(cell));
        }
        for facet in mesh.cells().flat_map(|cell| mesh.facets(cell)) {
            let twin = mesh.twin(facet);
            let slot = FacetId::<D>::new(facet.cell(), facet.corner()).index();
            embedded.twins[slot] = FacetId::new(twin.cell(), twin.corner());
        }
        embedded
    }

    /// The dimension of the sites' affine hull; `None` without sites.
    #[inline]
    #[must_use]
    pub fn dimension(&self) -> Option<usize> {
        self.dimension
    }

    /// Corners of a cell: the dimension plus one.
    #[inline]
    #[must_use]
    pub fn corner_count(&self) -> usize {
        self.dimension.map_or(0, |k| k + 1)
    }

    /// Cells, solid and ghost. (During construction, retired cells count too.)
    #[inline]
    #[must_use]
    pub fn cell_count(&self) -> usize {
        self.vertices.len() / (D + 1)
    }

    /// All cells by index, solid and ghost.
    #[inline]
    pub fn cells(&self) -> impl Iterator<Item = CellId> + Clone + use<D> {
        (0..self.cell_count()).map(CellId::new)
    }

    /// The cells that do not touch the ghost vertex, by index.
    #[inline]
    pub fn solid_cells(&self) -> impl Iterator<Item = CellId> + Clone + '_ {
        self.cells().filter(|&cell| !self.is_ghost(cell))
    }

    /// The cells that touch the ghost vertex, by index: one for each facet of the hull.
    #[inline]
    pub fn ghost_cells(&self) -> impl Iterator<Item = CellId> + Clone + '_ {
        self.cells().filter(|&cell| self.is_ghost(cell))
    }

    /// The vertices of a cell, one for each corner.
    #[inline]
    #[must_use]
    pub fn corners(&self, cell: CellId) -> &[VertexId] {
        let first = cell.index() * (D + 1);
        &self.vertices[first..first + self.corner_count()]
    }

    /// The vertex at a corner.
    #[inline]
    #[must_use]
    pub fn vertex(&self, cell: CellId, corner: usize) -> VertexId {
        self.vertices[cell.index() * (D + 1) + corner]
    }

    /// The corner of `cell` where `vertex` is.
    ///
    /// # Panics
    /// If the vertex is not in the cell.
    #[inline]
    #[must_use]
    pub fn corner_of(&self, cell: CellId, vertex: VertexId) -> usize {
        let found = self.corners(cell).iter().position(|&v| v == vertex);
        found.unwrap_or_else(|| panic!("{vertex:?} is no corner of {cell:?}"))
    }

    /// The facets of a cell, seen from it, by opposite corner.
    #[inline]
    pub fn facets(&self, cell: CellId) -> impl Iterator<Item = FacetId<D>> + Clone + use<D> {
        (0..self.corner_count()).map(move |corner| FacetId::new(cell, corner))
    }

    /// The same facet seen from the other side.
    #[inline]
    #[must_use]
    pub fn twin(&self, facet: FacetId<D>) -> FacetId<D> {
        self.twins[facet.index()]
    }

    /// The twins of a cell's facets, and what is in the slots that a mesh of lower dimension leaves.
    #[inline(always)]
    pub(crate) fn twins_of(&self, cell: CellId) -> &[FacetId<D>] {
        let first = cell.index() * (D + 1);
        &self.twins[first..=first + D]
    }

    /// The vertices of a cell, and what is in the slots that a mesh of lower dimension leaves.
    #[inline(always)]
    pub(crate) fn corners_of(&self, cell: CellId) -> &[VertexId] {
        let first = cell.index() * (D + 1);
        &self.vertices[first..=first + D]
    }

    /// The vertex opposite a facet, in the facet's own cell.
    #[inline]
    #[must_use]
    pub fn apex(&self, facet: FacetId<D>) -> VertexId {
        self.vertices[facet.index()]
    }

    /// Whether a cell touches the ghost vertex.
    #[inline]
    #[must_use]
    pub fn is_ghost(&self, cell: CellId) -> bool {
        self.corners(cell).contains(&VertexId::GHOST)
    }

    /// Adds a cell, in a retired slot if there is one. Its facets are their own twins until they are glued.
    ///
    /// # Panics
    /// If the number of corners is not the mesh's.
    pub fn add_cell(&mut self, corners: &[VertexId]) -> CellId {
        assert_eq!(corners.len(), self.corner_count(), "a cell has as many corners as its mesh");
        let cell = self.claim_cell();
        let first = cell.index() * (D + 1);
        self.vertices[first..first + corners.len()].copy_from_slice(corners);
        for corner in 0..corners.len() {
            self.twins[first + corner] = FacetId::new(cell, corner);
        }
        cell
    }

    /// Gives a cell other corners, in the same slot. Its twins stay until they are glued.
    ///
    /// # Panics
    /// If the number of corners is not the mesh's.
    #[inline]
    pub fn set_corners(&mut self, cell: CellId, corners: &[VertexId]) {
        assert_eq!(corners.len(), self.corner_count(), "a cell has as many corners as its mesh");
        let first = cell.index() * (D + 1);
        self.vertices[first..first + corners.len()].copy_from_slice(corners);
    }

    /// A slot for a cell, which still holds what it held.
    #[inline]
    pub(crate) fn claim_cell(&mut self) -> CellId {
        match self.free.pop() {
            Some(cell) => cell,
            None => self.new_cell(),
        }
    }

    /// Sees to it that `count` slots are retired; new ones come last in turn, the first of them first.
    #[inline]
    pub(crate) fn provide(&mut self, count: usize) {
        let first = self.cell_count();
        let missing = count.saturating_sub(self.free.len());
        if missing > 0 {
            let fresh = first..first + missing;
            self.vertices.resize(fresh.end * (D + 1), VertexId::GHOST);
            let facets = first * (D + 1)..fresh.end * (D + 1);
            self.twins.extend(facets.map(FacetId::<D>::from_index));
            self.free.splice(0..0, fresh.rev().map(CellId::new));
        }
    }

    #[cold]
    #[inline(never)]
    fn new_cell(&mut self) -> CellId {
        let cell = CellId::new(self.cell_count());
        self.vertices.resize(self.vertices.len() + D + 1, VertexId::GHOST);
        self.twins.extend((0..=D).map(|corner| FacetId::<D>::new(cell, corner)));
        cell
    }

    /// Makes two facets twins.
    #[inline]
    pub fn glue(&mut self, facet: FacetId<D>, twin: FacetId<D>) {
        self.twins[facet.index()] = twin;
        self.twins[twin.index()] = facet;
    }

    /// Gives the slot of a cell to the next [`Mesh::add_cell`]. The mesh is whole again after [`Mesh::compact`].
    pub fn retire(&mut self, cell: CellId) {
        self.free.push(cell);
    }

    /// Closes the slots of retired cells that were not used again: the last cells move into them, and `moved` is told
    /// from where to where.
    pub fn compact(&mut self, mut moved: impl FnMut(CellId, CellId)) {
        let mut free = std::mem::take(&mut self.free);
        free.sort_unstable();
        while let Some(hole) = free.pop() {
            let last = CellId::new(self.cell_count() - 1);
            if hole != last {
                self.move_cell(last, hole);
                moved(last, hole);
            }
            self.vertices.truncate(last.index() * (D + 1));
            self.twins.truncate(last.index() * (D + 1));
        }
    }

    fn move_cell(&mut self, from: CellId, to: CellId) {
        for corner in 0..self.corner_count() {
            let (old, new) = (FacetId::<D>::new(from, corner), FacetId::<D>::new(to, corner));
            self.vertices[new.index()] = self.vertices[old.index()];
            let twin = self.twin(old);
            if twin.cell() == from {
                self.twins[new.index()] = FacetId::new(to, twin.corner());
            } else {
                self.glue(new, twin);
            }
        }
    }

    /// Renames every vertex but the ghost.
    pub fn relabel(&mut self, name: impl Fn(VertexId) -> VertexId) {
        for vertex in self.vertices.iter_mut().filter(|vertex| !vertex.is_ghost()) {
            *vertex = name(*vertex);
        }
    }

    /// For each vertex below `count`, some cell that has it.
    #[must_use]
    pub fn cells_by_vertex(&self, count: usize) -> Vec<Option<CellId>> {
        let mut cells = vec![None; count];
        for cell in self.cells() {
            for vertex in self.corners(cell).iter().filter(|vertex| !vertex.is_ghost()) {
                cells[vertex.index()] = Some(cell);
            }
        }
        cells
    }

    /// The solid cells, each with its vertices in increasing order, in lexicographic order; flat.
    #[must_use]
    pub fn canonical(&self, name: impl Fn(VertexId) -> u32) -> Vec<u32> {
        let count = self.corner_count();
        if count == 0 {
            return Vec::new();
        }
        let mut cells: Vec<u32> = Vec::new();
        for cell in self.solid_cells() {
            let first = cells.len();
            cells.extend(self.corners(cell).iter().map(|&vertex| name(vertex)));
            cells[first..].sort_unstable();
        }
        let mut sorted: Vec<&[u32]> = cells.chunks_exact(count).collect();
        sorted.sort_unstable();
        sorted.concat()
    }
}

/// Reverses the orientation of a ghost cell whose ghost is at corner `i`.
pub(crate) fn turn_round(corners: &mut [VertexId], i: usize) {
    match *corners {
        [_] => {}
        [_, _] => corners.swap(0, 1),
        _ => {
            let (a, b) = if i == 0 {
                (1, 2)
            } else if i == 1 {
                (0, 2)
            } else {
                (0, 1)
            };
            corners.swap(a, b);
        }
    }
}
