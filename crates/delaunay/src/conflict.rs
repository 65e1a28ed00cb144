//! Conflict: whether a cell must go when a site comes, and the cavity of all that must.
//!
//! **Paper.** [Bow81], [Wat81], with ghost cells; the test on ghosts is the limit of the solid one as the ghost recedes.
//! **In.** A Delaunay mesh of some sites in R^D; a site `p` not in it. **Out.** Whether a cell's open circumball, after
//! perturbation, holds `p`; all such cells, and the rim between them and the rest.
//! **Invariants.** 1. The region is connected. 2. It is star-shaped around `p`. 3. Each rim facet has its cell inside.
//! **Cost.** One in_sphere for each cell of the cavity and each cell at its rim.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | `p` cospherical with a cell | the perturbation decides; never a tie | `a_grid_has_one_triangulation` |
//! | `p` in a hull facet's hyperplane | conflict if inside the facet's own circumsphere, within the hyperplane | `a_site_on_a_hull_edge_takes_its_ghost` |
//! | `p` in a hull facet's hyperplane, outside that | that ghost does not conflict | `beyond_a_hull_facet_spares_the_ghost` |

use delone_mesh::{Cavity, CellId, Mesh, VertexId};
use delone_predicates::{Kernel, Side, Sign};
use delone_probe::{Event, Probe};

/// Whether `cell` is in conflict with `p`.
///
/// Not inlined: the answer, which nobody can predict, is to remain a value and not become a branch.
#[inline(never)]
pub fn in_conflict<const D: usize>(
    mesh: &Mesh<D>,
    kernel: &impl Kernel<D>,
    cell: CellId,
    p: VertexId,
    probe: &mut impl Probe,
) -> bool {
    let corners = &mesh.corners(cell)[..=D]; // a length that the compiler knows
    match corners.iter().position(|vertex| vertex.is_ghost()) {
        None => {
            probe.on(Event::InSphere);
            kernel.in_sphere(corners, p) == Side::Positive
        }
        Some(ghost) => ghost_in_conflict(kernel, corners, ghost, p, probe),
    }
}

/// The same for a ghost cell, whose ghost is at corner `ghost`.
fn ghost_in_conflict<const D: usize>(
    kernel: &impl Kernel<D>,
    corners: &[VertexId],
    ghost: usize,
    p: VertexId,
    probe: &mut impl Probe,
) -> bool {
    let mut replaced = [p; 16];
    let replaced = &mut replaced[..corners.len()];
    replaced.copy_from_slice(corners);
    replaced[ghost] = p;
    probe.on(Event::Orient);
    match kernel.orient(replaced) {
        Sign::Positive => true,
        Sign::Negative => false,
        Sign::Zero => {
            replaced.swap(ghost, corners.len() - 1);
            probe.on(Event::InSphere);
            kernel.in_sphere_within(&replaced[..corners.len() - 1], p) == Side::Positive
        }
    }
}

/// Digs the cavity of `p` from one cell in conflict.
pub fn dig_conflicts<const D: usize>(
    mesh: &Mesh<D>,
    kernel: &impl Kernel<D>,
    seed: CellId,
    p: VertexId,
    cavity: &mut Cavity<D>,
    probe: &mut impl Probe,
) {
    cavity.dig(mesh, seed, |cell| in_conflict(mesh, kernel, cell, p, probe));
    probe.on(Event::Cavity { cells: cavity.cells().len() });
}
