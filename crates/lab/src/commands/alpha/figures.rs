//! Drawings of a whole filtration: Betti numbers as curves, persistence as bars and diagram; over radii.

use delone_alpha::{AlphaFiltration, Cut, SquaredRadius};
use delone_draw::{Class, barcode, betti_curves};

/// The square root, with the sign of the square.
pub(super) fn radius(square: &SquaredRadius) -> f64 {
    let square = square.to_f64();
    square.abs().sqrt() * if square < 0.0 { -1.0 } else { 1.0 }
}

pub(super) fn betti_numbers<const D: usize>(filtration: &AlphaFiltration<D>) -> String {
    let betti = filtration.betti_curves();
    let radii: Vec<f64> = filtration.spectrum().map(|value| radius(&value)).collect();
    let cuts = (1..).take(radii.len()).map(Cut::new);
    let numbers: Vec<Vec<usize>> = cuts.map(|cut| betti.at(cut)).collect();
    betti_curves("Betti numbers", &radii, &numbers)
}

pub(super) fn persistence<const D: usize>(filtration: &AlphaFiltration<D>) -> String {
    let value = |rank: u32| radius(&filtration.value_of_rank(rank));
    let bars = filtration.persistence().bars(filtration);
    let class = |bar: &delone_alpha::Bar| Class {
        dimension: bar.dimension,
        birth: value(bar.birth),
        death: bar.death.map(value),
    };
    barcode("Persistent homology", &bars.iter().map(class).collect::<Vec<_>>())
}
