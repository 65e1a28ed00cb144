//! Integers of up to N limbs on the stack, which say when they have grown out of them.
//!
//! The exact stage of long formulas before [`Dyadic`]: no allocation, and sums need no alignment. A result of more than N
//! limbs is *lost*, and so is all that is computed from it: a lost number has no sign, and the question is asked again in
//! numbers of any length. So no formula needs a proof of its width, and none can be wrong for want of one.
//!
//! **Widths.** 16 limbs are for the longest of ordinary input: coordinates of b bits over their common unit make the two sides of a
//! comparison of radii of tetrahedra, of degree 14 ([`crate::Metric`]), about 14 (b + 1) + 20 bits long: 832 for b = 57.

use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use crate::{Dyadic, Sign};

#[cfg(test)]
mod tests;

/// An integer by sign and magnitude, or *lost*.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Narrow<const N: usize> {
    /// Least significant limb first; zero from `len` on, and not zero below it.
    limbs: [u64; N],
    len: usize,
    /// Not of zero.
    negative: bool,
    lost: bool,
}

impl<const N: usize> Narrow<N> {
    const ZERO: Self = Self { limbs: [0; N], len: 0, negative: false, lost: false };
    const LOST: Self = Self { lost: true, ..Self::ZERO };

    /// `value / 2^low`, an integer by the choice of `low`; lost if it is too long.
    pub(crate) fn aligned(value: &Dyadic, low: i64) -> Self {
        let mantissa = value.mantissa();
        if mantissa.is_empty() {
            return Self::ZERO;
        }
        let shift = value.exponent().abs_diff(low);
        let place = usize::try_from(shift / 64).unwrap_or(N);
        if place + mantissa.len() >= N {
            return Self::LOST;
        }
        let bit = shift % 64;
        let (mut limbs, mut below) = ([0; N], 0);
        for (slot, &limb) in limbs[place..].iter_mut().zip(mantissa) {
            *slot = limb << bit | below;
            below = limb >> 1 >> (63 - bit);
        }
        limbs[place + mantissa.len()] = below;
        Self::of(limbs, place + mantissa.len() + 1, value.sign() == Sign::Negative)
    }

    /// From a magnitude of at most `len` limbs.
    #[inline]
    fn of(limbs: [u64; N], len: usize, negative: bool) -> Self {
        let len = limbs[..len].iter().rposition(|&limb| limb != 0).map_or(0, |top| top + 1);
        Self { limbs, len, negative: negative && len > 0, lost: false }
    }

    /// Whether the number has grown out of its limbs.
    pub(crate) fn is_lost(&self) -> bool {
        self.lost
    }

    /// The sign, unless the number is lost.
    pub(crate) fn sign(&self) -> Option<Sign> {
        (!self.lost).then_some(match (self.len, self.negative) {
            (0, _) => Sign::Zero,
            (_, true) => Sign::Negative,
            (_, false) => Sign::Positive,
        })
    }

    /// The sum with `other`, negated if asked.
    #[inline]
    fn plus(&self, other: &Self, negate: bool) -> Self {
        if self.lost || other.lost {
            return Self::LOST;
        }
        let len = self.len.max(other.len);
        let negative = other.negative != negate;
        // A zero has either sign.
        if self.negative == negative || self.len == 0 {
            self.sum(other, len, negative)
        } else {
            self.difference(other, len)
        }
    }

    /// Of magnitudes.
    #[inline]
    fn sum(&self, other: &Self, len: usize, negative: bool) -> Self {
        let (mut limbs, mut carry) = (self.limbs, false);
        for (slot, &limb) in limbs[..len].iter_mut().zip(&other.limbs) {
            (*slot, carry) = slot.carrying_add(limb, carry);
        }
        if carry {
            let Some(top) = limbs.get_mut(len) else { return Self::LOST };
            *top = 1;
        }
        Self::of(limbs, len + usize::from(carry), negative)
    }

    /// Of magnitudes, with the sign of this one if this one is the greater.
    #[inline]
    fn difference(&self, other: &Self, len: usize) -> Self {
        let (mut limbs, mut borrow) = (self.limbs, false);
        for (slot, &limb) in limbs[..len].iter_mut().zip(&other.limbs) {
            (*slot, borrow) = slot.borrowing_sub(limb, borrow);
        }
        if borrow {
            let mut carry = true;
            for slot in &mut limbs[..len] {
                (*slot, carry) = (!*slot).overflowing_add(u64::from(carry));
            }
        }
        Self::of(limbs, len, self.negative != borrow)
    }

    #[inline]
    fn product(&self, other: &Self) -> Self {
        let len = self.len + other.len;
        if self.lost || other.lost || len > N {
            return Self::LOST;
        }
        let mut limbs = [0; N];
        let factor = &other.limbs[..other.len];
        for (i, &a) in self.limbs[..self.len].iter().enumerate() {
            let mut carry = 0;
            for (slot, &b) in limbs[i..].iter_mut().zip(factor) {
                (*slot, carry) = a.carrying_mul_add(b, *slot, carry);
            }
            limbs[i + factor.len()] = carry;
        }
        Self::of(limbs, len, self.negative != other.negative)
    }
}

impl<const N: usize> Neg for Narrow<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { negative: !self.negative && self.len > 0, ..self }
    }
}

/// By value and by reference.
macro_rules! forward {
    ($($trait:ident $method:ident: |$a:ident, $b:ident| $value:expr;)*) => {$(
        impl<const N: usize> $trait<&Self> for Narrow<N> {
            type Output = Self;
            #[inline]
            fn $method(self, other: &Self) -> Self {
                let ($a, $b) = (&self, other);
                $value
            }
        }
        impl<const N: usize> $trait for Narrow<N> {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                self.$method(&other)
            }
        }
    )*};
}

forward! {
    Add add: |a, b| a.plus(b, false);
    Sub sub: |a, b| a.plus(b, true);
    Mul mul: |a, b| a.product(b);
}

impl<const N: usize> AddAssign<&Self> for Narrow<N> {
    #[inline]
    fn add_assign(&mut self, other: &Self) {
        *self = self.plus(other, false);
    }
}

impl<const N: usize> SubAssign<&Self> for Narrow<N> {
    #[inline]
    fn sub_assign(&mut self, other: &Self) {
        *self = self.plus(other, true);
    }
}

impl<const N: usize> num_traits::Zero for Narrow<N> {
    fn zero() -> Self {
        Self::ZERO
    }
    fn is_zero(&self) -> bool {
        self.len == 0 && !self.lost
    }
}

impl<const N: usize> num_traits::One for Narrow<N> {
    fn one() -> Self {
        let mut limbs = [0; N];
        limbs[0] = 1;
        Self { limbs, len: 1, negative: false, lost: false }
    }
    #[inline]
    fn is_one(&self) -> bool {
        self.len == 1 && self.limbs[0] == 1 && !self.negative
    }
}
