//! The kernel of plain doubles, to show what rounding does. Its answers may be wrong, and inconsistent.

use std::cmp::Ordering;

use crate::adaptive::{compare, gather, point, same, with_points};
use crate::filter::{any, value};
use crate::kernel::{Id, Kernel, PlaneKernel, all_axes};
use crate::{Sign, Stage};

/// Determinants in doubles, taken at their word: wrong where rounding, underflow or overflow decide.
///
/// For teaching, and to find out what an algorithm does under it; a determinant that is not a number counts as zero.
/// Comparisons of coordinates are right. The perturbation reads zeros and orientations that may be wrong.
///
/// ```
/// use delone_predicates::{Adaptive, Kernel, Naive, Sign};
/// let points = [[0.50000000000001, 0.500000000000008], [12.0, 12.0], [24.0, 24.0]];
/// assert_eq!(Adaptive::new(points).orient(&[0usize, 1, 2]), Sign::Negative);
/// assert_eq!(Naive::new(points).orient(&[0usize, 1, 2]), Sign::Zero);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Naive<P> {
    points: P,
}

impl<P> Naive<P> {
    /// A kernel over these points.
    pub const fn new(points: P) -> Self {
        Self { points }
    }
}

impl<const D: usize, P: AsRef<[[f64; D]]>> Kernel<D> for Naive<P> {
    type Reordered = Naive<Vec<[f64; D]>>;

    fn reordered(&self, order: &[u32]) -> Self::Reordered {
        Naive::new(gather(self.points.as_ref(), order))
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        Sign::of(with_points(&self.points, simplex, None, |points| any::orient_value(points, axes)))
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        Sign::of(with_points(&self.points, simplex, Some(q), |p| any::lifted_value(p, axes)))
    }

    #[inline]
    fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
        compare(&self.points, axis, u, v)
    }

    #[inline]
    fn orient<V: Id>(&self, simplex: &[V]) -> Sign {
        let at = |v| point(&self.points, v);
        match *simplex {
            [a, b, c] if D == 2 => Sign::of(value::orient2d(same(at(a)), same(at(b)), same(at(c)))),
            [a, b, c, d] if D == 3 => Sign::of(value::orient3d([a, b, c, d].map(|v| same(at(v))))),
            _ => self.orient_on(&all_axes::<D>(), simplex),
        }
    }

    #[inline]
    fn lifted<V: Id>(&self, simplex: &[V], q: V) -> Sign {
        let at = |v| point(&self.points, v);
        match *simplex {
            [a, b, c] if D == 2 => Sign::of(value::in_circle([a, b, c, q].map(|v| same(at(v))))),
            [a, b, c, d] if D == 3 => {
                Sign::of(value::in_sphere([a, b, c, d, q].map(|v| same(at(v)))))
            }
            _ => self.lifted_on(&all_axes::<D>(), simplex, q),
        }
    }

    fn orient_staged<V: Id>(&self, simplex: &[V]) -> (Sign, Stage) {
        (self.orient(simplex), Stage::Unfiltered)
    }

    fn lifted_staged<V: Id>(&self, simplex: &[V], q: V) -> (Sign, Stage) {
        (self.lifted(simplex, q), Stage::Unfiltered)
    }
}

impl<P: AsRef<[[f64; 2]]>> PlaneKernel for Naive<P> {
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        Sign::of(value::cross(vertices.map(|v| point(&self.points, v))))
    }
}
