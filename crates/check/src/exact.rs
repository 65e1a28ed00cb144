//! Numbers of the judge: signs, the two traits every formula is written against, and who implements
//! them.
//!
//! A formula ([`crate::space`]) is written once, over an [`Arithmetic`]: something that turns the
//! difference of two coordinates into a [`Number`]. Three kinds of numbers run it:
//!
//! | numbers | what they know | when |
//! |---|---|---|
//! | [`Ball`](ball::Ball) | a double and its error bound | first, if [filtered](crate::Options) |
//! | `i128` on a [`Lattice`] | the value, if coordinates are short enough | next, if filtered |
//! | a big integer on a [`Lattice`] | the exact value, always | last; alone, if not filtered |
//!
//! No code here is shared with a predicate of the algorithms under judgement.

pub(crate) mod ball;
pub(crate) mod determinant;
#[cfg(feature = "rug")]
mod gmp;
pub(crate) mod lattice;
mod pure;
pub(crate) mod word;

pub(crate) use ball::Balls;
pub(crate) use lattice::Lattice;

/// The pure-Rust big integer.
pub(crate) type Pure = dashu_int::IBig;

/// The big integer of GMP.
#[cfg(feature = "rug")]
pub(crate) type Gmp = rug::Integer;

/// The sign of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Sign {
    Negative,
    Zero,
    Positive,
}

impl Sign {
    /// The sign of the product of two numbers with these signs.
    pub(crate) fn times(self, other: Self) -> Self {
        match (self, other) {
            (Self::Zero, _) | (_, Self::Zero) => Self::Zero,
            (a, b) if a == b => Self::Positive,
            _ => Self::Negative,
        }
    }

    /// The sign of the opposite number, if `negative`; else this sign.
    pub(crate) fn flipped_if(self, negative: bool) -> Self {
        if negative { self.times(Self::Negative) } else { self }
    }
}

/// An element of a commutative ring, without division.
pub(crate) trait Number: Clone {
    fn plus(&self, other: &Self) -> Self;
    fn minus(&self, other: &Self) -> Self;
    fn times(&self, other: &Self) -> Self;
    fn scaled(&self, factor: u32) -> Self;

    /// The sign, or `None` if these numbers do not know it.
    fn sign(&self) -> Option<Sign>;
}

/// An exact integer: it always knows its sign.
pub(crate) trait Integer: Number {
    /// `mantissa * 2^shift`.
    fn shifted(mantissa: i64, shift: u32) -> Self;

    /// The sign; never in doubt.
    fn exact_sign(&self) -> Sign;

    /// The first [`DIGITS`] binary digits of the magnitude, and how many follow them.
    fn magnitude(&self) -> (f64, u32);
}

/// Binary digits that a double holds.
pub(crate) const DIGITS: u32 = 53;

/// A way to compute with differences of coordinates.
pub(crate) trait Arithmetic {
    type Number: Number;

    /// `a - b`, times a positive factor that is the same in every call.
    fn difference(&self, a: f64, b: f64) -> Self::Number;

    /// `a - b`, times the square of that factor.
    fn weights(&self, a: f64, b: f64) -> Self::Number;
}

#[cfg(test)]
mod tests;
