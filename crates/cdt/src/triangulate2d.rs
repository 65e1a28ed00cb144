//! The interior of a soup of boundary edges, holes unknown: `(V, EV) -> (V, [EV, FV])`.
//!
//! **Method.** The CDT of the edges, filled by a rule ([`crate::Domain`]); the triangles inside and their edges are handed back.
//! V is the caller's: no vertex is renamed, left out or added, and no index names a vertex that is not there.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | an input edge with a vertex inside | its pieces, in order | `edges_are_mapped_to_their_pieces` |
//! | equal vertices | the first one is named | `the_first_of_equal_vertices_is_named` |
//! | edges that cross | refused, all listed | `what_is_wrong_is_told` |

use std::fmt;

use delone_delaunay::Options;
use delone_mesh::{CellId, VertexId};
use delone_sites::{Noded, Pslg, PslgError};

use crate::regions::id;
use crate::{Cdt, Domain, EdgeKind, Fill, FillError, cavity};

/// The inside of a soup of edges, as a cellular complex.
#[derive(Clone, Debug, PartialEq)]
pub struct Interior {
    /// The edges of the triangles, smaller vertex first, in increasing order.
    pub ev: Vec<[u32; 2]>,
    /// The triangles, counter-clockwise, smallest vertex first, in increasing order.
    pub fv: Vec<[u32; 3]>,
    /// The region of each triangle.
    pub regions: Vec<u32>,
    /// What each edge is: `None` if the triangulation added it.
    pub kinds: Vec<Option<EdgeKind>>,
    /// For each input edge its pieces among `ev`, from its first end to its second; those outside are left out.
    pub pieces: Vec<Vec<u32>>,
    /// The whole CDT's regions, with depths, areas, and the chain that proves the fill.
    pub domain: Domain,
}

/// Why there is no interior.
#[derive(Clone, Debug, PartialEq)]
pub enum InteriorError {
    /// The edges are no planar straight-line graph.
    Pslg(PslgError),
    /// The rule has no answer.
    Fill(FillError),
}

impl fmt::Display for InteriorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pslg(error) => error.fmt(f),
            Self::Fill(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for InteriorError {}

/// Triangulates the inside of boundary edges. O(n log n), and the cavities of long edges.
///
/// ```
/// use delone_cdt::{Fill, triangulate2d};
///
/// // A square with a square hole.
/// let v = [[0., 0.], [4., 0.], [4., 4.], [0., 4.], [1., 1.], [3., 1.], [3., 3.], [1., 3.]];
/// let ev = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
/// let interior = triangulate2d(&v, &ev, &Fill::Nesting).unwrap();
/// assert_eq!((interior.ev.len(), interior.fv.len()), (16, 8));
/// assert_eq!(interior.domain.area().to_string(), "12");
/// ```
///
/// # Errors
/// If the edges cross, name vertices that are not there, or vertices are not finite; if the rule has no answer.
pub fn triangulate2d(
    v: &[[f64; 2]],
    ev: &[[usize; 2]],
    fill: &Fill,
) -> Result<Interior, InteriorError> {
    let pslg = Pslg::new(v, ev).map_err(InteriorError::Pslg)?;
    let cdt = cavity(&pslg, &Options::default(), &mut ());
    let domain = Domain::new(&cdt, &pslg, fill).map_err(InteriorError::Fill)?;
    Ok(Interior::of(&cdt, &pslg, domain))
}

impl Interior {
    /// The inside of a filled CDT.
    #[must_use]
    pub fn of(cdt: &Cdt, graph: &impl Noded, domain: Domain) -> Self {
        let names = graph.names();
        let corners = |cell: CellId| {
            let v = |corner| names[VertexId::index(cdt.mesh().vertex(cell, corner))];
            smallest_first([v(0), v(1), v(2)])
        };
        let inside = domain.cells(cdt).map(|cell| (corners(cell), domain.regions().of_cell(cell)));
        let mut inside: Vec<([u32; 3], u32)> = inside.collect();
        inside.sort_unstable();
        let (fv, regions): (Vec<[u32; 3]>, Vec<u32>) = inside.into_iter().unzip();
        let sides = fv.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let mut ev: Vec<[u32; 2]> = sides.map(ascending).collect();
        ev.sort_unstable();
        ev.dedup();
        let place = |subsegment: [u32; 2]| {
            ev.binary_search(&ascending(subsegment.map(|v| names[v as usize]))).ok()
        };
        let mut kinds = vec![None; ev.len()];
        let places: Vec<Option<usize>> = graph.subsegments().iter().map(|&s| place(s)).collect();
        for (found, &kind) in places.iter().zip(domain.kinds()) {
            if let Some(edge) = *found {
                kinds[edge] = Some(kind);
            }
        }
        let pieces = |chain: &[u32]| {
            chain.iter().filter_map(|&piece| places[piece as usize].map(id)).collect()
        };
        let pieces = graph.chains().iter().map(pieces).collect();
        Self { ev, fv, regions, kinds, pieces, domain }
    }
}

fn ascending([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

fn smallest_first([a, b, c]: [u32; 3]) -> [u32; 3] {
    if b < a && b < c {
        [b, c, a]
    } else if c < a && c < b {
        [c, a, b]
    } else {
        [a, b, c]
    }
}

#[cfg(test)]
mod tests;
