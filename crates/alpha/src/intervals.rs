//! When a simplex is singular, regular and interior: three ranks for each, and questions about one complex.
//!
//! ```text
//!          lo            mid            hi
//!  --------|--------------|--------------|--------->  rank      lo: it comes (its value)
//!  exterior    singular       regular       interior            mid: its first proper coface comes
//!                                                               hi: its last cell is there; never, on the hull
//! ```
//!
//! **Paper.** [EM94], section 4.3; there, closed balls as here.
//! **Invariants.** 1. lo <= mid <= hi; lo = mid of what is attached. 2. Of cells all three are equal: they are interior at once.
//! **Cost.** O(N), twelve bytes a simplex.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a simplex of the hull | never interior | `statuses_are_those_of_the_definition` |
//! | a vertex with edges only | regular, as its edges are cofaces; singular with CGAL, where cells alone count | `vertices_have_two_conventions` |
//! | one site | its vertex is a cell | `few_sites_have_statuses` |

use crate::bulk::narrow;
use crate::{AlphaFiltration, Cut, SimplexId};

/// What a simplex is to a complex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// It is not in.
    Exterior,
    /// It is in, and in no other simplex.
    Singular,
    /// It is a face of another, but not all of its cells are in: it bounds the shape.
    Regular,
    /// All its cells are in, and they surround it.
    Interior,
}

/// What counts as a coface of a vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum VertexConvention {
    /// Edges and all others, as in \[EM94\].
    #[default]
    Em94,
    /// Only cells, as in CGAL's plane; and no vertex is exterior.
    Cgal2,
}

/// The ranks at which a simplex changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interval {
    /// It comes.
    pub lo: u32,
    /// A proper coface comes; [`Interval::NEVER`] if there is none.
    pub mid: u32,
    /// Its last cell is there; [`Interval::NEVER`] on the hull.
    pub hi: u32,
}

impl Interval {
    /// No rank.
    pub const NEVER: u32 = u32::MAX;

    /// The status in a complex.
    #[must_use]
    pub const fn status(self, cut: Cut) -> Status {
        if !cut.holds(self.lo) {
            Status::Exterior
        } else if !cut.holds(self.mid) {
            Status::Singular
        } else if !cut.holds(self.hi) {
            Status::Regular
        } else {
            Status::Interior
        }
    }
}

impl<const D: usize> AlphaFiltration<D> {
    /// The interval of every simplex, by place.
    #[must_use]
    pub fn intervals(&self) -> Vec<Interval> {
        let (simplices, ranks) = (self.simplices(), self.ranks());
        let Some(top) = simplices.dimension() else { return Vec::new() };
        let fresh = |&lo: &u32| Interval { lo, mid: Interval::NEVER, hi: 0 };
        let mut intervals: Vec<Interval> = ranks.iter().map(fresh).collect();
        for cell in simplices.of_dimension(top) {
            let lo = ranks[cell];
            intervals[cell] = Interval { lo, mid: lo, hi: lo }; // Inv 2
        }
        for k in (1..=top).rev() {
            for (id, _, facets) in simplices.level(k) {
                let Interval { lo, hi, .. } = intervals[id];
                for &facet in facets {
                    let below = &mut intervals[facet as usize];
                    below.mid = below.mid.min(lo);
                    below.hi = below.hi.max(hi);
                }
            }
            if k == top {
                self.mark_hull(&mut intervals);
            }
        }
        debug_assert!(intervals.iter().all(|i| i.lo <= i.mid && i.mid <= i.hi), "Inv 1");
        intervals
    }

    /// Facets with one cell are on the hull, for ever.
    fn mark_hull(&self, intervals: &mut [Interval]) {
        let Some(top) = self.simplices().dimension().filter(|&top| top > 0) else { return };
        let facets = self.simplices().of_dimension(top - 1);
        for (facet, sides) in facets.zip(self.cells_beside_facets()) {
            if sides[1].is_none() {
                intervals[facet].hi = Interval::NEVER;
            }
        }
    }

    /// Of each simplex of one dimension less than the cells', the cells: one or two.
    pub(crate) fn cells_beside_facets(&self) -> Vec<[Option<u32>; 2]> {
        let simplices = self.simplices();
        let Some(top) = simplices.dimension().filter(|&top| top > 0) else { return Vec::new() };
        let facets = simplices.of_dimension(top - 1);
        let mut beside = vec![[None; 2]; facets.len()];
        for (cell, _, of_cell) in simplices.level(top) {
            for &facet in of_cell {
                let sides = &mut beside[facet as usize - facets.start];
                sides[usize::from(sides[0].is_some())] = Some(narrow(cell));
            }
        }
        beside
    }

    /// For each vertex, by place, the rank of the first cell at it.
    pub(crate) fn first_cells(&self) -> Vec<u32> {
        let simplices = self.simplices();
        let mut first = self.ranks().to_vec();
        let Some(top) = simplices.dimension() else { return first };
        for (id, _, _) in simplices.level(top).filter(|_| top > 0) {
            first[id] = self.ranks()[id];
        }
        for k in (1..=top).rev() {
            let below = simplices.of_dimension(k - 1);
            first[below].fill(Interval::NEVER);
            for (id, _, facets) in simplices.level(k) {
                for &facet in facets {
                    first[facet as usize] = first[facet as usize].min(first[id]);
                }
            }
        }
        first.truncate(simplices.of_dimension(0).len());
        first
    }

    /// The status of a simplex in a complex, by the cofaces of it. O(N) once: keep [`Self::intervals`] for many questions.
    #[must_use]
    pub fn classify(&self, cut: Cut, convention: VertexConvention) -> Vec<Status> {
        let mut intervals = self.intervals();
        if convention == VertexConvention::Cgal2 && self.simplices().dimension() > Some(0) {
            for (interval, mid) in intervals.iter_mut().zip(self.first_cells()) {
                *interval = Interval { lo: 0, mid, ..*interval };
            }
        }
        let mut statuses: Vec<Status> = intervals.iter().map(|i| i.status(cut)).collect();
        if convention == VertexConvention::Cgal2 {
            let vertices = self.simplices().of_dimension(0);
            let at_least = |status: &mut Status| *status = (*status).max(Status::Singular);
            statuses[vertices].iter_mut().for_each(at_least);
        }
        statuses
    }

    /// The simplices of a complex, by place.
    pub fn complex(&self, cut: Cut) -> impl Iterator<Item = SimplexId> + Clone + '_ {
        let places = self.ranks().iter().enumerate();
        places.filter(move |&(_, &rank)| cut.holds(rank)).map(|(id, _)| SimplexId::new(id))
    }

    /// The boundary of the shape: regular facets of cells, and with [`Mode::General`] singular simplices too.
    #[must_use]
    pub fn shape(&self, cut: Cut, mode: Mode) -> Vec<SimplexId> {
        let Some(top) = self.simplices().dimension() else { return Vec::new() };
        let facets = self.simplices().of_dimension(top.saturating_sub(1));
        let bounds = |(id, interval): (usize, &Interval)| match interval.status(cut) {
            Status::Singular => mode == Mode::General,
            Status::Regular => top > 0 && facets.contains(&id),
            Status::Exterior | Status::Interior => false,
        };
        let intervals = self.intervals();
        let ids = intervals.iter().enumerate().filter(|&found| bounds(found));
        ids.map(|(id, _)| SimplexId::new(id)).collect()
    }
}

/// What belongs to a shape besides the boundary of its cells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Singular simplices.
    #[default]
    General,
    /// Nothing.
    Regularized,
}

#[cfg(test)]
mod tests;
