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
//! **Invariants.** 1. The marked cells are exactly the seed and those met. 2. `rim` holds the facets between a cell dug
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
    met: Pile<Met<D>>,
    rim: Pile<FacetId<D>>,
    marks: Vec<Mark>,
    ridges: Ridges<D>,
}

/// Who says which cells are dug: a function of the cell, or something that looks from cell to cell.
pub trait Digger<const D: usize> {
    /// This cell is the one at `place` among those dug.
    #[inline(always)]
    fn explore(&mut self, place: usize, cell: CellId) {
        let _ = (place, cell);
    }

    /// The cell that is met as the one of this `number` has this vertex off the facet through which it is seen.
    #[inline(always)]
    fn meet(&mut self, number: usize, apex: VertexId) {
        let _ = (number, apex);
    }

    /// Whether the cell of `beyond`, met with this `number`, is to be dug. `beyond` is the twin of the facet opposite a corner of the
    /// cell explored at a place: `(place, corner)`.
    fn digs(&mut self, number: usize, from: (usize, usize), beyond: FacetId<D>) -> bool;
}

impl<const D: usize, F: FnMut(CellId) -> bool> Digger<D> for F {
    #[inline(always)]
    fn digs(&mut self, _: usize, _: (usize, usize), beyond: FacetId<D>) -> bool {
        self(beyond.cell())
    }
}

/// A cell met.
#[derive(Clone, Copy, Debug)]
struct Met<const D: usize> {
    /// From where: the index of the facet, if the places of cells dug were their numbers.
    slot: usize,
    /// Its own side of that facet.
    beyond: FacetId<D>,
    /// Its vertex off that facet.
    apex: VertexId,
}

impl<const D: usize> Default for Met<D> {
    fn default() -> Self {
        Self { slot: 0, beyond: FacetId::from_index(0), apex: VertexId::GHOST }
    }
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

    /// Digs the cells that `digger` wants and that are connected with `seed` through such cells; `seed` is one without being
    /// asked. What was dug before is forgotten. Each cell met is asked about once.
    pub fn dig(&mut self, mesh: &Mesh<D>, seed: CellId, mut digger: impl Digger<D>) {
        self.forget(mesh.cell_count());
        self.marks[seed.index()] = DUG;
        self.cells.room(1, seed)[0] = seed;
        self.cells.keep(1);
        // The usual case apart, so that the compiler knows how many corners a cell has.
        if mesh.corner_count() == D + 1 {
            self.dig_from_seed(mesh, seed, &mut digger, D + 1);
            self.find_rim(mesh, D + 1);
        } else {
            self.dig_from_seed(mesh, seed, &mut digger, mesh.corner_count());
            self.find_rim(mesh, mesh.corner_count());
        }
    }

    /// In layers, each of those met beyond the one before. The loops are short, have no branch that the data decides, and no turn
    /// waits for the one before: a processor has many of them under way, and so waits for memory once for many cells.
    #[inline(always)]
    fn dig_from_seed(
        &mut self,
        mesh: &Mesh<D>,
        seed: CellId,
        digger: &mut impl Digger<D>,
        count: usize,
    ) {
        let Self { cells, met, marks, .. } = self;
        let marks = marks.as_mut_slice();
        let (mut explored, mut asked) = (0, 0);
        while explored < cells.len() {
            let layer = &cells.as_slice()[explored..];
            let room = met.room(layer.len() * count, Met::default());
            let mut found = 0;
            for (place, &cell) in (explored..).zip(layer) {
                for (corner, &beyond) in mesh.twins_of(cell)[..count].iter().enumerate() {
                    let mark = &mut marks[beyond.cell().index()];
                    let slot = place * (D + 1) + corner;
                    room[found] = Met { slot, beyond, apex: mesh.apex(beyond) };
                    found += usize::from(*mark == UNKNOWN);
                    *mark = (*mark).max(SPARED); // till it is dug
                }
            }
            met.keep(found);
            let news = &met.as_slice()[asked..];
            for (number, new) in (asked..).zip(news) {
                digger.meet(number, new.apex);
            }
            for (place, &cell) in (explored..).zip(layer) {
                digger.explore(place, cell);
            }
            explored = cells.len();
            let room = cells.room(news.len(), seed);
            let mut dug = 0;
            for (number, &Met { slot, beyond, .. }) in (asked..).zip(news) {
                let digs = digger.digs(number, (slot / (D + 1), slot % (D + 1)), beyond);
                marks[beyond.cell().index()] = SPARED + u8::from(digs);
                room[dug] = beyond.cell();
                dug += usize::from(digs);
            }
            cells.keep(dug);
            asked = met.len();
        }
    }

    /// Lists the facets between cells dug and others.
    #[inline(always)]
    fn find_rim(&mut self, mesh: &Mesh<D>, count: usize) {
        let Self { cells, rim, marks, .. } = self;
        let room = rim.room(cells.len() * count, FacetId::from_index(0));
        let mut found = 0;
        for &cell in cells.as_slice() {
            let first = FacetId::new(cell, 0);
            for (corner, beyond) in (0u32..).zip(&mesh.twins_of(cell)[..count]) {
                room[found] = first.further(corner);
                found += usize::from(marks[beyond.cell().index()] == SPARED); // Inv 2
            }
        }
        rim.keep(found);
    }

    /// Makes ready for another cavity, in a mesh of `count` cells.
    fn forget(&mut self, count: usize) {
        for seed in self.cells.as_slice().iter().take(1) {
            self.marks[seed.index()] = UNKNOWN;
        }
        for met in self.met.as_slice() {
            self.marks[met.beyond.cell().index()] = UNKNOWN;
        }
        self.cells.clear();
        self.met.clear();
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
        let last = if D == 3 && self.corner_count() == 4 && cavity.rim.len() <= ridges::FACETS_MAX {
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
