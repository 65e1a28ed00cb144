//! Conflict: whether a cell must go when a site comes, and the cavity of all that must.
//!
//! **Paper.** [Bow81], [Wat81], with ghost cells; the test on ghosts is the limit of the solid one as the ghost recedes.
//! **In.** A Delaunay mesh of some sites in R^D; a site `p` not in it. **Out.** Whether a cell's open circumball, after
//! perturbation, holds `p`; all such cells, and the rim between them and the rest.
//! **Invariants.** 1. The region is connected. 2. It is star-shaped around `p`. 3. Each rim facet has its cell inside.
//! **Cost.** One in_sphere for each cell of the cavity and each cell at its rim. A kernel that can look is shown each cell dug once, and
//! each vertex beyond once; tests between the two share the rest, and those that these leave open are asked the ordinary way.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | `p` cospherical with a cell | the perturbation decides; never a tie | `a_grid_has_one_triangulation` |
//! | `p` in a hull facet's hyperplane | conflict if inside the facet's own circumsphere, within the hyperplane | `a_site_on_a_hull_edge_takes_its_ghost` |
//! | `p` in a hull facet's hyperplane, outside that | that ghost does not conflict | `beyond_a_hull_facet_spares_the_ghost` |

use delone_mesh::{Cavity, CellId, Digger, FacetId, Mesh, VertexId};
use delone_predicates::{Kernel, Outlook, Side, Sight, Sign};
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
    dig_conflicts_looking(mesh, kernel, seed, p, (cavity, &mut View::default()), probe);
}

/// The same, with scratch space to be used again and again.
pub(crate) fn dig_conflicts_looking<const D: usize>(
    mesh: &Mesh<D>,
    kernel: &impl Kernel<D>,
    seed: CellId,
    p: VertexId,
    (cavity, view): (&mut Cavity<D>, &mut View),
    probe: &mut impl Probe,
) {
    cavity.dig(mesh, seed, Conflicts { mesh, kernel, p, probe, view });
    probe.on(Event::Cavity { cells: cavity.cells().len() });
}

/// So many vertices of a cavity have names, nobody among them.
const NAMES: usize = 64;

/// What a site sees: vertices of its cavity, by name, what is common to the tests about each cell of it, by place, and apices of
/// cells met, by number. Of the ghost, nothing, nor of nobody.
#[derive(Clone, Debug)]
pub(crate) struct View {
    rows: [Sight; NAMES],
    outlooks: Vec<(Outlook, [u8; 4])>,
    sights: Vec<Sight>,
}

impl Default for View {
    fn default() -> Self {
        Self { rows: [Sight::default(); NAMES], outlooks: Vec::new(), sights: Vec::new() }
    }
}

impl View {
    /// How the vertex of this name is seen.
    #[inline(always)]
    fn row(&self, name: u8) -> &Sight {
        &self.rows[usize::from(name) % NAMES]
    }

    #[inline(always)]
    fn set_row(&mut self, name: u8, sight: Sight) {
        if name > 0 {
            self.rows[usize::from(name) % NAMES] = sight;
        }
    }
}

/// Digs what is in conflict with a site, which looks about from each cell.
struct Conflicts<'a, const D: usize, K, P> {
    mesh: &'a Mesh<D>,
    kernel: &'a K,
    p: VertexId,
    probe: &'a mut P,
    view: &'a mut View,
}

impl<const D: usize, K: Kernel<D>, P: Probe> Digger<D> for Conflicts<'_, D, K, P> {
    #[inline(always)]
    fn meet(&mut self, number: usize, apex: VertexId) {
        if K::LOOKS {
            *at_place(&mut self.view.sights, number) = self.sight(apex);
        }
    }

    #[inline(always)]
    fn name(&mut self, name: u8, vertex: VertexId) {
        if K::LOOKS {
            self.view.set_row(name, self.sight(vertex));
        }
    }

    #[inline(always)]
    fn name_met(&mut self, name: u8, number: usize) {
        if K::LOOKS {
            self.view.set_row(name, self.view.sights[number]);
        }
    }

    #[inline(always)]
    fn explore(&mut self, place: usize, names: [u8; 4]) {
        if K::LOOKS {
            let View { rows, outlooks, .. } = &mut *self.view;
            let (outlook, of) = at_place(outlooks, place);
            *of = names;
            self.kernel.look(outlook, names.map(|name| &rows[usize::from(name) % NAMES]));
        }
    }

    #[inline(always)]
    fn digs(&mut self, number: usize, from: (usize, usize), beyond: FacetId<D>) -> bool {
        if K::LOOKS {
            let ((outlook, names), sight) =
                (&self.view.outlooks[from.0], &self.view.sights[number]);
            let end = self.view.row(names[(from.1 ^ 1) % 4]);
            if let Some(sign) = self.kernel.lifted_beyond(outlook, from.1, end, sight) {
                self.probe.on(Event::InSphere);
                if sign == Sign::Zero {
                    return self.is_tied_in(beyond.cell());
                }
                return sign == Sign::Positive;
            }
        }
        in_conflict(self.mesh, self.kernel, beyond.cell(), self.p, self.probe)
    }
}

/// The item at a place of a list that grows.
#[inline(always)]
fn at_place<T: Default>(items: &mut Vec<T>, place: usize) -> &mut T {
    if place >= items.len() {
        grow(items, place);
    }
    &mut items[place]
}

#[cold]
#[inline(never)]
fn grow<T: Default>(items: &mut Vec<T>, place: usize) {
    items.resize_with(2 * place + 8, T::default);
}

impl<const D: usize, K: Kernel<D>, P> Conflicts<'_, D, K, P> {
    /// How the site sees a vertex.
    #[inline(always)]
    fn sight(&self, vertex: VertexId) -> Sight {
        let mut sight = Sight::default();
        if !vertex.is_ghost() {
            self.kernel.see(&mut sight, vertex, self.p);
        }
        sight
    }

    #[cold]
    #[inline(never)]
    fn is_tied_in(&self, cell: CellId) -> bool {
        self.kernel.tied(self.mesh.corners(cell), self.p) == Side::Positive
    }
}
