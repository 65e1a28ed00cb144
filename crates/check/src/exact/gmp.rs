//! The second big integers, under the feature `rug`: those of GMP.

use super::{Integer, Number, Sign};
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

    fn magnitude(&self) -> (f64, i32) {
        let dropped = self.significant_bits().saturating_sub(64);
        let kept = Self::from(self >> dropped).to_f64().abs();
        (kept, i32::try_from(dropped).unwrap_or(i32::MAX))
    }
}
