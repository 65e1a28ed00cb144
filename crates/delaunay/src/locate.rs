//! Location by the remembering stochastic visibility walk.
//!
//! **Paper.** \[DPT02\]. From a cell, cross any facet that has the goal strictly beyond it, the facets being tried in a
//! random order, all but the one just crossed. **In.** A Delaunay mesh of full dimension; a position `p`; a cell to start
//! from. **Out.** The solid cell whose closure holds `p`, or a ghost cell with `p` strictly beyond its facet.
//! **Cost.** O(n^(1/D)) steps on evenly spread sites from anywhere; O(1) from near by.
//! **Termination.** In a Delaunay mesh the power of `p` decreases at each step, so no cell comes twice; the bound below
//! is that of the cells there are.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | `p` on a facet's hyperplane | that facet is not crossed | `a_site_on_an_edge_is_found_from_both_sides` |

use delone_mesh::{CellId, FacetId, Mesh, VertexId};
use delone_predicates::{Kernel, Sign};
use delone_probe::{Event, Probe};

/// A small deterministic generator for the order in which a walk tries facets (xorshift, \[Mar03\]).
#[derive(Clone, Copy, Debug)]
pub struct Coin(u32);

impl Default for Coin {
    fn default() -> Self {
        Self(0x9e37_79b9)
    }
}

impl Coin {
    /// A number below `count`.
    #[inline]
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        let scaled = u64::from(self.0) * count as u64;
        (scaled >> 32) as usize
    }
}

/// Walks from `start` to a cell that holds `p`, or to a ghost that `p` is strictly beyond.
///
/// # Panics
/// If the mesh is not Delaunay and the walk turns in a circle.
pub fn walk<const D: usize>(
    mesh: &Mesh<D>,
    kernel: &impl Kernel<D>,
    start: CellId,
    p: VertexId,
    coin: &mut Coin,
    probe: &mut impl Probe,
) -> CellId {
    let mut cell = inward(mesh, start);
    let mut entered = None;
    for _ in 0..=mesh.cell_count() {
        let Some(facet) = way_out(mesh, kernel, cell, entered, p, coin, probe) else { return cell };
        probe.on(Event::WalkStep);
        let beyond = mesh.twin(facet);
        cell = beyond.cell();
        if mesh.is_ghost(cell) {
            return cell;
        }
        entered = Some(beyond.corner());
    }
    panic!("a walk in a Delaunay mesh visits no cell twice");
}

/// The solid cell at a ghost's facet, or the solid cell itself.
fn inward<const D: usize>(mesh: &Mesh<D>, cell: CellId) -> CellId {
    match mesh.corners(cell).iter().position(|vertex| vertex.is_ghost()) {
        Some(ghost) => mesh.twin(FacetId::new(cell, ghost)).cell(),
        None => cell,
    }
}

/// A facet of the solid `cell` with `p` strictly beyond it, other than the one `entered` through.
#[inline]
fn way_out<const D: usize>(
    mesh: &Mesh<D>,
    kernel: &impl Kernel<D>,
    cell: CellId,
    entered: Option<usize>,
    p: VertexId,
    coin: &mut Coin,
    probe: &mut impl Probe,
) -> Option<FacetId<D>> {
    let mut corners = [p; 16];
    let corners = &mut corners[..D + 1];
    corners.copy_from_slice(mesh.corners(cell));
    let first = coin.below(D + 1);
    for corner in (first..=D).chain(0..first).filter(|&corner| Some(corner) != entered) {
        let vertex = std::mem::replace(&mut corners[corner], p);
        probe.on(Event::Orient);
        if kernel.orient(corners) == Sign::Negative {
            return Some(FacetId::new(cell, corner));
        }
        corners[corner] = vertex;
    }
    None
}
