//! The default big integers: `dashu-int`, in pure Rust.

use super::{Integer, Number, Sign};
use dashu_int::IBig;

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
}
