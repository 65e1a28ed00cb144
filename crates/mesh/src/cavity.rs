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

mod names;
mod pile;
mod ridges;

use crate::{CellId, FacetId, Mesh, VertexId};
use names::Names;
use pile::Pile;
use ridges::Ridges;

/// A set of cells to be removed, and its rim; scratch space to be used again and again.
#[derive(Clone, Debug, Default)]
pub struct Cavity<const D: usize> {
    /// Those dug, by place.
    cells: Pile<CellId>,
    /// Those met, by number, and the numbers of those dug, by place.
    met: Pile<Met<D>>,
    numbers: Pile<usize>,
    rim: Pile<Inside<D>>,
    marks: Vec<Mark>,
    /// In space: the names of vertices, and of the corners of the cells dug, by place.
    names: Names,
    called: Pile<[u8; 4]>,
    ridges: Ridges<D>,
}

/// Who says which cells are dug: a function of the cell, or something that looks from cell to cell.
///
/// In space the vertices of cells dug have names, small numbers from 1; where there are too many of them, some are called 0.
pub trait Digger<const D: usize> {
    /// The cell that is met as the one of this `number` has this vertex off the facet through which it is seen.
    #[inline(always)]
    fn meet(&mut self, number: usize, apex: VertexId) {
        let _ = (number, apex);
    }

    /// The vertex of the seed has this name.
    #[inline(always)]
    fn name(&mut self, name: u8, vertex: VertexId) {
        let _ = (name, vertex);
    }

    /// The apex of the cell met with this number has this name.
    #[inline(always)]
    fn name_met(&mut self, name: u8, number: usize) {
        let _ = (name, number);
    }

    /// The cell at this `place` among those dug has corners of these names.
    #[inline(always)]
    fn explore(&mut self, place: usize, names: [u8; 4]) {
        let _ = (place, names);
    }

    /// Whether the cell of `beyond`, met with this `number`, is to be dug. `beyond` is the twin of the facet opposite a corner of the
    /// cell dug at a place: `(place, corner)`.
    fn digs(&mut self, number: usize, from: (usize, usize), beyond: FacetId<D>) -> bool;
}

impl<const D: usize, F: FnMut(CellId) -> bool> Digger<D> for F {
    #[inline(always)]
    fn digs(&mut self, _: usize, _: (usize, usize), beyond: FacetId<D>) -> bool {
        self(beyond.cell())
    }
}

/// A cell met; the seed is the first.
#[derive(Clone, Copy, Debug)]
struct Met<const D: usize> {
    /// From where: the index of the facet, if the places of cells dug were their numbers.
    slot: usize,
    /// Its own side of that facet.
    beyond: FacetId<D>,
}

/// A facet of the rim, seen from inside.
#[derive(Clone, Copy, Debug)]
struct Inside<const D: usize> {
    facet: FacetId<D>,
    /// That of its cell.
    place: u32,
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
        let door = Met { slot: 0, beyond: FacetId::new(seed, 0) };
        self.met.push(door);
        self.marks[seed.index()] = DUG;
        self.cells.push(seed);
        self.numbers.push(0);
        // The usual case apart, so that the compiler knows how many corners a cell has.
        if mesh.corner_count() == D + 1 {
            if D == 3 {
                self.name_seed(mesh, door.beyond, &mut digger);
            }
            self.dig_from_seed(mesh, &mut digger, D + 1);
            self.find_rim(mesh, D + 1);
        } else {
            self.dig_from_seed(mesh, &mut digger, mesh.corner_count());
            self.find_rim(mesh, mesh.corner_count());
        }
    }

    /// Names the vertices of the seed but its apex, as seen through the facet.
    #[inline(always)]
    fn name_seed(&mut self, mesh: &Mesh<D>, door: FacetId<D>, digger: &mut impl Digger<D>) {
        digger.meet(0, mesh.apex(door));
        for &vertex in &mesh.corners(door.cell())[1..] {
            digger.name(self.names.give(vertex), vertex);
        }
    }

    /// In layers, each of those met beyond the one before. The loops are short, have no branch that the data decides, and no turn
    /// waits for the one before: a processor has many of them under way, and so waits for memory once for many cells.
    #[inline(always)]
    fn dig_from_seed(&mut self, mesh: &Mesh<D>, digger: &mut impl Digger<D>, count: usize) {
        let (mut explored, mut asked) = (0, self.met.len());
        while explored < self.cells.len() {
            if D == 3 && count == 4 {
                self.explore(mesh, explored, digger);
            }
            self.meet(mesh, explored, count);
            explored = self.cells.len();
            self.decide(mesh, asked, digger);
            asked = self.met.len();
        }
    }

    /// Names the apices of the cells dug from the one at place `first` on, and explores these.
    #[inline(always)]
    fn explore(&mut self, mesh: &Mesh<D>, first: usize, digger: &mut impl Digger<D>) {
        let Self { cells, met, numbers, names, called, .. } = self;
        let (numbers, met) = (&numbers.as_slice()[first..], met.as_slice());
        let room = called.room(numbers.len(), [0; 4]);
        for ((place, &number), called) in (first..).zip(numbers).zip(room) {
            let door = met[number].beyond;
            digger.name_met(names.give(mesh.apex(door)), number);
            let corners = mesh.corners_of(door.cell());
            *called = std::array::from_fn(|corner| names.of(corners[corner % (D + 1)]));
            digger.explore(place, *called);
        }
        called.keep(cells.len() - first);
    }

    /// Lists the cells met beyond those dug from the one at place `first` on.
    #[inline(always)]
    fn meet(&mut self, mesh: &Mesh<D>, first: usize, count: usize) {
        let Self { cells, met, marks, .. } = self;
        let marks = marks.as_mut_slice();
        let layer = &cells.as_slice()[first..];
        let room = met.room(layer.len() * count, Met { slot: 0, beyond: FacetId::from_index(0) });
        let mut found = 0;
        for (place, &cell) in (first..).zip(layer) {
            for (corner, &beyond) in mesh.twins_of(cell)[..count].iter().enumerate() {
                let mark = &mut marks[beyond.cell().index()];
                room[found] = Met { slot: place * (D + 1) + corner, beyond };
                found += usize::from(*mark == UNKNOWN);
                *mark = (*mark).max(SPARED); // till it is dug
            }
        }
        met.keep(found);
    }

    /// Asks about the cells met from this number on.
    #[inline(always)]
    fn decide(&mut self, mesh: &Mesh<D>, asked: usize, digger: &mut impl Digger<D>) {
        let Self { cells, met, numbers, marks, .. } = self;
        let news = &met.as_slice()[asked..];
        for (number, new) in (asked..).zip(news) {
            digger.meet(number, mesh.apex(new.beyond));
        }
        let marks = marks.as_mut_slice();
        let room = cells.room(news.len(), CellId::new(0));
        let numbers_room = &mut numbers.room(news.len(), 0)[..room.len()];
        let mut dug = 0;
        for (number, &Met { slot, beyond }) in (asked..).zip(news) {
            let digs = digger.digs(number, (slot / (D + 1), slot % (D + 1)), beyond);
            marks[beyond.cell().index()] = SPARED + u8::from(digs);
            room[dug] = beyond.cell();
            numbers_room[dug] = number;
            dug += usize::from(digs);
        }
        cells.keep(dug);
        numbers.keep(dug);
    }

    /// Lists the facets between cells dug and others.
    #[inline(always)]
    fn find_rim(&mut self, mesh: &Mesh<D>, count: usize) {
        let Self { cells, rim, marks, .. } = self;
        let filler = Inside { facet: FacetId::from_index(0), place: 0 };
        let (room, marks) = (rim.room(cells.len() * count, filler), marks.as_slice());
        let mut found = 0;
        for (place, &cell) in (0u32..).zip(cells.as_slice()) {
            let first = FacetId::new(cell, 0);
            for (corner, beyond) in (0u32..).zip(&mesh.twins_of(cell)[..count]) {
                room[found] = Inside { facet: first.further(corner), place };
                found += usize::from(marks[beyond.cell().index()] == SPARED); // Inv 2
            }
        }
        rim.keep(found);
    }

    /// Makes ready for another cavity, in a mesh of `count` cells.
    fn forget(&mut self, count: usize) {
        for met in self.met.as_slice() {
            self.marks[met.beyond.cell().index()] = UNKNOWN;
        }
        self.cells.clear();
        self.met.clear();
        self.numbers.clear();
        self.rim.clear();
        self.called.clear();
        self.names.forget();
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
    pub fn rim(&self) -> impl ExactSizeIterator<Item = FacetId<D>> + Clone {
        self.rim.as_slice().iter().map(|inside| inside.facet)
    }
}

impl<const D: usize> Mesh<D> {
    /// Replaces the cells of the cavity by the cone from `apex` over its rim, and returns one of the new cells.
    ///
    /// # Panics
    /// If the rim is empty.
    pub fn star(&mut self, cavity: &mut Cavity<D>, apex: VertexId) -> CellId {
        let last = if D == 3 && self.corner_count() == 4 && cavity.names.suffice() {
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
        for inside in cavity.rim() {
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
        for inside in cavity.rim() {
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
