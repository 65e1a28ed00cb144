//! Fixed-width two's complement integers: the ring of integers modulo 2^(64 N), on the stack.
//!
//! **Why wrapping is right.** Sums, differences and products modulo 2^(64 N) form a ring, so whatever overflows on the
//! way cancels: only the *final* value must fit into 64 N bits with its sign. The one bound to prove is that of the
//! determinant (`determinant.rs`), not one per operation.

use crate::Sign;

/// An integer modulo 2^(64 N), least significant limb first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Int<const N: usize>([u64; N]);

impl<const N: usize> Int<N> {
    pub(crate) const ZERO: Self = Self([0; N]);

    /// `mantissa * 2^shift`, negated if asked.
    pub(crate) fn shifted(mantissa: u64, shift: usize, negative: bool) -> Self {
        let mut limbs = [0; N];
        let (limb, bit) = (shift / 64, shift % 64);
        if mantissa != 0 {
            limbs[limb] = mantissa << bit;
            if bit != 0 && limb + 1 < N {
                limbs[limb + 1] = mantissa >> (64 - bit);
            }
        }
        let value = Self(limbs);
        if negative { Self::ZERO - value } else { value }
    }

    pub(crate) fn sign(&self) -> Sign {
        if self.0[N - 1] >> 63 == 1 {
            Sign::Negative
        } else if self.0.iter().all(|&limb| limb == 0) {
            Sign::Zero
        } else {
            Sign::Positive
        }
    }
}

impl<const N: usize> std::ops::Add for Int<N> {
    type Output = Self;
    #[inline]
    fn add(mut self, other: Self) -> Self {
        let mut carry = false;
        for (a, &b) in self.0.iter_mut().zip(&other.0) {
            (*a, carry) = a.carrying_add(b, carry);
        }
        self
    }
}

impl<const N: usize> std::ops::Sub for Int<N> {
    type Output = Self;
    #[inline]
    fn sub(mut self, other: Self) -> Self {
        let mut borrow = false;
        for (a, &b) in self.0.iter_mut().zip(&other.0) {
            (*a, borrow) = a.borrowing_sub(b, borrow);
        }
        self
    }
}

impl<const N: usize> std::ops::Mul for Int<N> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let mut product = [0u64; N];
        for (i, &a) in self.0.iter().enumerate() {
            let mut carry = 0u64;
            for (slot, &b) in product[i..].iter_mut().zip(&other.0) {
                let (low, high) = a.carrying_mul_add(b, *slot, carry);
                *slot = low;
                carry = high;
            }
        }
        Self(product)
    }
}
