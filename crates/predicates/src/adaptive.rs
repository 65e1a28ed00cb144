//! The kernels over plain points: [`Adaptive`] (filters, then exact integers) and [`Exact`] (integers only).

use std::cmp::Ordering;

use crate::filter::Bounds;
use crate::kernel::{Id, Kernel, PlaneKernel, all_axes};
use crate::{Outlook, Sight, Sign, Stage, exact, filter};

/// The default kernel: floating-point filters, exact integers behind them.
///
/// `points` is anything that gives `&[[f64; D]]`, borrowed or owned. Coordinates must be finite.
///
/// ```
/// use delone_predicates::{Adaptive, Kernel, Sign};
/// let kernel = Adaptive::new([[0.0, 0.0], [5e-324, 0.0], [0.0, 5e-324]]);
/// assert_eq!(kernel.orient(&[0usize, 1, 2]), Sign::Positive);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Adaptive<P> {
    points: P,
    bounds: Bounds,
}

/// The kernel without filters: each answer by exact integers. For tests, and to see what the filters are worth.
#[derive(Clone, Copy, Debug)]
pub struct Exact<P> {
    points: P,
}

impl<P> Adaptive<P> {
    /// A kernel over these points. Reads them once, for the bounds of the static filters.
    pub fn new<const D: usize>(points: P) -> Self
    where
        P: AsRef<[[f64; D]]>,
    {
        Self { bounds: Bounds::of_all(points.as_ref()), points }
    }

    /// Calls `answer` with the points of `simplex` and then, if given, `q`.
    pub(crate) fn with<const D: usize, V: Id, A>(
        &self,
        simplex: &[V],
        q: Option<V>,
        answer: impl FnOnce(&[&[f64; D]]) -> A,
    ) -> A
    where
        P: AsRef<[[f64; D]]>,
    {
        with_points(&self.points, simplex, q, answer)
    }

    /// A point on two of its axes.
    fn on<const D: usize, V: Id>(&self, x: usize, y: usize, v: V) -> [f64; 2]
    where
        P: AsRef<[[f64; D]]>,
    {
        let point = point(&self.points, v);
        [point[x], point[y]]
    }

    /// A point of space with these two of its axes first.
    fn turned<const D: usize, V: Id>(&self, x: usize, y: usize, v: V) -> [f64; 3]
    where
        P: AsRef<[[f64; D]]>,
    {
        let point = point(&self.points, v);
        [point[x], point[y], point[3 - x - y]]
    }

    pub(crate) const fn given(&self) -> &P {
        &self.points
    }

    /// The points.
    pub fn points<const D: usize>(&self) -> &[[f64; D]]
    where
        P: AsRef<[[f64; D]]>,
    {
        self.points.as_ref()
    }

    /// A kernel over these points, whose static filters have these bounds.
    #[inline(always)]
    pub(crate) const fn bounded(points: P, bounds: Bounds) -> Self {
        Self { points, bounds }
    }

    /// A kernel over these points without static filters, made without a look at them: for a few calls on many points.
    pub const fn dynamic(points: P) -> Self {
        Self { points, bounds: Bounds::NONE }
    }
}

impl<P> Exact<P> {
    pub(crate) const fn given(&self) -> &P {
        &self.points
    }

    /// A kernel over these points.
    pub const fn new(points: P) -> Self {
        Self { points }
    }
}

/// `points[order[0]], points[order[1]], ..`
pub(crate) fn gather<const D: usize>(points: &[[f64; D]], order: &[u32]) -> Vec<[f64; D]> {
    order.iter().map(|&i| points[i as usize]).collect()
}

#[inline(always)]
pub(crate) fn point<const D: usize, V: Id>(points: &impl AsRef<[[f64; D]]>, v: V) -> &[f64; D] {
    &points.as_ref()[v.index()]
}

/// The order of two vertices along an axis.
#[inline]
pub(crate) fn compare<const D: usize, V: Id>(
    points: &impl AsRef<[[f64; D]]>,
    axis: usize,
    u: V,
    v: V,
) -> Ordering {
    let (a, b) = (point(points, u)[axis], point(points, v)[axis]);
    a.partial_cmp(&b).expect("coordinates are finite")
}

/// The point as one of N coordinates, where the caller knows that N is D.
#[inline(always)]
pub(crate) fn same<const D: usize, const N: usize>(point: &[f64; D]) -> &[f64; N] {
    point.as_slice().try_into().expect("N is D")
}

/// Calls `answer` with the points of `simplex` and then, if given, `q`.
pub(crate) fn with_points<'p, const D: usize, V: Id, A>(
    points: &'p impl AsRef<[[f64; D]]>,
    simplex: &[V],
    q: Option<V>,
    answer: impl FnOnce(&[&'p [f64; D]]) -> A,
) -> A {
    let mut slots: [&[f64; D]; exact::POINTS_MAX] = [&[0.0; D]; exact::POINTS_MAX];
    let mut count = 0;
    for &v in simplex.iter().chain(&q) {
        slots[count] = point(points, v);
        count += 1;
    }
    answer(&slots[..count])
}

/// The exact orientation on some axes.
pub(crate) fn orient_exactly<const D: usize, V: Id>(
    points: &impl AsRef<[[f64; D]]>,
    axes: &[usize],
    simplex: &[V],
) -> exact::Answer {
    with_points(points, simplex, None, |points| {
        exact::orient(&slices(points)[..points.len()], axes)
    })
}

/// The exact lifted determinant on some axes.
pub(crate) fn lifted_exactly<const D: usize, V: Id>(
    points: &impl AsRef<[[f64; D]]>,
    axes: &[usize],
    simplex: &[V],
    q: V,
) -> exact::Answer {
    with_points(points, simplex, Some(q), |points| {
        exact::lifted(&slices(points)[..points.len()], axes, None)
    })
}

/// The points as slices.
pub(crate) fn slices<'p, const D: usize>(
    points: &[&'p [f64; D]],
) -> [&'p [f64]; exact::POINTS_MAX] {
    std::array::from_fn(|i| points.get(i).map_or(&[][..], |point| point.as_slice()))
}

macro_rules! shared_methods {
    () => {
        #[inline]
        fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
            compare(&self.points, axis, u, v)
        }

        #[inline(always)]
        fn orient<V: Id>(&self, simplex: &[V]) -> Sign {
            self.orient_staged(simplex).0
        }

        #[inline(always)]
        fn lifted<V: Id>(&self, simplex: &[V], q: V) -> Sign {
            self.lifted_staged(simplex, q).0
        }
    };
}

impl<const D: usize, P: AsRef<[[f64; D]]>> Kernel<D> for Exact<P> {
    type Reordered = Exact<Vec<[f64; D]>>;

    fn reordered(&self, order: &[u32]) -> Self::Reordered {
        Exact::new(gather(self.points.as_ref(), order))
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        orient_exactly(&self.points, axes, simplex).0
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        lifted_exactly(&self.points, axes, simplex, q).0
    }

    shared_methods!();

    #[inline]
    fn orient_staged<V: Id>(&self, simplex: &[V]) -> (Sign, Stage) {
        let at = |v| point(&self.points, v);
        match *simplex {
            [a, b, c] if D == 2 => exact::orient2d(same(at(a)), same(at(b)), same(at(c))),
            [a, b, c, d] if D == 3 => {
                exact::orient3d(same(at(a)), same(at(b)), same(at(c)), same(at(d)))
            }
            _ => orient_exactly(&self.points, &all_axes::<D>(), simplex),
        }
    }

    #[inline]
    fn lifted_staged<V: Id>(&self, simplex: &[V], q: V) -> (Sign, Stage) {
        let at = |v| point(&self.points, v);
        match *simplex {
            [a, b, c] if D == 2 => {
                exact::in_circle(same(at(a)), same(at(b)), same(at(c)), same(at(q)))
            }
            [a, b, c, d] if D == 3 => {
                let (a, b, c, d) = (same(at(a)), same(at(b)), same(at(c)), same(at(d)));
                exact::in_sphere(a, b, c, d, same(at(q)))
            }
            _ => lifted_exactly(&self.points, &all_axes::<D>(), simplex, q),
        }
    }
}

impl<const D: usize, P: AsRef<[[f64; D]]>> Kernel<D> for Adaptive<P> {
    type Reordered = Adaptive<Vec<[f64; D]>>;

    const LOOKS: bool = D == 3;

    /// The bounds stay those of all points of this kernel, also if `order` leaves some out.
    fn reordered(&self, order: &[u32]) -> Self::Reordered {
        Adaptive { points: gather(self.points.as_ref(), order), bounds: self.bounds }
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        match (axes, simplex) {
            (&[axis], &[u, v]) => Sign::from(self.compare(axis, v, u)),
            (&[x, y], &[a, b, c]) => {
                let (a, b, c) = (self.on(x, y, a), self.on(x, y, b), self.on(x, y, c));
                let certain = filter::orient2d(&a, &b, &c, f64::INFINITY);
                certain.unwrap_or_else(|| exact::orient2d(&a, &b, &c)).0
            }
            _ => orient_exactly(&self.points, axes, simplex).0,
        }
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        match (axes, simplex) {
            (&[x, y], &[a, b, c]) if D == 3 => {
                let turned = |v| self.turned(x, y, v);
                let points = [turned(a), turned(b), turned(c), turned(q)];
                let certain = filter::in_circle_of_space(points.each_ref());
                certain.unwrap_or_else(|| exact::in_circle_of_space(points.each_ref())).0
            }
            _ => lifted_exactly(&self.points, axes, simplex, q).0,
        }
    }

    shared_methods!();

    #[inline(always)]
    fn orient_staged<V: Id>(&self, simplex: &[V]) -> (Sign, Stage) {
        let at = |v| point(&self.points, v);
        match *simplex {
            [a, b, c] if D == 2 => {
                let (a, b, c) = (same(at(a)), same(at(b)), same(at(c)));
                let certain = filter::orient2d(a, b, c, self.bounds.orient);
                certain.unwrap_or_else(|| exact::orient2d(a, b, c))
            }
            [a, b, c, d] if D == 3 => {
                let (a, b, c, d) = (same(at(a)), same(at(b)), same(at(c)), same(at(d)));
                let certain = filter::orient3d([a, b, c, d], self.bounds.orient);
                certain.unwrap_or_else(|| exact::orient3d(a, b, c, d))
            }
            _ => orient_any(&self.points, simplex),
        }
    }

    #[inline(always)]
    fn lifted_staged<V: Id>(&self, simplex: &[V], q: V) -> (Sign, Stage) {
        let at = |v| point(&self.points, v);
        match *simplex {
            [a, b, c] if D == 2 => {
                let (a, b, c, q) = (same(at(a)), same(at(b)), same(at(c)), same(at(q)));
                let certain = filter::in_circle([a, b, c, q], self.bounds.lifted);
                certain.unwrap_or_else(|| exact::in_circle(a, b, c, q))
            }
            [a, b, c, d] if D == 3 => {
                let (a, b, c) = (same(at(a)), same(at(b)), same(at(c)));
                let (d, q) = (same(at(d)), same(at(q)));
                let certain = filter::in_sphere([a, b, c, d, q], self.bounds.lifted);
                certain.unwrap_or_else(|| exact::in_sphere(a, b, c, d, q))
            }
            _ => lifted_any(&self.points, simplex, q),
        }
    }

    #[inline(always)]
    fn see<V: Id>(&self, sight: &mut Sight, vertex: V, q: V) {
        let at = |v| same(point(&self.points, v));
        sight.see(at(vertex), at(q));
    }

    #[inline(always)]
    fn look(&self, outlook: &mut Outlook, corners: [&Sight; 4]) {
        outlook.look(corners);
    }

    #[inline(always)]
    fn lifted_beyond(
        &self,
        outlook: &Outlook,
        corner: usize,
        end: &Sight,
        apex: &Sight,
    ) -> Option<Sign> {
        outlook.beyond(corner, end, apex, self.bounds.lifted)
    }
}

/// In more than three axes, and for simplices of a wrong number of vertices, which panic.
#[inline(never)]
fn orient_any<const D: usize, V: Id>(
    points: &impl AsRef<[[f64; D]]>,
    simplex: &[V],
) -> exact::Answer {
    let filtered = || with_points(points, simplex, None, filter::any::orient);
    let certain = if D > 3 && simplex.len() == D + 1 { filtered() } else { None };
    certain.unwrap_or_else(|| orient_exactly(points, &all_axes::<D>(), simplex))
}

/// As `orient_any`.
#[inline(never)]
fn lifted_any<const D: usize, V: Id>(
    points: &impl AsRef<[[f64; D]]>,
    simplex: &[V],
    q: V,
) -> exact::Answer {
    let filtered =
        || with_points(points, simplex, Some(q), |points| filter::any::lifted(points, None));
    let certain = if D > 3 && simplex.len() == D + 1 { filtered() } else { None };
    certain.unwrap_or_else(|| lifted_exactly(points, &all_axes::<D>(), simplex, q))
}

impl<P: AsRef<[[f64; 2]]>> PlaneKernel for Adaptive<P> {
    #[inline(always)]
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        let points = vertices.map(|v| point(&self.points, v));
        let certain = filter::cross(points, self.bounds.orient);
        let [a, b, c, d] = points;
        certain.unwrap_or_else(|| exact::cross(a, b, c, d)).0
    }
}

impl<P: AsRef<[[f64; 2]]>> PlaneKernel for Exact<P> {
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        let [a, b, c, d] = vertices.map(|v| point(&self.points, v));
        exact::cross(a, b, c, d).0
    }
}
