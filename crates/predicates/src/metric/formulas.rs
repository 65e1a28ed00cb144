//! Lengths, angles and radii over any numbers that have a sign.

use std::cmp::Ordering;

use crate::ring::{Homogeneous, Matrix, Ring, dot, minus, times};
use crate::{Approximate, Dyadic, Sign};

/// A ring whose numbers have a sign, if it is known.
pub(crate) trait Signed: Ring {
    /// The sign, unless the number is too inexact.
    fn known_sign(&self) -> Option<Sign>;
}

impl Signed for Approximate {
    fn known_sign(&self) -> Option<Sign> {
        self.sign()
    }
}

impl Signed for Dyadic {
    fn known_sign(&self) -> Option<Sign> {
        Some(self.sign())
    }
}

fn compare<T: Signed>(a: T, b: &T) -> Option<Ordering> {
    Some(order(minus(a, b).known_sign()?))
}

fn order(sign: Sign) -> Ordering {
    match sign {
        Sign::Negative => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Positive => Ordering::Greater,
    }
}

fn square<T: Ring>(a: &T) -> T {
    times(a, a)
}

/// The order of two squared lengths.
pub(super) fn compare_lengths<T: Signed, const D: usize>(
    [a, b]: &[Homogeneous<T, D>; 2],
    [c, d]: &[Homogeneous<T, D>; 2],
) -> Option<Ordering> {
    let (ab, cd) = (b.all_from(a), d.all_from(c));
    let (w_ab, w_cd) = (square(&times(&a.w, &b.w)), square(&times(&c.w, &d.w)));
    compare(times(&dot(&ab, &ab), &w_cd), &times(&dot(&cd, &cd), &w_ab))
}

/// An angle by the product of its sides: |p| |q| times its cosine, and the square of |p| |q|.
struct Angle<T> {
    sign: Sign,
    dot: T,
    square: T,
}

impl<T: Signed> Angle<T> {
    fn of<const D: usize>([p, at, q]: &[Homogeneous<T, D>; 3]) -> Option<Self> {
        let (p, q) = (p.all_from(at), q.all_from(at));
        let (dot_pq, squares) = (dot(&p, &q), [dot(&p, &p), dot(&q, &q)]);
        let [side_p, side_q] = squares.each_ref().map(Signed::known_sign);
        if side_p? == Sign::Zero || side_q? == Sign::Zero {
            return Some(Self { sign: Sign::Positive, dot: T::one(), square: T::one() });
        }
        let [p, q] = squares;
        Some(Self { sign: dot_pq.known_sign()?, dot: dot_pq, square: p * &q })
    }
}

/// The order of two angles: that of their cosines, reversed.
pub(super) fn compare_angles<T: Signed, const D: usize>(
    abc: &[Homogeneous<T, D>; 3],
    def: &[Homogeneous<T, D>; 3],
) -> Option<Ordering> {
    let (first, second) = (Angle::of(abc)?, Angle::of(def)?);
    let of_signs = second.sign.cmp(&first.sign);
    if of_signs.is_ne() || first.sign == Sign::Zero {
        return Some(of_signs);
    }
    let left = square(&first.dot) * &second.square;
    let order = compare(square(&second.dot) * &first.square, &left)?;
    Some(if first.sign == Sign::Positive { order } else { order.reverse() })
}

/// A squared radius as a quotient; infinite if the denominator is zero, which is never negative.
pub(super) struct Radius<T> {
    pub(super) numerator: T,
    pub(super) denominator: T,
}

impl<T: Signed> Radius<T> {
    /// Of a sphere whose squared radius is this.
    pub(super) fn of_square(square: T) -> Self {
        Self { numerator: square, denominator: T::one() }
    }

    /// Of the smallest sphere through the vertices, or orthogonal to them if they have weights.
    ///
    /// All edges are brought to one denominator c, the product of the w of the vertices.
    pub(super) fn of_simplex<const D: usize>(
        points: &[Homogeneous<T, D>],
        weights: Option<&[T]>,
    ) -> Self {
        let (first, others) = points.split_first().expect("a simplex has a vertex");
        let product = |but: usize| {
            let others = points.iter().enumerate().filter(|(i, _)| *i != 0 && *i != but);
            others.fold(T::one(), |c, (_, point)| times(&c, &point.w))
        };
        let edges: Vec<[T; D]> = (1..)
            .zip(others)
            .map(|(i, point)| point.all_from(first).map(|x| times(&x, &product(i))))
            .collect();
        let c_square = square(&times(&product(0), &first.w));
        let height = |i: usize| {
            let square = dot(&edges[i], &edges[i]);
            let Some(weights) = weights else { return square };
            minus(square, &times(&minus(weights[i + 1].clone(), &weights[0]), &c_square))
        };
        let heights: Vec<T> = (0..edges.len()).map(height).collect();
        let gram = gram(&edges, None).determinant();
        let denominator = quadruple(&times(&gram, &c_square));
        let mut numerator = -gram_bordered(&edges, &heights);
        if let Some(weights) = weights {
            numerator -= &times(&denominator, &weights[0]);
        }
        Self { numerator, denominator }
    }

    /// Whether the denominator is exactly zero.
    pub(super) fn is_infinite(&self) -> bool {
        self.denominator.is_zero()
    }

    /// The order of two squared radii.
    pub(super) fn compare(&self, other: &Self) -> Option<Ordering> {
        let infinite = [self, other]
            .map(|radius| radius.denominator.known_sign().map(|sign| sign != Sign::Positive));
        match (infinite[0]?, infinite[1]?) {
            (false, false) => {}
            (this, that) => return Some(this.cmp(&that)),
        }
        let [left, right] =
            [(self, other), (other, self)].map(|(a, b)| times(&a.numerator, &b.denominator));
        compare(left, &right)
    }
}

fn quadruple<T: Ring>(a: &T) -> T {
    let double = a.clone() + a.clone();
    double.clone() + double
}

/// The matrix of products of edges, bordered by heights on two sides and a zero if there are any.
fn gram<T: Ring, const D: usize>(edges: &[[T; D]], heights: Option<&[T]>) -> Matrix<T> {
    let mut rows = Matrix::new(edges.len() + usize::from(heights.is_some()));
    for (i, edge) in edges.iter().enumerate() {
        edges.iter().for_each(|other| rows.push(dot(edge, other)));
        if let Some(heights) = heights {
            rows.push(heights[i].clone());
        }
    }
    if let Some(heights) = heights {
        heights.iter().for_each(|height| rows.push(height.clone()));
        rows.push(T::zero());
    }
    rows
}

/// `-h^T adj(G) h`.
fn gram_bordered<T: Ring, const D: usize>(edges: &[[T; D]], heights: &[T]) -> T {
    gram(edges, Some(heights)).determinant()
}
