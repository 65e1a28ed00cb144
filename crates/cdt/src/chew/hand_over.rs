//! From rings to a mesh: a solid cell for each triangle, a ghost for each half-edge whose left is outside.

use delone_mesh::{FacetId, Mesh, VertexId};
use delone_predicates::{PlaneKernel, Sign};

use super::rings::{Half, Rings};

/// No facet.
const NONE: u32 = u32::MAX;

/// The mesh of the triangulation and its constrained half-edges, ranks renamed to `sorted[rank]`; `None` if there is no
/// triangle.
pub(crate) fn hand_over(
    rings: &Rings,
    kernel: &impl PlaneKernel,
    sorted: &[u32],
) -> Option<(Mesh<2>, Vec<bool>)> {
    let name = |rank: u32| VertexId::new(sorted[rank as usize] as usize);
    let mut corners: Vec<VertexId> = Vec::with_capacity(6 * sorted.len());
    // The facet of each half-edge.
    let mut facets = vec![NONE; rings.len() as usize];
    let alive = (0..rings.len()).filter(|&h| !rings.is_removed(h));
    let count =
        |corners: &[VertexId]| u32::try_from(corners.len()).expect("facets have 32-bit ids");
    for h in alive.clone() {
        if facets[h as usize] == NONE && is_triangle(rings, kernel, h) {
            let face = [h, rings.around(h), rings.around(rings.around(h))];
            // The half-edge from corner i to corner i + 1 is the facet opposite corner i + 2.
            for (g, opposite) in face.into_iter().zip([2, 0, 1]) {
                facets[g as usize] = count(&corners) + opposite;
            }
            corners.extend(face.map(|g| name(rings.origin(g))));
        }
    }
    if corners.is_empty() {
        return None;
    }
    let outside: Vec<Half> = alive.clone().filter(|&h| facets[h as usize] == NONE).collect();
    for &h in &outside {
        facets[h as usize] = count(&corners) + 2;
        corners.extend([name(rings.origin(h)), name(rings.destination(h)), VertexId::GHOST]);
    }
    let (mut twins, mut constrained) = (vec![NONE; corners.len()], vec![false; corners.len()]);
    let mut glue = |f: u32, g: u32| {
        twins[f as usize] = g;
        twins[g as usize] = f;
    };
    for &h in &outside {
        // The ghosts of u to v and of v to w meet in the edge from v to the ghost.
        glue(facets[h as usize] - 2, facets[rings.around(h) as usize] - 1);
    }
    for h in alive {
        if h % 2 == 0 {
            glue(facets[h as usize], facets[(h ^ 1) as usize]);
        }
        constrained[facets[h as usize] as usize] = rings.is_segment(h);
    }
    let twins = twins.into_iter().map(|facet| FacetId::from_index(facet as usize)).collect();
    Some((Mesh::from_parts(2, corners, twins), constrained))
}

fn is_triangle(rings: &Rings, kernel: &impl PlaneKernel, h: Half) -> bool {
    let (second, third) = (rings.around(h), rings.around(rings.around(h)));
    let corners = [h, second, third].map(|g| rings.origin(g) as usize);
    rings.around(third) == h && kernel.orient(&corners) == Sign::Positive
}
