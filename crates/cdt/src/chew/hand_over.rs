//! From rings to a mesh: a solid cell for each triangle, a ghost for each half-edge whose left is outside.

use delone_mesh::{CellId, HalfEdge, Mesh, VertexId};
use delone_predicates::{PlaneKernel, Sign};

use super::rings::{Half, Rings};

/// The mesh of the triangulation and its constrained half-edges, ranks renamed to `sorted[rank]`; `None` if there is no
/// triangle.
pub(crate) fn hand_over(
    rings: &Rings,
    kernel: &impl PlaneKernel,
    sorted: &[u32],
) -> Option<(Mesh<2>, Vec<bool>)> {
    let name = |rank: u32| VertexId::new(sorted[rank as usize] as usize);
    let mut mesh: Option<Mesh<2>> = None;
    let mut facets: Vec<Option<HalfEdge>> = vec![None; rings.len() as usize];
    let alive = (0..rings.len()).filter(|&h| !rings.is_removed(h));
    for h in alive.clone() {
        if facets[h as usize].is_none() && is_triangle(rings, kernel, h) {
            let face = [h, rings.around(h), rings.around(rings.around(h))];
            let cell = add(&mut mesh, &face.map(|g| name(rings.origin(g))));
            // The half-edge from corner i to corner i + 1 is the facet opposite corner i + 2.
            for (i, g) in face.into_iter().enumerate() {
                facets[g as usize] = Some(HalfEdge::new(cell, (i + 2) % 3));
            }
        }
    }
    mesh.as_ref()?;
    let outside: Vec<Half> = alive.clone().filter(|&h| facets[h as usize].is_none()).collect();
    for &h in &outside {
        let corners = [name(rings.origin(h)), name(rings.destination(h)), VertexId::GHOST];
        facets[h as usize] = Some(HalfEdge::new(add(&mut mesh, &corners), 2));
    }
    let mut mesh = mesh?;
    let facet = |h: Half| facets[h as usize].expect("each half-edge has a cell on its left");
    for &h in &outside {
        // The ghosts of u to v and of v to w meet in the edge from v to the ghost.
        let (here, there) = (facet(h).cell(), facet(rings.around(h)).cell());
        mesh.glue(HalfEdge::new(here, 0), HalfEdge::new(there, 1));
    }
    let mut constrained = vec![false; 3 * mesh.cell_count()];
    for h in alive {
        if h % 2 == 0 {
            mesh.glue(facet(h), facet(h ^ 1));
        }
        constrained[facet(h).index()] = rings.is_segment(h);
    }
    Some((mesh, constrained))
}

fn is_triangle(rings: &Rings, kernel: &impl PlaneKernel, h: Half) -> bool {
    let (second, third) = (rings.around(h), rings.around(rings.around(h)));
    let corners = [h, second, third].map(|g| rings.origin(g) as usize);
    rings.around(third) == h && kernel.orient(&corners) == Sign::Positive
}

/// Adds a cell; the first one makes the mesh.
fn add(mesh: &mut Option<Mesh<2>>, corners: &[VertexId; 3]) -> CellId {
    mesh.get_or_insert_with(|| Mesh::bare(2)).add_cell(corners)
}
