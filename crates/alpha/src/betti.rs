//! Signatures: numbers that change along a filtration, at every rank at once.
//!
//! **Paper.** [DE95] for Betti numbers without matrices in the plane and in space; Euler's relation for the one between.
//! **Cost.** O(N log* N) for D <= 3; beyond, that of persistence.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | the empty complex | all numbers are zero | `betti_numbers_are_those_of_the_matrices` |
//! | four dimensions and more | from the pairs of persistence | `betti_numbers_are_those_of_the_matrices` |

use crate::bulk::narrow;
use crate::persistence::Order;
use crate::{AlphaFiltration, Cut, Persistence};

/// Numbers by dimension, for every complex of a filtration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Curves {
    width: usize,
    /// For each cut from 0 on, `width` numbers.
    numbers: Vec<u32>,
}

impl Curves {
    /// The numbers of a complex, by dimension.
    #[must_use]
    pub fn at(&self, cut: Cut) -> Vec<usize> {
        let start = cut.ranks() as usize * self.width;
        self.numbers[start..start + self.width].iter().map(|&number| number as usize).collect()
    }

    /// From what is added to a number at a rank (dimension, rank) and taken from it.
    fn sum(
        width: usize,
        ranks: usize,
        more: impl Iterator<Item = (usize, u32)>,
        less: impl Iterator<Item = (usize, u32)>,
    ) -> Self {
        let mut numbers = vec![0u32; (ranks + 1) * width];
        let place = |(k, rank): (usize, u32)| (rank as usize + 1) * width + k;
        more.for_each(|change| numbers[place(change)] = numbers[place(change)].wrapping_add(1));
        less.for_each(|change| numbers[place(change)] = numbers[place(change)].wrapping_sub(1));
        for i in width..numbers.len() {
            numbers[i] = numbers[i].wrapping_add(numbers[i - width]); // sums are not negative, terms may be
        }
        Self { width, numbers }
    }
}

impl<const D: usize> AlphaFiltration<D> {
    /// How many simplices of each dimension are in.
    #[must_use]
    pub fn simplex_curves(&self) -> Curves {
        let simplices = self.simplices();
        let width = simplices.dimension().map_or(1, |top| top + 1);
        let more =
            (0..width).flat_map(|k| simplices.of_dimension(k).map(move |id| (k, self.ranks()[id])));
        Curves::sum(width, self.rank_count(), more, std::iter::empty())
    }

    /// The Betti numbers, from dimension 0 to one less than the cells', but at least 0.
    #[must_use]
    pub fn betti_curves(&self) -> Curves {
        match self.simplices().dimension() {
            Some(3) => self.betti_in_space(),
            _ => self.betti_of(&self.persistence()),
        }
    }

    /// The Betti numbers by pairs.
    #[must_use]
    pub fn betti_of(&self, persistence: &Persistence) -> Curves {
        let width = self.simplices().dimension().unwrap_or(0).max(1);
        let births = persistence.all().map(|(k, pair)| (k, self.rank(pair.birth)));
        let deaths = persistence.all().filter_map(|(k, pair)| Some((k, self.rank(pair.death?))));
        Curves::sum(width, self.rank_count(), births, deaths)
    }

    /// Components and voids by their pairs, the number between them by Euler's relation: b1 = b0 + b2 - n0 + n1 - n2 + n3.
    fn betti_in_space(&self) -> Curves {
        let mut betti = self.betti_of(&self.ends(&Order::of(self)));
        let counts = self.simplex_curves();
        for cut in 0..=self.rank_count() {
            let euler = counts.at(Cut::new(narrow(cut)));
            let b = &mut betti.numbers[3 * cut..3 * cut + 3];
            let plus = b[0] as usize + b[2] as usize + euler[1] + euler[3];
            b[1] = narrow(plus - euler[0] - euler[2]);
        }
        betti
    }
}

#[cfg(test)]
mod tests;
