//! Dyadic numbers of any length: an integer times a power of two, with exact sums and products.
//!
//! The mantissa is kept odd, so a number is as long as its information: coordinates far apart in the range of doubles,
//! and all products of them, cost what they hold and not what they span. Only a sum pays for the distance of its terms.
//! Equal numbers have equal representations.

use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use smallvec::SmallVec;

use crate::Sign;
use crate::exact::align::odd;

mod limbs;
mod nearest;
#[cfg(test)]
mod tests;

pub(crate) use nearest::nearest_ratio;

/// Limbs of a magnitude on the stack; more are allocated.
const INLINE: usize = 8;

/// Magnitudes, least significant limb first.
type Limbs = SmallVec<[u64; INLINE]>;

/// `+- mantissa * 2^exponent`, exactly.
///
/// Made from doubles and integers, and from other such numbers by `+`, `-`, `*` and [`Dyadic::half`]: all exact.
///
/// ```
/// use delone_predicates::Dyadic;
/// let third = (0..100).fold(Dyadic::from(0), |sum, _| (sum + Dyadic::from(1)).half().half());
/// assert_eq!(third.to_f64(), 1.0 / 3.0); // to the nearest double, from 200 bits
/// assert_ne!(third, Dyadic::from(1.0 / 3.0));
/// ```
#[derive(Debug, PartialEq, Eq, Hash)]
pub struct Dyadic {
    /// Without zeros on top; odd; empty for zero.
    mantissa: Limbs,
    exponent: i64,
    negative: bool,
}

impl Dyadic {
    /// Zero.
    pub const ZERO: Self = Self { mantissa: SmallVec::new_const(), exponent: 0, negative: false };

    /// The sign.
    #[must_use]
    pub fn sign(&self) -> Sign {
        match (self.mantissa.is_empty(), self.negative) {
            (true, _) => Sign::Zero,
            (false, true) => Sign::Negative,
            (false, false) => Sign::Positive,
        }
    }

    /// The magnitude over `2^exponent`, odd, least significant limb first; empty for zero.
    #[must_use]
    pub fn mantissa(&self) -> &[u64] {
        &self.mantissa
    }

    /// The exponent of the mantissa's unit.
    #[must_use]
    pub fn exponent(&self) -> i64 {
        self.exponent
    }

    /// Half of this number.
    #[must_use]
    pub fn half(mut self) -> Self {
        if !self.mantissa.is_empty() {
            self.exponent -= 1;
        }
        self
    }

    /// This number times `2^exponent`.
    #[must_use]
    pub fn scaled(mut self, exponent: i64) -> Self {
        if !self.mantissa.is_empty() {
            self.exponent += exponent;
        }
        self
    }

    /// The exponent of the highest bit: this number is at least `2^e` in magnitude, and less than `2^(e + 1)`. `None` for
    /// zero.
    #[must_use]
    pub fn magnitude(&self) -> Option<i64> {
        (!self.mantissa.is_empty()).then(|| self.top())
    }

    /// The nearest double, ties to even; infinite if the magnitude rounds to 2^1024 or more.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        nearest_ratio(self, &Self::from(1))
    }

    /// From a magnitude that may be even and have zeros on top.
    fn new(mut mantissa: Limbs, exponent: i64, negative: bool) -> Self {
        match limbs::make_odd(&mut mantissa) {
            Some(zeros) => Self { mantissa, exponent: exponent + limbs::length(zeros), negative },
            None => Self::ZERO,
        }
    }

    /// From a value of 128 bits.
    #[inline]
    fn short(value: i128, exponent: i64) -> Self {
        if value == 0 {
            return Self::ZERO;
        }
        let magnitude = value.unsigned_abs();
        let zeros = magnitude.trailing_zeros();
        let exponent = exponent + i64::from(zeros);
        Self { mantissa: limbs::pair(magnitude >> zeros), exponent, negative: value < 0 }
    }

    /// The exponent of the highest bit; not for zero.
    pub(crate) fn top(&self) -> i64 {
        self.exponent + limbs::length(limbs::bits(&self.mantissa)) - 1
    }

    /// The mantissa times `2^shift`.
    #[inline]
    fn over(&self, shift: u64) -> Limbs {
        if shift == 0 {
            SmallVec::from_slice(&self.mantissa)
        } else {
            limbs::shifted(&self.mantissa, shift)
        }
    }

    /// The sum with `other`, negated if asked.
    fn plus(&self, other: &Self, negate: bool) -> Self {
        let (a, b) = (self, other);
        if b.mantissa.is_empty() {
            return a.clone();
        }
        let negative = b.negative != negate;
        if a.mantissa.is_empty() {
            return Self { negative, ..b.clone() };
        }
        let low = a.exponent.min(b.exponent);
        let (shift_a, shift_b) = (a.exponent.abs_diff(low), b.exponent.abs_diff(low));
        if let ([x], [y]) = (&a.mantissa[..], &b.mantissa[..])
            && shift_a.max(shift_b) <= 62
        {
            let signed = |x: u64, shift: u64, negative: bool| {
                let value = i128::from(x) << shift; // below 2^126
                if negative { -value } else { value }
            };
            return Self::short(
                signed(*x, shift_a, a.negative) + signed(*y, shift_b, negative),
                low,
            );
        }
        let (x, y) = (a.over(shift_a), b.over(shift_b));
        if a.negative == negative {
            return Self::new(limbs::sum(x, &y), low, negative);
        }
        match limbs::compare(&x, &y) {
            Ordering::Equal => Self::ZERO,
            Ordering::Greater => Self::new(limbs::difference(x, &y), low, a.negative),
            Ordering::Less => Self::new(limbs::difference(y, &x), low, negative),
        }
    }
}

impl Clone for Dyadic {
    #[inline]
    fn clone(&self) -> Self {
        let mantissa = SmallVec::from_slice(&self.mantissa); // at once, not limb by limb
        Self { mantissa, ..*self }
    }
}

impl Default for Dyadic {
    fn default() -> Self {
        Self::ZERO
    }
}

impl From<i64> for Dyadic {
    fn from(value: i64) -> Self {
        Self::short(value.into(), 0)
    }
}

impl From<f64> for Dyadic {
    /// # Panics
    /// If the double is not finite.
    fn from(value: f64) -> Self {
        assert!(value.is_finite(), "{value} is not a number times a power of two");
        let (mantissa, exponent) = odd(value);
        if mantissa == 0 {
            return Self::ZERO;
        }
        let negative = value.is_sign_negative();
        Self { mantissa: limbs::pair(mantissa.into()), exponent: exponent.into(), negative }
    }
}

impl Neg for Dyadic {
    type Output = Self;
    fn neg(mut self) -> Self {
        self.negative = !self.negative && !self.mantissa.is_empty();
        self
    }
}

impl Mul<&Dyadic> for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: &Dyadic) -> Dyadic {
        let exponent = self.exponent + other.exponent;
        let negative = self.negative != other.negative;
        let mantissa = match (&self.mantissa[..], &other.mantissa[..]) {
            ([], _) | (_, []) => return Dyadic::ZERO,
            ([x], [y]) => limbs::pair(u128::from(*x) * u128::from(*y)),
            (x, y) => limbs::product(x, y),
        };
        Dyadic { mantissa, exponent, negative } // odd times odd
    }
}

/// By value and by reference.
macro_rules! forward {
    ($($trait:ident $method:ident: |$a:ident, $b:ident| $value:expr;)*) => {$(
        impl $trait<&Dyadic> for Dyadic {
            type Output = Self;
            fn $method(self, other: &Self) -> Self {
                let ($a, $b) = (&self, other);
                $value
            }
        }
        impl $trait for Dyadic {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.$method(&other)
            }
        }
    )*};
}

forward! {
    Add add: |a, b| a.plus(b, false);
    Sub sub: |a, b| a.plus(b, true);
    Mul mul: |a, b| a * b;
}

impl AddAssign<&Self> for Dyadic {
    fn add_assign(&mut self, other: &Self) {
        *self = self.plus(other, false);
    }
}

impl SubAssign<&Self> for Dyadic {
    fn sub_assign(&mut self, other: &Self) {
        *self = self.plus(other, true);
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Self) -> Ordering {
        match self.plus(other, true).sign() {
            Sign::Negative => Ordering::Less,
            Sign::Zero => Ordering::Equal,
            Sign::Positive => Ordering::Greater,
        }
    }
}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl num_traits::Zero for Dyadic {
    fn zero() -> Self {
        Self::ZERO
    }
    fn is_zero(&self) -> bool {
        self.mantissa.is_empty()
    }
}

impl num_traits::One for Dyadic {
    fn one() -> Self {
        Self::from(1)
    }
    fn is_one(&self) -> bool {
        self.exponent == 0 && !self.negative && self.mantissa[..] == [1]
    }
}
