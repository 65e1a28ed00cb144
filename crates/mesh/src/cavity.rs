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
//! **Invariants.** 1. The marked cells are exactly `cells`. 2. `rim` holds the facets between a marked cell and one that
//! is not, seen from inside. **Cost.** O(D^2) for each rim facet, and the turns, each old facet being crossed O(D) times.

use crate::{CellId, FacetId, Mesh, VertexId};

/// A set of cells to be removed, and its rim; scratch space to be used again and again.
#[derive(Clone, Debug, Default)]
pub struct Cavity<const D: usize> {
    cells: Vec<CellId>,
    rim: Vec<FacetId<D>>,
    explored: usize,
    marks: Vec<u32>,
    epoch: u32,
}

impl<const D: usize> Cavity<D> {
    /// An empty cavity.
    #[must_use]
    pub fn new() -> Self {
        Self { cells: Vec::new(), rim: Vec::new(), explored: 0, marks: Vec::new(), epoch: 0 }
    }

    /// Forgets the last cavity and starts one at `seed`.
    pub fn begin(&mut self, seed: CellId) {
        self.cells.clear();
        self.rim.clear();
        self.explored = 0;
        self.epoch = self.epoch.wrapping_add(1);
        if self.epoch == 0 {
            self.marks.fill(0);
            self.epoch = 1;
        }
        self.dig(seed);
    }

    /// Adds a cell.
    pub fn dig(&mut self, cell: CellId) {
        if self.marks.len() <= cell.index() {
            self.marks.resize(cell.index() + 1, 0);
        }
        self.marks[cell.index()] = self.epoch;
        self.cells.push(cell);
    }

    /// Whether the cell is in.
    #[inline]
    #[must_use]
    pub fn holds(&self, cell: CellId) -> bool {
        self.marks.get(cell.index()) == Some(&self.epoch)
    }

    /// The next cell whose facets have not been looked at.
    pub fn next_unexplored(&mut self) -> Option<CellId> {
        let cell = self.cells.get(self.explored).copied();
        self.explored += usize::from(cell.is_some());
        cell
    }

    /// Adds a facet to the rim, seen from inside.
    pub fn push_rim(&mut self, facet: FacetId<D>) {
        self.rim.push(facet);
    }

    /// The cells.
    #[must_use]
    pub fn cells(&self) -> &[CellId] {
        &self.cells
    }

    /// The rim facets, seen from inside.
    #[must_use]
    pub fn rim(&self) -> &[FacetId<D>] {
        &self.rim
    }
}

impl<const D: usize> Mesh<D> {
    /// Replaces the cells of the cavity by the cone from `apex` over its rim, and returns one of the new cells.
    ///
    /// # Panics
    /// If the rim is empty.
    pub fn star(&mut self, cavity: &Cavity<D>, apex: VertexId) -> CellId {
        // The usual case apart, so that the compiler knows how many corners a cell has.
        if self.corner_count() == D + 1 {
            self.star_of(cavity, apex, D + 1)
        } else {
            self.star_of(cavity, apex, self.corner_count())
        }
    }

    #[inline(always)]
    fn star_of(&mut self, cavity: &Cavity<D>, apex: VertexId, count: usize) -> CellId {
        let mut last = None;
        for &inside in &cavity.rim {
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
        for &inside in &cavity.rim {
            let new = self.twins[inside.index()].cell();
            for corner in (0..count).filter(|&corner| corner != inside.corner()) {
                let facet = FacetId::new(new, corner);
                if self.twin(facet) == facet {
                    let partner = self.across_ridge(cavity, inside, corner);
                    self.glue(facet, partner);
                }
            }
        }
        self.free.extend_from_slice(&cavity.cells);
        last.expect("Inv 2: a cavity of a sphere that is not all of it has a rim")
    }

    /// The facet, of the new cell on the other side of the ridge opposite `corner` in the rim facet `inside`, that
    /// contains this ridge and the apex.
    fn across_ridge(&self, cavity: &Cavity<D>, inside: FacetId<D>, corner: usize) -> FacetId<D> {
        // The ridge is `cell` without its corners `from` and `to`; we leave through the facet opposite `to`.
        let (mut cell, mut from, mut to) = (inside.cell(), inside.corner(), corner);
        for _ in 0..=cavity.cells.len() {
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
