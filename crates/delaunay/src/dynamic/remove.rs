//! The removal of a site: its star is replaced by cells that its neighbours make up among themselves.
//!
//! ```text
//!      b---a                    b---a         The neighbours of v, triangulated alone, and in it the cells in conflict
//!     /|\ /|                   /  . |         with v: they fill the star of v, facet for facet, and are sewn in.
//!    c-+-v |    v goes   ->   c-----|
//!     \|/ \|                   \  . |
//!      d---e                    d---e
//! ```
//!
//! **Paper.** [DT03]. **Why.** Let S be all other sites, and L some of them, the neighbours of v among them. A cell of S in
//! conflict with v has vertices in the link of v only, and is a cell of L too, being empty of fewer sites. The star of v is
//! a star among L and v as well, by the same reason, and there is only one. So the cells in conflict with v are the same
//! in S and in L: they fill the same star. Ties are no exception, since the perturbation ranks the sites of L as it does
//! those of S. A ghost is a vertex like others.
//! **Cost.** O(k log k) expected for k neighbours in the plane.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | the neighbours lie in a hyperplane, other sites do not | L takes in one site beyond a facet of the link | `a_removed_apex_leaves_its_flat_neighbours` |
//! | all other sites lie in a hyperplane | all is built anew, in its dimension | `sites_come_and_go_on_small_grids` |

use delone_mesh::{Cavity, CellId, VertexId};
use delone_predicates::Kernel;
use delone_probe::{Event, Probe};

use super::{Dynamic, State, record};
use crate::bowyer_watson;
use crate::conflict::dig_conflicts;
use crate::flat::span;
use crate::locate::walk;
use crate::result::id_of;
use crate::star::{gather_star, neighbours};

impl<const D: usize, K: Kernel<D>> Dynamic<D, K> {
    /// Takes out a site; whether it was there. What it hid comes back.
    ///
    /// # Panics
    /// If the kernel has no such vertex.
    pub fn remove(&mut self, site: u32, probe: &mut impl Probe) -> bool {
        let state = std::mem::replace(&mut self.states[site as usize], State::Absent);
        match state {
            State::Absent => return false,
            State::Hidden => return true,
            State::In(cell) => {
                if self.mesh.dimension() == Some(D) {
                    self.take_out(site, cell, probe);
                } else {
                    self.rebuild(probe);
                }
            }
        }
        if self.mesh.dimension() == Some(D) {
            for hidden in self.hidden().collect::<Vec<_>>() {
                self.place(hidden, probe);
            }
        }
        true
    }

    /// Fills the star of a site, of which `cell` is a cell.
    fn take_out(&mut self, site: u32, cell: CellId, probe: &mut impl Probe) {
        let v = VertexId::new(site as usize);
        gather_star(&self.mesh, v, cell, &mut self.cavity);
        let Some(around) = self.spanning_neighbours() else { return self.rebuild(probe) };
        let donor = bowyer_watson(&self.kernel, &around, &mut ());
        let start = CellId::new(0);
        let seed = walk(&donor, &self.kernel, start, v, &mut self.coin, probe);
        let mut graft = Cavity::new();
        dig_conflicts(&donor, &self.kernel, seed, v, &mut graft, probe);
        for cell in self.mesh.transplant(&self.cavity, &donor, &graft, |vertex| vertex) {
            probe.on(Event::CellMade);
            record(&self.mesh, &mut self.states, cell);
        }
        self.compact();
        self.hint = self.cell_of(around[0]).expect("Inv 1: a neighbour stays a vertex");
    }

    /// The neighbours of the site whose star is the cavity, and one more site if these lie in a hyperplane; `None` if all
    /// other sites do.
    pub(super) fn spanning_neighbours(&self) -> Option<Vec<u32>> {
        let mut around: Vec<u32> =
            neighbours(&self.mesh, &self.cavity).into_iter().map(id_of).collect();
        if span(&self.kernel, &around).axes.len() < D {
            // A solid facet of the link spans that hyperplane, so the apex beyond is off it.
            let beyond = self.cavity.rim().map(|facet| self.mesh.twin(facet));
            let solid = beyond.into_iter().find(|facet| !self.mesh.is_ghost(facet.cell()))?;
            around.push(id_of(self.mesh.apex(solid)));
        }
        Some(around)
    }
}
