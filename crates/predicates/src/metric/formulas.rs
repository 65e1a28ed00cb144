//! Lengths, angles and radii over any numbers that have a sign.

use std::cmp::Ordering;

use smallvec::SmallVec;

use super::words;
use crate::Sign;
use crate::formula::{Call, Formula, Signed};
use crate::ring::{Homogeneous, Matrix, Ring, dot, minus, times};

fn compare<T: Signed>(a: T, b: &T) -> Option<Ordering> {
    Some(order(minus(a, b).known_sign()?))
}

pub(super) fn order(sign: Sign) -> Ordering {
    match sign {
        Sign::Negative => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Positive => Ordering::Greater,
    }
}

fn square<T: Ring>(a: &T) -> T {
    times(a, a)
}

/// Of two edges, the order of their lengths.
pub(super) struct Lengths;

impl<const D: usize> Formula<D> for Lengths {
    type Answer = Ordering;
    fn answer<T: Signed>(&self, call: &Call<T, D>) -> Option<Ordering> {
        let [a, b, c, d] = call.points.as_slice() else { panic!("two edges have four ends") };
        compare_lengths([a, b], [c, d])
    }
    const HAS_WORDS: bool = true;
    fn in_words(&self, points: &[[i64; 3]]) -> Option<Ordering> {
        let &[a, b, c, d] = points else { panic!("two edges have four ends") };
        Some(words::compare_lengths([a, b], [c, d]))
    }
}

/// The scalar product of two edges.
pub(super) struct Dot;

impl<const D: usize> Formula<D> for Dot {
    type Answer = Sign;
    fn answer<T: Signed>(&self, call: &Call<T, D>) -> Option<Sign> {
        let [a, b, c, d] = call.points.as_slice() else { panic!("two edges have four ends") };
        dot(&b.all_from(a), &d.all_from(c)).known_sign()
    }
}

/// Of two times three points, the order of the angles.
pub(super) struct Angles;

impl<const D: usize> Formula<D> for Angles {
    type Answer = Ordering;
    fn answer<T: Signed>(&self, call: &Call<T, D>) -> Option<Ordering> {
        let [a, b, c, d, e, f] = call.points.as_slice() else { panic!("angles have three points") };
        compare_angles([a, b, c], [d, e, f])
    }
}

/// The order of the radii of two simplices, the first of so many points. Squares are their weights, if they have any.
pub(crate) struct Radii(pub(crate) usize);

impl<const D: usize> Formula<D> for Radii {
    type Answer = Ordering;
    fn answer<T: Signed>(&self, call: &Call<T, D>) -> Option<Ordering> {
        let (s, t) = call.points.split_at(self.0);
        let [of_s, of_t] = match call.squares.split_at_checked(self.0) {
            None | Some((_, [])) => [None; 2],
            Some((of_s, of_t)) => [Some(of_s), Some(of_t)],
        };
        Radius::of_simplex(s, of_s).compare(&Radius::of_simplex(t, of_t))
    }
    const HAS_WORDS: bool = true;
    fn in_words(&self, points: &[[i64; 3]]) -> Option<Ordering> {
        let (s, t) = points.split_at(self.0);
        Some(words::Radius::of_simplex(s)?.compare(&words::Radius::of_simplex(t)?))
    }
}

/// The order of a simplex's squared radius and the last of the squares; the others are weights.
pub(super) struct RadiusOver;

impl<const D: usize> Formula<D> for RadiusOver {
    type Answer = Ordering;
    fn answer<T: Signed>(&self, call: &Call<T, D>) -> Option<Ordering> {
        let (bound, weights) = call.squares.split_last().expect("a bound");
        let weights = (!weights.is_empty()).then_some(weights);
        Radius::of_simplex(&call.points, weights).compare(&Radius::of_square(bound.clone()))
    }
}

/// The order of two squared lengths.
fn compare_lengths<T: Signed, const D: usize>(
    [a, b]: [&Homogeneous<T, D>; 2],
    [c, d]: [&Homogeneous<T, D>; 2],
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
    fn of<const D: usize>([p, at, q]: [&Homogeneous<T, D>; 3]) -> Option<Self> {
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
fn compare_angles<T: Signed, const D: usize>(
    abc: [&Homogeneous<T, D>; 3],
    def: [&Homogeneous<T, D>; 3],
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
    pub(super) fn of_simplex<const D: usize>(
        points: &[Homogeneous<T, D>],
        weights: Option<&[T]>,
    ) -> Self {
        let (edges, c_square) = edges(points);
        let height = |i: usize, square: &T| height(weights, &c_square, i, square.clone());
        let (gram, bordered) = bordered(&edges, height).determinants();
        let denominator = quadruple(&times(&gram, &c_square));
        let mut numerator = -bordered;
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

/// All edges from the first point, brought to one denominator c, the product of the w of the points; and the square of c.
pub(super) fn edges<T: Ring, const D: usize>(
    points: &[Homogeneous<T, D>],
) -> (SmallVec<[[T; D]; 4]>, T) {
    let (first, others) = points.split_first().expect("a simplex has a vertex");
    let product = |but: usize| {
        let others = points.iter().enumerate().filter(|(i, _)| *i != 0 && *i != but);
        others.fold(T::one(), |c, (_, point)| times(&c, &point.w))
    };
    let edges = (1..)
        .zip(others)
        .map(|(i, point)| point.all_from(first).map(|x| times(&x, &product(i))))
        .collect();
    (edges, square(&times(&product(0), &first.w)))
}

/// The height of edge `i`, of this squared length: less the weight of its end over that of the first point.
pub(super) fn height<T: Ring>(weights: Option<&[T]>, c_square: &T, i: usize, length: T) -> T {
    let Some(weights) = weights else { return length };
    let over = minus(weights[i + 1].clone(), &weights[0]);
    minus(length, &times(&over, c_square))
}

fn quadruple<T: Ring>(a: &T) -> T {
    let double = a.clone() + a.clone();
    double.clone() + double
}

/// The matrix of products of edges, bordered by heights on two sides and a zero; `height` is told the edge's square.
fn bordered<T: Ring, const D: usize>(
    edges: &[[T; D]],
    height: impl Fn(usize, &T) -> T,
) -> Matrix<T> {
    let k = edges.len();
    let mut products: SmallVec<[T; 9]> = SmallVec::new();
    for (i, edge) in edges.iter().enumerate() {
        for (j, other) in edges.iter().enumerate() {
            products.push(if j < i { products[j * k + i].clone() } else { dot(edge, other) });
        }
    }
    let heights: SmallVec<[T; 4]> = (0..k).map(|i| height(i, &products[i * k + i])).collect();
    let mut rows = Matrix::new(k + 1);
    for (row, height) in products.chunks(k.max(1)).zip(&heights) {
        row.iter().chain([height]).for_each(|entry| rows.push(entry.clone()));
    }
    heights.into_iter().chain([T::zero()]).for_each(|entry| rows.push(entry));
    rows
}
