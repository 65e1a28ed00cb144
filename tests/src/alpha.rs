//! Alpha filtrations of plain and weighted points alike.

use delone::alpha::AlphaFiltration;
use delone::delaunay::{Options, delaunay, regular};
use delone::sites::{Sites, WeightedSites};

/// The filtration of points, in the order of their sites, with or without weights.
#[must_use]
pub fn filtration<const D: usize>(
    points: &[[f64; D]],
    weights: Option<&[f64]>,
) -> AlphaFiltration<D> {
    match weights {
        None => {
            let sites = Sites::new(points).expect("finite");
            AlphaFiltration::of(&sites, &delaunay(&sites, &Options::default(), &mut ()))
        }
        Some(weights) => {
            let sites = WeightedSites::new(points, weights).expect("finite");
            AlphaFiltration::of_regular(&sites, &regular(&sites, &Options::default(), &mut ()))
        }
    }
}
