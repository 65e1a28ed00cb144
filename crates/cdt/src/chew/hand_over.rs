//! From rings to a mesh: a solid cell for each triangle, a ghost for each half-edge whose left is outside.

use delone_mesh::{FacetId, Mesh, VertexId};
use delone_predicates::{PlaneKernel, Sign};

use super::rings::{Half, Rings};

/// No facet yet.
const NONE: u32 = u32::MAX;

/// No facet before the triangles are there.
const OUTSIDE: u32 = u32::MAX - 1;

/// The mesh of the triangulation and its constrained half-edges, ranks renamed to `sorted[rank]`; `None` if there is no
/// triangle.
pub(crate) fn hand_over(
    rings: &Rings,
    kernel: &impl PlaneKernel,
    sorted: &[u32],
) -> Option<(Mesh<2>, Vec<bool>)> {
    let name = |rank: u32| VertexId::new(sorted[rank as usize] as usize);
    let outside = outside(rings, kernel)?;
    let mut corners: Vec<VertexId> = Vec::with_capacity(6 * sorted.len());
    // The facet of each half-edge.
    let mut facets = vec![NONE; rings.len() as usize];
    outside.iter().for_each(|&h| facets[h as usize] = OUTSIDE);
    let alive = (0..rings.len()).filter(|&h| !rings.is_removed(h));
    let count =
        |corners: &[VertexId]| u32::try_from(corners.len()).expect("facets have 32-bit ids");
    for h in alive.clone() {
        if facets[h as usize] == NONE {
            let second = rings.around(h);
            let face = [h, second, rings.around(second)];
            debug_assert_eq!(rings.around(face[2]), h, "each face but one is a triangle");
            // The half-edge from corner i to corner i + 1 is the facet opposite corner i + 2.
            let first = count(&corners);
            facets[face[0] as usize] = first + 2;
            facets[face[1] as usize] = first;
            facets[face[2] as usize] = first + 1;
            corners.extend(face.map(|g| name(rings.origin(g))));
        }
    }
    if corners.is_empty() {
        return None;
    }
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
    for h in alive.step_by(2) {
        let [f, g] = [h, h ^ 1].map(|h| facets[h as usize]);
        glue(f, g);
        if rings.is_segment(h) {
            constrained[f as usize] = true;
            constrained[g as usize] = true;
        }
    }
    let twins = twins.into_iter().map(|facet| FacetId::from_index(facet as usize)).collect();
    Some((Mesh::from_parts(2, corners, twins), constrained))
}

/// The half-edges around the outer face: all edges of the first site go to one side, and the face is on the other.
fn outside(rings: &Rings, kernel: &impl PlaneKernel) -> Option<Vec<Half>> {
    rings.start(0)?;
    let to = |h: Half| rings.destination(h) as usize;
    let is_open = |&h: &Half| kernel.orient(&[0, to(h), to(rings.next(h))]) != Sign::Positive;
    let first =
        rings.halves(0).find(is_open).expect("edges that all go to one side leave an open sector");
    let mut outside = vec![first];
    let mut h = rings.around(first);
    while h != first {
        outside.push(h);
        h = rings.around(h);
    }
    Some(outside)
}
