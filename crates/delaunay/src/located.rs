//! Where points lie in a triangulation: which vertex, face or cell has each in its relative interior.
//!
//! **Paper.** The walk of [DPT02], from point to point along Hilbert's curve. **In.** A Delaunay or regular mesh of full
//! dimension; any points. **Out.** A [`Located`] for each. **Cost.** O(1) steps for each of many evenly spread points.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a point at a site, on an edge, on a facet | that, exactly | `every_face_of_a_lattice_is_told` |
//! | a point in a hull facet's hyperplane, outside the hull | some ghost that it is strictly beyond | `every_face_of_a_lattice_is_told` |
//! | the mesh has a lower dimension | refused | `flat_meshes_are_refused` |

use std::fmt;
use std::num::NonZeroUsize;

use delone_mesh::{CellId, FacetId, Mesh, VertexId};
use delone_predicates::{Kernel, Sign};
use delone_sites::{Sites, SitesError};

use crate::locate::{Coin, walk};
use crate::queries::Queries;

/// Where a point lies. Of the cells around a vertex, a face or a facet, some one is named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Located<const D: usize> {
    /// At a vertex.
    Vertex(VertexId),
    /// In the relative interior of a face of dimension 1 to D - 2: the face of `cell` whose corners have their bit set.
    Face {
        /// A cell with the face.
        cell: CellId,
        /// Bit `i` is set if corner `i` is on the face.
        corners: u16,
    },
    /// In the relative interior of a facet: in the plane, an edge.
    Facet(FacetId<D>),
    /// Inside a solid cell.
    Cell(CellId),
    /// Outside the hull, strictly beyond the facet of this ghost cell.
    Ghost(CellId),
}

/// Why points could not be located.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum LocateError {
    /// A coordinate is not finite.
    Points(SitesError),
    /// The mesh is not of full dimension.
    Flat(Option<usize>),
}

impl fmt::Display for LocateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Points(error) => error.fmt(f),
            Self::Flat(None) => write!(f, "there are no sites: nothing can be located among them"),
            Self::Flat(Some(k)) => {
                write!(f, "the sites lie in a flat of dimension {k}: project the points onto it")
            }
        }
    }
}

impl std::error::Error for LocateError {}

/// Locates points in the mesh of `sites`, on up to `threads` threads, which make no difference to the answers.
///
/// ```
/// use std::num::NonZeroUsize;
/// use delone_delaunay::{Located, Options, delaunay, locate};
/// use delone_sites::Sites;
///
/// let sites = Sites::new(&[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]]).unwrap();
/// let triangulation = delaunay(&sites, &Options::default(), &mut ());
/// let queries = [[1.0, 1.0], [4.0, 0.0], [2.0, 2.0], [9.0, 9.0]];
/// let found = locate(triangulation.mesh(), &sites, &queries, NonZeroUsize::MIN).unwrap();
/// assert!(matches!(found[..],
///     [Located::Cell(_), Located::Vertex(_), Located::Facet(_), Located::Ghost(_)]));
/// ```
///
/// # Errors
/// If a coordinate is not finite, or the sites lie in a flat of lower dimension.
pub fn locate<const D: usize>(
    mesh: &Mesh<D>,
    sites: &Sites<D>,
    points: &[[f64; D]],
    threads: NonZeroUsize,
) -> Result<Vec<Located<D>>, LocateError> {
    if mesh.dimension() != Some(D) {
        return Err(LocateError::Flat(mesh.dimension()));
    }
    let queries = Queries::new(sites, points).map_err(LocateError::Points)?;
    Ok(queries.answer(threads, |queries, hint: &mut Hint, query| {
        hint.locate(mesh, &queries.kernel, queries.get(query).1)
    }))
}

/// Where the last walk ended.
#[derive(Default)]
pub(crate) struct Hint {
    cell: Option<CellId>,
    coin: Coin,
}

impl Hint {
    /// Locates `p` from where the last one was.
    pub(crate) fn locate<const D: usize>(
        &mut self,
        mesh: &Mesh<D>,
        kernel: &impl Kernel<D>,
        p: VertexId,
    ) -> Located<D> {
        let start = self.cell.unwrap_or_else(|| CellId::new(0));
        let cell = walk(mesh, kernel, start, p, &mut self.coin, &mut ());
        self.cell = Some(cell);
        if mesh.is_ghost(cell) { Located::Ghost(cell) } else { face_of(mesh, kernel, cell, p) }
    }
}

/// The face of the solid cell whose relative interior holds `p`, which is in the cell's closure.
fn face_of<const D: usize>(
    mesh: &Mesh<D>,
    kernel: &impl Kernel<D>,
    cell: CellId,
    p: VertexId,
) -> Located<D> {
    let mut corners = mesh.corners(cell).to_vec();
    let mut on = 0u16;
    for corner in 0..=D {
        let vertex = std::mem::replace(&mut corners[corner], p);
        on |= u16::from(kernel.orient(&corners) != Sign::Zero) << corner;
        corners[corner] = vertex;
    }
    let (first, missing) = (on.trailing_zeros() as usize, on.trailing_ones() as usize);
    match on.count_ones() as usize {
        1 => Located::Vertex(corners[first]),
        count if count == D + 1 => Located::Cell(cell),
        count if count == D => Located::Facet(FacetId::new(cell, missing)),
        _ => Located::Face { cell, corners: on },
    }
}

#[cfg(test)]
mod tests;
