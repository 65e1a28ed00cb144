//! Magnitudes of any length, least significant limb first.

use std::cmp::Ordering;

use smallvec::{SmallVec, smallvec};

use super::{INLINE, Limbs};

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
    let mut limbs = [0; INLINE];
    (limbs[0], limbs[1]) = (low, high);
    SmallVec::from_buf_and_len(limbs, 1 + usize::from(high != 0))
}

/// So many zeros.
#[inline]
fn zeros(count: usize) -> Limbs {
    if count <= INLINE {
        SmallVec::from_buf_and_len([0; INLINE], count)
    } else {
        smallvec![0; count]
    }
}

/// Takes off zeros on top and, as factors of two, below. The number of the latter; `None` if all is zero.
#[inline]
pub(super) fn make_odd(limbs: &mut Limbs) -> Option<usize> {
    let len = limbs.iter().rposition(|&limb| limb != 0)? + 1;
    limbs.truncate(len);
    if limbs[0] & 1 == 1 {
        return Some(0);
    }
    let first = limbs.iter().position(|&limb| limb != 0)?;
    let bit = limbs[first].trailing_zeros();
    let limbs_left = len - first;
    for i in 0..limbs_left {
        let above = if first + i + 1 < len { limbs[first + i + 1] } else { 0 };
        limbs[i] = limbs[first + i] >> bit | above << 1 << (63 - bit);
    }
    limbs.truncate(limbs_left);
    if limbs.last() == Some(&0) {
        limbs.pop();
    }
    Some(64 * first + bit as usize)
}

/// Times `2^shift`.
#[inline]
pub(super) fn shifted(limbs: &[u64], shift: u64) -> Limbs {
    let low = usize::try_from(shift / 64).expect("exponents are those of products of doubles");
    let bit = shift % 64;
    let mut result = zeros(low + limbs.len() + 1);
    let mut below = 0;
    for (slot, &limb) in result[low..].iter_mut().zip(limbs) {
        *slot = limb << bit | below;
        below = limb >> 1 >> (63 - bit);
    }
    if below == 0 {
        result.truncate(low + limbs.len());
    } else {
        result[low + limbs.len()] = below;
    }
    result
}

pub(super) fn sum(mut a: Limbs, b: &[u64]) -> Limbs {
    while a.len() < b.len() {
        a.push(0);
    }
    let (low, high) = a.split_at_mut(b.len());
    let mut carry = false;
    for (slot, &limb) in low.iter_mut().zip(b) {
        (*slot, carry) = slot.carrying_add(limb, carry);
    }
    for slot in high {
        (*slot, carry) = slot.overflowing_add(u64::from(carry));
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
    let (low, high) = a.split_at_mut(b.len());
    let mut borrow = false;
    for (slot, &limb) in low.iter_mut().zip(b) {
        (*slot, borrow) = slot.borrowing_sub(limb, borrow);
    }
    for slot in high {
        (*slot, borrow) = slot.overflowing_sub(u64::from(borrow));
    }
    debug_assert!(!borrow, "the greater magnitude comes first");
}

/// The order of magnitudes without zeros on top.
pub(super) fn compare(a: &[u64], b: &[u64]) -> Ordering {
    a.len().cmp(&b.len()).then_with(|| a.iter().rev().cmp(b.iter().rev()))
}

pub(super) fn product(a: &[u64], b: &[u64]) -> Limbs {
    let mut product = zeros(a.len() + b.len());
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
