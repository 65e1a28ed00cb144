//! Chains: integer combinations of the cells of one dimension.

use std::collections::BTreeMap;

use crate::Complex;
use crate::complex::without;

/// An integer combination of cells of one dimension, by number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chain {
    dimension: usize,
    terms: BTreeMap<usize, i64>,
}

impl Chain {
    /// The sum of these terms: a cell's number and its coefficient.
    #[must_use]
    pub fn new(dimension: usize, terms: impl IntoIterator<Item = (usize, i64)>) -> Self {
        let mut chain = Self { dimension, terms: BTreeMap::new() };
        terms.into_iter().for_each(|(cell, coefficient)| chain.add(cell, coefficient));
        chain
    }

    fn add(&mut self, cell: usize, coefficient: i64) {
        let sum = self.terms.get(&cell).copied().unwrap_or(0) + coefficient;
        if sum == 0 {
            self.terms.remove(&cell);
        } else {
            self.terms.insert(cell, sum);
        }
    }

    /// The dimension of its cells.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Its cells by number, with their coefficients, none of which is zero.
    pub fn terms(&self) -> impl Iterator<Item = (usize, i64)> + Clone + '_ {
        self.terms.iter().map(|(&cell, &coefficient)| (cell, coefficient))
    }

    /// Whether it has no terms.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The chain with its coefficients reduced to 0 and 1, by parity.
    #[must_use]
    pub fn mod_2(&self) -> Self {
        Self::new(self.dimension, self.terms().map(|(cell, c)| (cell, c.rem_euclid(2))))
    }

    /// Its boundary; that of a chain of vertices has no terms.
    ///
    /// # Panics
    /// If it names a cell that the complex does not have.
    #[must_use]
    pub fn boundary<const D: usize>(&self, complex: &Complex<D>) -> Self {
        let Some(below) = self.dimension.checked_sub(1) else { return Self::new(0, []) };
        let mut boundary = Self::new(below, []);
        for (number, coefficient) in self.terms() {
            let cell = &complex.cells(self.dimension)[number];
            for i in 0..cell.len() {
                let face = complex.find(&without(cell, i));
                let face = face.expect("a complex holds the faces of its cells");
                boundary.add(face, if i % 2 == 0 { coefficient } else { -coefficient });
            }
        }
        boundary
    }
}
