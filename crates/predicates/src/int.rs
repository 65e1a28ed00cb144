//! Fixed-width two's complement integers on the stack, with products of exact widths.
//!
//! An [`Int<N>`] holds -2^(64 N - 1) .. 2^(64 N - 1). [`Int::times`] of A and B limbs gives A+B limbs and never
//! overflows, so a minor costs only the limbs it has. Sums and differences keep the width: that they fit is the
//! caller's to prove (`exact.rs`, *Head-room*).

use crate::Sign;

/// An integer of N limbs in two's complement, least significant limb first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Int<const N: usize>([u64; N]);

impl<const N: usize> Int<N> {
    pub(crate) const ZERO: Self = Self([0; N]);

    pub(crate) const ONE: Self = {
        let mut limbs = [0; N];
        limbs[0] = 1;
        Self(limbs)
    };

    /// `mantissa * 2^shift`, negated if asked. Bits over the width are lost.
    #[inline]
    pub(crate) fn shifted(mantissa: u64, shift: usize, negative: bool) -> Self {
        let mut limbs = [0; N];
        let (limb, bit) = (shift / 64, shift % 64);
        if limb < N {
            limbs[limb] = mantissa << bit;
        }
        if limb + 1 < N {
            limbs[limb + 1] = mantissa >> 1 >> (63 - bit);
        }
        let value = Self(limbs);
        if negative { Self::ZERO - value } else { value }
    }

    /// `magnitude * 2^shift`, negated if asked. Bits over the width are lost.
    #[inline]
    pub(crate) fn from_limbs(magnitude: &[u64], shift: u64, negative: bool) -> Self {
        let (place, bit) = (usize::try_from(shift / 64).unwrap_or(N).min(N), shift % 64);
        let (mut limbs, mut below) = ([0; N], 0);
        for (slot, &limb) in limbs[place..].iter_mut().zip(magnitude.iter().chain(&[0])) {
            *slot = limb << bit | below;
            below = limb >> 1 >> (63 - bit);
        }
        if negative { Self::ZERO - Self(limbs) } else { Self(limbs) }
    }

    #[inline]
    pub(crate) fn sign(&self) -> Sign {
        if self.0[N - 1] >> 63 == 1 {
            Sign::Negative
        } else if self.0.iter().all(|&limb| limb == 0) {
            Sign::Zero
        } else {
            Sign::Positive
        }
    }

    /// The value, if it is at most 2^62 in magnitude.
    #[inline]
    pub(crate) fn short(&self) -> Option<i64> {
        const LIMIT: u64 = 1 << 62;
        let (low, mask) = (self.0[0].cast_signed(), self.mask());
        let fits = self.0[1..].iter().all(|&limb| limb == mask) && (low < 0) == (mask != 0);
        (fits && low.unsigned_abs() <= LIMIT).then_some(low)
    }

    /// All ones if negative, else zero.
    #[inline(always)]
    fn mask(&self) -> u64 {
        0u64.wrapping_sub(self.0[N - 1] >> 63)
    }

    /// The product. `R` must be `N + B`.
    ///
    /// The limbs are multiplied as if unsigned; a negative factor was then read 2^(64 N) too high, which is taken off.
    #[inline(always)]
    pub(crate) fn times<const B: usize, const R: usize>(&self, other: &Int<B>) -> Int<R> {
        const { assert!(R == N + B, "the product of N and B limbs has N + B") };
        if N * B > 8 { self.times_called(other) } else { self.times_inlined(other) }
    }

    /// Of many limbs: a call costs less than the code of all its copies.
    #[inline(never)]
    fn times_called<const B: usize, const R: usize>(&self, other: &Int<B>) -> Int<R> {
        self.times_inlined(other)
    }

    #[inline(always)]
    fn times_inlined<const B: usize, const R: usize>(&self, other: &Int<B>) -> Int<R> {
        let mut product = [0u64; R];
        if N == 1 && B == 1 {
            let (a, b) = (self.0[0].cast_signed(), other.0[0].cast_signed());
            (product[0], product[1]) = halves(i128::from(a) * i128::from(b));
            return Int(product);
        }
        for (i, &a) in self.0.iter().enumerate() {
            let mut carry = 0u64;
            for (j, &b) in other.0.iter().enumerate() {
                (product[i + j], carry) = a.carrying_mul_add(b, product[i + j], carry);
            }
            product[i + B] = carry;
        }
        subtract_masked(&mut product[N..], &other.0, self.mask());
        subtract_masked(&mut product[B..], &self.0, other.mask());
        Int(product)
    }

    /// The same value in at least as many limbs.
    #[inline]
    pub(crate) fn extended<const M: usize>(&self) -> Int<M> {
        const { assert!(M >= N, "extending adds limbs") };
        let mut limbs = [self.mask(); M];
        limbs[..N].copy_from_slice(&self.0);
        Int(limbs)
    }

    /// The product with one limb, its top limb dropped: right when the product fits into N limbs.
    #[inline]
    pub(crate) fn scaled(&self, factor: i64) -> Self {
        let mut product = [0u64; N];
        let mut carry = 0u64;
        for (slot, &a) in product.iter_mut().zip(&self.0) {
            (*slot, carry) = a.carrying_mul_add(factor.cast_unsigned(), 0, carry);
        }
        let negative = (factor >> 63).cast_unsigned();
        subtract_masked(&mut product[1..], &self.0[..N - 1], negative);
        Self(product)
    }

    /// The product modulo 2^(64 N): right when the product fits.
    #[inline]
    pub(crate) fn wrapping_times(&self, other: &Self) -> Self {
        let mut product = [0u64; N];
        for (i, &a) in self.0.iter().enumerate() {
            let mut carry = 0u64;
            for (slot, &b) in product[i..].iter_mut().zip(&other.0) {
                (*slot, carry) = a.carrying_mul_add(b, *slot, carry);
            }
        }
        Self(product)
    }
}

impl From<i128> for Int<2> {
    #[inline(always)]
    fn from(value: i128) -> Self {
        let (low, high) = halves(value);
        Self([low, high])
    }
}

impl From<i64> for Int<1> {
    #[inline(always)]
    fn from(value: i64) -> Self {
        Self([value.cast_unsigned()])
    }
}

impl Int<1> {
    /// The value.
    #[inline(always)]
    pub(crate) fn low(self) -> i64 {
        self.0[0].cast_signed()
    }
}

/// The low and the high limb.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limbs are cut out")]
fn halves(value: i128) -> (u64, u64) {
    (value as u64, (value >> 64) as u64)
}

/// `product -= limbs & mask`, modulo its width.
#[inline(always)]
fn subtract_masked(product: &mut [u64], limbs: &[u64], mask: u64) {
    let mut borrow = false;
    for (slot, &limb) in product.iter_mut().zip(limbs) {
        (*slot, borrow) = slot.borrowing_sub(limb & mask, borrow);
    }
}

impl<const N: usize> std::ops::Add for Int<N> {
    type Output = Self;
    #[inline(always)]
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
    #[inline(always)]
    fn sub(mut self, other: Self) -> Self {
        let mut borrow = false;
        for (a, &b) in self.0.iter_mut().zip(&other.0) {
            (*a, borrow) = a.borrowing_sub(b, borrow);
        }
        self
    }
}
