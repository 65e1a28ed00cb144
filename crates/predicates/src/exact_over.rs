//! The exact kernel over exact numbers of any kind: of another crate, or [`Dyadic`](crate::Dyadic).
//!
//! A double is an integer times a power of two. All coordinates of a call are multiplied by the power of two that makes them integers,
//! which changes no sign, and then the determinant is computed in the ring.

use std::cmp::Ordering;
use std::marker::PhantomData;

use smallvec::SmallVec;

use crate::Sign;
use crate::adaptive::{compare, gather, point};
use crate::exact::align::{odd, span};
use crate::kernel::{Id, Kernel, PlaneKernel};
use crate::ring::{self, Homogeneous, Ring};

/// The kernel that computes each determinant in the numbers T: integers or rationals of any length, or anything else in which
/// sums and products are exact. Slower than [`Exact`](crate::Exact), and written without it.
///
/// With the feature `rug` of this crate, `T` may be `rug::Integer` or `rug::Rational`.
///
/// ```
/// use delone_predicates::{Dyadic, ExactOver, Kernel, Sign};
/// let kernel = ExactOver::<Dyadic, _>::new([[0.0, 0.0], [5e-324, 0.0], [0.0, 5e-324]]);
/// assert_eq!(kernel.orient(&[0usize, 1, 2]), Sign::Positive);
/// ```
#[derive(Debug)]
pub struct ExactOver<T, P> {
    points: P,
    numbers: PhantomData<fn() -> T>,
}

impl<T, P: Clone> Clone for ExactOver<T, P> {
    fn clone(&self) -> Self {
        Self::new(self.points.clone())
    }
}

impl<T, P> ExactOver<T, P> {
    /// A kernel over these points. Coordinates must be finite.
    pub const fn new(points: P) -> Self {
        Self { points, numbers: PhantomData }
    }
}

impl<T: Ring + PartialOrd + From<i64>, P> ExactOver<T, P> {
    /// The points of a call as integers over one power of two.
    fn points_of<const D: usize, V: Id>(
        &self,
        vertices: impl Iterator<Item = V> + Clone,
    ) -> SmallVec<[Homogeneous<T, D>; 5]>
    where
        P: AsRef<[[f64; D]]>,
    {
        let points = vertices.map(|v| point(&self.points, v));
        let low = span(points.clone().flatten()).map_or(0, |(low, _)| low);
        points.map(|point| Homogeneous::plain(point.map(|x| aligned(x, low)))).collect()
    }
}

/// `value / 2^low`, an integer by the choice of `low`.
fn aligned<T: Ring + From<i64>>(value: f64, low: i32) -> T {
    let (mantissa, exponent) = odd(value);
    if mantissa == 0 {
        return T::zero();
    }
    let power = num_traits::pow(T::from(2), exponent.abs_diff(low) as usize);
    let magnitude = T::from(mantissa.cast_signed()) * &power; // of 53 bits
    if value < 0.0 { -magnitude } else { magnitude }
}

fn sign<T: Ring + PartialOrd>(value: &T) -> Sign {
    let order = value.partial_cmp(&T::zero());
    Sign::from(order.expect("exact numbers can be compared"))
}

impl<const D: usize, T, P> Kernel<D> for ExactOver<T, P>
where
    T: Ring + PartialOrd + From<i64>,
    P: AsRef<[[f64; D]]>,
{
    type Reordered = ExactOver<T, Vec<[f64; D]>>;

    fn reordered(&self, order: &[u32]) -> Self::Reordered {
        ExactOver::new(gather(self.points.as_ref(), order))
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        let k = axes.len();
        assert_eq!(simplex.len(), k + 1, "orient in {k} axes takes {} points", k + 1);
        sign(&ring::orient::<T, D>(&self.points_of(simplex.iter().copied()), axes))
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        let k = axes.len();
        assert_eq!(simplex.len(), k + 1, "in_sphere in {k} axes takes {} points", k + 2);
        let vertices = simplex.iter().copied().chain([q]);
        sign(&ring::lifted::<T, D>(&self.points_of(vertices), axes))
    }

    fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
        compare(&self.points, axis, u, v)
    }
}

impl<T: Ring + PartialOrd + From<i64>, P: AsRef<[[f64; 2]]>> PlaneKernel for ExactOver<T, P> {
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        let points = self.points_of::<2, V>(vertices.into_iter());
        let points = points.as_slice().try_into().expect("four points");
        sign(&ring::cross::<T>(points))
    }
}
