//! Exact areas: an integer times a power of two.
//!
//! Coordinates are doubles, so they are integers over a power of two, and so are the areas of polygons between them.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | no area | `0` | `dyadics_are_told_in_lowest_terms` |
//! | beyond or below the doubles | exact as text; the nearest double is infinite, denormal or zero | `the_nearest_double_is_nearest` |

use std::fmt;
use std::ops::AddAssign;

use dashu_int::IBig;
use dashu_int::ops::BitTest;

/// `numerator * 2^exponent`, exactly. Displayed as `p` or `p/q` in lowest terms.
///
/// Equal numbers are equal: the numerator is odd, or zero with the exponent 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Area {
    numerator: IBig,
    exponent: i32,
}

impl Default for Area {
    fn default() -> Self {
        Self { numerator: IBig::ZERO, exponent: 0 }
    }
}

impl Area {
    pub(crate) fn new(numerator: IBig, exponent: i32) -> Self {
        match numerator.trailing_zeros() {
            None => Self::default(),
            Some(zeros) => {
                let shifted =
                    i32::try_from(zeros).expect("areas of doubles have few thousand bits");
                Self { numerator: numerator >> zeros, exponent: exponent + shifted }
            }
        }
    }

    /// The integer that times `2^low` is this number; `low` is at most the exponent.
    fn aligned(&self, low: i32) -> IBig {
        &self.numerator << size_of(i64::from(self.exponent - low))
    }

    /// The opposite number.
    #[must_use]
    pub fn negative(&self) -> Self {
        Self { numerator: -&self.numerator, exponent: self.exponent }
    }

    /// The nearest double, ties to even.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let bits = signed(self.numerator.bit_len());
        let top = bits + i64::from(self.exponent); // the number is below 2^top in absolute value
        if bits == 0 || top < -1075 {
            return 0.0;
        }
        if top > 1024 {
            return if self.numerator > IBig::ZERO { f64::INFINITY } else { f64::NEG_INFINITY };
        }
        let unit = (top - 53).max(-1074); // a double of this size is a multiple of 2^unit
        let shift = i64::from(self.exponent) - unit;
        let size = size_of(shift);
        let mantissa = if shift >= 0 {
            self.numerator.clone() << size
        } else {
            rounded(&self.numerator, size)
        };
        // The product is a double, or overflows as rounding should.
        mantissa.to_f64().value() * power_of_two(unit)
    }
}

fn signed(bits: usize) -> i64 {
    i64::try_from(bits).expect("areas of doubles have a few thousand bits")
}

fn size_of(shift: i64) -> usize {
    usize::try_from(shift.unsigned_abs()).expect("areas of doubles have a few thousand bits")
}

/// `numerator / 2^bits`, to the nearest integer, ties to even.
fn rounded(numerator: &IBig, bits: usize) -> IBig {
    let doubled: IBig = numerator >> (bits - 1); // one bit more, rounded down
    let floor: IBig = &doubled >> 1;
    let half = (&doubled << (bits - 1)) == *numerator; // at most one half is left
    let above = doubled.bit(0) && (!half || floor.bit(0));
    if above { floor + IBig::ONE } else { floor }
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
        let low = self.exponent.min(other.exponent);
        *self = Self::new(self.aligned(low) + other.aligned(low), low);
    }
}

impl fmt::Display for Area {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = size_of(i64::from(self.exponent));
        if self.exponent >= 0 {
            write!(f, "{}", &self.numerator << size)
        } else {
            write!(f, "{}/{}", self.numerator, IBig::ONE << size)
        }
    }
}

/// Points as integers over one power of two.
#[derive(Clone, Debug)]
pub(crate) struct Lattice {
    low: i32,
}

impl Lattice {
    /// The coarsest lattice that holds all the coordinates.
    pub(crate) fn of(points: &[[f64; 2]]) -> Self {
        let low = points.iter().flatten().filter(|&&x| x != 0.0).map(|&x| decode(x).1).min();
        Self { low: low.unwrap_or(0) }
    }

    fn integer(&self, x: f64) -> IBig {
        let (mantissa, exponent) = decode(x);
        if mantissa == 0 {
            return IBig::ZERO;
        }
        IBig::from(mantissa) << usize::try_from(exponent - self.low).expect("low is least")
    }

    /// Twice the signed area of a triangle, in units of the lattice.
    pub(crate) fn twice_area(&self, [a, b, c]: [[f64; 2]; 3]) -> IBig {
        let [ax, ay] = a.map(|x| self.integer(x));
        let minus = |p: [f64; 2]| [self.integer(p[0]) - &ax, self.integer(p[1]) - &ay];
        let ([bx, by], [cx, cy]) = (minus(b), minus(c));
        bx * cy - by * cx
    }

    /// The area, of its double in units of the lattice.
    pub(crate) fn area(&self, twice: IBig) -> Area {
        Area::new(twice, 2 * self.low - 1)
    }
}

/// `x = mantissa * 2^exponent`, the mantissa odd or zero.
fn decode(x: f64) -> (i64, i32) {
    let bits = x.abs().to_bits();
    let biased = i32::try_from(bits >> 52).expect("11 bits");
    let fraction = i64::try_from(bits & ((1 << 52) - 1)).expect("52 bits");
    let (mantissa, exponent) =
        if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
    if mantissa == 0 {
        return (0, 0);
    }
    let zeros = mantissa.trailing_zeros();
    let odd = mantissa >> zeros;
    (if x < 0.0 { -odd } else { odd }, exponent.saturating_add_unsigned(zeros))
}

#[cfg(test)]
mod tests;
