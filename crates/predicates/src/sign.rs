//! What a predicate answers: [`Sign`] before the symbolic perturbation, [`Side`] after it.

use std::cmp::Ordering;
use std::ops::{Mul, Neg};

/// The sign of a determinant: the answer of a plain predicate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(i8)]
pub enum Sign {
    /// Less than zero: a right turn, outside.
    Negative = -1,
    /// Exactly zero: degenerate.
    Zero = 0,
    /// Greater than zero: a left turn, inside.
    Positive = 1,
}

/// What is left after the symbolic perturbation: there is no tie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Side {
    /// Outside.
    Negative,
    /// Inside.
    Positive,
}

impl Sign {
    /// The sign of `value` against zero.
    #[inline]
    #[must_use]
    pub fn of(value: f64) -> Self {
        // Without branches: nobody can predict it.
        match i8::from(value > 0.0) - i8::from(value < 0.0) {
            1 => Self::Positive,
            0 => Self::Zero,
            _ => Self::Negative,
        }
    }

    /// This sign as the answer to "strictly inside?", if it is not a tie.
    #[inline]
    #[must_use]
    pub fn side(self) -> Option<Side> {
        match self {
            Self::Negative => Some(Side::Negative),
            Self::Zero => None,
            Self::Positive => Some(Side::Positive),
        }
    }

    /// The sign times -1 to the power `n`.
    #[inline]
    #[must_use]
    pub fn times_minus_one_to(self, n: usize) -> Self {
        if n % 2 == 1 { -self } else { self }
    }
}

impl From<Ordering> for Sign {
    #[inline]
    fn from(ordering: Ordering) -> Self {
        match ordering {
            Ordering::Less => Self::Negative,
            Ordering::Equal => Self::Zero,
            Ordering::Greater => Self::Positive,
        }
    }
}

impl Neg for Sign {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        match self {
            Self::Negative => Self::Positive,
            Self::Zero => Self::Zero,
            Self::Positive => Self::Negative,
        }
    }
}

impl Mul for Sign {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        match self {
            Self::Negative => -other,
            Self::Zero => Self::Zero,
            Self::Positive => other,
        }
    }
}

impl Side {
    /// Whether this is [`Side::Positive`].
    #[inline]
    #[must_use]
    pub fn is_inside(self) -> bool {
        self == Self::Positive
    }
}
