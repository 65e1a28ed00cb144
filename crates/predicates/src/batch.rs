//! Filters over many points or many simplices at once, by columns of coordinates.
//!
//! Each answer is that of the dynamic filter of the predicate, bit for bit: 1 and -1 are signs, 0 means uncertain and never
//! "zero"; whoever asks finishes those one by one. The loops have no calls, and the same operations on each lane, for the
//! compiler to make vectors of them, as wide as it may assume. Measured (`benches/records/batch.md`): about twice as fast as
//! one by one in orient2d, in_circle and orient3d; slower in in_sphere.
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

    /// [`in_sphere`](crate::in_sphere) of `a`, `b`, `c`, `d` and each of many points.
    in_sphere(a, b, c, d; e: 3 = [x, y, z]) = |points| filter::in_sphere(points, f64::INFINITY);
    /// [`in_sphere`](crate::in_sphere) of each of many tetrahedra and `e`.
    in_sphere_of
}
