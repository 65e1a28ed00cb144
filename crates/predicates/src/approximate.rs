//! Doubles with a bound of their error: the arithmetic of filters for formulas that are written over a ring.
//!
//! **The bound.** With u = 2^-53, a sum or product v of two doubles is off by at most u |v| + 2^-1075, the second term only of
//! a product that underflows. So if a and b are off by at most e and f, then a + b by e + f + u |v|, and a b by
//! |a| f + |b| e + e f + u |v| + 2^-1075. These bounds are sums of at most four products of numbers that are not negative,
//! computed in at most seven roundings: a factor of 1 + 16 u covers them and its own, and a guard of 16 * 2^-1074 covers
//! the four products and that factor's, where they underflow, and the 2^-1075.
//!
//! **Overflow.** What overflows makes the bound infinite or NaN: no sign.

use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use crate::Sign;

const U: f64 = f64::EPSILON / 2.0;
const SLACK: f64 = 1.0 + 16.0 * U;
const GUARD: f64 = f64::from_bits(16);

/// A number that is `value`, off by at most `error`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approximate {
    value: f64,
    error: f64,
}

impl Approximate {
    /// This double, exactly.
    #[inline]
    #[must_use]
    pub const fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// A number whose nearest double is this.
    #[inline]
    #[must_use]
    pub fn nearest(value: f64) -> Self {
        Self { value, error: value.abs() * (U * SLACK) + GUARD }
    }

    /// A number of which nothing is known.
    #[inline]
    #[must_use]
    pub const fn unknown(_value: f64) -> Self {
        Self { value: 0.0, error: f64::INFINITY }
    }

    /// The sign, if the bound allows only one.
    #[inline]
    #[must_use]
    pub fn sign(self) -> Option<Sign> {
        let certain = self.value.abs() > self.error || self.value == 0.0 && self.error == 0.0;
        certain.then(|| Sign::of(self.value))
    }

    /// Two doubles that the number is between; infinite or NaN where nothing is known.
    #[inline]
    pub(crate) fn bounds(self) -> [f64; 2] {
        if self.error == 0.0 {
            return [self.value; 2];
        }
        [(self.value - self.error).next_down(), (self.value + self.error).next_up()]
    }

    #[inline]
    fn rounded_sum(self, other: Self, value: f64) -> Self {
        if self.error == 0.0 && other.error == 0.0 && value == 0.0 {
            return Self::exact(value); // a difference of equal doubles
        }
        Self { value, error: (self.error + other.error + U * value.abs() + GUARD) * SLACK }
    }
}

impl Add for Approximate {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.rounded_sum(other, self.value + other.value)
    }
}

impl Sub for Approximate {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.rounded_sum(other, self.value - other.value)
    }
}

impl Neg for Approximate {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { value: -self.value, error: self.error }
    }
}

impl Mul for Approximate {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let value = a.value * b.value;
        let inherited = a.value.abs() * b.error + b.value.abs() * a.error + a.error * b.error;
        Self { value, error: (inherited + U * value.abs() + GUARD) * SLACK }
    }
}

impl Mul<&Self> for Approximate {
    type Output = Self;
    #[inline]
    fn mul(self, other: &Self) -> Self {
        self * *other
    }
}

impl AddAssign<&Self> for Approximate {
    #[inline]
    fn add_assign(&mut self, other: &Self) {
        *self = *self + *other;
    }
}

impl SubAssign<&Self> for Approximate {
    #[inline]
    fn sub_assign(&mut self, other: &Self) {
        *self = *self - *other;
    }
}

impl num_traits::Zero for Approximate {
    fn zero() -> Self {
        Self::exact(0.0)
    }
    fn is_zero(&self) -> bool {
        self.value == 0.0 && self.error == 0.0
    }
}

impl num_traits::One for Approximate {
    fn one() -> Self {
        Self::exact(1.0)
    }
    #[inline]
    fn is_one(&self) -> bool {
        self.value == 1.0 && self.error == 0.0
    }
}
