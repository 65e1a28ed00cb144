//! The second big integers, under the feature `rug`: those of GMP.

use super::{DIGITS, Integer, Number, Sign};
use rug::Integer as Gmp;
use std::cmp::Ordering;

impl Number for Gmp {
    fn plus(&self, other: &Self) -> Self {
        Self::from(self + other)
    }

    fn minus(&self, other: &Self) -> Self {
        Self::from(self - other)
    }

    fn times(&self, other: &Self) -> Self {
        Self::from(self * other)
    }

    fn scaled(&self, factor: u32) -> Self {
        Self::from(self * factor)
    }

    fn sign(&self) -> Option<Sign> {
        Some(self.exact_sign())
    }
}

impl Integer for Gmp {
    fn shifted(mantissa: i64, shift: u32) -> Self {
        Self::from(mantissa) << shift
    }

    fn exact_sign(&self) -> Sign {
        match self.cmp0() {
            Ordering::Less => Sign::Negative,
            Ordering::Equal => Sign::Zero,
            Ordering::Greater => Sign::Positive,
        }
    }

    fn magnitude(&self) -> (f64, u32) {
        let dropped = self.significant_bits().saturating_sub(DIGITS);
        ((self.clone().abs() >> dropped).to_f64(), dropped)
    }
}
