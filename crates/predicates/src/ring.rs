//! Predicates over any ring: one formula for doubles with an error bound, for exact numbers of ours, and for those of
//! another crate.
//!
//! A point is homogeneous, (X : W) with W > 0, the coordinates being X / W. Determinants are scaled by powers of the W of
//! their points, which change no sign.
//!
//! **Invariants.** 1. W > 0: whoever makes a point turns its signs so. 2. A point with W = 1 can be the reference: differences to
//! it are taken, which makes the determinant smaller by one row. Where no point of a call has W = 1, the column of the W
//! stays.

use std::ops::{AddAssign, Mul, Neg, Sub, SubAssign};

use num_traits::{One, Zero};
use smallvec::SmallVec;

/// What determinants need of a number: sums, differences, products, zero and one.
///
/// Every type that has these is one: integers and rationals of any length, as those of `num-bigint` and, with its feature
/// `num-traits`, `rug`. A kernel over a type whose operations overflow is as wrong as they are.
pub trait Ring:
    Clone
    + PartialEq
    + Zero
    + One
    + Sub<Output = Self>
    + Neg<Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
    + for<'a> AddAssign<&'a Self>
    + for<'a> SubAssign<&'a Self>
{
}

impl<T> Ring for T where
    T: Clone
        + PartialEq
        + Zero
        + One
        + Sub<Output = T>
        + Neg<Output = T>
        + for<'a> Mul<&'a T, Output = T>
        + for<'a> AddAssign<&'a T>
        + for<'a> SubAssign<&'a T>
{
}

/// A point with coordinates `x / w`, `w` being positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Homogeneous<T, const D: usize> {
    /// The numerators.
    pub x: [T; D],
    /// The common denominator, positive.
    pub w: T,
}

impl<T: Ring, const D: usize> Homogeneous<T, D> {
    /// The point with these coordinates.
    pub fn plain(x: [T; D]) -> Self {
        Self { x, w: T::one() }
    }

    /// The numerator of a coordinate over the weights of this point and of `origin`, relative to which it is taken.
    fn from(&self, origin: &Self, axis: usize) -> T {
        minus(times(&self.x[axis], &origin.w), &times(&origin.x[axis], &self.w))
    }

    /// All coordinates [from](Self::from) the origin.
    pub(crate) fn all_from(&self, origin: &Self) -> [T; D] {
        std::array::from_fn(|axis| self.from(origin, axis))
    }
}

/// The product; nothing to do if `b` is one.
pub(crate) fn times<T: Ring>(a: &T, b: &T) -> T {
    if b.is_one() { a.clone() } else { a.clone() * b }
}

pub(crate) fn minus<T: Ring>(mut a: T, b: &T) -> T {
    a -= b;
    a
}

/// The sum of products in pairs.
pub(crate) fn dot<T: Ring>(a: &[T], b: &[T]) -> T {
    let mut sum = T::zero();
    for (a, b) in a.iter().zip(b) {
        sum += &(a.clone() * b);
    }
    sum
}

/// `a d - b c`.
pub(crate) fn minor<T: Ring>(a: &T, b: &T, c: &T, d: &T) -> T {
    minus(a.clone() * d, &(b.clone() * c))
}

/// A square matrix, row by row.
pub(crate) struct Matrix<T> {
    entries: SmallVec<[T; 16]>,
    size: usize,
}

impl<T: Ring> Matrix<T> {
    /// Without rows yet.
    pub(crate) fn new(size: usize) -> Self {
        Self { entries: SmallVec::new(), size }
    }

    pub(crate) fn push(&mut self, entry: T) {
        self.entries.push(entry);
    }

    fn at(&self, row: usize, column: usize) -> &T {
        &self.entries[row * self.size + column]
    }

    fn minor2(&self, [i, j]: [usize; 2]) -> T {
        minor(self.at(i, 0), self.at(i, 1), self.at(j, 0), self.at(j, 1))
    }

    /// The determinant: up to three rows by cofactors, more by minors of subsets of the rows.
    pub(crate) fn determinant(&self) -> T {
        debug_assert_eq!(self.entries.len(), self.size * self.size, "a square matrix");
        match self.size {
            0 => T::one(),
            1 => self.at(0, 0).clone(),
            2 => self.minor2([0, 1]),
            3 => {
                let mut sum = self.minor2([0, 1]) * self.at(2, 2);
                sum -= &(self.minor2([0, 2]) * self.at(1, 2));
                sum += &(self.minor2([1, 2]) * self.at(0, 2));
                sum
            }
            _ => self.determinants().1,
        }
    }

    /// The determinant without the last row and column, and with them; of at least one row.
    ///
    /// As `exact/any.rs`: the minor of the first j columns and a set of j rows, from those of j - 1.
    pub(crate) fn determinants(&self) -> (T, T) {
        let all = (1usize << self.size) - 1;
        let mut minors: SmallVec<[T; 16]> = SmallVec::with_capacity(all + 1);
        minors.push(T::one());
        for set in 1..=all {
            let column = set.count_ones() as usize - 1;
            let mut sum = T::zero();
            let mut negative = column % 2 == 1;
            for row in (0..self.size).filter(|row| set >> row & 1 == 1) {
                let term = times(self.at(row, column), &minors[set ^ 1 << row]);
                if negative {
                    sum -= &term
                } else {
                    sum += &term
                }
                negative = !negative;
            }
            minors.push(sum);
        }
        let determinant = minors.swap_remove(all);
        (minors.swap_remove(all >> 1), determinant)
    }
}

/// A point that differences can be taken to: the last with W = 1.
fn reference<T: Ring, const D: usize>(points: &[Homogeneous<T, D>]) -> Option<usize> {
    points.iter().rposition(|point| point.w.is_one())
}

/// `(-1)^n value`.
fn signed<T: Ring>(value: T, n: usize) -> T {
    if n % 2 == 1 { -value } else { value }
}

/// The sign of this is the orientation of k+1 points on k axes.
pub(crate) fn orient<T: Ring, const D: usize>(points: &[Homogeneous<T, D>], axes: &[usize]) -> T {
    let Some(place) = reference(points) else {
        let mut rows = Matrix::new(points.len());
        for point in points {
            rows.push(point.w.clone());
            axes.iter().for_each(|&axis| rows.push(point.x[axis].clone()));
        }
        return rows.determinant();
    };
    let mut rows = Matrix::new(axes.len());
    for point in without(points, place) {
        axes.iter().for_each(|&axis| rows.push(point.from(&points[place], axis)));
    }
    signed(rows.determinant(), place) // the one of the reference's row, in the first column
}

/// All but the one at `place`.
fn without<P>(points: &[P], place: usize) -> impl Iterator<Item = &P> {
    points.iter().enumerate().filter(move |(i, _)| *i != place).map(|(_, point)| point)
}

/// The sign of this is positive if the last of k+2 points is inside the circumsphere of the others, these being positively
/// oriented on the k axes; heights are squared lengths in all axes.
pub(crate) fn lifted<T: Ring, const D: usize>(points: &[Homogeneous<T, D>], axes: &[usize]) -> T {
    let Some(place) = reference(points) else {
        let mut rows = Matrix::new(points.len());
        for Homogeneous { x, w } in points {
            rows.push(w.clone() * w);
            axes.iter().for_each(|&axis| rows.push(x[axis].clone() * w));
            rows.push(dot(x, x));
        }
        return -rows.determinant();
    };
    let mut rows = Matrix::new(points.len() - 1);
    for point in without(points, place) {
        let x = point.all_from(&points[place]);
        axes.iter().for_each(|&axis| rows.push(times(&x[axis], &point.w)));
        rows.push(dot(&x, &x));
    }
    -signed(rows.determinant(), place)
}

/// The sign of this is that of `(b - a) x (d - c)`.
pub(crate) fn cross<T: Ring>([a, b, c, d]: &[Homogeneous<T, 2>; 4]) -> T {
    let ([x, y], [z, w]) = (b.all_from(a), d.all_from(c));
    minor(&x, &y, &z, &w)
}

/// The sign of this is the order of two coordinates.
pub(crate) fn compare<T: Ring, const D: usize>(
    u: &Homogeneous<T, D>,
    v: &Homogeneous<T, D>,
    axis: usize,
) -> T {
    u.from(v, axis)
}
