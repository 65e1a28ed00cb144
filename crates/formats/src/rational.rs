//! Coordinates written `p/q`, rounded once to the nearest double.
//!
//! The quotient of the integers is developed in binary until 64 significant bits are there, the rest goes into one
//! sticky bit, and the conversion of that integer rounds to nearest, ties to even; the final scaling by a power of
//! two is exact (integers of at most 38 digits never reach the subnormal range).

use crate::text::parse_number;

/// A coordinate and whether it was rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rounded {
    pub(crate) value: f64,
    pub(crate) inexact: bool,
}

/// A decimal number or `p/q` with whole `p` and positive `q` below 2^126.
pub(crate) fn parse_coordinate(text: &str) -> Option<Rounded> {
    let Some((p, q)) = text.split_once('/') else {
        return parse_number(text).map(|value| Rounded { value, inexact: false });
    };
    let negative = p.starts_with('-');
    let digits = p.strip_prefix(['-', '+']).unwrap_or(p);
    let whole = |s: &str| -> Option<u128> {
        s.bytes().all(|b| b.is_ascii_digit()).then(|| s.parse().ok())?
    };
    let (p, q) = (whole(digits)?, whole(q)?);
    if q == 0 || p >> 126 != 0 || q >> 126 != 0 {
        return None;
    }
    let mut rounded = divide(p, q);
    if negative {
        rounded.value = -rounded.value;
    }
    Some(rounded)
}

fn divide(p: u128, q: u128) -> Rounded {
    let (mut quotient, mut rest) = (p / q, p % q);
    let mut exponent = 0_i32;
    // Each turn adds one bit; 64 significant ones take at most 64 + 126 turns.
    while rest != 0 && quotient >> 64 == 0 {
        rest <<= 1;
        quotient = (quotient << 1) | u128::from(rest >= q);
        rest = if rest >= q { rest - q } else { rest };
        exponent -= 1;
    }
    let sticky = quotient | u128::from(rest != 0);
    let mantissa = sticky as f64;
    let inexact = rest != 0 || sticky.checked_ilog2().unwrap_or(0) >= 53 + sticky.trailing_zeros();
    Rounded { value: mantissa * 2.0_f64.powi(exponent), inexact }
}

#[cfg(test)]
mod tests;
