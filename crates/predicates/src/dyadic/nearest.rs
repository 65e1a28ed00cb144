//! The double nearest to a quotient of two dyadic numbers, ties to even.

use std::cmp::Ordering;

use super::{Dyadic, limbs};

/// The double nearest to `a / b`; infinite beyond the largest. `b` is positive.
pub(crate) fn nearest_ratio(a: &Dyadic, b: &Dyadic) -> f64 {
    debug_assert!(b.sign() == crate::Sign::Positive, "denominators are positive");
    if a.mantissa.is_empty() {
        return 0.0;
    }
    let (quotient, exponent, rest) = leading_bits(a, b);
    let magnitude = rounded(quotient, exponent, rest);
    if a.negative { -magnitude } else { magnitude }
}

/// `|a| / b = (q + r) 2^e` with q of 64 bits and 0 <= r < 1: q, e, and whether r is not zero. By long division, bit by bit,
/// unless b is a power of two.
fn leading_bits(a: &Dyadic, b: &Dyadic) -> (u64, i64, bool) {
    if b.mantissa[..] == [1] {
        let (quotient, exponent, rest) = own_bits(a);
        return (quotient, exponent - b.exponent, rest);
    }
    let mut scale = a.top() - b.top();
    // Over one unit, with tops at the same place: the quotient is between 1/2 and 2.
    let (mut rest, divisor) = {
        let (long, short) = (limbs::bits(&a.mantissa), limbs::bits(&b.mantissa));
        let place = |n: usize| limbs::length(long.max(short) - n).unsigned_abs();
        (limbs::shifted(&a.mantissa, place(long)), limbs::shifted(&b.mantissa, place(short)))
    };
    let is_below = |rest: &super::Limbs| limbs::compare(rest, &divisor) == Ordering::Less;
    if is_below(&rest) {
        rest = limbs::shifted(&rest, 1);
        scale -= 1;
    }
    let mut quotient = 0u64;
    for _ in 0..64 {
        quotient <<= 1;
        if !is_below(&rest) {
            quotient |= 1;
            limbs::subtract(&mut rest, &divisor);
            while rest.last() == Some(&0) {
                rest.pop();
            }
        }
        rest = limbs::shifted(&rest, 1);
    }
    (quotient, scale - 63, !rest.is_empty())
}

/// The same of `|a|` itself, which is not zero.
fn own_bits(a: &Dyadic) -> (u64, i64, bool) {
    let (high, below) = a.mantissa.split_last().expect("the number is not zero");
    let zeros = high.leading_zeros();
    let low = below.last().copied().unwrap_or(0);
    let both = (u128::from(*high) << 64 | u128::from(low)) << zeros;
    let [quotient, left] = [both >> 64, both & u128::from(u64::MAX)];
    let quotient = u64::try_from(quotient).expect("the upper half has 64 bits");
    // A mantissa is odd: what is further down is not zero.
    let exponent = a.exponent + limbs::length(64 * below.len()) - i64::from(zeros);
    (quotient, exponent, left != 0 || below.len() > 1)
}

/// The double nearest to `(q + r) 2^e`, q having its top bit set.
fn rounded(quotient: u64, exponent: i64, rest: bool) -> f64 {
    // The unit of the result: 53 bits, fewer for denormals.
    let unit = (exponent + 11).max(-1074);
    let dropped = unit - exponent;
    if dropped > 64 {
        return 0.0; // below half of the least
    }
    let quotient = u128::from(quotient);
    let (kept, half) = (quotient >> dropped, 1u128 << (dropped - 1));
    let below = quotient & (half | (half - 1));
    let up = below > half || below == half && (rest || kept & 1 == 1);
    let kept = u64::try_from(kept + u128::from(up)).expect("at most 2^53");
    if kept == 0 {
        return 0.0;
    }
    // 2^53 is a power of two: one bit of the next exponent.
    let (kept, unit) = if kept == 1 << 53 { (1 << 52, unit + 1) } else { (kept, unit) };
    if unit > 971 {
        return f64::INFINITY;
    }
    let field = u64::try_from(unit + 1074).expect("at least the least unit");
    // Of a normal number the hidden bit adds one to the field.
    f64::from_bits((field << 52) + kept)
}
