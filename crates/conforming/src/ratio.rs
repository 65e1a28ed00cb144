//! Ratios and their square roots to any precision, shorter numbers near long ones, and powers of two at least and at most: where shells and feet meet segments.
//!
//! **Method.** Newton's, in exact arithmetic: with x near sqrt(n / d), the residual n - d x^2 is exact, and the correction, one
//! double, makes 48 more bits right. So the root is a sum of doubles, as many as the precision asks for. Of n / d itself the residual is n - d x.

use delone_predicates::{Dyadic, Sign};

/// Bits that one correction makes right.
const GAIN: u32 = 48;

/// `sqrt(n / d)` for positive `n` and `d`, off by less than `2^-bits` of itself.
pub(crate) fn root(n: &Dyadic, d: &Dyadic, bits: u32) -> Dyadic {
    let top = |x: &Dyadic| x.magnitude().expect("lengths are positive");
    // Both in [1, 4), their ratio times an even power of two.
    let (of_n, of_d) = (top(n), top(d));
    let odd = (of_n - of_d).rem_euclid(2);
    let (n, d) = (n.clone().scaled(odd - of_n), d.clone().scaled(-of_d));
    let near_d = d.to_f64();
    let first = (n.to_f64() / near_d).sqrt();
    let mut root = Dyadic::from(first);
    for _ in 0..bits.div_ceil(GAIN) {
        let residual = n.clone() - &d * &(&root * &root);
        if residual.sign() == Sign::Zero {
            break;
        }
        let size = top(&residual);
        let correction = residual.scaled(-size).to_f64() / (2.0 * near_d * first);
        root += &Dyadic::from(correction).scaled(size);
    }
    root.scaled((of_n - of_d - odd) / 2)
}

/// `n / d` for positive `n` and `d`, off by less than `2^-bits` of itself.
pub(crate) fn quotient(n: &Dyadic, d: &Dyadic, bits: u32) -> Dyadic {
    let (Some(of_n), Some(of_d)) = (n.magnitude(), d.magnitude()) else { return Dyadic::ZERO };
    let (n, d) = (n.clone().scaled(-of_n), d.clone().scaled(-of_d));
    let near_d = d.to_f64();
    let mut quotient = Dyadic::from(n.to_f64() / near_d);
    for _ in 1..bits.div_ceil(GAIN) {
        let residual = n.clone() - &d * &quotient;
        let Some(size) = residual.magnitude() else { break };
        let correction = residual.scaled(-size).to_f64() / near_d;
        quotient += &Dyadic::from(correction).scaled(size);
    }
    quotient.scaled(of_n - of_d)
}

/// A number off by less than `2^unit`.
pub(crate) fn rounded(x: &Dyadic, unit: i64) -> Dyadic {
    let mut near = Dyadic::ZERO;
    loop {
        let left = x.clone() - &near;
        let Some(size) = left.magnitude().filter(|&size| size >= unit) else { return near };
        near += &Dyadic::from(left.scaled(-size).to_f64()).scaled(size);
    }
}

/// The greatest k such that `4^k <= square`, which is positive.
pub(crate) fn log4(square: &Dyadic) -> i64 {
    square.magnitude().expect("lengths are positive").div_euclid(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// |x - sqrt(n / d)| <= e x follows from (1 - e)^2 <= n / (d x^2) <= (1 + e)^2, here with e = 2^-bits.
    fn check(n: &Dyadic, d: &Dyadic, bits: u32) {
        let x = root(n, d, bits);
        let e = Dyadic::from(1).scaled(-i64::from(bits));
        let one = Dyadic::from(1);
        let square = |y: Dyadic| &y * &y;
        let dx2 = d * &square(x);
        assert!(&square(one.clone() - &e) * &dx2 <= *n, "{bits}");
        assert!(*n <= &square(one.clone() + &e) * &dx2, "{bits}");
        let dx = d * &quotient(n, d, bits);
        assert!(&(one.clone() - &e) * &dx <= *n && *n <= &(one + &e) * &dx, "{bits}");
    }

    #[test]
    fn ratios_and_roots_are_as_precise_as_asked() {
        let values = [1.0, 2.0, 3.0, 0.1, 7e-300, 1e300, 5e-324, f64::MAX, 1.0 + f64::EPSILON];
        for n in values.map(Dyadic::from) {
            for d in values.map(Dyadic::from) {
                for bits in [50, 52, 96, 300, 2300] {
                    check(&n, &d, bits);
                }
            }
        }
    }

    #[test]
    fn rounding_is_by_less_than_a_unit_and_makes_numbers_short() {
        let long =
            (0..40i64).fold(Dyadic::ZERO, |x, i| x + Dyadic::from(1.0 / 3.0).scaled(-50 * i));
        for unit in [3, 0, -10, -60, -300, -1500] {
            for x in [long.clone(), -long.clone(), Dyadic::ZERO] {
                let near = rounded(&x, unit);
                let off = x - &near;
                assert!(off.magnitude().is_none_or(|size| size < unit), "{unit}");
                let limbs = near.mantissa().len();
                assert!(
                    i64::try_from(limbs).unwrap() <= (-unit).max(0) / 64 + 2,
                    "{unit}: {limbs}"
                );
            }
        }
    }

    #[test]
    fn powers_of_two_are_bracketed() {
        for (square, k) in [(1.0, 0), (3.9, 0), (4.0, 1), (0.99, -1), (0.25, -1), (0.2, -2)] {
            assert_eq!(log4(&Dyadic::from(square)), k, "{square}");
        }
    }
}
