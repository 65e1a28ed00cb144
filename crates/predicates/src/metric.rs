//! Comparisons of lengths, angles and radii: what alpha shapes and mesh refinement ask besides.
//!
//! **Stages.** Lengths and radii of plain points: fixed widths, which decide alone if coordinates are short enough over one unit
//! (`metric/words.rs`): quicker than a filter of the general formula. Else the formula in doubles that carry their error
//! bounds ([`Approximate`]), and where these do not decide, in dyadic numbers of any length ([`Dyadic`]).
//!
//! **The radius.** With the edges v_i from the first vertex of a k-simplex, their Gram matrix G and heights h_i = |v_i|^2,
//! the centre is at sum l_i v_i with 2 G l = h, and the squared radius is h^T adj(G) h / (4 det G): in any dimension, degree 2k + 2 over
//! 2k. With weights, h_i = |v_i|^2 - w_i + w_0, and the squared radius of the orthogonal sphere is that less w_0.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a flat simplex | its radius is infinite, greater than all others and equal to each such | `flat_simplices_have_an_infinite_radius` |
//! | one vertex | squared radius 0, or its weight negated | `the_radius_of_a_vertex_is_its_weight` |
//! | an angle with an empty side | counts as zero | `an_angle_with_an_empty_side_is_zero` |
//! | a point on the smallest sphere through a simplex | zero | `in_smallest_sphere_is_the_sign_of_the_power` |
//! | equal radii of different simplices | equal | `radii_on_a_grid_tie` |

use std::cmp::Ordering;

use smallvec::SmallVec;

use crate::adaptive::{Adaptive, Exact, point};
use crate::formula::{Call, Formula, exactly, in_words};
use crate::kernel::{Id, Kernel};
use crate::ring::Homogeneous;
use crate::{Approximate, Constructed, Dyadic, Sign, Weighted};
use ball::{InBall, Weights};
use formulas::{Angles, Dot, Lengths, Radius, RadiusOver};

pub use ball::SquaredRadius;
pub use circumball::Circumball;
pub(crate) use formulas::Radii;

mod ball;
mod circumball;
mod formulas;
#[cfg(test)]
mod tests;
mod words;

/// A kernel that also compares lengths, angles and radii, exactly.
///
/// ```
/// use std::cmp::Ordering;
/// use delone_predicates::{Adaptive, Metric};
/// let kernel = Adaptive::new([[0.0, 0.0], [3.0, 0.0], [0.0, 4.0], [0.6, 0.8]]);
/// assert_eq!(kernel.compare_radius(&[0usize, 1, 2], 6.25), Ordering::Equal); // 2.5 squared
/// assert_eq!(kernel.squared_radius(&[1usize, 2]), 6.25);
/// assert_eq!(kernel.compare_radii(&[0usize, 1, 2], &[1, 2]), Ordering::Equal);
/// assert_eq!(kernel.compare_lengths([0usize, 1], [0, 2]), Ordering::Less);
/// assert_eq!(kernel.compare_angles([0usize, 1, 2], [0, 2, 1]), Ordering::Greater); // at 1, at 2
/// ```
pub trait Metric<const D: usize>: Kernel<D> {
    /// The point of a vertex, each coordinate off by a known bound.
    fn approximate_point<V: Id>(&self, v: V) -> Homogeneous<Approximate, D>;

    /// The point of a vertex.
    fn exact_point<V: Id>(&self, v: V) -> Homogeneous<Dyadic, D>;

    /// The point of a vertex, if its coordinates are doubles and the kernel may answer by a quicker way for these.
    #[inline]
    fn plain_point<V: Id>(&self, _v: V) -> Option<[f64; D]> {
        None
    }

    /// The weight of a vertex, in a kernel of weighted sites.
    #[inline]
    fn weight_of<V: Id>(&self, _v: V) -> Option<f64> {
        None
    }

    /// The sign of `(b - a) . (d - c)`: positive if `d` is further than `c` in the direction from `a` to `b`. At one vertex,
    /// `dot([z, p, z, q])` is positive for an acute angle, zero for a right one.
    fn dot<V: Id>(&self, vertices: [V; 4]) -> Sign {
        decided(self, &Dot, vertices.into_iter(), std::iter::empty())
    }

    /// Whether |ab| is less than, equal to or greater than |cd|.
    fn compare_lengths<V: Id>(&self, ab: [V; 2], cd: [V; 2]) -> Ordering {
        decided(self, &Lengths, ab.into_iter().chain(cd), std::iter::empty())
    }

    /// The order of two angles between 0 and 180 degrees, each of three vertices and at the second of them.
    fn compare_angles<V: Id>(&self, abc: [V; 3], def: [V; 3]) -> Ordering {
        decided(self, &Angles, abc.into_iter().chain(def), std::iter::empty())
    }

    /// The order of the radii of the circumspheres of two simplices of one to D+1 vertices, each within its flat; with weights,
    /// of the squared radii of the spheres orthogonal to them, which may be negative. That of a flat simplex is infinite.
    ///
    /// # Panics
    /// If a simplex has no vertices.
    fn compare_radii<V: Id>(&self, s: &[V], t: &[V]) -> Ordering {
        assert!(!s.is_empty() && !t.is_empty(), "a simplex has a vertex");
        let vertices = s.iter().chain(t).copied();
        decided(self, &Radii(s.len()), vertices.clone(), weights(self, vertices))
    }

    /// The order of the squared radius of a simplex, as in [`Metric::compare_radii`], and a bound, which may be infinite.
    ///
    /// # Panics
    /// If the simplex has no vertices, or the bound is not a number.
    fn compare_radius<V: Id>(&self, simplex: &[V], bound: f64) -> Ordering {
        assert!(!bound.is_nan(), "a bound is a number");
        if !bound.is_finite() {
            let flat = || exact_radius(self, simplex).is_infinite();
            let infinite = bound > 0.0 && flat();
            return if infinite { Ordering::Equal } else { 0.0f64.total_cmp(&bound) };
        }
        let vertices = simplex.iter().copied();
        decided(self, &RadiusOver, vertices.clone(), weights(self, vertices).chain([bound]))
    }

    /// The double nearest to the squared radius of a simplex, as in [`Metric::compare_radii`].
    ///
    /// # Panics
    /// If the simplex has no vertices.
    fn squared_radius<V: Id>(&self, simplex: &[V]) -> f64 {
        self.exact_squared_radius(simplex).to_f64()
    }

    /// The squared radius of a simplex, as in [`Metric::compare_radii`].
    ///
    /// # Panics
    /// If the simplex has no vertices.
    fn exact_squared_radius<V: Id>(&self, simplex: &[V]) -> SquaredRadius {
        let Radius { numerator, denominator } = exact_radius(self, simplex);
        SquaredRadius::new(numerator, denominator)
    }

    /// What doubles tell of a simplex with at most four vertices, which are plain points of at most three axes; for all its facets at
    /// once.
    ///
    /// ```
    /// use delone_predicates::{Adaptive, Metric, Sign};
    /// let kernel = Adaptive::new([[0.0, 0.0], [8.0, 0.0], [4.0, 1.0]]);
    /// let ball = kernel.circumball(&[0usize, 1, 2]).unwrap();
    /// assert_eq!(ball.inside[2], Some(Sign::Positive)); // an obtuse angle
    /// assert!(ball.squared_radius[0] <= 72.25 && 72.25 <= ball.squared_radius[1]);
    /// ```
    #[inline]
    fn circumball<V: Id>(&self, simplex: &[V]) -> Option<Circumball> {
        with_plain(self, simplex.iter().copied(), circumball::circumball).flatten()
    }

    /// Two doubles that the squared radius of a simplex is between; infinite where nothing is known.
    ///
    /// # Panics
    /// If the simplex has no vertices.
    fn radius_bounds<V: Id>(&self, simplex: &[V]) -> [f64; 2] {
        if let Some(ball) = self.circumball(simplex) {
            return ball.squared_radius;
        }
        let vertices = simplex.iter().copied();
        let points: SmallVec<[_; 4]> =
            vertices.clone().map(|v| self.approximate_point(v)).collect();
        let weights: Weights<_> = weights(self, vertices).map(Approximate::exact).collect();
        ball::bounds(&Radius::of_simplex(&points, (!weights.is_empty()).then_some(&weights[..])))
    }

    /// Positive if `q` is strictly inside the smallest sphere through the vertices of a simplex that is not flat, which has its
    /// centre in the simplex's own flat; with weights, if the power of `q`, less its weight, to the smallest orthogonal
    /// sphere is negative.
    ///
    /// # Panics
    /// If the simplex has no vertices.
    fn in_smallest_sphere<V: Id>(&self, simplex: &[V], q: V) -> Sign {
        assert!(!simplex.is_empty(), "a simplex has a vertex");
        let vertices = simplex.iter().copied().chain([q]);
        let of_all = with_plain(self, vertices.clone(), circumball::circumball).flatten();
        if let Some(sign) = of_all.and_then(|ball| *ball.inside.get(simplex.len())?) {
            return sign;
        }
        decided(self, &InBall, vertices.clone(), weights(self, vertices))
    }
}

/// Calls `answer` with the points, if there are at most four and all are plain.
#[inline(always)]
fn with_plain<const D: usize, V: Id, K: Metric<D> + ?Sized, A>(
    kernel: &K,
    vertices: impl Iterator<Item = V>,
    answer: impl FnOnce(&[[f64; D]]) -> A,
) -> Option<A> {
    let (mut points, mut count) = ([[0.0; D]; 4], 0);
    for v in vertices {
        *points.get_mut(count)? = kernel.plain_point(v)?;
        count += 1;
    }
    Some(answer(&points[..count]))
}

/// The answer: in words if the points are plain and short; else by doubles if they suffice, and exactly if not.
fn decided<const D: usize, V: Id, K: Metric<D> + ?Sized, F: Formula<D>>(
    kernel: &K,
    formula: &F,
    vertices: impl Iterator<Item = V> + Clone,
    squares: impl Iterator<Item = f64> + Clone,
) -> F::Answer {
    if F::HAS_WORDS && squares.clone().next().is_none() {
        let plain = vertices.clone().map(|v| kernel.plain_point(v));
        if let Some(answer) = in_words(formula, plain) {
            return answer;
        }
    }
    in_general(kernel, formula, vertices, squares)
}

#[inline(never)]
fn in_general<const D: usize, V: Id, K: Metric<D> + ?Sized, F: Formula<D>>(
    kernel: &K,
    formula: &F,
    vertices: impl Iterator<Item = V> + Clone,
    squares: impl Iterator<Item = f64> + Clone,
) -> F::Answer {
    let points = vertices.clone().map(|v| kernel.approximate_point(v)).collect();
    let near = Call { points, squares: squares.clone().map(Approximate::exact).collect() };
    formula.answer(&near).unwrap_or_else(|| {
        let points = vertices.map(|v| kernel.exact_point(v)).collect();
        exactly(formula, &Call { points, squares: squares.map(Dyadic::from).collect() })
    })
}

/// The weights of all vertices, or none.
fn weights<const D: usize, V: Id, K: Metric<D> + ?Sized>(
    kernel: &K,
    vertices: impl Iterator<Item = V> + Clone,
) -> impl Iterator<Item = f64> + Clone {
    vertices.filter_map(|v| kernel.weight_of(v))
}

fn exact_radius<const D: usize, V: Id, K: Metric<D> + ?Sized>(
    kernel: &K,
    simplex: &[V],
) -> Radius<Dyadic> {
    let vertices = simplex.iter().copied();
    let points: SmallVec<[_; 4]> = vertices.clone().map(|v| kernel.exact_point(v)).collect();
    let weights: SmallVec<[_; 4]> = weights(kernel, vertices).map(Dyadic::from).collect();
    Radius::of_simplex(&points, (!weights.is_empty()).then_some(&weights[..]))
}

/// For kernels over plain points.
macro_rules! plain {
    ($kernel:ident, $near:expr, $plain:expr) => {
        impl<const D: usize, P: AsRef<[[f64; D]]>> Metric<D> for $kernel<P> {
            fn approximate_point<V: Id>(&self, v: V) -> Homogeneous<Approximate, D> {
                Homogeneous::plain(point(self.given(), v).map($near))
            }

            fn exact_point<V: Id>(&self, v: V) -> Homogeneous<Dyadic, D> {
                Homogeneous::plain(point(self.given(), v).map(Dyadic::from))
            }

            #[inline]
            fn plain_point<V: Id>(&self, v: V) -> Option<[f64; D]> {
                $plain.then(|| *point(self.given(), v))
            }
        }
    };
}

plain!(Adaptive, Approximate::exact, true);
plain!(Exact, Approximate::unknown, false); // no filter, no quicker way

impl<const D: usize, P: AsRef<[[f64; D]]>, W: AsRef<[f64]>> Metric<D> for Weighted<P, W> {
    fn approximate_point<V: Id>(&self, v: V) -> Homogeneous<Approximate, D> {
        self.sites().approximate_point(v)
    }

    fn exact_point<V: Id>(&self, v: V) -> Homogeneous<Dyadic, D> {
        self.sites().exact_point(v)
    }

    fn weight_of<V: Id>(&self, v: V) -> Option<f64> {
        Some(self.weight(v))
    }
}

impl<const D: usize> Metric<D> for Constructed<D> {
    fn dot<V: Id>(&self, vertices: [V; 4]) -> Sign {
        self.dot_locally(vertices)
            .unwrap_or_else(|| decided(self, &Dot, vertices.into_iter(), std::iter::empty()))
    }

    fn approximate_point<V: Id>(&self, v: V) -> Homogeneous<Approximate, D> {
        self.approximate_at(v.index())
    }

    fn exact_point<V: Id>(&self, v: V) -> Homogeneous<Dyadic, D> {
        self.exact_at(v.index())
    }

    #[inline]
    fn plain_point<V: Id>(&self, v: V) -> Option<[f64; D]> {
        self.plain_at(v.index())
    }
}
