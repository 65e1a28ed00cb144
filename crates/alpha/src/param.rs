//! The parameter: which of a filtration's complexes is meant. Every convention has a name; there are no bare numbers.
//!
//! | name | the complex of squared radius a | used by |
//! |---|---|---|
//! | `Squared(a)` | as it says; negative with weights | CGAL, Gudhi |
//! | `Radius(r)` | r^2; below zero -r^2 | \[EM94\], MATLAB, R |
//! | `Inverse(q)` | 1/q^2; q = 0 is the whole complex | \[EKS83\] in magnitude, the Python package alphashape |
//! | `Rank(t)` | of the greatest rank r with r / (m - 1) <= t, of m values | a slider: 0 the least value, 1 everything |
//! | `Unit(t)` | (t L)^2, L the longer side of the bounding box | drawings that fill a unit square |
//! | `Index(i)` | the value of rank i | |
//! | `Critical(..)` | the first complex that has a property | MATLAB, CGAL's optimal alpha |
//!
//! **Exact.** A query is compared with values as the double that it is: r^2, 1/q^2 and (t L)^2 are quotients of numbers of any
//! length. Complexes are closed: a simplex whose value equals the query is in.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a query equal to a value | that value is in | `queries_are_closed_and_exact` |
//! | below all values | the empty complex | `queries_are_closed_and_exact` |
//! | one value, or none | every `Rank` is the whole complex | `few_values_have_a_slider` |
//! | not a number, or out of the convention's range | an error | `what_is_no_parameter_is_refused` |
//! | a property that no complex has | an error | `critical_complexes_have_their_property` |

use std::fmt;

use delone_predicates::{Dyadic, SquaredRadius};

use crate::AlphaFiltration;
use crate::bulk::narrow;

/// A parameter, by its convention. See the module's text.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum AlphaParam {
    /// The radius of the balls.
    Radius(f64),
    /// Their squared radius.
    Squared(f64),
    /// One over the radius, not negative.
    Inverse(f64),
    /// A fraction of the different values, from 0 to 1.
    Rank(f64),
    /// The radius over the longer side of the sites' bounding box.
    Unit(f64),
    /// The rank of a value.
    Index(usize),
    /// The first complex with a property.
    Critical(Critical),
}

/// A property of complexes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Critical {
    /// Every vertex is in a cell.
    AllPoints,
    /// Every vertex is in a cell, and all cells hang together across facets.
    OneRegion,
    /// At most so many components, with every vertex in.
    Components(usize),
    /// These numbers of components and of independent cycles.
    Betti(usize, usize),
}

/// Why a parameter was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ParamError {
    /// Not a number, or not in the range of its convention.
    OutOfRange(AlphaParam),
    /// No complex of the filtration has the property.
    NoSuchComplex(Critical),
}

impl fmt::Display for ParamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange(AlphaParam::Rank(t)) => {
                write!(f, "a rank of {t}: give a fraction from 0 to 1")
            }
            Self::OutOfRange(param) => {
                write!(
                    f,
                    "{param:?} is out of range: give a finite number, not negative for an inverse or a unit"
                )
            }
            Self::NoSuchComplex(critical) => {
                write!(
                    f,
                    "no complex of these sites has the property {critical:?}: look at the signature"
                )
            }
        }
    }
}

impl std::error::Error for ParamError {}

/// A complex of a filtration: the number of values, from the least on, whose simplices are in. 0 is the empty complex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Cut(u32);

impl Cut {
    /// The complex of the simplices of rank below `ranks`.
    #[must_use]
    pub const fn new(ranks: u32) -> Self {
        Self(ranks)
    }

    /// How many values are in.
    #[must_use]
    pub const fn ranks(self) -> u32 {
        self.0
    }

    /// Whether a rank is in.
    #[must_use]
    pub const fn holds(self, rank: u32) -> bool {
        rank < self.0
    }
}

impl<const D: usize> AlphaFiltration<D> {
    /// The complex that a parameter means. O(log n) exact comparisons; critical ones O(N log N).
    ///
    /// # Errors
    /// If the number is out of the range of its convention, or no complex has the property.
    pub fn cut(&self, param: AlphaParam) -> Result<Cut, ParamError> {
        let error = Err(ParamError::OutOfRange(param));
        let finite = |x: f64| x.is_finite().then(|| Dyadic::from(x));
        let one = Dyadic::from(1);
        let bound = match param {
            AlphaParam::Squared(a) => finite(a).map(|a| (a, one)),
            AlphaParam::Radius(r) => {
                let square = |x: Dyadic| if r < 0.0 { -(x.clone() * &x) } else { x.clone() * &x };
                finite(r).map(|r| (square(r), one))
            }
            AlphaParam::Inverse(q) if q >= 0.0 => finite(q).map(|q| (one, q.clone() * &q)),
            AlphaParam::Unit(t) if t >= 0.0 => finite(t).map(|t| {
                let radius = t * &self.geometry().longer_side();
                (radius.clone() * &radius, one)
            }),
            AlphaParam::Inverse(_) | AlphaParam::Unit(_) => None,
            AlphaParam::Rank(t) => {
                return if (0.0..=1.0).contains(&t) { Ok(self.fraction(t)) } else { error };
            }
            AlphaParam::Index(i) => {
                return if i < self.rank_count() { Ok(Cut(narrow(i + 1))) } else { error };
            }
            AlphaParam::Critical(critical) => return self.critical(critical),
        };
        match bound {
            None => error,
            Some((numerator, denominator)) => {
                Ok(self.up_to(&SquaredRadius::new(numerator, denominator)))
            }
        }
    }

    /// The complex of all values up to this one.
    #[must_use]
    pub fn up_to(&self, bound: &SquaredRadius) -> Cut {
        let (mut low, mut high) = (0, narrow(self.rank_count()));
        while low < high {
            let middle = low + (high - low) / 2;
            if self.value_of_rank(middle) <= *bound { low = middle + 1 } else { high = middle }
        }
        Cut(low)
    }

    /// The whole complex.
    #[must_use]
    pub fn whole(&self) -> Cut {
        Cut(narrow(self.rank_count()))
    }

    /// The greatest rank r with r / (m - 1) <= t, as doubles: each r / (m - 1) names its own rank.
    fn fraction(&self, t: f64) -> Cut {
        let Some(last) = self.rank_count().checked_sub(1) else { return Cut(0) };
        let last = narrow(last);
        let is_in = |rank: u32| rank == 0 || f64::from(rank) / f64::from(last) <= t;
        let (mut low, mut high) = (0, last);
        while low < high {
            let middle = high - (high - low) / 2;
            if is_in(middle) { low = middle } else { high = middle - 1 }
        }
        Cut(low + 1)
    }

    fn critical(&self, critical: Critical) -> Result<Cut, ParamError> {
        let whole = self.whole();
        let found = match critical {
            Critical::AllPoints => Some(self.all_points()),
            Critical::OneRegion => Some(self.all_points().max(self.one_region())),
            Critical::Components(most) => {
                let vertices = self.simplices().of_dimension(0);
                let present = vertices.map(|v| self.ranks()[v]).max().map_or(0, |rank| rank + 1);
                let betti = self.betti_curves();
                let fits = |cut: &u32| betti.at(Cut(*cut))[0] <= most;
                (present..=whole.0).find(fits).map(Cut)
            }
            Critical::Betti(b0, b1) => {
                let betti = self.betti_curves();
                let fits = |cut: &u32| {
                    let numbers = betti.at(Cut(*cut));
                    (numbers.first().copied().unwrap_or(0), numbers.get(1).copied().unwrap_or(0))
                        == (b0, b1)
                };
                (0..=whole.0).find(fits).map(Cut)
            }
        };
        found.ok_or(ParamError::NoSuchComplex(critical))
    }

    /// The first complex in which every vertex is in a cell.
    fn all_points(&self) -> Cut {
        let latest = self.first_cells().into_iter().max();
        Cut(latest.map_or(0, |rank| rank + 1))
    }

    /// The first complex whose cells, and those of all later ones, hang together across facets: the last at which two parts meet.
    fn one_region(&self) -> Cut {
        let Some(k) = self.simplices().dimension().filter(|&k| k > 0) else { return self.whole() };
        let (ranks, cells) = (self.ranks(), self.simplices().of_dimension(k));
        // Two cells meet when both are there: their facet is, then. Kruskal's algorithm.
        let mut meetings: Vec<(u32, u32, u32)> = Vec::new();
        let beside = self.cells_beside_facets();
        for sides in &beside {
            if let [Some(a), Some(b)] = *sides {
                let rank = ranks[a as usize].max(ranks[b as usize]);
                let local = |cell: u32| cell - narrow(cells.start);
                meetings.push((rank, local(a), local(b)));
            }
        }
        meetings.sort_unstable();
        let mut sets = crate::bulk::Sets::new(cells.len());
        let mut last = cells.clone().map(|cell| ranks[cell]).min().unwrap_or(0);
        for (rank, a, b) in meetings {
            let (a, b) = (sets.find(a), sets.find(b));
            if a != b {
                sets.unite(a, b);
                last = rank;
            }
        }
        Cut(last + 1)
    }
}

#[cfg(test)]
mod tests;
