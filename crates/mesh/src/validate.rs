//! Whether a mesh is what it says: a closed oriented pseudo-manifold, and a sphere.
//!
//! | level | proves | cost |
//! |---|---|---|
//! | [`Level::Handles`] | arrays of one length, no retired cell, distinct corners, at most one ghost a cell | O(n) |
//! | [`Level::Twins`] | and twins are mutual, over the same vertices, with opposite orientations | O(n) |
//! | [`Level::Sphere`] | and connected, each vertex with one connected star, and the Euler number of a sphere | O(n log n) |
//!
//! Geometry is not looked at: that is the judge's (`delone-check`).

use std::collections::BTreeSet;
use std::fmt;

use crate::{CellId, FacetId, Mesh, VertexId};

/// How much to prove.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Handles in range, corners distinct.
    Handles,
    /// Twins are mutual and consistent.
    Twins,
    /// The cells form a sphere.
    Sphere,
}

/// What is wrong with a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshFault {
    /// The arrays do not have one entry for each corner of each cell.
    Lengths,
    /// A retired cell was left.
    Retired(CellId),
    /// A vertex stands at two corners of a cell.
    RepeatedCorner(CellId),
    /// A vertex index is not below the number of vertices.
    VertexRange(CellId, VertexId),
    /// The twin is out of range, the facet itself, or not mutual. Cell and corner.
    Twin(CellId, usize),
    /// A facet and its twin have different vertices, or the same orientation. Cell and corner.
    TwinVertices(CellId, usize),
    /// The mesh falls into several parts.
    Disconnected,
    /// The star of a vertex falls into several parts.
    SplitStar(VertexId),
    /// The Euler number is not that of a sphere: found, expected.
    Euler(i64, i64),
}

impl fmt::Display for MeshFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lengths => write!(f, "the arrays do not have one entry for each corner"),
            Self::Retired(cell) => write!(f, "{cell:?} is retired: compact the mesh"),
            Self::RepeatedCorner(cell) => write!(f, "{cell:?} has one vertex at two corners"),
            Self::VertexRange(cell, v) => write!(f, "{cell:?} has {v:?}, which is out of range"),
            Self::Twin(cell, corner) => {
                write!(f, "the facet of {cell:?} opposite corner {corner} has no mutual twin")
            }
            Self::TwinVertices(cell, corner) => write!(
                f,
                "the facet of {cell:?} opposite corner {corner} and its twin do not match"
            ),
            Self::Disconnected => write!(f, "the mesh is not connected"),
            Self::SplitStar(v) => write!(f, "the star of {v:?} is not connected"),
            Self::Euler(found, expected) => {
                write!(f, "the Euler number is {found} and not {expected}")
            }
        }
    }
}

impl<const D: usize> Mesh<D> {
    /// All faults up to `level`, over vertices below `vertex_count`. No fault: the level is proved.
    #[must_use]
    pub fn faults(&self, level: Level, vertex_count: usize) -> Vec<MeshFault> {
        let mut faults = self.handle_faults(vertex_count);
        if level >= Level::Twins && faults.is_empty() {
            faults = self.twin_faults();
        }
        if level >= Level::Sphere && faults.is_empty() {
            faults = self.sphere_faults();
        }
        faults
    }

    pub(crate) fn handle_faults(&self, vertex_count: usize) -> Vec<MeshFault> {
        if self.vertices.len() != self.twins.len() || !self.vertices.len().is_multiple_of(D + 1) {
            return vec![MeshFault::Lengths];
        }
        let mut faults: Vec<MeshFault> =
            self.free.iter().copied().map(MeshFault::Retired).collect();
        for cell in self.cells() {
            let corners = self.corners(cell);
            if corners.iter().enumerate().any(|(i, v)| corners[..i].contains(v)) {
                faults.push(MeshFault::RepeatedCorner(cell));
            }
            let out_of_range =
                corners.iter().filter(|v| !v.is_ghost() && v.index() >= vertex_count);
            faults.extend(out_of_range.map(|&v| MeshFault::VertexRange(cell, v)));
        }
        faults
    }

    fn twin_faults(&self) -> Vec<MeshFault> {
        let mut faults = Vec::new();
        for facet in self.cells().flat_map(|cell| self.facets(cell)) {
            let (cell, corner) = (facet.cell(), facet.corner());
            let twin = self.twin(facet);
            let in_range = twin.index() < self.twins.len() && twin.corner() < self.corner_count();
            if !in_range || twin == facet || self.twin(twin) != facet {
                faults.push(MeshFault::Twin(cell, corner));
            } else if !self.matches(facet, twin) {
                faults.push(MeshFault::TwinVertices(cell, corner));
            }
        }
        faults
    }

    /// Whether two facets have the same vertices in opposite orientations: the corners of one cell, with its apex
    /// replaced by the other's, must be an odd permutation of the other's corners.
    fn matches(&self, facet: FacetId<D>, twin: FacetId<D>) -> bool {
        let mut corners = self.corners(facet.cell()).to_vec();
        corners[facet.corner()] = self.apex(twin);
        let mut swaps = 0;
        for (i, vertex) in self.corners(twin.cell()).iter().enumerate() {
            match corners[i..].iter().position(|v| v == vertex) {
                Some(0) => {}
                Some(offset) => {
                    corners.swap(i, i + offset);
                    swaps += 1;
                }
                None => return false,
            }
        }
        // At a point the two cells of a 0-sphere have no orientation to compare.
        self.dimension == Some(0) || swaps % 2 == 1
    }

    fn sphere_faults(&self) -> Vec<MeshFault> {
        let mut faults = Vec::new();
        let Some(dimension) = self.dimension else { return faults };
        let everything: Vec<CellId> = self.cells().collect();
        if !self.is_connected(&everything, None) && dimension > 0 {
            faults.push(MeshFault::Disconnected);
        }
        if dimension >= 2 {
            faults.extend(self.split_stars());
        }
        let expected = if dimension % 2 == 0 { 2 } else { 0 };
        let found = self.euler();
        if found != expected {
            faults.push(MeshFault::Euler(found, expected));
        }
        faults
    }

    /// Whether the cells are connected through facets, without leaving the set, and, if `around` is given, through
    /// facets that hold this vertex. `cells` is sorted.
    fn is_connected(&self, cells: &[CellId], around: Option<VertexId>) -> bool {
        let Some(&first) = cells.first() else { return true };
        let mut seen = vec![false; cells.len()];
        seen[0] = true;
        let mut stack = vec![first];
        let mut reached = 1;
        while let Some(cell) = stack.pop() {
            for facet in self.facets(cell).filter(|&facet| Some(self.apex(facet)) != around) {
                let next = self.twin(facet).cell();
                if let Ok(place) = cells.binary_search(&next)
                    && !seen[place]
                {
                    seen[place] = true;
                    reached += 1;
                    stack.push(next);
                }
            }
        }
        reached == cells.len()
    }

    fn split_stars(&self) -> Vec<MeshFault> {
        let mut uses: Vec<(VertexId, CellId)> = self
            .cells()
            .flat_map(|cell| self.corners(cell).iter().map(move |&vertex| (vertex, cell)))
            .collect();
        uses.sort_unstable();
        let stars = uses.chunk_by(|a, b| a.0 == b.0);
        let mut cells = Vec::new();
        stars
            .filter_map(|star| {
                cells.clear();
                cells.extend(star.iter().map(|&(_, cell)| cell));
                let vertex = star[0].0;
                (!self.is_connected(&cells, Some(vertex))).then_some(MeshFault::SplitStar(vertex))
            })
            .collect()
    }

    /// The alternating number of faces of all dimensions, the ghost's included.
    fn euler(&self) -> i64 {
        let count = self.corner_count();
        let mut sum = 0;
        for size in 1..=count {
            let mut faces = BTreeSet::new();
            let masks = (0u32..1 << count).filter(|mask| mask.count_ones() as usize == size);
            for mask in masks {
                for cell in self.cells() {
                    let corners = self.corners(cell).iter().enumerate();
                    let mut face: Vec<VertexId> =
                        corners.filter(|(i, _)| mask >> i & 1 == 1).map(|(_, &v)| v).collect();
                    face.sort_unstable();
                    faces.insert(face);
                }
            }
            let number = i64::try_from(faces.len()).expect("fewer faces than 2^63");
            sum += if size % 2 == 1 { number } else { -number };
        }
        sum
    }
}
