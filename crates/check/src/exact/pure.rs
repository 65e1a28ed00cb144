//! The default big integers: `dashu-int`, in pure Rust.

use super::{DIGITS, Integer, Number, Sign};
use dashu_int::IBig;
use dashu_int::ops::{BitTest, UnsignedAbs};

impl Number for IBig {
    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    fn minus(&self, other: &Self) -> Self {
        self - other
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }

    fn scaled(&self, factor: u32) -> Self {
        self * Self::from(factor)
    }

    fn sign(&self) -> Option<Sign> {
        Some(self.exact_sign())
    }
}

impl Integer for IBig {
    fn shifted(mantissa: i64, shift: u32) -> Self {
        Self::from(mantissa) << shift as usize
    }

    fn exact_sign(&self) -> Sign {
        if self.is_zero() {
            Sign::Zero
        } else if *self > Self::ZERO {
            Sign::Positive
        } else {
            Sign::Negative
        }
    }

    fn magnitude(&self) -> (f64, u32) {
        let size = self.unsigned_abs();
        let dropped = size.bit_len().saturating_sub(DIGITS as usize);
        ((size >> dropped).to_f64().value(), u32::try_from(dropped).unwrap_or(u32::MAX))
    }
}
