//! The kernel of constructed points: points on segments, crossings of lines and planes, exact, among plain points.
//!
//! Algorithms written for plain points run under it unchanged, ties and their perturbation included: a constructed
//! vertex is a vertex.
//!
//! **Paper.** \[Att20\]; where we differ: exact coordinates are kept, in numbers of any length, and so are nearest doubles.
//!
//! **Values.** The nearest doubles of a constructed point are computed when it is pushed, its homogeneous coordinates in
//! [`Dyadic`] numbers then, or when they are first asked for (`constructed/lazy.rs`). Where these are exact, the vertex is as good as plain. Elsewhere they are off by half of the last place
//! at most, and nearest is monotone: where nearest doubles differ, they are in the order of the exact values.
//!
//! **Stages.** Calls on vertices that are exact doubles, plain or not, are those of [`Adaptive`]. Others: 1. A static filter for
//! all vertices: the value of the determinant in nearest doubles over the bound of *magnitudes*. 2. A dynamic filter: the
//! determinant in doubles that carry their error bounds ([`Approximate`]). 3. In up to three axes, integers of fixed widths
//! (`constructed/short.rs`). 4. The determinant in dyadic numbers.
//!
//! **The static bound.** A difference of nearest doubles has the rounding of the subtraction, at most u |p - q|, and the
//! errors of p and q, at most u |p| and u |q| (2^-1075 each for denormals). Let M be, on each axis, the extent of the box
//! of all nearest doubles plus twice the greatest magnitude of a coordinate, plus 2^-1020: then each difference is at most M, and
//! off by at most u M. From there on the determinant is rounded as for plain points, where a difference is off by at most u
//! times itself: so the bound of `filter.rs` holds with M in place of the extents, but for terms of higher order, since a
//! difference is at most (1 + u) M exactly. Twice that bound is taken: of the longest paths of 4, 8, 11 and 16 roundings the
//! constants 3, 7, 10 and 16, doubled, leave at least 2 u.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | lines or planes without one common point | refused by [`Constructed::push`] | `parallel_lines_and_planes_are_refused` |
//! | a construction from a constructed point | refused | `constructions_are_from_plain_points` |
//! | a crossing that is a plain point | equal in every comparison; zero as an orientation | `a_constructed_point_may_equal_a_plain_one` |
//! | a crossing beyond the largest double | its nearest double is infinite, its answers are exact | `crossings_beyond_the_largest_double` |

use std::cmp::Ordering;

use crate::adaptive::Adaptive;
use crate::approximate::Approximate;
use crate::filter::{Bounds, value};
use crate::formula::{Call, Cross, Formula, Lifted, Orient, exactly};
use crate::kernel::{Id, Kernel, PlaneKernel, all_axes};
use crate::ring::{self, Homogeneous};
use crate::{Dyadic, Sign, Stage};
use smallvec::SmallVec;

mod construction;
mod extent;
mod lazy;
mod local;
mod push;
mod short;
#[cfg(test)]
mod tests;

pub use construction::{Construction, ConstructionError};
use extent::Extent;
use lazy::Value;
use short::Short;

/// Instead of a place among the values: a plain point.
const PLAIN: u32 = u32::MAX >> 1;

/// Added to the place of a vertex whose nearest doubles are not the point itself.
const ROUNDED: u32 = 1 << 31;

/// A kernel over plain points and points constructed from them; ids are in the order of [`Constructed::push`].
///
/// ```
/// use delone_predicates::{Constructed, Construction, Kernel, Sign};
/// let square = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]];
/// let mut kernel = Constructed::new(square.to_vec());
/// let centre = kernel.push(&Construction::Crossing { a: 0, b: 2, c: 1, d: 3 })?;
/// let third = kernel.push(&Construction::SegmentPoint { a: 0, b: 2, t: (1.0 / 3.0).into() })?;
/// assert_eq!(kernel.position(centre), [1.5, 0.5]);
/// let [a, c, centre, third] = [0, 2, centre, third].map(|id| id as usize);
/// assert_eq!(kernel.orient(&[a, c, centre]), Sign::Zero); // on the diagonal, exactly
/// assert_eq!(kernel.orient(&[a, c, third]), Sign::Zero); // though its position is rounded
/// # Ok::<(), delone_predicates::ConstructionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Constructed<const D: usize> {
    /// Of all vertices, the nearest doubles.
    positions: Vec<[f64; D]>,
    /// The place of a vertex among the values, or `PLAIN`; and whether it is `ROUNDED`.
    places: Vec<u32>,
    values: Vec<Value<D>>,
    /// Vertices of a smaller index are exact in doubles, and so are most calls known to be.
    exact_below: usize,
    extent: Extent<D>,
    /// Of the vertices that are exact in doubles.
    extent_exact: Extent<D>,
    /// Of calls on vertices that are exact in doubles.
    bounds: Bounds,
    /// Of the positions as nearest doubles.
    wide: Bounds,
    /// The largest magnitude of a coordinate of these.
    far: f64,
}

impl<const D: usize> Constructed<D> {
    /// A kernel over plain points, which may be none. Coordinates must be finite.
    #[must_use]
    pub fn new(points: Vec<[f64; D]>) -> Self {
        let mut extent = Extent::EMPTY;
        points.iter().for_each(|point| {
            extent.include(point);
        });
        let places = vec![PLAIN; points.len()];
        Self {
            exact_below: points.len(),
            positions: points,
            places,
            values: Vec::new(),
            extent,
            extent_exact: extent,
            bounds: extent.bounds(),
            wide: extent.wide_bounds(),
            far: extent.far(),
        }
    }

    /// The number of vertices.
    #[must_use]
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there are no vertices.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// Adds a plain point. Its id. O(1).
    ///
    /// # Panics
    /// If a coordinate is not finite, or if there are 2^32 - 1 points.
    pub fn push_plain(&mut self, point: [f64; D]) -> u32 {
        assert!(point.iter().all(|x| x.is_finite()), "{point:?} is not finite");
        self.add(point, PLAIN)
    }

    fn add(&mut self, position: [f64; D], place: u32) -> u32 {
        let id = u32::try_from(self.positions.len()).ok().filter(|&id| id != u32::MAX);
        self.positions.push(position);
        self.places.push(place);
        if self.extent.include(&position) {
            self.wide = self.extent.wide_bounds();
            self.far = self.extent.far();
        }
        if place & ROUNDED == 0 && self.extent_exact.include(&position) {
            self.bounds = self.extent_exact.bounds();
        }
        self.grow_exact();
        id.expect("fewer than 2^32 - 1 points")
    }

    /// Takes the last vertex away; whether there was one. The static bounds stay those of all that came.
    pub fn pop(&mut self) -> bool {
        if self.positions.pop().is_none() {
            return false;
        }
        if self.places.pop().is_some_and(|place| place != PLAIN) {
            self.values.pop();
        }
        self.exact_below = self.exact_below.min(self.positions.len());
        true
    }

    /// Moves `exact_below` over vertices that are exact: each once in all.
    fn grow_exact(&mut self) {
        while self.exact_below < self.positions.len() && !self.is_rounded(self.exact_below) {
            self.exact_below += 1;
        }
    }

    /// The double nearest to each coordinate; infinite where that is beyond the largest. For drawing and export.
    #[must_use]
    pub fn position(&self, id: u32) -> [f64; D] {
        self.positions[id as usize]
    }

    /// [`Constructed::position`] of all vertices, by id.
    #[must_use]
    pub fn positions(&self) -> &[[f64; D]] {
        &self.positions
    }

    /// Whether a vertex is a plain point.
    #[must_use]
    pub fn is_plain(&self, id: u32) -> bool {
        self.places[id as usize] & !ROUNDED == PLAIN
    }

    /// Whether [`Constructed::position`] is the vertex itself.
    #[must_use]
    pub fn is_exact_position(&self, id: u32) -> bool {
        !self.is_rounded(id as usize)
    }

    /// The vertex exactly: numerators over one positive denominator, which is 1 but for crossings.
    #[must_use]
    pub fn exact(&self, id: u32) -> Homogeneous<Dyadic, D> {
        self.exact_at(id as usize)
    }

    #[inline(always)]
    fn is_rounded(&self, v: usize) -> bool {
        self.places[v] & ROUNDED != 0
    }

    /// The value of a vertex that is not plain.
    fn value_at(&self, v: usize) -> Option<&Homogeneous<Dyadic, D>> {
        let place = self.places[v] & !ROUNDED;
        (place != PLAIN).then(|| self.values[place as usize].get())
    }

    pub(crate) fn exact_at(&self, v: usize) -> Homogeneous<Dyadic, D> {
        match self.value_at(v) {
            None => Homogeneous::plain(self.positions[v].map(Dyadic::from)),
            Some(exact) => exact.clone(),
        }
    }

    /// The vertex in doubles, if it is exact in them.
    #[inline]
    pub(crate) fn plain_at(&self, v: usize) -> Option<[f64; D]> {
        (!self.is_rounded(v)).then(|| self.positions[v])
    }

    pub(crate) fn approximate_at(&self, v: usize) -> Homogeneous<Approximate, D> {
        let rounded = self.is_rounded(v);
        let near = |x| if rounded { Approximate::nearest(x) } else { Approximate::exact(x) };
        Homogeneous::plain(self.positions[v].map(near))
    }

    /// The plain kernel over the nearest doubles: for calls on vertices that are such.
    #[inline(always)]
    fn nearest(&self) -> Adaptive<&[[f64; D]]> {
        Adaptive::bounded(&self.positions[..], self.bounds)
    }

    #[inline(always)]
    fn all_exact<V: Id>(&self, vertices: impl Iterator<Item = V>) -> bool {
        vertices.fold(0, |places, v| places | self.places[v.index()]) & ROUNDED == 0
    }

    /// The last stages: of the sign of a determinant over a ring.
    #[inline(never)]
    fn by_ring<V: Id>(
        &self,
        vertices: impl Iterator<Item = V> + Clone,
        formula: &impl Formula<D, Answer = Sign>,
        in_short: impl FnOnce(&Short<'_, D>) -> Option<Sign>,
    ) -> (Sign, Stage) {
        let near = vertices.clone().map(|v| self.approximate_at(v.index())).collect();
        if let Some(sign) = formula.answer(&Call { points: near, squares: SmallVec::new() }) {
            return (sign, Stage::DynamicFilter);
        }
        if let Some(sign) = in_short(&Short::new(self, vertices.clone())) {
            return (sign, Stage::FixedWidth);
        }
        let points = vertices.map(|v| self.exact_at(v.index())).collect();
        (exactly(formula, &Call { points, squares: SmallVec::new() }), Stage::Dyadic)
    }

    fn orient_by_ring<V: Id>(&self, axes: &[usize], simplex: &[V]) -> (Sign, Stage) {
        let k = axes.len();
        assert_eq!(simplex.len(), k + 1, "orient in {k} axes takes {} points", k + 1);
        self.by_ring(simplex.iter().copied(), &Orient(axes), |short| short.orient(axes))
    }

    fn lifted_by_ring<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> (Sign, Stage) {
        let k = axes.len();
        assert_eq!(simplex.len(), k + 1, "in_sphere in {k} axes takes {} points", k + 2);
        let vertices = simplex.iter().copied().chain([q]);
        self.by_ring(vertices, &Lifted(axes), |short| short.lifted(axes))
    }

    /// The first stage.
    #[inline(always)]
    fn by_static_filter(value: f64, bound: f64) -> Option<(Sign, Stage)> {
        (value.abs() > bound).then(|| (Sign::of(value), Stage::StaticFilter))
    }
}

/// The vertices of a call as points of N coordinates, where the caller knows that N is D.
#[inline(always)]
fn at<const D: usize, const N: usize, V: Id, const M: usize>(
    positions: &[[f64; D]],
    vertices: [V; M],
) -> [&[f64; N]; M] {
    vertices.map(|v| crate::adaptive::same(&positions[v.index()]))
}

impl<const D: usize> Kernel<D> for Constructed<D> {
    type Reordered = Self;

    /// The bounds stay those of all points of this kernel, also if `order` leaves some out.
    fn reordered(&self, order: &[u32]) -> Self {
        let mut values = Vec::new();
        let mut place_of = |&i: &u32| {
            let (place, rounded) = (self.places[i as usize] & !ROUNDED, self.places[i as usize]);
            if place == PLAIN {
                return PLAIN;
            }
            values.push(self.values[place as usize].clone());
            let place = u32::try_from(values.len() - 1).expect("no more values than vertices");
            place | rounded & ROUNDED
        };
        let places = order.iter().map(&mut place_of).collect();
        let positions = crate::adaptive::gather(&self.positions, order);
        let mut kernel = Self { positions, places, values, exact_below: 0, ..*self };
        kernel.grow_exact();
        kernel
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        if self.all_exact(simplex.iter().copied()) {
            return self.nearest().orient_on(axes, simplex);
        }
        self.orient_by_ring(axes, simplex).0
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        if self.all_exact(simplex.iter().copied().chain([q])) {
            return self.nearest().lifted_on(axes, simplex, q);
        }
        self.lifted_by_ring(axes, simplex, q).0
    }

    #[inline]
    fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
        let (u, v) = (u.index(), v.index());
        let (a, b) = (self.positions[u][axis], self.positions[v][axis]);
        match a.partial_cmp(&b).expect("nearest doubles are numbers") {
            Ordering::Equal if self.is_rounded(u) || self.is_rounded(v) => {
                let difference = ring::compare(&self.exact_at(u), &self.exact_at(v), axis);
                difference.cmp(&Dyadic::ZERO)
            }
            order => order,
        }
    }

    #[inline(always)]
    fn orient<V: Id>(&self, simplex: &[V]) -> Sign {
        self.orient_staged(simplex).0
    }

    #[inline(always)]
    fn lifted<V: Id>(&self, simplex: &[V], q: V) -> Sign {
        self.lifted_staged(simplex, q).0
    }

    #[inline(always)]
    fn orient_staged<V: Id>(&self, simplex: &[V]) -> (Sign, Stage) {
        if simplex.iter().rev().all(|v| v.index() < self.exact_below) {
            return self.nearest().orient_staged(simplex);
        }
        self.orient_mixed(simplex)
    }

    #[inline(always)]
    fn lifted_staged<V: Id>(&self, simplex: &[V], q: V) -> (Sign, Stage) {
        // The last first: it is often a vertex that has just been added.
        if [&q].into_iter().chain(simplex).all(|v| v.index() < self.exact_below) {
            return self.nearest().lifted_staged(simplex, q);
        }
        self.lifted_mixed(simplex, q)
    }
}

/// Calls on vertices of which some may be rounded.
impl<const D: usize> Constructed<D> {
    /// The filter by the call's own differences, in the plane.
    #[inline]
    fn orient_locally<V: Id>(&self, simplex: &[V], value: f64) -> Option<(Sign, Stage)> {
        let sign = match *simplex {
            [a, b, c] if D == 2 => local::orient2d(at(&self.positions, [a, b, c]), value),
            _ => None,
        };
        sign.map(|sign| (sign, Stage::DynamicFilter))
    }

    /// The same.
    #[inline]
    fn lifted_locally<V: Id>(&self, simplex: &[V], q: V) -> Option<(Sign, Stage)> {
        let sign = match *simplex {
            [a, b, c] if D == 2 => local::in_circle(at(&self.positions, [a, b, c, q])),
            _ => None,
        };
        sign.map(|sign| (sign, Stage::DynamicFilter))
    }

    /// The same of a scalar product.
    #[inline]
    pub(crate) fn dot_locally<V: Id>(&self, vertices: [V; 4]) -> Option<Sign> {
        if D == 2 { local::dot(at(&self.positions, vertices)) } else { None }
    }

    /// The orientation in nearest doubles; 0 in dimensions without a filter.
    #[inline(always)]
    fn orient_value<V: Id>(&self, simplex: &[V]) -> f64 {
        match *simplex {
            [a, b, c] if D == 2 => {
                let [a, b, c] = at(&self.positions, [a, b, c]);
                value::orient2d(a, b, c)
            }
            [a, b, c, d] if D == 3 => value::orient3d(at(&self.positions, [a, b, c, d])),
            _ => 0.0,
        }
    }

    // The filters hold for exact vertices too: whether all are is asked only where these do not decide, so that most calls look at
    // positions and at nothing else.
    #[inline]
    fn orient_mixed<V: Id>(&self, simplex: &[V]) -> (Sign, Stage) {
        let value = self.orient_value(simplex);
        Self::by_static_filter(value, self.wide.orient)
            .or_else(|| self.orient_locally(simplex, value))
            .unwrap_or_else(|| self.orient_unfiltered(simplex))
    }

    #[inline]
    fn lifted_mixed<V: Id>(&self, simplex: &[V], q: V) -> (Sign, Stage) {
        let certain = match *simplex {
            [a, b, c] if D == 2 => {
                let points = at(&self.positions, [a, b, c, q]);
                let (value, heights) = value::in_circle_and_heights(points);
                Self::by_static_filter(value, self.wide.lifted).or_else(|| {
                    let sign = local::in_circle_within(value, heights, self.far)?;
                    Some((sign, Stage::DynamicFilter))
                })
            }
            [a, b, c, d] if D == 3 => {
                let value = value::in_sphere(at(&self.positions, [a, b, c, d, q]));
                Self::by_static_filter(value, self.wide.lifted)
            }
            _ => None,
        };
        certain.unwrap_or_else(|| self.lifted_unfiltered(simplex, q))
    }

    #[inline(never)]
    fn orient_unfiltered<V: Id>(&self, simplex: &[V]) -> (Sign, Stage) {
        if self.all_exact(simplex.iter().copied()) {
            return self.nearest().orient_staged(simplex);
        }
        self.orient_by_ring(&all_axes::<D>(), simplex)
    }

    #[inline(never)]
    fn lifted_unfiltered<V: Id>(&self, simplex: &[V], q: V) -> (Sign, Stage) {
        if let Some(certain) = self.lifted_locally(simplex, q) {
            return certain;
        }
        if self.all_exact(simplex.iter().copied().chain([q])) {
            return self.nearest().lifted_staged(simplex, q);
        }
        self.lifted_by_ring(&all_axes::<D>(), simplex, q)
    }
}

impl PlaneKernel for Constructed<2> {
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        if self.all_exact(vertices.into_iter()) {
            return self.nearest().cross(vertices);
        }
        let value = value::cross(at(&self.positions, vertices));
        if let Some((sign, _)) = Self::by_static_filter(value, self.wide.orient) {
            return sign;
        }
        self.by_ring(vertices.into_iter(), &Cross, |_| None).0
    }
}
