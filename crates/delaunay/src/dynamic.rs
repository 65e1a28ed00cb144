//! A Delaunay or regular triangulation to which sites come, and from which they go, in any dimension.
//!
//! **Paper.** Insertion is [Bow81]'s, removal after [DT03]; see `dynamic/remove.rs`.
//! **In.** A kernel over all vertices that may ever come; which of them come and go. **Out.** After each change the mesh of
//! the vertices present: cell for cell the one that would be built of them from scratch.
//! **Invariants.** 1. A vertex that is present has a cell, which is on record, or is hidden (weights only). 2. The mesh has no
//! retired cell between two changes.
//! **Cost.** A walk from the last change, and O(1) for each cell that goes or comes. While all sites lie in a flat of lower
//! dimension, and when that changes, everything is built anew: O(n log n) for such a change. With weights, a removal tries
//! every hidden site again.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a site off the flat of all others comes, or goes | all is built anew in the new dimension | `sites_come_and_go_on_small_grids` |
//! | a site that is present comes, an absent one goes | nothing happens | `what_is_there_does_not_come_again` |
//! | a site hides others, then goes | those come back | `hidden_sites_come_back` |

mod remove;

use delone_mesh::{Cavity, CellId, Mesh, VertexId};
use delone_predicates::Kernel;
use delone_probe::{Event, Probe};
use delone_sites::scatter;

use crate::bowyer_watson;
use crate::conflict::{dig_conflicts, in_conflict};
use crate::locate::{Coin, walk};
use crate::result::id_of;
use crate::star::gather_star;

/// A triangulation to be changed site by site. See the module's text.
///
/// ```
/// use delone_delaunay::{Dynamic, Inserted};
/// use delone_predicates::Adaptive;
///
/// let kernel = Adaptive::new([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0]]);
/// let mut triangulation = Dynamic::<2, _>::new(kernel, 4);
/// for site in 0..4 {
///     assert_eq!(triangulation.insert(site, &mut ()), Inserted::Vertex);
/// }
/// assert_eq!(triangulation.mesh().solid_cells().count(), 3);
/// assert!(triangulation.remove(3, &mut ()));
/// assert_eq!(triangulation.mesh().solid_cells().count(), 1);
/// ```
#[derive(Clone, Debug)]
pub struct Dynamic<const D: usize, K> {
    kernel: K,
    mesh: Mesh<D>,
    states: Vec<State>,
    cavity: Cavity<D>,
    coin: Coin,
    hint: CellId,
}

/// What came of an insertion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inserted {
    /// The site is a vertex.
    Vertex,
    /// The site is hidden: present, but the vertex of no cell. With weights only.
    Hidden,
    /// The site was present before.
    Present,
}

/// Where a site is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Absent,
    Hidden,
    /// A vertex of this cell, among others.
    In(CellId),
}

impl<const D: usize, K: Kernel<D>> Dynamic<D, K> {
    /// The triangulation of none of the kernel's vertices, 0 to `vertices - 1`, whose positions are distinct.
    #[must_use]
    pub fn new(kernel: K, vertices: usize) -> Self {
        Self::of(kernel, Mesh::empty(), vertices, &[])
    }

    /// The Delaunay or regular triangulation `mesh` of some of the kernel's vertices, 0 to `vertices - 1`, whose positions
    /// are distinct; `hidden` are present too. O(n).
    ///
    /// # Panics
    /// If the mesh or `hidden` names other vertices.
    #[must_use]
    pub fn of(kernel: K, mesh: Mesh<D>, vertices: usize, hidden: &[u32]) -> Self {
        let cells = mesh.cells_by_vertex(vertices).into_iter();
        let mut states: Vec<State> =
            cells.map(|cell| cell.map_or(State::Absent, State::In)).collect();
        hidden.iter().for_each(|&site| states[site as usize] = State::Hidden);
        let hint = CellId::new(0);
        Self { kernel, mesh, states, cavity: Cavity::new(), coin: Coin::default(), hint }
    }

    /// The mesh; vertex `i` is the kernel's. Vertices that are absent or hidden have no cell.
    #[must_use]
    pub const fn mesh(&self) -> &Mesh<D> {
        &self.mesh
    }

    /// The mesh, to be kept.
    #[must_use]
    pub fn into_mesh(self) -> Mesh<D> {
        self.mesh
    }

    /// The sites that are present and hidden, in increasing order.
    pub fn hidden(&self) -> impl Iterator<Item = u32> + Clone + '_ {
        let states = (0u32..).zip(&self.states);
        states.filter(|(_, state)| **state == State::Hidden).map(|(site, _)| site)
    }

    /// A cell of a vertex of the mesh; `None` if the site is absent or hidden.
    #[must_use]
    pub fn cell_of(&self, site: u32) -> Option<CellId> {
        match self.states.get(site as usize) {
            Some(&State::In(cell)) => Some(cell),
            _ => None,
        }
    }

    /// Takes in a site.
    ///
    /// # Panics
    /// If the kernel has no such vertex.
    pub fn insert(&mut self, site: u32, probe: &mut impl Probe) -> Inserted {
        if self.states[site as usize] != State::Absent {
            return Inserted::Present;
        }
        self.states[site as usize] = State::Hidden;
        if self.mesh.dimension() == Some(D) {
            self.place(site, probe);
        } else {
            self.rebuild(probe);
        }
        match self.states[site as usize] {
            State::In(_) => Inserted::Vertex,
            State::Absent | State::Hidden => Inserted::Hidden,
        }
    }

    /// Makes a hidden site a vertex, if it is one.
    fn place(&mut self, site: u32, probe: &mut impl Probe) {
        let p = VertexId::new(site as usize);
        let seed = walk(&self.mesh, &self.kernel, self.hint, p, &mut self.coin, probe);
        self.hint = seed;
        if K::HIDES && !in_conflict(&self.mesh, &self.kernel, seed, p, probe) {
            return;
        }
        dig_conflicts(&self.mesh, &self.kernel, seed, p, &mut self.cavity, probe);
        for &cell in self.cavity.cells() {
            for vertex in self.mesh.corners(cell).iter().filter(|vertex| !vertex.is_ghost()) {
                self.states[vertex.index()] = State::Hidden; // unless the rim has it, see below
            }
        }
        self.cavity.rim().for_each(|_| probe.on(Event::CellMade));
        let new = self.mesh.star(&mut self.cavity, p);
        gather_star(&self.mesh, p, new, &mut self.cavity);
        for &cell in self.cavity.cells() {
            record(&self.mesh, &mut self.states, cell);
        }
        self.compact();
        self.hint = self.cell_of(site).expect("Inv 1: the new site has a cell");
    }

    /// Builds everything anew.
    fn rebuild(&mut self, probe: &mut impl Probe) {
        let present = (0u32..).zip(&self.states).filter(|(_, state)| **state != State::Absent);
        let mut order: Vec<u32> = present.map(|(site, _)| site).collect();
        order.sort_unstable_by_key(|&site| scatter(u64::from(site)));
        self.mesh = bowyer_watson(&self.kernel, &order, probe);
        order.iter().for_each(|&site| self.states[site as usize] = State::Hidden);
        self.mesh.cells().for_each(|cell| record(&self.mesh, &mut self.states, cell));
        self.hint = CellId::new(0);
    }

    /// Closes the slots of retired cells (Inv 2).
    fn compact(&mut self) {
        let mut moved = Vec::new();
        self.mesh.compact(|_, to| moved.push(to));
        for cell in moved.into_iter().filter(|cell| cell.index() < self.mesh.cell_count()) {
            record(&self.mesh, &mut self.states, cell);
        }
    }
}

/// Puts a cell on record as one of each of its vertices.
fn record<const D: usize>(mesh: &Mesh<D>, states: &mut [State], cell: CellId) {
    for vertex in mesh.corners(cell).iter().filter(|vertex| !vertex.is_ghost()) {
        states[id_of(*vertex) as usize] = State::In(cell);
    }
}

#[cfg(test)]
mod tests;
