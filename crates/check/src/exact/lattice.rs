//! All coordinates of one judgement on one power of two, as integers.
//!
//! A finite double is `m 2^e` with `m` odd (or zero) and `|m| < 2^53`. Let `e0` be the least `e`
//! among the nonzero coordinates; then `x / 2^e0` is an integer for every coordinate `x`. Every
//! formula of the judge is homogeneous, so the common factor changes no sign. From 5e-324 to
//! 1.7e308 a coordinate has at most 2098 bits.

use super::{Arithmetic, Integer};
use std::marker::PhantomData;

/// The odd mantissa and the exponent of a finite double: `x = mantissa * 2^exponent`.
/// Zero is `(0, 0)`.
pub(crate) fn decode(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let top = u16::from_be_bytes([bits.to_be_bytes()[0], bits.to_be_bytes()[1]]);
    let biased = i32::from((top & 0x7fff) >> 4);
    let fraction = (bits & ((1 << 52) - 1)).cast_signed();
    let (mantissa, exponent) =
        if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased - 1075) };
    if mantissa == 0 {
        return (0, 0);
    }
    let zeros = mantissa.trailing_zeros();
    let odd = mantissa >> zeros;
    let signed = if x < 0.0 { -odd } else { odd };
    (signed, exponent.saturating_add_unsigned(zeros))
}

/// The range of binary digits that some coordinates take up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Span {
    /// Every coordinate is a multiple of `2^low`.
    pub(crate) low: i32,
    /// Every coordinate is less than `2^high` in absolute value.
    pub(crate) high: i32,
}

impl Span {
    /// The span of these finite coordinates; `None` if all are zero.
    pub(crate) fn of(coordinates: impl Iterator<Item = f64>) -> Option<Self> {
        let mut span: Option<Self> = None;
        for x in coordinates {
            let (mantissa, low) = decode(x);
            if mantissa == 0 {
                continue;
            }
            let width = 64 - mantissa.unsigned_abs().leading_zeros();
            let high = low.saturating_add_unsigned(width);
            span = Self::both(span, Some(Self { low, high }));
        }
        span
    }

    /// A span of roots: numbers of this span are multiples of `2^(2 low)`, less than `2^(2 high)`.
    pub(crate) fn halved(self) -> Self {
        Self { low: self.low.div_euclid(2), high: -(-self.high).div_euclid(2) }
    }

    /// The least span that holds both, if there are any.
    pub(crate) fn both(one: Option<Self>, other: Option<Self>) -> Option<Self> {
        match (one, other) {
            (Some(a), Some(b)) => Some(Self { low: a.low.min(b.low), high: a.high.max(b.high) }),
            (span, None) | (None, span) => span,
        }
    }

    /// How many bits the integers `x / 2^low` need, without sign.
    pub(crate) fn bits(self) -> u32 {
        self.high.abs_diff(self.low)
    }
}

/// Coordinates as integers `x / 2^low`.
#[derive(Clone, Debug)]
pub(crate) struct Lattice<I> {
    low: i32,
    integers: PhantomData<I>,
}

impl<I: Integer> Lattice<I> {
    /// The lattice of spacing `2^low`, `low` being that of a [`Span`] of all coordinates to come.
    pub(crate) fn new(low: i32) -> Self {
        Self { low, integers: PhantomData }
    }

    /// The exponent of the spacing.
    pub(crate) fn low(&self) -> i32 {
        self.low
    }

    /// The integer `x / 2^low`.
    pub(crate) fn integer(&self, x: f64) -> I {
        Self::multiple(x, self.low)
    }

    /// The integer `x / 2^low`.
    fn multiple(x: f64, low: i32) -> I {
        match decode(x) {
            (0, _) => I::shifted(0, 0),
            (mantissa, exponent) => I::shifted(mantissa, exponent.abs_diff(low)),
        }
    }
}

impl<I: Integer> Arithmetic for Lattice<I> {
    type Number = I;

    fn difference(&self, a: f64, b: f64) -> I {
        self.integer(a).minus(&self.integer(b))
    }

    fn weights(&self, a: f64, b: f64) -> I {
        Self::multiple(a, 2 * self.low).minus(&Self::multiple(b, 2 * self.low))
    }
}
