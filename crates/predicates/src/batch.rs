//! Filters over many points or many simplices at once, by columns of coordinates.
//!
//! Each answer is that of the dynamic filter of the predicate, bit for bit: 1 and -1 are signs, 0 means uncertain and never
//! "zero"; whoever asks finishes those one by one. The loops have no calls, and the same operations on each lane, for the
//! compiler to make vectors of them, as wide as it may assume. Measured (`benches/records/batch.md`): 1.3 to 1.8
//! times as fast as one by one.
//!
//! ```
//! use delone_predicates::{Sign, batch, orient2d};
//! let (x, y) = ([0.0, 2.0, 1.0, 3.0], [1.0, 0.0, 1.0, 3.0]);
//! let (a, b) = ([0.0, 0.0], [4.0, 4.0]);
//! let mut signs = [0; 4];
//! assert_eq!(batch::orient2d(a, b, [&x, &y], &mut signs), 2);
//! assert_eq!(signs, [1, -1, 0, 0]);
//! assert_eq!(orient2d(a, b, [x[2], y[2]]), Sign::Zero);
//! ```

use crate::filter::{self, Certain};

#[cfg(test)]
mod tests;

/// The filter's answer in a byte.
#[inline(always)]
fn byte(answer: Certain) -> i8 {
    answer.map_or(0, |(sign, _)| sign as i8)
}

/// How many are uncertain.
fn uncertain(signs: &[i8]) -> usize {
    signs.iter().filter(|&&sign| sign == 0).count()
}

/// Columns cut to the number of answers.
fn cut<const D: usize>(columns: [&[f64]; D], count: usize) -> [&[f64]; D] {
    columns.map(|column| {
        assert!(column.len() >= count, "{} coordinates for {count} answers", column.len());
        &column[..count]
    })
}

/// A predicate of some fixed points and one that is taken from columns, and of one fixed point and others from columns.
macro_rules! batches {
    ($(
        $(#[$doc:meta])* $many:ident($($fixed:ident),*; $last:ident: $d:literal = [$($axis:ident),*])
            = |$points:ident| $filter:expr;
        $(#[$of_doc:meta])* $of:ident
    )*) => {$(
        $(#[$doc])*
        ///
        /// Fills `signs`, and returns how many are uncertain.
        ///
        /// # Panics
        /// If a column is shorter than `signs`.
        pub fn $many($($fixed: [f64; $d],)* $last: [&[f64]; $d], signs: &mut [i8]) -> usize {
            let [$($axis),*] = cut($last, signs.len());
            for (i, sign) in signs.iter_mut().enumerate() {
                let $points = [$(&$fixed,)* &[$($axis[i]),*]];
                *sign = byte($filter);
            }
            uncertain(signs)
        }

        $(#[$of_doc])*
        ///
        /// Fills `signs`, and returns how many are uncertain.
        ///
        /// # Panics
        /// If a column is shorter than `signs`.
        pub fn $of($($fixed: [&[f64]; $d],)* $last: [f64; $d], signs: &mut [i8]) -> usize {
            $(let $fixed = cut($fixed, signs.len());)*
            for (i, sign) in signs.iter_mut().enumerate() {
                $(let $fixed = $fixed.map(|column| column[i]);)*
                let $points = [$(&$fixed,)* &$last];
                *sign = byte($filter);
            }
            uncertain(signs)
        }
    )*};
}

batches! {
    /// [`orient2d`](crate::orient2d) of `a`, `b` and each of many points.
    orient2d(a, b; c: 2 = [x, y]) = |points| {
        filter::orient2d(points[0], points[1], points[2], f64::INFINITY)
    };
    /// [`orient2d`](crate::orient2d) of each of many pairs of points and `c`.
    orient2d_of

    /// [`in_circle`](crate::in_circle) of `a`, `b`, `c` and each of many points.
    in_circle(a, b, c; d: 2 = [x, y]) = |points| filter::in_circle(points, f64::INFINITY);
    /// [`in_circle`](crate::in_circle) of each of many triangles and `d`.
    in_circle_of

    /// [`orient3d`](crate::orient3d) of `a`, `b`, `c` and each of many points.
    orient3d(a, b, c; d: 3 = [x, y, z]) = |points| filter::orient3d(points, f64::INFINITY);
    /// [`orient3d`](crate::orient3d) of each of many triangles and `d`.
    orient3d_of
}

/// Lengths of the pieces of [`in_pieces`].
const PIECE: usize = 64;

/// The signs of values over their bounds; first all values of a piece, then all bounds. How many are uncertain.
///
/// in_sphere takes more numbers than there are registers. In one loop the compiler makes no lanes of calls, but pairs within a
/// call, with more moves than products: slower than one by one. Pieces are of one length, the last filled with zeros.
#[inline(always)]
fn in_pieces<const M: usize>(
    columns: [&[f64]; M],
    signs: &mut [i8],
    value: impl Fn([f64; M]) -> f64,
    bound: impl Fn([f64; M]) -> f64,
) -> usize {
    let mut start = 0;
    for signs in signs.chunks_mut(PIECE) {
        let mut piece = [[0.0; PIECE]; M];
        for (piece, column) in piece.iter_mut().zip(columns) {
            piece[..signs.len()].copy_from_slice(&column[start..start + signs.len()]);
        }
        let at = |i: usize| piece.each_ref().map(|column| column[i]);
        let (mut values, mut bounds) = ([0.0; PIECE], [0.0; PIECE]);
        values.iter_mut().enumerate().for_each(|(i, slot)| *slot = value(at(i)));
        bounds.iter_mut().enumerate().for_each(|(i, slot)| *slot = bound(at(i)));
        for ((sign, value), bound) in signs.iter_mut().zip(values).zip(bounds) {
            *sign = i8::from(value > bound) - i8::from(value < -bound);
        }
        start += signs.len();
    }
    uncertain(signs)
}

/// [`in_sphere`](crate::in_sphere) of `a`, `b`, `c`, `d` and each of many points.
///
/// Fills `signs`, and returns how many are uncertain.
///
/// # Panics
/// If a column is shorter than `signs`.
pub fn in_sphere(
    a: [f64; 3],
    b: [f64; 3],
    c: [f64; 3],
    d: [f64; 3],
    e: [&[f64]; 3],
    signs: &mut [i8],
) -> usize {
    let value = |e| filter::value::in_sphere([&a, &b, &c, &d, &e]);
    let bound = |e| filter::in_sphere_bound([&a, &b, &c, &d, &e]);
    in_pieces(cut(e, signs.len()), signs, value, bound)
}

/// [`in_sphere`](crate::in_sphere) of each of many tetrahedra and `e`.
///
/// Fills `signs`, and returns how many are uncertain.
///
/// # Panics
/// If a column is shorter than `signs`.
pub fn in_sphere_of(
    a: [&[f64]; 3],
    b: [&[f64]; 3],
    c: [&[f64]; 3],
    d: [&[f64]; 3],
    e: [f64; 3],
    signs: &mut [i8],
) -> usize {
    let corners = |[ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz]: [f64; 12]| {
        [[ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz]]
    };
    let value = |columns| {
        let [a, b, c, d] = &corners(columns);
        filter::value::in_sphere([a, b, c, d, &e])
    };
    let bound = |columns| {
        let [a, b, c, d] = &corners(columns);
        filter::in_sphere_bound([a, b, c, d, &e])
    };
    let [[ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz]] =
        [a, b, c, d].map(|columns| cut(columns, signs.len()));
    let columns = [ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz];
    in_pieces(columns, signs, value, bound)
}
