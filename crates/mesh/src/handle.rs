//! Handles: vertices, cells and facets, four bytes each, `Option` included.

use std::fmt;
use std::num::NonZeroU32;

/// A vertex: a site, a Steiner point, or [`VertexId::GHOST`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VertexId(NonZeroU32);

/// A cell: a simplex of the mesh's dimension, solid or ghost.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CellId(NonZeroU32);

/// A facet of a cell, seen from that cell: `cell * (D + 1) + corner`, opposite the vertex at `corner`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FacetId<const D: usize>(NonZeroU32);

/// `index + 1`, which leaves zero to `Option`.
#[inline(always)]
fn raw(index: usize) -> NonZeroU32 {
    match u32::try_from(index + 1).map(NonZeroU32::new) {
        Ok(Some(raw)) => raw,
        _ => overflow(),
    }
}

#[cold]
#[inline(never)]
fn overflow() -> ! {
    panic!("a mesh holds fewer than 2^32 - 1 vertices, cells and facets each")
}

macro_rules! index {
    () => {
        /// The index, from 0.
        #[inline]
        #[must_use]
        pub const fn index(self) -> usize {
            self.0.get() as usize - 1
        }
    };
}

impl VertexId {
    /// The vertex at infinity. It sorts after all others.
    pub const GHOST: Self = Self(NonZeroU32::MAX);

    /// The vertex of this index.
    ///
    /// # Panics
    /// If the index is 2^32 - 2 or more.
    #[inline]
    #[must_use]
    pub fn new(index: usize) -> Self {
        let vertex = Self(raw(index));
        assert!(vertex != Self::GHOST, "a vertex index is below 2^32 - 2");
        vertex
    }

    index!();

    /// A place in a list by vertex in which the ghost's comes first: the index plus two, and 0.
    #[inline(always)]
    pub(crate) const fn place(self) -> usize {
        self.0.get().wrapping_add(1) as usize
    }

    /// Whether this is the vertex at infinity.
    #[inline]
    #[must_use]
    pub fn is_ghost(self) -> bool {
        self == Self::GHOST
    }
}

impl From<VertexId> for usize {
    #[inline]
    fn from(vertex: VertexId) -> Self {
        vertex.index()
    }
}

impl CellId {
    /// The cell of this index.
    #[inline]
    #[must_use]
    pub fn new(index: usize) -> Self {
        Self(raw(index))
    }

    index!();
}

impl<const D: usize> FacetId<D> {
    /// The facet of `cell` opposite its `corner`.
    #[inline]
    #[must_use]
    pub fn new(cell: CellId, corner: usize) -> Self {
        debug_assert!(corner <= D, "a cell has D + 1 corners");
        Self(raw(cell.index() * (D + 1) + corner))
    }

    index!();

    /// The facet of this index.
    #[inline]
    #[must_use]
    pub fn from_index(index: usize) -> Self {
        Self(raw(index))
    }

    /// The facet `corners` corners further on in the same cell, which must have so many.
    #[inline(always)]
    pub(crate) fn further(self, corners: u32) -> Self {
        Self(self.0.saturating_add(corners))
    }

    /// The cell it is seen from.
    #[inline]
    #[must_use]
    pub fn cell(self) -> CellId {
        CellId(raw(self.index() / (D + 1)))
    }

    /// The corner of that cell opposite the facet.
    #[inline]
    #[must_use]
    pub fn corner(self) -> usize {
        self.index() % (D + 1)
    }
}

impl fmt::Debug for VertexId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_ghost() { f.write_str("ghost") } else { write!(f, "v{}", self.index()) }
    }
}

impl fmt::Debug for CellId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "c{}", self.index())
    }
}

impl<const D: usize> fmt::Debug for FacetId<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "c{}/{}", self.cell().index(), self.corner())
    }
}
