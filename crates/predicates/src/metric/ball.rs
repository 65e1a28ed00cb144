//! The smallest sphere through a simplex: what is inside of it, and its squared radius as a quotient.
//!
//! **Inside.** With the edges v_i from the first vertex of a k-simplex, c that to the query, and heights h as of the radius
//! (`metric.rs`), the power of the query with respect to the sphere is h_c less c V^T G^-1 h. That times det G is the determinant of
//! the Gram matrix with a column of heights and a row of the query. So there is no division, and no flat of the simplex to find.

use std::cmp::Ordering;

use smallvec::SmallVec;

use super::formulas::{Radius, edges, height};
use super::words;
use crate::dyadic::nearest_ratio;
use crate::formula::{Call, Formula, Signed};
use crate::ring::{Homogeneous, Matrix, dot, times};
use crate::{Approximate, Dyadic, Sign};

/// Whether the last of the points is inside the smallest sphere through the others. Squares are the weights, if there are any.
pub(super) struct InBall;

impl<const D: usize> Formula<D> for InBall {
    type Answer = Sign;
    fn answer<T: Signed>(&self, call: &Call<T, D>) -> Option<Sign> {
        let weights = (!call.squares.is_empty()).then_some(&call.squares[..]);
        power(&call.points, weights).known_sign().map(|sign| -sign)
    }
    const HAS_WORDS: bool = true;
    fn in_words(&self, points: &[[i64; 3]]) -> Option<Sign> {
        words::in_ball(points)
    }
}

/// The power of the last point with respect to the sphere through, or orthogonal to, the others: times a positive number.
fn power<T: Signed, const D: usize>(points: &[Homogeneous<T, D>], weights: Option<&[T]>) -> T {
    let (edges, c_square) = edges(points);
    let k = edges.len() - 1;
    let mut rows = Matrix::new(k + 1);
    for (i, edge) in edges.iter().enumerate() {
        edges[..k].iter().for_each(|other| rows.push(dot(edge, other)));
        rows.push(height(weights, &c_square, i, dot(edge, edge)));
    }
    rows.determinant()
}

/// An exact squared radius: a quotient, whose denominator is not negative; where it is zero, the simplex is flat and the
/// radius infinite.
///
/// ```
/// use delone_predicates::{Adaptive, Metric};
/// let kernel = Adaptive::new([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [3.0, 3.0]]);
/// let half = kernel.exact_squared_radius(&[0usize, 1, 2]);
/// assert!(half.to_f64() == 0.5 && half < kernel.exact_squared_radius(&[0usize, 3]));
/// ```
#[derive(Clone, Debug)]
pub struct SquaredRadius {
    numerator: Dyadic,
    denominator: Dyadic,
}

impl SquaredRadius {
    /// The quotient of two numbers.
    ///
    /// # Panics
    /// If the denominator is negative.
    #[must_use]
    pub fn new(numerator: Dyadic, denominator: Dyadic) -> Self {
        assert!(denominator.sign() != Sign::Negative, "a denominator is not negative");
        Self { numerator, denominator }
    }

    /// The numerator.
    #[must_use]
    pub const fn numerator(&self) -> &Dyadic {
        &self.numerator
    }

    /// The denominator, not reduced.
    #[must_use]
    pub const fn denominator(&self) -> &Dyadic {
        &self.denominator
    }

    /// The nearest double.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        if self.denominator.sign() == Sign::Zero {
            return f64::INFINITY;
        }
        nearest_ratio(&self.numerator, &self.denominator)
    }
}

impl Ord for SquaredRadius {
    fn cmp(&self, other: &Self) -> Ordering {
        let infinite = [self, other].map(|radius| radius.denominator.sign() == Sign::Zero);
        if infinite[0] || infinite[1] {
            return infinite[0].cmp(&infinite[1]);
        }
        let left = times(&self.numerator, &other.denominator);
        left.cmp(&times(&other.numerator, &self.denominator))
    }
}

impl PartialOrd for SquaredRadius {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for SquaredRadius {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for SquaredRadius {}

/// Two doubles that the quotient is between, which may be infinite.
pub(super) fn bounds(radius: &Radius<Approximate>) -> [f64; 2] {
    const UNKNOWN: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
    let [[low, high], [small, large]] =
        [&radius.numerator, &radius.denominator].map(|number| number.bounds());
    if !(small > 0.0 && low.is_finite() && high.is_finite() && large.is_finite()) {
        return UNKNOWN;
    }
    if low == high && small == large && large == 1.0 {
        return [low; 2];
    }
    let least = low / if low < 0.0 { small } else { large };
    let most = high / if high < 0.0 { large } else { small };
    [least.next_down(), most.next_up()]
}

/// The points of a call with their weights, if they have any.
pub(super) type Weights<T> = SmallVec<[T; 4]>;
