//! Filters in more than three axes: the determinant and the permanent of all subsets of rows together.
//!
//! The recurrence is that of `exact/any.rs`, in doubles: a minor of j columns is a sum of j products of a difference and
//! a minor of j - 1 columns.
//!
//! **The bound.** Let rho(j) count the roundings on the longest path to a minor of j columns: rho(1) = 1, the difference;
//! then one for the difference, one for the product, j - 1 for the sum: rho(j) = rho(j - 1) + j + 1, so
//! rho(j) = (j (j + 3) - 2) / 2, at most 34 for j = 7. A height of D squares has D + 2 (each square two differences and a
//! product, the sum D - 1), one more each if a difference of weights is added: the sum, and no more roundings than the
//! squares have. A lifted determinant of k + 1 rows has rho(k) + (D + 3) + 1 + k. With rho <= 60 for all, the error is
//! at most ((1 + u)^rho - 1) times the exact permanent, and that at most (1 - u)^-rho times the computed one; together
//! below rho u (1 + 4 rho u) < (rho + 1/2) u, and the constant (rho + 1) u leaves room for its own product.
//!
//! **Underflow.** The j products of a sum lose at most j 2^-1075 <= 2^-1072 together, a height of seven squares no more.
//! Each magnitude sum has the guard 2^-1020 (`filter.rs`); times (rho + 1) u >= 8 * 2^-53 that is 2^-1070.

use super::{Certain, GUARD, U};
use crate::exact::AXES_MAX;
use crate::{Sign, Stage};

const ROWS: usize = AXES_MAX + 1;

/// Differences to the last point, by rows.
type Rows = [[f64; AXES_MAX]; ROWS];

/// The sign of a determinant, from its value, its permanent and the roundings on its longest path.
#[inline]
pub(crate) fn certain((value, permanent): (f64, f64), roundings: usize) -> Option<Sign> {
    let roundings = u8::try_from(roundings).expect("roundings are at most 60");
    let bound = (f64::from(roundings) + 1.0) * U * permanent;
    (value.abs() > bound).then(|| Sign::of(value))
}

/// Roundings on the longest path to a minor of `k` columns.
fn roundings(k: usize) -> usize {
    (k * (k + 3) - 2) / 2
}

fn rows<const D: usize>(points: &[&[f64; D]], last: &[f64; D]) -> Rows {
    let mut rows = [[0.0; AXES_MAX]; ROWS];
    for (row, point) in rows.iter_mut().zip(points) {
        for axis in 0..D {
            row[axis] = point[axis] - last[axis];
        }
    }
    rows
}

/// The orientation of D+1 points of R^D.
pub(crate) fn orient<const D: usize>(points: &[&[f64; D]]) -> Certain {
    let (last, points) = points.split_last()?;
    let rows = rows(points, last);
    let sign = certain(minors_of(D, &rows, None), roundings(D))?;
    Some((sign.times_minus_one_to(D), Stage::DynamicFilter))
}

/// The lifted determinant of D+2 points of R^D, with their weights if they have any; signed as
/// [`crate::Kernel::lifted`] is.
pub(crate) fn lifted<const D: usize>(points: &[&[f64; D]], weights: Option<&[f64]>) -> Certain {
    let (last, points) = points.split_last()?;
    let rows = rows(points, last);
    let mut heights = [(0.0, 0.0); ROWS];
    for (i, height) in heights.iter_mut().enumerate().take(points.len()) {
        let squares = rows[i][..D].iter().map(|d| d * d).sum::<f64>();
        let weight = weights.map_or(0.0, |weights| weights[D + 1] - weights[i]);
        *height = (squares + weight, squares + weight.abs() + GUARD);
    }
    let roundings = roundings(D) + (D + 3) + 1 + D;
    let sign = certain(minors_of(D, &rows, Some(&heights)), roundings)?;
    Some((sign.times_minus_one_to(D), Stage::DynamicFilter))
}

/// The orientation on some axes in plain doubles.
pub(crate) fn orient_value<const D: usize>(points: &[&[f64; D]], axes: &[usize]) -> f64 {
    let Some((last, points)) = points.split_last() else { return 0.0 };
    let value = minors_of(axes.len(), &on_axes(&rows(points, last), axes), None).0;
    if axes.len() % 2 == 1 { -value } else { value }
}

/// The lifted determinant on some axes in plain doubles.
pub(crate) fn lifted_value<const D: usize>(points: &[&[f64; D]], axes: &[usize]) -> f64 {
    let Some((last, points)) = points.split_last() else { return 0.0 };
    let rows = rows(points, last);
    let heights = rows.map(|row| (row.iter().map(|d| d * d).sum(), 0.0));
    let value = minors_of(axes.len(), &on_axes(&rows, axes), Some(&heights)).0;
    if axes.len() % 2 == 1 { -value } else { value }
}

fn on_axes(rows: &Rows, axes: &[usize]) -> Rows {
    rows.map(|row| std::array::from_fn(|column| axes.get(column).map_or(0.0, |&axis| row[axis])))
}

/// The determinant and the permanent of `k` columns, and a last column of heights if there is one.
fn minors_of(k: usize, rows: &Rows, heights: Option<&[(f64, f64); ROWS]>) -> (f64, f64) {
    let n = k + usize::from(heights.is_some());
    let entry = |row: usize, column: usize| match heights {
        Some(heights) if column == k => heights[row],
        _ => (rows[row][column], rows[row][column].abs()),
    };
    match n {
        0..=4 => minors::<16>(n, entry),
        5 => minors::<32>(n, entry),
        6 => minors::<64>(n, entry),
        _ => minors::<256>(n, entry),
    }
}

/// The determinant and the permanent of n rows and columns of values and magnitudes; M is at least 2^n.
#[inline(always)]
pub(crate) fn minors<const M: usize>(
    n: usize,
    entry: impl Fn(usize, usize) -> (f64, f64),
) -> (f64, f64) {
    let mut minors = [(1.0, 1.0); M];
    let all = (1usize << n) - 1;
    for set in 1..=all {
        let column = set.count_ones() as usize - 1;
        let (mut sum, mut magnitude) = (0.0, 0.0);
        let mut rest = set;
        let mut negative = column % 2 == 1;
        while rest != 0 {
            let row = rest.trailing_zeros() as usize;
            rest &= rest - 1;
            let (minor, minor_magnitude) = minors[set ^ 1 << row];
            let (entry, entry_magnitude) = entry(row, column);
            sum += if negative { -entry * minor } else { entry * minor };
            magnitude += entry_magnitude * minor_magnitude;
            negative = !negative;
        }
        minors[set] = (sum, magnitude + GUARD);
    }
    minors[all]
}
