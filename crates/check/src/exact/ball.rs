//! The filter: a double with a bound on its error, good under underflow and overflow alike.
//!
//! A [`Ball`] `(mid, err)` stands for some real `x` with `|x - mid| <= err`. Let `u = 2^-53`. Round
//! to nearest gives, for a double operation with exact result `r` and rounded result `v`:
//!
//! * `a ± b`: `|v - r| <= u |v|` if `v` is finite (sums of doubles do not underflow inexactly);
//! * `a * b`: `|v - r| <= u |v| + 2^-1075` if `v` is finite.
//!
//! **Sum.** `|(x + y) - v| <= ea + eb + u |v|`.
//!
//! **Product.** With `x = a + dx` and `y = b + dy`,
//! `|xy - v| <= |a| eb + |b| ea + ea eb + u |v| + 2^-1075`.
//!
//! Both bounds are themselves computed in doubles, from terms that are not negative, in at most
//! eight roundings, each of which loses at most a factor `1 - u` or, when a product underflows, an
//! absolute `2^-1075`. The factor [`GROW`], `1 + 32u`, repays the first, since
//! `(1 - u)^8 (1 + 32u) > 1`; adding [`TINY`], `2^-1022`, repays the second, there being fewer than
//! 16 underflows.
//!
//! **Overflow.** If `v` is infinite or NaN then so is `u |v|`, hence `err`; an `err` that is
//! infinite or NaN stays so under both rules (terms that are not negative never cancel; `0 * inf`
//! is NaN). If `err` overflows by itself it is infinite. [`Ball::sign`] answers only when
//! `|mid| > err`, which is false if `err` is infinite or either is NaN. So an overflow anywhere
//! leads to "not known", never to a wrong sign.

use super::{Arithmetic, Number, Sign};

/// `1 + 2^-48`.
const GROW: f64 = 1.0 + 1.0 / 281_474_976_710_656.0;
/// `2^-1022`.
const TINY: f64 = f64::MIN_POSITIVE;
/// `2^-52`: twice the unit roundoff, so that it is not eaten up by its own rounding.
const ROUNDOFF: f64 = f64::EPSILON;

/// Some real within `err` of `mid`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball {
    mid: f64,
    err: f64,
}

impl Ball {
    fn widened(mid: f64, err: f64) -> Self {
        Self { mid, err: (err + mid.abs() * ROUNDOFF) * GROW + TINY }
    }
}

impl Number for Ball {
    fn plus(&self, other: &Self) -> Self {
        Self::widened(self.mid + other.mid, self.err + other.err)
    }

    fn minus(&self, other: &Self) -> Self {
        Self::widened(self.mid - other.mid, self.err + other.err)
    }

    fn times(&self, other: &Self) -> Self {
        let err = self.mid.abs() * other.err + other.mid.abs() * self.err + self.err * other.err;
        Self::widened(self.mid * other.mid, err)
    }

    fn scaled(&self, factor: u32) -> Self {
        self.times(&Self { mid: f64::from(factor), err: 0.0 })
    }

    fn sign(&self) -> Option<Sign> {
        if self.mid > self.err {
            Some(Sign::Positive)
        } else if self.mid < -self.err {
            Some(Sign::Negative)
        } else {
            None
        }
    }
}

/// The arithmetic of balls: differences of coordinates, rounded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Balls;

impl Arithmetic for Balls {
    type Number = Ball;

    fn difference(&self, a: f64, b: f64) -> Ball {
        Ball::widened(a - b, 0.0)
    }

    fn weights(&self, a: f64, b: f64) -> Ball {
        self.difference(a, b)
    }
}
