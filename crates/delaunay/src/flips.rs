//! Lawson's algorithms in the plane: any triangulation becomes Delaunay by flips; and sites come one by one, each splitting
//! the triangle it falls in.
//!
//! ```text
//!       x               x          An edge xy is illegal if the apex beyond it, u, is in conflict with its triangle.
//!      / \             /|\         Then p, x, u, y are a strictly convex quadrilateral: flip the edge, and look at
//!     p---\---u  ->   p-+-u        the edges around. Ghosts are triangles like others: to flip an edge to the
//!      \ / \ /         \|/         ghost makes a triangle on the outside, or none.
//!       y               y
//! ```
//!
//! **Paper.** [Law77]; as an incremental algorithm [GKS92]; ties after [DT11], ghosts as in `bowyer_watson.rs`.
//! **In.** [`flips`]: a kernel over distinct vertices, the order to insert them in. [`flip_to_delaunay`]: a triangulation of
//! the convex hull of its vertices. **Out.** The Delaunay mesh under the lexicographic perturbation.
//! **Invariants.** 1. A flip lowers the lifted surface (perturbed), so an edge that is flipped away never comes back.
//! 2. While a site comes, all edges are legal but perhaps those opposite it that are on the stack; so each flip gives it one
//! more neighbour.
//! **Cost.** [`flips`]: O(n log n) expected in randomized order, less than three flips expected for each site.
//! [`flip_to_delaunay`]: O(n^2) flips at worst, none if the mesh is Delaunay already. Unweighted sites only: with weights an
//! illegal edge may be reflex, and no flip helps.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | no site; all sites in line | the empty mesh, a chain | `flips_agree_on_every_subset_of_a_grid` |
//! | a site on an edge | both triangles are split | `a_site_on_an_edge_splits_two_triangles` |
//! | a site on a hull edge | the triangle and its ghost are split | `flips_agree_on_every_subset_of_a_grid` |
//! | cocircular sites | the perturbation decides | `shuffled_grids_are_flipped_back` |

use delone_mesh::{Cavity, CellId, HalfEdge, Mesh, VertexId};
use delone_predicates::{Kernel, Sign};
use delone_probe::{Event, Probe};

use crate::bowyer_watson::starting_with;
use crate::conflict::in_conflict;
use crate::flat::{chain, span};
use crate::locate::{Coin, walk};

/// The Delaunay mesh of the kernel's vertices in `order`. See the module's text.
///
/// # Panics
/// If `order` names a vertex twice, or one that the kernel does not know, or two vertices are at one position.
pub fn flips(kernel: &impl Kernel<2>, order: &[u32], probe: &mut impl Probe) -> Mesh<2> {
    if order.is_empty() {
        return Mesh::empty();
    }
    let flat = span(kernel, order);
    if flat.axes.len() < 2 {
        return chain(kernel, order);
    }
    let order = starting_with(&flat.simplex, order);
    let kernel = kernel.reordered(&order);
    let mut mesh = Mesh::simplex(&[0, 1, 2].map(VertexId::new));
    let (mut cavity, mut coin, mut stack) = (Cavity::new(), Coin::default(), Vec::new());
    let mut hint = CellId::new(0);
    for done in 3..order.len() {
        let p = VertexId::new(done);
        let cell = walk(&mesh, &kernel, hint, p, &mut coin, probe);
        hint = split(&mut mesh, &kernel, cell, p, &mut cavity, probe);
        stack.extend(mesh.ring(p, hint).map(|spoke| mesh.next(spoke)));
        legalize(&mut mesh, &kernel, p, &mut stack, probe);
        probe.on(Event::Site { done: done + 1, total: order.len() });
    }
    mesh.compact(|_, _| {});
    mesh.relabel(|vertex| VertexId::new(order[vertex.index()] as usize));
    mesh
}

/// Joins `p` to the corners of the cell it is in, or of both cells whose edge it is on; returns one of the new cells.
fn split(
    mesh: &mut Mesh<2>,
    kernel: &impl Kernel<2>,
    cell: CellId,
    p: VertexId,
    cavity: &mut Cavity<2>,
    probe: &mut impl Probe,
) -> CellId {
    let under = edge_under(mesh, kernel, cell, p, probe);
    let other = under.map(|h| mesh.twin(h).cell());
    cavity.dig(mesh, cell, |beyond| Some(beyond) == other);
    cavity.rim().for_each(|_| probe.on(Event::CellMade));
    mesh.star(cavity, p)
}

/// The edge of a solid cell that `p`, which is in the cell's closure, lies on.
fn edge_under(
    mesh: &Mesh<2>,
    kernel: &impl Kernel<2>,
    cell: CellId,
    p: VertexId,
    probe: &mut impl Probe,
) -> Option<HalfEdge> {
    if mesh.is_ghost(cell) {
        return None;
    }
    mesh.facets(cell).find(|&h| {
        probe.on(Event::Orient);
        kernel.orient(&[mesh.origin(h), mesh.destination(h), p]) == Sign::Zero
    })
}

/// Flips the edges on the stack, which are opposite `p`, and those that come to be opposite it, until all are legal.
fn legalize(
    mesh: &mut Mesh<2>,
    kernel: &impl Kernel<2>,
    p: VertexId,
    stack: &mut Vec<HalfEdge>,
    probe: &mut impl Probe,
) {
    let mut flips = 0;
    while let Some(h) = stack.pop() {
        let twin = mesh.twin(h);
        if in_conflict(mesh, kernel, twin.cell(), p, probe) {
            mesh.flip(h);
            probe.on(Event::Flip);
            stack.extend([h, mesh.prev(twin)]);
            flips += 1;
            assert!(flips <= mesh.cell_count(), "Inv 2: each flip gives the site a neighbour");
        }
    }
}

/// Flips the edges of a triangulation until it is Delaunay, under the lexicographic perturbation; returns how many flips
/// that took. A mesh of lower dimension is Delaunay already.
///
/// ```
/// use delone_delaunay::flip_to_delaunay;
/// use delone_mesh::{Mesh, VertexId};
/// use delone_predicates::Adaptive;
///
/// let kernel = Adaptive::new([[0.0, 0.0], [4.0, 1.0], [8.0, 0.0], [4.0, -1.0]]);
/// let mut mesh = Mesh::from_cells(2, &[0, 2, 1, 0, 3, 2].map(VertexId::new)).unwrap();
/// assert_eq!(flip_to_delaunay(&mut mesh, &kernel, &mut ()), 1);
/// ```
///
/// # Panics
/// If the mesh is no triangulation of the convex hull of its vertices, and the flips do not end.
pub fn flip_to_delaunay(
    mesh: &mut Mesh<2>,
    kernel: &impl Kernel<2>,
    probe: &mut impl Probe,
) -> u64 {
    if mesh.dimension() != Some(2) {
        return 0;
    }
    let edges = mesh.cells().flat_map(|cell| mesh.facets(cell));
    let mut stack: Vec<HalfEdge> = edges.filter(|&h| h < mesh.twin(h)).collect();
    let vertices = mesh.cell_count() as u64 / 2 + 2; // Euler
    let mut flips = 0;
    while let Some(h) = stack.pop() {
        let t = mesh.twin(h);
        let (cell, apex) = if mesh.apex(t).is_ghost() {
            (t.cell(), mesh.apex(h))
        } else {
            (h.cell(), mesh.apex(t))
        };
        if in_conflict(mesh, kernel, cell, apex, probe) {
            mesh.flip(h);
            probe.on(Event::Flip);
            stack.extend([h, mesh.prev(h), t, mesh.prev(t)]);
            flips += 1;
            assert!(flips <= vertices * vertices / 2, "Inv 1: no edge is flipped away twice");
        }
    }
    flips
}

#[cfg(test)]
mod tests;
