//! Handles: vertices, cells and facets, four bytes each: indices as they are, for they are looked up everywhere.

use std::fmt;

/// A vertex: a site, a Steiner point, or [`VertexId::GHOST`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct VertexId(u32);

/// A cell: a simplex of the mesh's dimension, solid or ghost.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CellId(u32);

/// A facet of a cell, seen from that cell: `cell * (D + 1) + corner`, opposite the vertex at `corner`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FacetId<const D: usize>(u32);

/// The largest index but one belongs to the ghost.
#[inline(always)]
fn raw(index: usize) -> u32 {
    match u32::try_from(index) {
        Ok(raw) if raw != u32::MAX => raw,
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
        /// The handle that is stored as this number.
        #[inline]
        #[must_use]
        pub const fn from_raw(raw: u32) -> Self {
            Self(raw)
        }

        /// The number that it is stored as: the index, or 2^32 - 1 for what is none.
        #[inline]
        #[must_use]
        pub const fn raw(self) -> u32 {
            self.0
        }

        /// The index, from 0.
        #[inline]
        #[must_use]
        pub const fn index(self) -> usize {
            self.0 as usize
        }
    };
}

impl VertexId {
    /// The vertex at infinity. It sorts after all others.
    pub const GHOST: Self = Self(u32::MAX);

    /// The vertex of this index.
    ///
    /// # Panics
    /// If the index is 2^32 - 1 or more.
    #[inline]
    #[must_use]
    pub fn new(index: usize) -> Self {
        Self(raw(index))
    }

    index!();

    /// A place in a list by vertex in which the ghost's comes first: the index plus one, and 0.
    #[inline(always)]
    pub(crate) const fn place(self) -> usize {
        self.0.wrapping_add(1) as usize
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

/// Corners of a cell of D dimensions.
#[expect(clippy::cast_possible_truncation, reason = "that it does not is asserted")]
const fn corners<const D: usize>() -> u32 {
    let corners = (D + 1) as u32;
    assert!(corners as usize == D + 1, "dimensions are few");
    corners
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
        Self(self.0 + corners)
    }

    /// The cell it is seen from.
    #[inline]
    #[must_use]
    pub fn cell(self) -> CellId {
        CellId(self.0 / const { corners::<D>() })
    }

    /// The corner of that cell opposite the facet.
    #[inline]
    #[must_use]
    pub fn corner(self) -> usize {
        (self.0 % const { corners::<D>() }) as usize
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
