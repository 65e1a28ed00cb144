//! Magnitudes of any length, least significant limb first.

use std::cmp::Ordering;

use smallvec::{SmallVec, smallvec};

use super::Limbs;

/// A count as an exponent.
pub(super) fn length(bits: usize) -> i64 {
    i64::try_from(bits).expect("a length in memory")
}

/// The number of bits, given that the top limb is not zero.
pub(super) fn bits(limbs: &[u64]) -> usize {
    limbs.last().map_or(0, |top| 64 * limbs.len() - top.leading_zeros() as usize)
}

/// Up to 128 bits, without zeros on top.
#[expect(clippy::cast_possible_truncation, reason = "limbs are cut out")]
pub(super) fn pair(value: u128) -> Limbs {
    let (low, high) = (value as u64, (value >> 64) as u64);
    let mut limbs = SmallVec::new();
    limbs.push(low);
    if high != 0 {
        limbs.push(high);
    }
    limbs
}

/// Takes off zeros on top and, as factors of two, below. The number of the latter; `None` if all is zero.
pub(super) fn make_odd(limbs: &mut Limbs) -> Option<usize> {
    while limbs.last() == Some(&0) {
        limbs.pop();
    }
    let first = limbs.iter().position(|&limb| limb != 0)?;
    let bit = limbs[first].trailing_zeros();
    if first > 0 {
        limbs.drain(..first);
    }
    if bit > 0 {
        for i in 0..limbs.len() {
            let above = limbs.get(i + 1).map_or(0, |above| above << (64 - bit));
            limbs[i] = limbs[i] >> bit | above;
        }
        if limbs.last() == Some(&0) {
            limbs.pop();
        }
    }
    Some(64 * first + bit as usize)
}

/// Times `2^shift`.
pub(super) fn shifted(limbs: &[u64], shift: u64) -> Limbs {
    let zeros = usize::try_from(shift / 64).expect("exponents are those of products of doubles");
    let bit = shift % 64;
    let mut result: Limbs = smallvec![0; zeros];
    result.reserve(limbs.len() + 1);
    if bit == 0 {
        result.extend_from_slice(limbs);
        return result;
    }
    let mut carry = 0;
    for &limb in limbs {
        result.push(limb << bit | carry);
        carry = limb >> (64 - bit);
    }
    if carry != 0 {
        result.push(carry);
    }
    result
}

pub(super) fn sum(mut a: Limbs, b: &[u64]) -> Limbs {
    if a.len() < b.len() {
        a.resize(b.len(), 0);
    }
    let mut carry = false;
    for (i, slot) in a.iter_mut().enumerate() {
        match b.get(i) {
            Some(&limb) => (*slot, carry) = slot.carrying_add(limb, carry),
            None if carry => (*slot, carry) = slot.overflowing_add(1),
            None => break,
        }
    }
    if carry {
        a.push(1);
    }
    a
}

/// `a - b`, for `a >= b`. Zeros may be left on top.
pub(super) fn difference(mut a: Limbs, b: &[u64]) -> Limbs {
    subtract(&mut a, b);
    a
}

/// `a -= b`, for `a >= b`.
pub(super) fn subtract(a: &mut [u64], b: &[u64]) {
    let mut borrow = false;
    for (i, slot) in a.iter_mut().enumerate() {
        match b.get(i) {
            Some(&limb) => (*slot, borrow) = slot.borrowing_sub(limb, borrow),
            None if borrow => (*slot, borrow) = slot.overflowing_sub(1),
            None => break,
        }
    }
    debug_assert!(!borrow, "the greater magnitude comes first");
}

/// The order of magnitudes without zeros on top.
pub(super) fn compare(a: &[u64], b: &[u64]) -> Ordering {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

pub(super) fn product(a: &[u64], b: &[u64]) -> Limbs {
    let mut product: Limbs = smallvec![0; a.len() + b.len()];
    for (i, &x) in a.iter().enumerate() {
        let mut carry = 0;
        for (slot, &y) in product[i..].iter_mut().zip(b) {
            (*slot, carry) = x.carrying_mul_add(y, *slot, carry);
        }
        product[i + b.len()] = carry;
    }
    if product.last() == Some(&0) {
        product.pop();
    }
    product
}
