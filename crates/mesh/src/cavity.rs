//! Dig and star: a connected set of cells is removed, and the hole filled with the cone from one vertex.
//!
//! ```text
//!        b-----c            b-----c       Rim facets keep their order of corners: the cell (a, b, x) on rim
//!       / \   / \          / \ . / \      facet ab gives the new cell (a, b, p), with p where x was, so
//!      a---x-/---d   ->   a---p-/---d     that its outer facet keeps its orientation. Two new cells meet in
//!       \   / \ /          \ / \ . /      a facet through p for each ridge of the rim. The partner across a
//!        e-----f            e-----f       ridge is found by turning about it through the old cells.
//! ```
//!
//! **Invariants.** 1. The marked cells are exactly `cells` and those spared. 2. `rim` holds the facets between a cell dug
//! and one that is not, seen from inside. **Cost.** In space O(1) for each rim facet, by the ridges' names
//! (`cavity/ridges.rs`); else O(D^2) for each, and the turns, each old facet being crossed O(D) times.

mod pile;
mod ridges;

use crate::{CellId, FacetId, Mesh, VertexId};
use pile::Pile;
use ridges::Ridges;

/// A set of cells to be removed, and its rim; scratch space to be used again and again.
#[derive(Clone, Debug, Default)]
pub struct Cavity<const D: usize> {
    cells: Pile<CellId>,
    spared: Pile<CellId>,
    rim: Pile<FacetId<D>>,
    marks: Vec<Mark>,
    ridges: Ridges<D>,
}

/// What is known of a cell: one byte each, so that the marks of many cells share a line of the cache, and numbers, so
/// that they are found without branches.
type Mark = u8;
const UNKNOWN: Mark = 0;
const SPARED: Mark = 1;
const DUG: Mark = 2;

impl<const D: usize> Cavity<D> {
    /// An empty cavity.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Digs the cells `in_conflict` that are connected with `seed` through such cells; `seed` is one without being asked.
    /// What was dug before is forgotten. Each cell met is asked about once.
    pub fn dig(
        &mut self,
        mesh: &Mesh<D>,
        seed: CellId,
        mut in_conflict: impl FnMut(CellId) -> bool,
    ) {
        self.forget(mesh.cell_count());
        self.marks[seed.index()] = DUG;
        self.cells.push_if(true, seed);
        let mut explored = 0;
        while let Some(&cell) = self.cells.as_slice().get(explored) {
            explored += 1;
            for facet in mesh.facets(cell) {
                let beyond = mesh.twin(facet).cell();
                let mut mark = self.marks[beyond.index()];
                if mark == UNKNOWN {
                    let dug = in_conflict(beyond);
                    mark = SPARED + u8::from(dug);
                    self.marks[beyond.index()] = mark;
                    self.cells.push_if(dug, beyond);
                    self.spared.push_if(!dug, beyond);
                }
                self.rim.push_if(mark == SPARED, facet); // Inv 2
            }
        }
    }

    /// Makes ready for another cavity, in a mesh of `count` cells.
    fn forget(&mut self, count: usize) {
        for pile in [&mut self.cells, &mut self.spared] {
            for cell in pile.as_slice() {
                self.marks[cell.index()] = UNKNOWN;
            }
            pile.clear();
        }
        self.rim.clear();
        if self.marks.len() < count {
            self.marks.resize(count, UNKNOWN);
        }
    }

    /// Whether the cell is in.
    #[inline]
    #[must_use]
    pub fn holds(&self, cell: CellId) -> bool {
        self.marks.get(cell.index()) == Some(&DUG)
    }

    /// The cells.
    #[must_use]
    pub fn cells(&self) -> &[CellId] {
        self.cells.as_slice()
    }

    /// The rim facets, seen from inside.
    #[must_use]
    pub fn rim(&self) -> &[FacetId<D>] {
        self.rim.as_slice()
    }
}

impl<const D: usize> Mesh<D> {
    /// Replaces the cells of the cavity by the cone from `apex` over its rim, and returns one of the new cells.
    ///
    /// # Panics
    /// If the rim is empty.
    pub fn star(&mut self, cavity: &mut Cavity<D>, apex: VertexId) -> CellId {
        let named = D == 3 && self.corner_count() == 4 && self.name_rim(cavity);
        let last = if named {
            self.star_by_names(cavity, apex)
        } else if self.corner_count() == D + 1 {
            // The usual case apart, so that the compiler knows how many corners a cell has.
            self.star_by_turns(cavity, apex, D + 1)
        } else {
            self.star_by_turns(cavity, apex, self.corner_count())
        };
        self.free.extend_from_slice(cavity.cells());
        last.expect("Inv 2: a cavity of a sphere that is not all of it has a rim")
    }

    #[inline(always)]
    fn star_by_turns(
        &mut self,
        cavity: &Cavity<D>,
        apex: VertexId,
        count: usize,
    ) -> Option<CellId> {
        let mut last = None;
        for &inside in cavity.rim() {
            let outside = self.twin(inside);
            let cell = self.claim_cell();
            let (old, slot) = (inside.cell().index() * (D + 1), cell.index() * (D + 1));
            for corner in 0..count {
                self.vertices[slot + corner] = self.vertices[old + corner];
                self.twins[slot + corner] = FacetId::new(cell, corner);
            }
            let new = FacetId::new(cell, inside.corner());
            self.vertices[new.index()] = apex;
            self.glue(new, outside);
            self.twins[inside.index()] = new; // from here on, whoever leaves through the rim finds the new cell
            last = Some(new.cell());
        }
        for &inside in cavity.rim() {
            let new = self.twins[inside.index()].cell();
            for corner in (0..count).filter(|&corner| corner != inside.corner()) {
                let facet = FacetId::new(new, corner);
                if self.twin(facet) == facet {
                    let partner = self.across_ridge(cavity, inside, corner);
                    self.glue(facet, partner);
                }
            }
        }
        last
    }

    /// The facet, of the new cell on the other side of the ridge opposite `corner` in the rim facet `inside`, that
    /// contains this ridge and the apex.
    fn across_ridge(&self, cavity: &Cavity<D>, inside: FacetId<D>, corner: usize) -> FacetId<D> {
        // The ridge is `cell` without its corners `from` and `to`; we leave through the facet opposite `to`.
        let (mut cell, mut from, mut to) = (inside.cell(), inside.corner(), corner);
        for _ in 0..=cavity.cells().len() {
            let beyond = self.twin(FacetId::new(cell, to));
            if !cavity.holds(beyond.cell()) {
                return FacetId::new(beyond.cell(), from);
            }
            let pivot = self.vertex(cell, from);
            (cell, from) = (beyond.cell(), beyond.corner());
            to = self.corner_of(cell, pivot);
        }
        panic!("Inv 2: turning about a ridge of the rim leaves the cavity")
    }
}
