//! Exact areas: fractions.
//!
//! Coordinates of sites are doubles, so the areas of polygons between them are integers over a power of two. Crossings of
//! segments have ratios as coordinates, and so the areas between them are ratios.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | no area | `0` | `areas_are_told_in_lowest_terms` |
//! | beyond or below the doubles | exact as text; the nearest double is infinite, denormal or zero | `the_nearest_double_is_nearest` |

mod sum;

use std::fmt;
use std::ops::AddAssign;

use dashu_int::ops::{BitTest, DivRem, Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};

pub(crate) use sum::{Areas, total};

/// An exact fraction. Displayed as `p` or `p/q` in lowest terms; equal numbers are equal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Area {
    numerator: IBig,
    /// At least 1, and without a common factor with the numerator.
    denominator: UBig,
}

impl Default for Area {
    fn default() -> Self {
        Self { numerator: IBig::ZERO, denominator: UBig::ONE }
    }
}

impl Area {
    /// `numerator / denominator`; the denominator is not zero.
    pub(crate) fn ratio(numerator: IBig, denominator: UBig) -> Self {
        let common = numerator.clone().unsigned_abs().gcd(&denominator);
        Self {
            numerator: numerator / IBig::from(common.clone()),
            denominator: denominator / common,
        }
    }

    /// `numerator * 2^exponent`.
    pub(crate) fn dyadic(numerator: IBig, exponent: i64) -> Self {
        let size = size_of(exponent);
        if exponent >= 0 {
            return Self { numerator: numerator << size, denominator: UBig::ONE };
        }
        let zeros = numerator.trailing_zeros().unwrap_or(size).min(size);
        Self { numerator: numerator >> zeros, denominator: UBig::ONE << (size - zeros) }
    }

    /// The opposite number.
    #[must_use]
    pub fn negative(&self) -> Self {
        Self { numerator: -&self.numerator, denominator: self.denominator.clone() }
    }

    /// The nearest double, ties to even.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let size = self.numerator.clone().unsigned_abs();
        // The number is below 2^top, and not below 2^(top - 2).
        let top = signed(size.bit_len()) - signed(self.denominator.bit_len()) + 1;
        let nearest = if size.is_zero() || top < -1074 {
            0.0
        } else if top > 1026 {
            f64::INFINITY
        } else {
            // Two bits more than a double holds, or all that a denormal holds, and two; the rest only matters as "some".
            let unit = (top - 55).max(-1076);
            let shift = size_of(unit);
            let (over, under) = if unit >= 0 {
                (size, &self.denominator << shift)
            } else {
                (size << shift, self.denominator.clone())
            };
            let (quotient, rest) = over.div_rem(under);
            rounded(&quotient, !rest.is_zero(), unit)
        };
        if self.numerator < IBig::ZERO { -nearest } else { nearest }
    }
}

/// The double nearest to `(quotient + some) * 2^unit`, where `some` is between 0 and 1, and positive if there `is_more`.
fn rounded(quotient: &UBig, is_more: bool, unit: i64) -> f64 {
    // A double of this size is a multiple of 2^(unit + extra).
    let extra = (signed(quotient.bit_len()) - 53).max(-1074 - unit).max(0);
    let dropped = size_of(extra);
    let floor = quotient >> dropped;
    let up = dropped > 0 && quotient.bit(dropped - 1) && {
        let below = quotient.trailing_zeros().is_some_and(|zeros| zeros < dropped - 1);
        below || is_more || floor.bit(0)
    };
    let mantissa = if up { floor + UBig::ONE } else { floor };
    // At most 2^53: exact. The product is a double, or overflows as rounding should.
    let mantissa = u64::try_from(mantissa).expect("53 bits, or 2^53");
    let scale = unit + extra;
    if scale > 971 { f64::INFINITY } else { mantissa as f64 * power_of_two(scale) }
}

fn signed(bits: usize) -> i64 {
    i64::try_from(bits).expect("numbers of bits are small")
}

fn size_of(shift: i64) -> usize {
    usize::try_from(shift.unsigned_abs()).expect("numbers of bits are small")
}

/// 2^exponent, for exponents from -1074 to 971.
fn power_of_two(exponent: i64) -> f64 {
    let bits = if exponent >= -1022 {
        u64::try_from(exponent + 1023).map(|biased| biased << 52)
    } else {
        u64::try_from(exponent + 1074).map(|place| 1 << place)
    };
    f64::from_bits(bits.expect("an exponent of a double"))
}

impl AddAssign<&Self> for Area {
    fn add_assign(&mut self, other: &Self) {
        *self = self.plus(other);
    }
}

impl Area {
    fn plus(&self, other: &Self) -> Self {
        let [b, d] = [&self.denominator, &other.denominator].map(|q| IBig::from(q.clone()));
        Self::ratio(
            &self.numerator * &d + &other.numerator * &b,
            &self.denominator * &other.denominator,
        )
    }
}

impl fmt::Display for Area {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.denominator.is_one() {
            write!(f, "{}", self.numerator)
        } else {
            write!(f, "{}/{}", self.numerator, self.denominator)
        }
    }
}

#[cfg(test)]
mod tests;
