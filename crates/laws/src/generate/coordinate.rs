//! Coordinates of the kinds on which algorithms fail.

use crate::choices::Choices;
use crate::exact::{nudged, power_of_two};

/// What most coordinates of a case are like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Palette {
    /// Integers up to this, either sign: exact degeneracies by the dozen.
    Integers(i32),
    /// Integers, nudged by a few units in the last place.
    Nudged,
    /// Tenths, which are no doubles: almost degenerate.
    Tenths,
    /// Any mixture, powers of two over the full range and the ends of it among them.
    Mixed,
    /// Any finite bits.
    Bits,
}

impl Palette {
    /// One of them.
    pub fn choose(choices: &mut dyn Choices) -> Self {
        match choices.below(12) {
            0..3 => Self::Integers(2),
            3..5 => Self::Integers(4),
            5 => Self::Integers(40),
            6 => Self::Integers(1000),
            7 | 8 => Self::Nudged,
            9 => Self::Tenths,
            10 => Self::Mixed,
            _ => Self::Bits,
        }
    }
}

/// A finite double.
pub fn coordinate(palette: Palette, choices: &mut dyn Choices) -> f64 {
    match palette {
        Palette::Integers(max) => f64::from(choices.integer(-max, max)),
        Palette::Nudged => nudged(f64::from(choices.integer(-4, 4)), choices.integer(-2, 2)),
        Palette::Tenths => f64::from(choices.integer(-20, 20)) / 10.0,
        Palette::Mixed => mixed(choices),
        Palette::Bits => {
            // The largest exponent is that of infinity and NaN: its lowest bit is cleared.
            let bits = choices.bits();
            let x = f64::from_bits(bits);
            if x.is_finite() { x } else { f64::from_bits(bits & !(1 << 52)) }
        }
    }
}

fn mixed(choices: &mut dyn Choices) -> f64 {
    match choices.below(8) {
        0 => power_of_two(choices.integer(-1074, 1023)) * [1.0, -1.0][choices.index(2)],
        1 => [0.0, -0.0, 5e-324, f64::MAX, -f64::MAX, f64::MIN_POSITIVE][choices.index(6)],
        2 => coordinate(Palette::Tenths, choices),
        3 => coordinate(Palette::Nudged, choices),
        _ => coordinate(Palette::Integers(4), choices),
    }
}
