//! In space: which two new cells meet across each ridge of the rim, looked up by the names of the ridge's ends.
//!
//! Each vertex of the rim gets a small number, its name. The rim's facets being oriented alike, each ridge is the directed
//! edge (x, y) of one of them and (y, x) of another: one pass writes the new facet over each directed edge into a table,
//! a second reads the partner at the reversed edge. No search, and no branch that the data decides. A rim of more
//! facets than there are names for the vertices of is left to the turns about its ridges.
//!
//! **Invariants.** 1. Between two calls no vertex has a name. 2. A rim is a sphere of triangles: F of them have F / 2 + 2 vertices.

use super::Cavity;
use crate::{CellId, FacetId, Mesh, VertexId};

/// Names are 1 to 63; 0 is no name.
const NAMES: usize = 64;

/// So many facets have no more than 63 vertices. Inv 2
pub(super) const FACETS_MAX: usize = 2 * (NAMES - 1 - 2);

/// The corners of the facet opposite each corner, turning the same way as seen from inside.
const FACETS: [[usize; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

/// Scratch space for the names and the table.
#[derive(Clone, Debug, Default)]
pub(super) struct Ridges<const D: usize> {
    /// By vertex, as [`VertexId::place`] has them.
    names: Vec<u8>,
    /// By directed edge: the new facet over it.
    table: Vec<FacetId<D>>,
    /// The new cells, one for each rim facet, as their facets opposite the apex, and the names of their other vertices.
    made: Vec<(FacetId<D>, [u8; 3])>,
}

/// The names given.
struct Names<'r> {
    names: &'r mut Vec<u8>,
    /// The places of the vertices that have one.
    named: [usize; NAMES],
    count: u8,
}

impl Names<'_> {
    /// The name of a vertex, which gets one if it has none.
    #[inline(always)]
    fn of(&mut self, vertex: VertexId) -> u8 {
        let place = vertex.place();
        if place >= self.names.len() {
            self.grow(place);
        }
        let name = &mut self.names[place];
        let is_new = *name == 0;
        *name = if is_new { self.count.wrapping_add(1) } else { *name };
        self.named[usize::from(self.count) % NAMES] = place;
        self.count = self.count.saturating_add(u8::from(is_new));
        *name
    }

    #[cold]
    #[inline(never)]
    fn grow(&mut self, place: usize) {
        self.names.resize(2 * place + 1, 0);
    }

    /// Takes all names back. Inv 1
    fn forget(self) {
        let count = usize::from(self.count);
        assert!(count < NAMES, "Inv 2: a rim is a sphere, and has so many vertices");
        for &place in &self.named[..count] {
            self.names[place] = 0;
        }
    }
}

/// The place in the table of the directed edge between two names.
#[inline(always)]
fn place(from: u8, to: u8) -> usize {
    usize::from(from) % NAMES * NAMES + usize::from(to) % NAMES
}

impl<const D: usize> Mesh<D> {
    /// The cone from `apex` over a rim of at most [`FACETS_MAX`] facets in space; one of its cells.
    pub(super) fn star_by_names(
        &mut self,
        cavity: &mut Cavity<D>,
        apex: VertexId,
    ) -> Option<CellId> {
        let Cavity { rim, ridges: Ridges { names, table, made }, .. } = cavity;
        let rim = rim.as_slice();
        self.provide(rim.len());
        let kept = self.free.len() - rim.len();
        let slots = self.free[kept..].iter().rev();
        let (vertices, twins) = (self.vertices.as_mut_slice(), self.twins.as_mut_slice());
        table.resize(NAMES * NAMES, FacetId::from_index(0));
        let table: &mut [FacetId<D>; NAMES * NAMES] =
            table.as_mut_slice().try_into().expect("it has this length");
        let mut names = Names { names, named: [0; NAMES], count: 0 };
        // Not for its own sake: who reads the outer side of all facets first waits for memory once, and not at each write below.
        let is_twin = |&inside: &FacetId<D>| twins[twins[inside.index()].index()] == inside;
        assert!(rim.iter().fold(true, |all, inside| all & is_twin(inside)), "twins are mutual");
        made.clear();
        // Numbers are written one by one: what is written in parts cannot be read at once without waiting.
        made.extend(rim.iter().zip(slots).map(|(&inside, &cell)| {
            let [i, j, k] = FACETS[inside.corner() % 4];
            let old = inside.index() - inside.corner();
            let corners: &[VertexId; 4] = vertices[old..old + 4].try_into().expect("four of them");
            let [x, y, z] = [corners[i % 4], corners[j % 4], corners[k % 4]];
            let [a, b, c] = [names.of(x), names.of(y), names.of(z)];
            let base = FacetId::new(cell, 0);
            let corners = &mut vertices[base.index()..base.index() + 4];
            corners[0] = apex;
            corners[1] = x;
            corners[2] = y;
            corners[3] = z;
            let outside = twins[inside.index()];
            twins[base.index()] = outside;
            twins[outside.index()] = base;
            table[place(b, c)] = base.further(1);
            table[place(c, a)] = base.further(2);
            table[place(a, b)] = base.further(3);
            (base, [a, b, c])
        }));
        self.free.truncate(kept);
        names.forget();
        for &(base, [a, b, c]) in &*made {
            let twins = &mut twins[base.index()..base.index() + 4];
            twins[1] = table[place(c, b)];
            twins[2] = table[place(a, c)];
            twins[3] = table[place(b, a)];
        }
        made.last().map(|&(base, _)| base.cell())
    }
}
