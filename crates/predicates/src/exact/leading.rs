//! Determinants with a column of ones in doubles, decided by their leading terms: what is tried before long sums.
//!
//! **Why.** Where exponents lie hundreds apart, differences to a large last point cancel all that the other points say, and
//! products leave the range of doubles; filters then fail. But few monomials of such a determinant are of
//! the largest magnitude, as a rule one. So nothing is translated, and exponents are kept apart from mantissas until
//! columns, and then rows, have been scaled by powers of two to have a largest entry of one size: no product
//! overflows, and what underflows is far below the leading terms. Powers of two are positive: no sign changes.
//!
//! **The bound** is that of `filter/any.rs`. Entries are not rounded but for heights: squares, their sum, and a weight are at most
//! D + 1 roundings, and one more is for what is dropped, below 2^-1000 of the magnitude. A minor of j columns is a
//! sum of j products of an entry and a minor of j - 1: j more roundings. So N columns have N (N + 1) / 2, and with heights
//! D + 2 more: at most 54, and the constant is one more.
//!
//! **Range.** Entries are below 2^(T + 6), T being [`top`]: a mantissa below 2, or a height below 4 * 7, or one and a weight, below 2^6.
//! N! products of N are below 2^(N (T + 6) + 19) <= 2^979. An entry below 2^(-1010 + 6) may be dropped: its
//! magnitude counts as 2^-950, of which the bound, at least 4 u, makes 2^-1001. Products that underflow are covered by
//! the guards, 4 u * 2^-1020 = 2^-1071 for at most nine products of a sum, which lose 2^-1075 each.
//!
//! **Out.** `None` means uncertain; a determinant that is zero always is.

use super::{AXES_MAX, POINTS_MAX};
use crate::Sign;
use crate::filter::any::{certain, minors};

/// `mantissa * 2^exponent`, off by a few roundings of `magnitude * 2^exponent`; the exponent of zero is [`NOTHING`].
#[derive(Clone, Copy)]
struct Entry {
    mantissa: f64,
    magnitude: f64,
    exponent: i32,
}

/// Below all exponents, and far from the ends of the type.
const NOTHING: i32 = i32::MIN / 4;

/// Entries of a smaller exponent are dropped.
const DROPPED: i32 = -1010;

/// The magnitude of an entry that was dropped.
const REST: f64 = power_of_two(-950);

/// The largest exponent of the entries of N columns.
const fn top(columns: i32) -> i32 {
    960 / columns - 6
}

/// A normal number.
const fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits((1023 + exponent as i64).cast_unsigned() << 52)
}

impl Entry {
    const ZERO: Self = Self { mantissa: 0.0, magnitude: 0.0, exponent: NOTHING };
    const ONE: Self = Self { mantissa: 1.0, magnitude: 1.0, exponent: 0 };

    /// Exactly, the magnitude in 1..2, or zero.
    #[inline(always)]
    fn of(value: f64) -> Self {
        const DENORMAL: i32 = 100;
        if value == 0.0 {
            return Self::ZERO;
        }
        let denormal = value.abs() < f64::MIN_POSITIVE;
        let bits = (if denormal { value * power_of_two(DENORMAL) } else { value }).to_bits();
        let mantissa = f64::from_bits(bits & !(0x7ff << 52) | 1023 << 52);
        let field = i32::from(u16::try_from(bits >> 52 & 0x7ff).expect("eleven bits"));
        let exponent = field - 1023 - if denormal { DENORMAL } else { 0 };
        Self { mantissa, magnitude: mantissa.abs(), exponent }
    }

    /// Value and magnitude over `2^exponent`.
    #[inline(always)]
    fn over(self, exponent: i32) -> (f64, f64) {
        let exponent = self.exponent - exponent;
        if exponent >= DROPPED {
            let unit = power_of_two(exponent);
            (self.mantissa * unit, self.magnitude * unit)
        } else {
            (0.0, if self.magnitude == 0.0 { 0.0 } else { REST })
        }
    }

    /// The sum of the squares of a point's coordinates, less a weight.
    #[inline(always)]
    fn height(point: &[f64], weight: f64) -> Self {
        let coordinates = point.iter().map(|&x| Self::of(x));
        let largest = coordinates.clone().map(|x| x.exponent).max().unwrap_or(NOTHING);
        let weight = Self::of(-weight);
        if largest == NOTHING {
            return weight;
        }
        let squares = coordinates.map(|x| x.over(largest).0).map(|x| x * x).sum::<f64>();
        let exponent = weight.exponent.max(2 * largest);
        let squares = Self { mantissa: squares, magnitude: squares, exponent: 2 * largest };
        let (squares, weight) = (squares.over(exponent).0, weight.over(exponent).0);
        Self { mantissa: squares + weight, magnitude: squares + weight.abs(), exponent }
    }
}

/// The sign of `det[p_i 1]` on the given axes.
pub(super) fn orient(points: &[&[f64]], axes: &[usize]) -> Option<Sign> {
    let sign = match axes.len() {
        2 => of_columns::<3, 8>(points, axes, None),
        3 => of_columns::<4, 16>(points, axes, None),
        4 => of_columns::<5, 32>(points, axes, None),
        5 => of_columns::<6, 64>(points, axes, None),
        6 => of_columns::<7, 128>(points, axes, None),
        AXES_MAX => of_columns::<8, 256>(points, axes, None),
        _ => None,
    };
    // The ones come last here.
    sign.map(|sign| sign.times_minus_one_to(axes.len()))
}

/// The sign of `det[1 p_i h_i]` on the given axes, as `long::lifted`.
pub(super) fn lifted(points: &[&[f64]], axes: &[usize], weights: Option<&[f64]>) -> Option<Sign> {
    let mut heights = [Entry::ZERO; POINTS_MAX];
    for (i, height) in heights.iter_mut().enumerate().take(points.len()) {
        *height = Entry::height(points[i], weights.map_or(0.0, |weights| weights[i]));
    }
    let heights = Some(&heights);
    let sign = match axes.len() {
        1 => of_columns::<3, 8>(points, axes, heights),
        2 => of_columns::<4, 16>(points, axes, heights),
        3 => of_columns::<5, 32>(points, axes, heights),
        4 => of_columns::<6, 64>(points, axes, heights),
        5 => of_columns::<7, 128>(points, axes, heights),
        6 => of_columns::<8, 256>(points, axes, heights),
        AXES_MAX => of_columns::<9, 512>(points, axes, heights),
        _ => None,
    };
    sign.map(|sign| sign.times_minus_one_to(axes.len() + 1))
}

/// The sign of the determinant of N rows of coordinates on the axes, a height if there is one, and one; M is 2^N.
#[inline(never)]
fn of_columns<const N: usize, const M: usize>(
    points: &[&[f64]],
    axes: &[usize],
    heights: Option<&[Entry; POINTS_MAX]>,
) -> Option<Sign> {
    let mut rows = [[Entry::ONE; N]; N];
    for (i, row) in rows.iter_mut().enumerate() {
        for (slot, &axis) in row.iter_mut().zip(axes) {
            *slot = Entry::of(points[i][axis]);
        }
        if let Some(heights) = heights {
            row[N - 2] = heights[i];
        }
    }
    let rows = scaled(rows)?;
    let roundings = N * (N + 1) / 2 + heights.map_or(0, |_| points[0].len() + 2);
    certain(minors::<M>(N, |row, column| rows[row][column]), roundings)
}

/// Columns, then rows, by powers of two; nothing if a column is zero.
#[inline(always)]
fn scaled<const N: usize>(mut rows: [[Entry; N]; N]) -> Option<[[(f64, f64); N]; N]> {
    for column in 0..N {
        let largest = rows.iter().map(|row| row[column].exponent).max()?;
        if largest == NOTHING {
            return None;
        }
        for row in &mut rows {
            row[column].exponent -= largest;
        }
    }
    let top = top(i32::try_from(N).expect("few columns"));
    Some(rows.map(|row| {
        let largest = row.iter().map(|entry| entry.exponent).max().unwrap_or(0);
        row.map(|entry| entry.over(largest - top))
    }))
}

#[cfg(test)]
mod tests;
