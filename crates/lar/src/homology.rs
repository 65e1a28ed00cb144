//! Betti numbers, from the ranks of the boundary operators, exactly.
//!
//! **Method.** Columns of the boundary matrix are reduced one after the other, until each has a lowest entry that no earlier
//! column has: the number of those left is the rank. Over the rationals columns stay integer: `a c - b d` takes the place of
//! a column `c` whose lowest entry `b` meets the lowest entry `a` of `d`, divided by what its entries have in common.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | no vertices | no numbers | `small_spaces_have_their_betti_numbers` |
//! | torsion | the two fields differ | `the_projective_plane_has_torsion` |

use dashu_int::ops::{Abs, Gcd};
use dashu_int::{IBig, UBig};

use crate::Complex;

/// The field over which ranks are taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Coefficients {
    /// Parity.
    Two,
    /// Fractions.
    #[default]
    Rational,
}

/// A column: its entries by row, rows in increasing order, no entry zero.
type Column = Vec<(usize, IBig)>;

impl<const D: usize> Complex<D> {
    /// The Betti numbers by dimension: pieces, tunnels or (in the plane) holes, cavities.
    #[must_use]
    pub fn betti(&self, coefficients: Coefficients) -> Vec<usize> {
        let count = self.counts().len();
        let ranks: Vec<usize> = (0..=count).map(|k| self.rank(k, coefficients)).collect();
        (0..count).map(|k| self.cells(k).len() - ranks[k] - ranks[k + 1]).collect()
    }

    /// The rank of the boundary operator of dimension `k`.
    #[must_use]
    pub fn rank(&self, k: usize, coefficients: Coefficients) -> usize {
        let operator = self.boundary(k);
        let mut by_lowest: Vec<Option<Column>> = vec![None; operator.rows()];
        let mut rank = 0;
        for entries in operator.outer_iterator() {
            let column = entries.iter().map(|(row, &entry)| (row, IBig::from(entry))).collect();
            let mut column = normal(column, coefficients);
            while let Some((lowest, _)) = column.last() {
                let slot = &mut by_lowest[*lowest];
                match slot {
                    Some(other) => column = normal(eliminated(&column, other), coefficients),
                    None => {
                        *slot = Some(column);
                        rank += 1;
                        break;
                    }
                }
            }
        }
        rank
    }
}

/// `a c - b d`, where `a` and `b` are the last entries of `d` and `c`, which are in one row.
fn eliminated(c: &Column, d: &Column) -> Column {
    let (Some((_, b)), Some((_, a))) = (c.last(), d.last()) else { return Vec::new() };
    let mut merged = Column::with_capacity(c.len() + d.len());
    let (mut c, mut d) = (c.iter().peekable(), d.iter().peekable());
    loop {
        let row = match (c.peek(), d.peek()) {
            (Some((r, _)), Some((s, _))) => *r.min(s),
            (Some((r, _)), None) => *r,
            (None, Some((s, _))) => *s,
            (None, None) => return merged,
        };
        let mut value = IBig::ZERO;
        if let Some((_, entry)) = c.next_if(|(r, _)| *r == row) {
            value += a * entry;
        }
        if let Some((_, entry)) = d.next_if(|(s, _)| *s == row) {
            value -= b * entry;
        }
        if !value.is_zero() {
            merged.push((row, value));
        }
    }
}

/// A multiple of the column with small entries: parities, or integers without a common factor.
fn normal(mut column: Column, coefficients: Coefficients) -> Column {
    match coefficients {
        Coefficients::Two => {
            column.retain(|(_, entry)| entry % 2 != 0);
            column.iter_mut().for_each(|(_, entry)| *entry = IBig::ONE);
        }
        Coefficients::Rational => {
            let unsigned = |entry: &IBig| UBig::try_from(entry.clone().abs()).unwrap_or(UBig::ONE);
            let common =
                column.iter().fold(UBig::ZERO, |common, (_, entry)| common.gcd(unsigned(entry)));
            if common > UBig::ONE {
                let common = IBig::from(common);
                column.iter_mut().for_each(|(_, entry)| *entry = &*entry / &common);
            }
        }
    }
    column
}
