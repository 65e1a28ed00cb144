//! Integers of 128 bits, for coordinates that provably never leave them (grids, small integers).
//!
//! Let all coordinates be less than `2^b` in absolute value, so differences are less than
//! `2^(b+1)`. The largest number in the lifted determinant of a `k`-simplex in `D` dimensions, or
//! in any partial sum of it, is less than
//!
//! ```text
//! (k+1)! * 2^(k(b+1)) * D * 2^(2(b+1)),
//! ```
//!
//! the permanent of its `k+1` rows: `k` differences and one sum of `D` squares. The orientation is
//! smaller. [`fits`] demands that this stays below `2^126`. The operations wrap, so that not even a
//! wrong proof could panic.

use super::{DIGITS, Integer, Number, Sign};

/// Whether `i128` holds every number of the predicates of `k`-simplices in `ambient` dimensions
/// with `bits`-bit coordinates.
pub(crate) fn fits(bits: u32, k: usize, ambient: usize) -> bool {
    if k == 0 || k > 8 || ambient > 8 {
        return false;
    }
    let factor: usize = (1..=k + 1).product::<usize>() * ambient;
    let rows = u32::try_from(k + 2).unwrap_or(u32::MAX);
    let factor_bits = usize::BITS - factor.leading_zeros();
    bits <= 126 && factor_bits + rows * (bits + 1) <= 126
}

impl Number for i128 {
    fn plus(&self, other: &Self) -> Self {
        self.wrapping_add(*other)
    }

    fn minus(&self, other: &Self) -> Self {
        self.wrapping_sub(*other)
    }

    fn times(&self, other: &Self) -> Self {
        self.wrapping_mul(*other)
    }

    fn scaled(&self, factor: u32) -> Self {
        self.wrapping_mul(Self::from(factor))
    }

    fn sign(&self) -> Option<Sign> {
        Some(self.exact_sign())
    }
}

impl Integer for i128 {
    fn shifted(mantissa: i64, shift: u32) -> Self {
        Self::from(mantissa).wrapping_shl(shift)
    }

    fn exact_sign(&self) -> Sign {
        match self.cmp(&0) {
            std::cmp::Ordering::Less => Sign::Negative,
            std::cmp::Ordering::Equal => Sign::Zero,
            std::cmp::Ordering::Greater => Sign::Positive,
        }
    }

    fn magnitude(&self) -> (f64, u32) {
        let size = self.unsigned_abs();
        let dropped = (Self::BITS - size.leading_zeros()).saturating_sub(DIGITS);
        ((size >> dropped) as f64, dropped)
    }
}
