//! In the plane a facet is a half-edge: facet `i` of a triangle runs from corner `i + 1` to corner `i + 2`.
//!
//! ```text
//!            apex(h)                    next(h) and prev(h) are the other two half-edges of h's triangle,
//!            /    \                     counter-clockwise. Around a vertex, twin(prev(h)) is the next half-edge
//!   prev(h) /  h's \ next(h)            leaving origin(h), counter-clockwise.
//!          / triangle\
//!  origin(h) --h--> destination(h)
//! ```

use crate::{CellId, FacetId, Mesh, VertexId};

/// A directed edge of a planar mesh: the facet of the triangle on its left.
pub type HalfEdge = FacetId<2>;

impl Mesh<2> {
    /// The corners of a triangle. The mesh must be of dimension 2.
    #[inline]
    #[must_use]
    pub fn triangle(&self, cell: CellId) -> [VertexId; 3] {
        let corners = self.corners_of(cell);
        [corners[0], corners[1], corners[2]]
    }

    /// The twins of a triangle's three half-edges. The mesh must be of dimension 2.
    #[inline]
    #[must_use]
    pub fn triangle_twins(&self, cell: CellId) -> [HalfEdge; 3] {
        let twins = self.twins_of(cell);
        [twins[0], twins[1], twins[2]]
    }

    /// A slot for a triangle, retired or new, which is to be set.
    #[inline]
    pub fn claim_triangle(&mut self) -> CellId {
        if let Some(cell) = self.free.pop() {
            return cell;
        }
        let cell = CellId::new(self.cell_count());
        let first = HalfEdge::new(cell, 0);
        self.vertices.extend_from_slice(&[VertexId::GHOST; 3]);
        self.twins.extend_from_slice(&[first, first.further(1), first.further(2)]);
        cell
    }

    /// Makes a cell this triangle, with these twins. Each of them is still to be told of its own.
    #[inline]
    pub fn set_triangle(&mut self, cell: CellId, corners: [VertexId; 3], twins: [HalfEdge; 3]) {
        let first = 3 * cell.index();
        self.vertices[first..first + 3].copy_from_slice(&corners);
        self.twins[first..first + 3].copy_from_slice(&twins);
    }

    /// Where `h` starts.
    #[inline]
    #[must_use]
    pub fn origin(&self, h: HalfEdge) -> VertexId {
        self.apex(self.next(h))
    }

    /// Where `h` ends.
    #[inline]
    #[must_use]
    pub fn destination(&self, h: HalfEdge) -> VertexId {
        self.apex(self.prev(h))
    }

    /// The half-edge after `h` around its triangle, counter-clockwise.
    #[inline]
    #[must_use]
    pub fn next(&self, h: HalfEdge) -> HalfEdge {
        let index = h.index();
        HalfEdge::from_index(if index % 3 == 2 { index - 2 } else { index + 1 })
    }

    /// The half-edge before `h` around its triangle.
    #[inline]
    #[must_use]
    pub fn prev(&self, h: HalfEdge) -> HalfEdge {
        let index = h.index();
        HalfEdge::from_index(if index.is_multiple_of(3) { index + 2 } else { index - 1 })
    }

    /// The half-edges that leave `vertex`, counter-clockwise, from one in `cell`, which has the vertex. Edges to the
    /// ghost are among them.
    #[inline]
    pub fn ring(
        &self,
        vertex: VertexId,
        cell: CellId,
    ) -> impl Iterator<Item = HalfEdge> + Clone + '_ {
        let corner = self.corner_of(cell, vertex);
        let first = HalfEdge::new(cell, (corner + 2) % 3);
        let mut turned = Some(first);
        std::iter::from_fn(move || {
            let h = turned?;
            let after = self.twin(self.prev(h));
            turned = (after != first).then_some(after);
            Some(h)
        })
    }

    /// The half-edge from `a`, which `cell` has, to `b`, if they are joined. O(degree of `a`).
    #[must_use]
    pub fn half_edge(&self, a: VertexId, b: VertexId, cell: CellId) -> Option<HalfEdge> {
        self.ring(a, cell).find(|&h| self.destination(h) == b)
    }
}
