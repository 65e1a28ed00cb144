//! Orientation in the plane by a sum of doubles without error: where exponents lie too far apart for few limbs, but products of
//! two coordinates stay inside the range of doubles.
//!
//! **Paper** \[ORO05\]: `VecSum`. A pass over numbers adds them up and leaves behind each the rounding error of its
//! addition, so that the numbers still have the same sum, the last one nearly all of it. Products are split into a double and its error \[She97\].
//!
//! **Certain** if the last number is larger than twice the computed sum of the others' magnitudes (the computed sum of 11 magnitudes is more than half of
//! the true one), or if the others are all zero. After [`PASSES`] passes the caller goes on to what always ends.
//!
//! **Range.** Coordinates are zero or of exponents within ±[`RANGE`]. A product is then zero or at least 2^-900, and a
//! multiple of 2^-1004: its error is a double. The largest sum, 12 * 2^902, and splitting, 2^478, do not overflow. Sums of doubles never underflow.

use crate::Sign;

/// The largest exponent of a coordinate, and the smallest but for the sign.
const RANGE: u64 = 450;

/// Passes before giving up: degenerate input mostly cancels in the first.
const PASSES: usize = 3;

/// The sum of two numbers and its rounding error \[She97, theorem 7\].
#[inline(always)]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    let of_a = sum - of_b;
    (sum, (a - of_a) + (b - of_b))
}

/// A number in two halves of at most 26 bits \[She97, theorem 17\].
#[derive(Clone, Copy)]
struct Halves {
    whole: f64,
    high: f64,
    low: f64,
}

impl Halves {
    #[inline(always)]
    fn of(whole: f64) -> Self {
        const SPLITTER: f64 = 134_217_729.0; // 2^27 + 1
        let big = SPLITTER * whole;
        let high = big - (big - whole);
        Self { whole, high, low: whole - high }
    }

    /// The product and its rounding error \[She97, theorem 18\].
    #[inline(always)]
    fn times(self, other: Self) -> (f64, f64) {
        let product = self.whole * other.whole;
        let rest = product - self.high * other.high;
        let rest = rest - self.low * other.high - self.high * other.low;
        (product, self.low * other.low - rest)
    }
}

/// The orientation of three points in the plane, if it is certain.
#[inline(never)]
pub(super) fn orient2d(values: &[f64; 6]) -> Option<Sign> {
    let fields = 1023 - RANGE..1023 + RANGE;
    if !values.iter().all(|x| *x == 0.0 || fields.contains(&(x.abs().to_bits() >> 52))) {
        return None;
    }
    let [ax, ay, bx, by, cx, cy] = values.map(Halves::of);
    let plus = [ax.times(by), bx.times(cy), cx.times(ay)];
    let minus = [ay.times(bx), by.times(cx), cy.times(ax)];
    let mut terms = [0.0; 12];
    for i in 0..3 {
        // What cancels stands side by side.
        terms[2 * i] = plus[i].0;
        terms[2 * i + 1] = -minus[i].0;
        terms[6 + 2 * i] = plus[i].1;
        terms[7 + 2 * i] = -minus[i].1;
    }
    (0..PASSES).find_map(|_| pass(&mut terms))
}

/// One pass over the terms, and the sign of their sum if it is certain then.
#[inline(always)]
fn pass<const N: usize>(terms: &mut [f64; N]) -> Option<Sign> {
    let mut rest = 0.0;
    for i in 1..N {
        (terms[i], terms[i - 1]) = two_sum(terms[i], terms[i - 1]);
        rest += terms[i - 1].abs();
    }
    let sum = terms[N - 1];
    (rest == 0.0 || sum.abs() > 2.0 * rest).then(|| Sign::of(sum))
}

#[cfg(test)]
mod tests;
