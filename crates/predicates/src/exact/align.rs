//! Doubles as integers on one common power of two.

use crate::int::Int;

const FRACTION: u64 = (1 << 52) - 1;

/// The exponent field of the bits of a magnitude; 1 for denormals, whose unit is that of the least normal numbers.
#[inline(always)]
fn field(magnitude: u64) -> u64 {
    (magnitude >> 52).max(1)
}

/// All values over one power of two as integers of at most 61 bits, if they are such: a value counts from the top, so
/// that the largest has its highest bit in bit 60.
///
/// In doubles, for the compiler to do two at a time. Scaled by a power of two that is not below 1 no bit is lost, and
/// y = 2^31 h + l with |y| < 2^61: adding 1.5 * 2^83 rounds to a multiple of 2^31, whose count h then stands in the low
/// bits of the sum. What is left, |l| <= 2^30, is exact; adding 1.5 * 2^52 rounds it to an integer, and if that changes it, y
/// is none. Outside the exponents where the scale is a normal number of at least 1, the same in integers.
#[inline(always)]
pub(crate) fn one_limb<const M: usize>(values: &[f64; M]) -> Option<[i64; M]> {
    /// 1.5 * 2^83
    const HIGH: f64 = f64::from_bits((1023 + 83) << 52 | 1 << 51);
    /// 1.5 * 2^52
    const LOW: f64 = f64::from_bits((1023 + 52) << 52 | 1 << 51);
    let mut top = 0.0;
    for value in values {
        top = if value.abs() > top { value.abs() } else { top };
    }
    let top = top.to_bits() >> 52;
    if !(60..=1083).contains(&top) {
        return one_limb_of_any_exponent(values);
    }
    let scale = f64::from_bits((2106 - top) << 52);
    let mut integers = [0; M];
    let mut lost = 0;
    for i in 0..M {
        let value = values[i] * scale;
        let high = value + HIGH;
        let rest = value - (high - HIGH);
        let low = rest + LOW;
        lost |= u64::from(low - LOW != rest);
        let counts = (high.to_bits() << 31).wrapping_add(low.to_bits());
        integers[i] =
            counts.wrapping_sub((HIGH.to_bits() << 31).wrapping_add(LOW.to_bits())).cast_signed();
    }
    (lost == 0).then_some(integers)
}

/// As [`one_limb`].
#[inline(never)]
fn one_limb_of_any_exponent<const M: usize>(values: &[f64; M]) -> Option<[i64; M]> {
    let top = top_field(values);
    let mut lost = 0;
    let mut integers = [0; M];
    for i in 0..M {
        let bits = values[i].to_bits();
        let magnitude = bits << 1 >> 1;
        let hidden = u64::from(magnitude > FRACTION) << 52;
        let mantissa = (magnitude & FRACTION | hidden) << 8;
        let shift = (top - field(magnitude)).min(63);
        let integer = mantissa >> shift;
        lost |= integer << shift ^ mantissa;
        let sign = bits.cast_signed() >> 63;
        integers[i] = (integer.cast_signed() ^ sign) - sign;
    }
    (lost == 0).then_some(integers)
}

/// As [`one_limb`], of at most 125 bits.
#[inline(always)]
pub(crate) fn two_limbs<const M: usize>(values: &[f64; M]) -> Option<[i128; M]> {
    let top = top_field(values);
    let mut lost = 0;
    let mut integers = [0; M];
    for i in 0..M {
        let bits = values[i].to_bits();
        let magnitude = bits << 1 >> 1;
        let hidden = u64::from(magnitude > FRACTION) << 52;
        let mantissa = u128::from(magnitude & FRACTION | hidden) << 72;
        let shift = (top - field(magnitude)).min(127);
        let integer = mantissa >> shift;
        lost |= integer << shift ^ mantissa;
        let sign = i128::from(bits.cast_signed() >> 63);
        integers[i] = (integer.cast_signed() ^ sign) - sign;
    }
    (lost == 0).then_some(integers)
}

/// The highest exponent field.
#[inline(always)]
fn top_field<const M: usize>(values: &[f64; M]) -> u64 {
    let mut top = 0;
    for value in values {
        top = top.max(value.to_bits() << 1 >> 1);
    }
    debug_assert!(top >> 52 < 0x7ff, "a coordinate that is not finite reached a predicate");
    field(top)
}

/// The number of bits that the magnitudes of all differences fit into, at most `2^bits`, and the common zeros below.
#[inline(always)]
pub(crate) fn extent<const M: usize>(differences: &[i64; M]) -> (u32, u32) {
    let (mut any, mut magnitudes) = (0, 0);
    for d in differences {
        any |= d;
        magnitudes |= d ^ d >> 63;
    }
    (64 - magnitudes.leading_zeros(), any.trailing_zeros().min(63))
}

/// The exponent of the lowest bit set and the width up to the highest, over all values; `None` if all are zero.
pub(crate) fn span<'a>(values: impl Iterator<Item = &'a f64>) -> Option<(i32, u32)> {
    let (mut low, mut high) = (i32::MAX, i32::MIN);
    for &value in values {
        let (mantissa, exponent) = odd(value);
        if mantissa != 0 {
            low = low.min(exponent);
            high = high.max(exponent + (64 - mantissa.leading_zeros()).cast_signed());
        }
    }
    (high > low).then(|| (low, high.abs_diff(low)))
}

/// `|value| = mantissa * 2^exponent` exactly, the mantissa odd or zero.
#[inline]
pub(crate) fn odd(value: f64) -> (u64, i32) {
    let magnitude = value.to_bits() << 1 >> 1;
    let hidden = u64::from(magnitude > FRACTION) << 52;
    let mantissa = magnitude & FRACTION | hidden;
    let zeros = mantissa.trailing_zeros() & 63;
    let field = i32::try_from(field(magnitude)).expect("a field of eleven bits");
    (mantissa >> zeros, field - 1075 + zeros.cast_signed())
}

/// `value / 2^low`, an integer by the choice of `low`.
#[inline]
pub(crate) fn aligned<const N: usize>(value: f64, low: i32) -> Int<N> {
    let (mantissa, exponent) = odd(value);
    if mantissa == 0 {
        return Int::ZERO;
    }
    Int::shifted(mantissa, exponent.abs_diff(low) as usize, value.is_sign_negative())
}
