//! Persistent homology over Z/2 of a filtration: which simplex bears a class, which one kills it.
//!
//! **Paper.** [ELZ02]; by cohomology and clearing, [SMV11] and [BKR14]; [DE95] for the two ends of the dimensions, where the
//! triangulation of a ball needs no matrix: components by union-find from the front, voids by union-find of the dual from the back.
//! **In.** A filtration. **Out.** Pairs of simplices, and those that are never killed: one vertex, as the whole complex is a ball.
//! **Invariants.** 1. A simplex is in one pair. 2. With the order of simplices fixed the pairs are unique: every algorithm gives them.
//! 3. Pairs of different ranks do not depend on the order among equal ranks.
//! **Cost.** O(N log* N) for D <= 2. In between, the worst case of the reduction is cubic; it is near linear on sites that have been seen.
//!
//! Why no library of matrix reduction: of the columns of a filtration in space nine tenths never get to a matrix, being paired by
//! the union-finds; handing all of them over costs more than what is left.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | equal values | pairs in the total order; those without length are left out of diagrams | `diagrams_do_not_depend_on_ties` |
//! | components born at once | that of the later vertex dies | `pairs_are_those_of_the_matrix` |
//! | sites in a flat | the last dimension is that of the flat | `pairs_are_those_of_the_matrix` |

use crate::bulk::{Lists, Sets, narrow};
use crate::{AlphaFiltration, SimplexId};

mod middle;

/// A class: the simplex that bears it and the one that kills it, if any does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Pair {
    /// The class appears with this simplex, of the class's dimension.
    pub birth: SimplexId,
    /// It vanishes with this one, of one dimension more.
    pub death: Option<SimplexId>,
}

/// A class that lives for a while: ranks of birth and death.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Bar {
    /// Of the class.
    pub dimension: usize,
    /// The rank at which it is there.
    pub birth: u32,
    /// The rank at which it is gone.
    pub death: Option<u32>,
}

/// The pairs of a filtration, by dimension.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Persistence {
    pairs: Vec<Vec<Pair>>,
}

impl Persistence {
    /// The pairs of a dimension, by birth's place.
    #[must_use]
    pub fn pairs(&self, dimension: usize) -> &[Pair] {
        self.pairs.get(dimension).map_or(&[], |pairs| pairs)
    }

    /// All pairs, by dimension.
    pub fn all(&self) -> impl Iterator<Item = (usize, Pair)> + Clone + '_ {
        self.pairs
            .iter()
            .enumerate()
            .flat_map(|(k, pairs)| pairs.iter().map(move |&pair| (k, pair)))
    }

    /// The bars of some length, sorted.
    #[must_use]
    pub fn bars<const D: usize>(&self, filtration: &AlphaFiltration<D>) -> Vec<Bar> {
        let bar = |(dimension, pair): (usize, Pair)| Bar {
            dimension,
            birth: filtration.rank(pair.birth),
            death: pair.death.map(|death| filtration.rank(death)),
        };
        let mut bars: Vec<Bar> =
            self.all().map(bar).filter(|bar| bar.death != Some(bar.birth)).collect();
        bars.sort_unstable();
        bars
    }
}

/// The order of a filtration, and each simplex's place in it.
pub(crate) struct Order {
    pub(crate) simplices: Vec<u32>,
    pub(crate) places: Vec<u32>,
}

impl Order {
    pub(crate) fn of<const D: usize>(filtration: &AlphaFiltration<D>) -> Self {
        let simplices = filtration.order();
        let mut places = vec![0; simplices.len()];
        for (place, &simplex) in simplices.iter().enumerate() {
            places[simplex as usize] = narrow(place);
        }
        Self { simplices, places }
    }

    /// The simplices of a range of ids, in the filtration's order.
    fn within(&self, range: &std::ops::Range<usize>) -> impl DoubleEndedIterator<Item = u32> + '_ {
        let range = range.clone();
        self.simplices.iter().copied().filter(move |&id| range.contains(&(id as usize)))
    }
}

impl<const D: usize> AlphaFiltration<D> {
    /// Persistent homology. See the module's text.
    #[must_use]
    pub fn persistence(&self) -> Persistence {
        let Some(top) = self.simplices().dimension() else {
            return Persistence { pairs: Vec::new() };
        };
        let order = Order::of(self);
        let mut pairs = self.ends(&order).pairs;
        for k in 1..top.saturating_sub(1) {
            pairs[k] = middle::pairs(self, &order, k, &pairs);
        }
        pairs.iter_mut().for_each(|of_one| of_one.sort_unstable());
        Persistence { pairs }
    }

    /// The pairs of the first and of the last dimension.
    pub(crate) fn ends(&self, order: &Order) -> Persistence {
        let top = self.simplices().dimension().unwrap_or(0);
        let mut pairs = vec![Vec::new(); top.max(1)];
        pairs[0] = self.components(order);
        if top >= 2 {
            pairs[top - 1] = self.voids(order);
        }
        Persistence { pairs }
    }

    /// Classes of dimension 0: when an edge joins two components, the one of the later vertex dies.
    fn components(&self, order: &Order) -> Vec<Pair> {
        let simplices = self.simplices();
        let vertices = simplices.of_dimension(0);
        // Vertices by order: the least of a set of places is its first vertex.
        let mut sets = Sets::new(vertices.len());
        let in_order: Vec<u32> = order.within(&vertices).collect();
        let mut local = vec![0; vertices.len()];
        for (i, &vertex) in in_order.iter().enumerate() {
            local[vertex as usize] = narrow(i);
        }
        let mut pairs = Vec::with_capacity(vertices.len());
        for edge in order.within(&simplices.of_dimension(1)) {
            let edge = SimplexId::new(edge as usize);
            let &[a, b] = simplices.facets(edge) else { panic!("an edge has two ends") };
            let (a, b) = (sets.find(local[a as usize]), sets.find(local[b as usize]));
            if a != b {
                let dies = in_order[a.max(b) as usize];
                pairs.push(Pair { birth: SimplexId::new(dies as usize), death: Some(edge) });
                sets.unite(a, b);
            }
        }
        let first = in_order.first().map(|&v| SimplexId::new(v as usize));
        pairs.extend(first.map(|birth| Pair { birth, death: None }));
        pairs
    }

    /// Classes of one dimension less than the cells', from the end: taking a facet away joins the voids on its sides. A void is
    /// known by its last cell; the outer one is later than all. Of two that join, the one of the earlier cell was born with the
    /// facet, and dies with that cell.
    fn voids(&self, order: &Order) -> Vec<Pair> {
        let simplices = self.simplices();
        let Some(top) = simplices.dimension().filter(|&top| top >= 2) else { return Vec::new() };
        let (facets, cells) = (simplices.of_dimension(top - 1), simplices.of_dimension(top));
        // Cells from the last one on, 0 being the outer void: the least of a set is its last cell.
        let from_end: Vec<u32> = order.within(&cells).rev().collect();
        let mut local = vec![0; cells.len()];
        for (i, &cell) in from_end.iter().enumerate() {
            local[cell as usize - cells.start] = narrow(i + 1);
        }
        let beside = self.cells_beside_facets();
        let side = |cell: Option<u32>| cell.map_or(0, |cell| local[cell as usize - cells.start]);
        let mut sets = Sets::new(cells.len() + 1);
        let mut pairs = Vec::new();
        for facet in order.within(&facets).rev() {
            let sides = beside[facet as usize - facets.start];
            let (a, b) = (sets.find(side(sides[0])), sets.find(side(sides[1])));
            if a != b {
                let dies = from_end[a.max(b) as usize - 1];
                let [birth, death] = [facet, dies].map(|id| SimplexId::new(id as usize));
                pairs.push(Pair { birth, death: Some(death) });
                sets.unite(a, b);
            }
        }
        pairs
    }

    /// For each simplex of dimension k, those of dimension k + 1 that have it.
    pub(crate) fn cofaces(&self, k: usize) -> (usize, Lists) {
        let range = self.simplices().of_dimension(k);
        let start = range.start;
        let pairs = self.simplices().level(k + 1).flat_map(move |(id, _, facets)| {
            facets.iter().map(move |&facet| (facet as usize - start, narrow(id)))
        });
        (start, Lists::new(range.len(), pairs))
    }
}

#[cfg(test)]
mod tests;
