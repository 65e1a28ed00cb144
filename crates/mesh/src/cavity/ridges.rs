//! In space: which two new cells meet across each ridge of the rim, looked up by the names of the ridge's ends.
//!
//! Each vertex of the rim gets a small number, its name. The rim's facets being oriented alike, each ridge is the directed
//! edge (x, y) of one of them and (y, x) of another: one pass writes the new facet over each directed edge into a table,
//! a second reads the partner at the reversed edge. No search, and no branch that the data decides. A rim of more
//! vertices than there are names is left to the turns about its ridges.
//!
//! **Invariants.** 1. Between two calls no vertex has a name.

use super::Cavity;
use super::pile::Pile;
use crate::{CellId, FacetId, Mesh, VertexId};

/// Names are 1 to 63; 0 is no name.
const NAMES: u8 = 64;

/// The corners of the facet opposite each corner, turning the same way as seen from inside.
const FACETS: [[usize; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

/// A facet by its vertices, as [`FACETS`] turns it, and their names.
type Named = ([VertexId; 3], [u8; 3]);

/// Scratch space for the names and the table.
#[derive(Clone, Debug, Default)]
pub(super) struct Ridges<const D: usize> {
    /// By vertex; the ghost's comes first.
    names: Vec<u8>,
    /// The vertices that have one, as places in `names`.
    named: Pile<usize>,
    /// The next name to give, less one.
    next: u8,
    /// The rim's facets.
    facets: Vec<Named>,
    /// By directed edge: the new facet over it.
    table: Vec<FacetId<D>>,
    /// The new cells, one for each rim facet, as their facets opposite the apex.
    made: Vec<FacetId<D>>,
}

impl<const D: usize> Ridges<D> {
    /// The name of a vertex, which gets one if it has none; nonsense if there are no more.
    #[inline(always)]
    fn name(&mut self, vertex: VertexId) -> u8 {
        let place = if vertex.is_ghost() { 0 } else { vertex.index() + 1 };
        if place >= self.names.len() {
            self.grow(place);
        }
        let name = &mut self.names[place];
        let new = *name == 0;
        self.named.push_if(new, place);
        *name |= self.next.wrapping_add(1) & u8::from(new).wrapping_neg();
        self.next = self.next.wrapping_add(u8::from(new));
        *name
    }

    #[cold]
    #[inline(never)]
    fn grow(&mut self, place: usize) {
        self.names.resize(2 * place + 1, 0);
    }

    /// Takes all names back, and says whether there were enough. Inv 1
    fn forget(&mut self) -> bool {
        let enough = self.named.len() < usize::from(NAMES);
        for &place in self.named.as_slice() {
            self.names[place] = 0;
        }
        self.named.clear();
        self.next = 0;
        enough
    }
}

/// The place in the table of the directed edge between two names.
#[inline(always)]
fn place(from: u8, to: u8) -> usize {
    usize::from(from % NAMES) * usize::from(NAMES) + usize::from(to % NAMES)
}

impl<const D: usize> Mesh<D> {
    /// Names the vertices of a rim in space; false if there are too many.
    pub(super) fn name_rim(&self, cavity: &mut Cavity<D>) -> bool {
        let Cavity { rim, ridges, .. } = cavity;
        ridges.facets.clear();
        for &inside in rim.as_slice() {
            // Written out: the closures of `array::map` are not always inlined here.
            let (corners, [i, j, k]) = (self.corners(inside.cell()), FACETS[inside.corner() % 4]);
            let [x, y, z] = [corners[i], corners[j], corners[k]];
            let names = [ridges.name(x), ridges.name(y), ridges.name(z)];
            ridges.facets.push(([x, y, z], names));
        }
        ridges.forget()
    }

    /// The cone from `apex` over a rim whose vertices have been named; one of its cells.
    pub(super) fn star_by_names(
        &mut self,
        cavity: &mut Cavity<D>,
        apex: VertexId,
    ) -> Option<CellId> {
        let Cavity { rim, ridges, .. } = cavity;
        let Ridges { facets, table, made, .. } = ridges;
        table.resize(usize::from(NAMES) * usize::from(NAMES), FacetId::from_index(0));
        made.clear();
        for (&inside, &([x, y, z], [a, b, c])) in rim.as_slice().iter().zip(&*facets) {
            let base = FacetId::new(self.claim_cell(), 0);
            let slot = base.index();
            self.vertices[slot..slot + 4].copy_from_slice(&[apex, x, y, z]);
            self.glue(base, self.twin(inside));
            table[place(b, c)] = base.further(1);
            table[place(c, a)] = base.further(2);
            table[place(a, b)] = base.further(3);
            made.push(base);
        }
        for (base, &(_, [a, b, c])) in made.iter().zip(&*facets) {
            let slot = base.index() + 1;
            let partners = [table[place(c, b)], table[place(a, c)], table[place(b, a)]];
            self.twins[slot..slot + 3].copy_from_slice(&partners);
        }
        made.last().map(|base| base.cell())
    }
}
