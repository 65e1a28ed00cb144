//! In space: which two new cells meet across each ridge of the rim, looked up by the names of the ridge's ends.
//!
//! The vertices of a cavity have names. The rim's facets being oriented alike, each ridge is the directed
//! edge (x, y) of one of them and (y, x) of another: one pass writes the new facet over each directed edge into a table,
//! a second reads the partner at the reversed edge. No search, and no branch that the data decides. A cavity of more
//! vertices than there are names is left to the turns about its ridges.

use super::names::NAMES;
use super::{Cavity, Inside};
use crate::{CellId, FacetId, Mesh, VertexId};

/// The corners of the facet opposite each corner, turning the same way as seen from inside.
const FACETS: [[usize; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

/// Scratch space for the names and the table.
#[derive(Clone, Debug, Default)]
pub(super) struct Ridges<const D: usize> {
    /// By directed edge: the new facet over it.
    table: Vec<FacetId<D>>,
    /// The new cells, one for each rim facet, as their facets opposite the apex, and the names of their other vertices.
    made: Vec<(FacetId<D>, [u8; 3])>,
}

/// Where the table has the directed edge between two names.
#[inline(always)]
fn edge(from: u8, to: u8) -> usize {
    usize::from(from) % NAMES * NAMES + usize::from(to) % NAMES
}

impl<const D: usize> Mesh<D> {
    /// The cone from `apex` over the rim of a cavity in space all of whose vertices have names; one of its cells.
    pub(super) fn star_by_names(
        &mut self,
        cavity: &mut Cavity<D>,
        apex: VertexId,
    ) -> Option<CellId> {
        let Cavity { rim, called, ridges: Ridges { table, made }, .. } = cavity;
        let (rim, called) = (rim.as_slice(), called.as_slice());
        self.provide(rim.len());
        let kept = self.free.len() - rim.len();
        let slots = self.free[kept..].iter().rev();
        let (vertices, twins) = (self.vertices.as_mut_slice(), self.twins.as_mut_slice());
        table.resize(NAMES * NAMES, FacetId::from_index(0));
        let table: &mut [FacetId<D>; NAMES * NAMES] =
            table.as_mut_slice().try_into().expect("it has this length");
        // Not for its own sake: who reads the outer side of all facets first waits for memory once, and not at each write below.
        let is_twin =
            |inside: &Inside<D>| twins[twins[inside.facet.index()].index()] == inside.facet;
        assert!(rim.iter().fold(true, |all, inside| all & is_twin(inside)), "twins are mutual");
        made.clear();
        // Numbers are written one by one: what is written in parts cannot be read at once without waiting.
        made.extend(rim.iter().zip(slots).map(|(&Inside { facet: inside, place }, &cell)| {
            let [i, j, k] = FACETS[inside.corner() % 4];
            let names = called[place as usize];
            let [a, b, c] = [names[i % 4], names[j % 4], names[k % 4]];
            let old = inside.index() - inside.corner();
            let corners: &[VertexId; 4] = vertices[old..old + 4].try_into().expect("four of them");
            let [x, y, z] = [corners[i % 4], corners[j % 4], corners[k % 4]];
            let base = FacetId::new(cell, 0);
            let corners = &mut vertices[base.index()..base.index() + 4];
            corners[0] = apex;
            corners[1] = x;
            corners[2] = y;
            corners[3] = z;
            let outside = twins[inside.index()];
            twins[base.index()] = outside;
            twins[outside.index()] = base;
            table[edge(b, c)] = base.further(1);
            table[edge(c, a)] = base.further(2);
            table[edge(a, b)] = base.further(3);
            (base, [a, b, c])
        }));
        self.free.truncate(kept);
        for &(base, [a, b, c]) in &*made {
            let twins = &mut twins[base.index()..base.index() + 4];
            twins[1] = table[edge(c, b)];
            twins[2] = table[edge(a, c)];
            twins[3] = table[edge(b, a)];
        }
        made.last().map(|&(base, _)| base.cell())
    }
}
