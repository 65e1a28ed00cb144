//! The kernels over plain points: [`Adaptive`] (a filter, then exact integers) and [`Exact`] (integers only).

use std::cmp::Ordering;

use crate::kernel::{Id, Kernel, PlaneKernel, all_axes};
use crate::{Sign, determinant, filter};

/// Ids that one predicate call takes at most.
const POINTS_MAX: usize = determinant::AXES_MAX + 2;

/// The default kernel: floating-point filters in the plane and in space, exact integers behind them.
///
/// `points` is anything that gives `&[[f64; D]]`, borrowed or owned. Coordinates must be finite.
///
/// ```
/// use delone_predicates::{Adaptive, Kernel, Sign};
/// let kernel = Adaptive::new([[0.0, 0.0], [5e-324, 0.0], [0.0, 5e-324]]);
/// assert_eq!(kernel.orient(&[0usize, 1, 2]), Sign::Positive);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Adaptive<P>(P);

/// The kernel without filters: each answer by exact integers. For tests, and to see what the filters are worth.
#[derive(Clone, Copy, Debug)]
pub struct Exact<P>(P);

impl<P> Adaptive<P> {
    /// A kernel over these points.
    pub const fn new(points: P) -> Self {
        Self(points)
    }
}

impl<P> Exact<P> {
    /// A kernel over these points.
    pub const fn new(points: P) -> Self {
        Self(points)
    }
}

/// `points[order[0]], points[order[1]], ..`
fn gather<const D: usize>(points: &[[f64; D]], order: &[u32]) -> Vec<[f64; D]> {
    order.iter().map(|&i| points[i as usize]).collect()
}

#[inline(always)]
fn point<const D: usize, V: Id, P: AsRef<[[f64; D]]>>(points: &P, v: V) -> &[f64; D] {
    &points.as_ref()[v.index()]
}

/// Calls `exact` with the points of `simplex` and then, if given, `q`.
fn with_points<const D: usize, V: Id, P: AsRef<[[f64; D]]>>(
    points: &P,
    simplex: &[V],
    q: Option<V>,
    exact: impl FnOnce(&[&[f64]]) -> Sign,
) -> Sign {
    let mut slots: [&[f64]; POINTS_MAX] = [&[]; POINTS_MAX];
    let mut count = 0;
    for &v in simplex.iter().chain(&q) {
        slots[count] = point(points, v);
        count += 1;
    }
    exact(&slots[..count])
}

macro_rules! exact_methods {
    ($name:ident) => {
        type Reordered = $name<Vec<[f64; D]>>;

        fn reordered(&self, order: &[u32]) -> Self::Reordered {
            $name(gather(self.0.as_ref(), order))
        }

        fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
            with_points(&self.0, simplex, None, |points| determinant::orient(points, axes))
        }

        fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
            with_points(&self.0, simplex, Some(q), |points| determinant::lifted(points, axes))
        }

        #[inline]
        fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
            let (a, b) = (point(&self.0, u)[axis], point(&self.0, v)[axis]);
            a.partial_cmp(&b).expect("coordinates are finite")
        }
    };
}

impl<const D: usize, P: AsRef<[[f64; D]]>> Kernel<D> for Exact<P> {
    exact_methods!(Exact);
}

impl<const D: usize, P: AsRef<[[f64; D]]>> Kernel<D> for Adaptive<P> {
    exact_methods!(Adaptive);

    #[inline]
    fn orient<V: Id>(&self, simplex: &[V]) -> Sign {
        let sign = match *simplex {
            [a, b, c] if D == 2 => {
                let [a, b, c] = [a, b, c].map(|v| coordinates(point(&self.0, v)));
                filter::orient2d(a, b, c)
            }
            [a, b, c, d] if D == 3 => {
                let [a, b, c, d] = [a, b, c, d].map(|v| coordinates(point(&self.0, v)));
                filter::orient3d(a, b, c, d)
            }
            _ => None,
        };
        sign.unwrap_or_else(|| self.orient_on(&all_axes::<D>(), simplex))
    }

    #[inline]
    fn lifted<V: Id>(&self, simplex: &[V], q: V) -> Sign {
        let sign = match *simplex {
            [a, b, c] if D == 2 => {
                let [a, b, c, q] = [a, b, c, q].map(|v| coordinates(point(&self.0, v)));
                filter::in_circle(a, b, c, q)
            }
            [a, b, c, d] if D == 3 => {
                let [a, b, c, d, q] = [a, b, c, d, q].map(|v| coordinates(point(&self.0, v)));
                filter::in_sphere(a, b, c, d, q)
            }
            _ => None,
        };
        sign.unwrap_or_else(|| self.lifted_on(&all_axes::<D>(), simplex, q))
    }
}

/// The first `N` coordinates: `[f64; D]` as `[f64; N]` where the caller knows that they are the same type.
#[inline(always)]
fn coordinates<const D: usize, const N: usize>(point: &[f64; D]) -> [f64; N] {
    std::array::from_fn(|axis| point[axis])
}

impl<P: AsRef<[[f64; 2]]>> PlaneKernel for Adaptive<P> {
    #[inline]
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        let points = vertices.map(|v| *point(&self.0, v));
        filter::cross(points).unwrap_or_else(|| determinant::cross(points))
    }
}

impl<P: AsRef<[[f64; 2]]>> PlaneKernel for Exact<P> {
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        determinant::cross(vertices.map(|v| *point(&self.0, v)))
    }
}
