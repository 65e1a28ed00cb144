//! The triangles of one block of sites, ghosts included, in the slots that the block owns.
//!
//! ```text
//!                  inner(g)                 A ghost (u, v, GHOST) is named by its edge g = 3 slot + 2, the one from u to
//!        inside   <--------                 v. The outside is on its left. So the chain of ghosts, `after` by `after`,
//!        ------ v ---g----> u ------        goes round the hull clockwise, and g's twin is the same edge seen from the
//!     after(g)     GHOST     before(g)      triangle inside (or from another ghost, where the block is a chain).
//! ```
//!
//! An *edge* is a facet's number, `3 slot + corner`, opposite that corner: `apexes` and `twins` are the two arrays of a
//! [`delone_mesh::Mesh`], but for the vertices, which are places until the end. Numbers are global; a patch holds those from
//! `first` on.

use delone_mesh::{FacetId, VertexId};

/// The number of a facet of a triangle.
pub(super) type Edge = u32;

/// The number of a site, by place in the order of the cuts; or [`GHOST`].
pub(super) type Place = u32;

/// The vertex at infinity.
pub(super) const GHOST: Place = u32::MAX;

/// The slots of a block. See the module's text.
#[derive(Debug)]
pub(super) struct Patch<'a> {
    apexes: &'a mut [VertexId],
    twins: &'a mut [FacetId<2>],
    first: Edge,
}

/// The edge after `e` in its triangle, counter-clockwise.
#[inline(always)]
pub(super) const fn next(e: Edge) -> Edge {
    if e % 3 == 2 { e - 2 } else { e + 1 }
}

/// The edge before `e` in its triangle.
#[inline(always)]
pub(super) const fn prev(e: Edge) -> Edge {
    if e.is_multiple_of(3) { e + 2 } else { e - 1 }
}

impl<'a> Patch<'a> {
    /// A patch of the facets from number 0 on.
    pub(super) const fn new(apexes: &'a mut [VertexId], twins: &'a mut [FacetId<2>]) -> Self {
        Self { apexes, twins, first: 0 }
    }

    /// The patches of the facets below and from number `at` on.
    pub(super) fn split(&mut self, at: Edge) -> (Patch<'_>, Patch<'_>) {
        let middle = self.at(at);
        let (left_apexes, right_apexes) = self.apexes.split_at_mut(middle);
        let (left_twins, right_twins) = self.twins.split_at_mut(middle);
        (
            Patch { apexes: left_apexes, twins: left_twins, first: self.first },
            Patch { apexes: right_apexes, twins: right_twins, first: at },
        )
    }

    /// The corners of all slots, in use or not.
    pub(super) fn triangles(&self) -> impl Iterator<Item = [Place; 3]> + '_ {
        self.apexes.as_chunks::<3>().0.iter().map(|corners| corners.map(VertexId::raw))
    }

    /// How many triangles fit.
    pub(super) const fn slots(&self) -> usize {
        self.apexes.len() / 3
    }

    #[inline(always)]
    const fn at(&self, e: Edge) -> usize {
        e.wrapping_sub(self.first) as usize
    }

    /// The vertex opposite `e`.
    #[inline(always)]
    pub(super) const fn apex(&self, e: Edge) -> Place {
        self.apexes[self.at(e)].raw()
    }

    /// The same edge seen from the other side.
    #[inline(always)]
    pub(super) const fn twin(&self, e: Edge) -> Edge {
        self.twins[self.at(e)].raw()
    }

    #[inline(always)]
    pub(super) const fn set_apex(&mut self, e: Edge, vertex: Place) {
        self.apexes[self.at(e)] = VertexId::from_raw(vertex);
    }

    /// Makes two edges twins.
    #[inline(always)]
    pub(super) const fn glue(&mut self, e: Edge, f: Edge) {
        self.twins[self.at(e)] = FacetId::from_raw(f);
        self.twins[self.at(f)] = FacetId::from_raw(e);
    }

    /// Puts a triangle into `slot`; returns its last edge, from `a` to `b`.
    #[inline(always)]
    pub(super) const fn put(&mut self, slot: u32, [a, b, c]: [Place; 3]) -> Edge {
        self.set_apex(3 * slot, a);
        self.set_apex(3 * slot + 1, b);
        self.set_apex(3 * slot + 2, c);
        3 * slot + 2
    }

    /// Where the ghost's edge starts.
    #[inline(always)]
    pub(super) const fn start(&self, ghost: Edge) -> Place {
        self.apex(ghost - 2)
    }

    /// Where the ghost's edge ends.
    #[inline(always)]
    pub(super) const fn end(&self, ghost: Edge) -> Place {
        self.apex(ghost - 1)
    }

    /// The ghost whose edge starts where this one's ends.
    #[inline(always)]
    pub(super) const fn after(&self, ghost: Edge) -> Edge {
        self.twin(ghost - 2) + 1
    }

    /// The ghost whose edge ends where this one's starts.
    #[inline(always)]
    pub(super) const fn before(&self, ghost: Edge) -> Edge {
        self.twin(ghost - 1) + 2
    }

    /// Makes `after` follow `before` round the hull.
    #[inline(always)]
    pub(super) const fn chain(&mut self, before: Edge, after: Edge) {
        self.glue(before - 2, after - 1);
    }
}
