//! The kernel of weighted sites: in_sphere is the power test, and a Delaunay algorithm under it makes the regular
//! triangulation.
//!
//! A site p of weight w is lifted to |p|^2 - w. Relative to the query q, in whose frame determinants are computed, that is
//! |p - q|^2 + (weight of q - w): the rest is linear in p - q and falls out. Equal weights change nothing.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | `q` has power zero to the orthosphere | the perturbation decides, by rank | `power_ties_equal_explicit_infinitesimals` |
//! | equal positions of different weights | ranked by weight | `equal_positions_are_ranked_by_weight` |

use std::cmp::Ordering;

use crate::adaptive::{Adaptive, slices};
use crate::kernel::{Id, Kernel, PlaneKernel, all_axes};
use crate::{Sign, Stage, exact, filter};

/// Sites with weights: filters, then exact integers. Weights are finite doubles, of either sign.
///
/// ```
/// use delone_predicates::{Kernel, Sign, Weighted};
/// let sites = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [4.0, 4.0]];
/// let kernel = Weighted::new(sites, [0.0, 0.0, 0.0, 0.25]);
/// assert_eq!(kernel.lifted(&[0usize, 1, 2], 3), Sign::Positive); // its weight lets it in
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Weighted<P, W> {
    sites: Adaptive<P>,
    weights: W,
}

impl<P, W: AsRef<[f64]>> Weighted<P, W> {
    /// A kernel over these points, with one weight for each.
    ///
    /// # Panics
    /// If there are not as many weights as points, or if one is not finite.
    pub fn new<const D: usize>(points: P, weights: W) -> Self
    where
        P: AsRef<[[f64; D]]>,
    {
        let (sites, count) = (points.as_ref().len(), weights.as_ref().len());
        assert_eq!(sites, count, "{sites} sites have {count} weights");
        let bad = weights.as_ref().iter().position(|weight| !weight.is_finite());
        assert_eq!(bad, None, "the weight of that site is not finite");
        Self { sites: Adaptive::new(points), weights }
    }

    /// The points.
    pub fn points<const D: usize>(&self) -> &[[f64; D]]
    where
        P: AsRef<[[f64; D]]>,
    {
        self.sites.points()
    }

    pub(crate) const fn sites(&self) -> &Adaptive<P> {
        &self.sites
    }

    pub(crate) fn weight(&self, v: impl Id) -> f64 {
        self.weights.as_ref()[v.index()]
    }

    /// The weights of a simplex and a query, in that order.
    fn weights_of<V: Id>(&self, simplex: &[V], q: V) -> [f64; exact::POINTS_MAX] {
        let mut weights = [0.0; exact::POINTS_MAX];
        for (slot, &v) in weights.iter_mut().zip(simplex.iter().chain([&q])) {
            *slot = self.weight(v);
        }
        weights
    }
}

impl<const D: usize, P, W> Kernel<D> for Weighted<P, W>
where
    P: AsRef<[[f64; D]]>,
    W: AsRef<[f64]>,
{
    type Reordered = Weighted<Vec<[f64; D]>, Vec<f64>>;

    const HIDES: bool = true;

    fn reordered(&self, order: &[u32]) -> Self::Reordered {
        let weights = order.iter().map(|&i| self.weights.as_ref()[i as usize]).collect();
        Weighted { sites: self.sites.reordered(order), weights }
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        self.sites.orient_on(axes, simplex)
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        let weights = self.weights_of(simplex, q);
        self.sites.with(simplex, Some(q), |points| {
            let count = points.len();
            exact::lifted(&slices(points)[..count], axes, Some(&weights[..count])).0
        })
    }

    #[inline]
    fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
        self.sites.compare(axis, u, v)
    }

    /// By position, then by weight.
    fn compare_lexicographic<V: Id>(&self, u: V, v: V) -> Ordering {
        let by_weight = || self.weight(u).partial_cmp(&self.weight(v)).expect("weights are finite");
        self.sites.compare_lexicographic(u, v).then_with(by_weight)
    }

    #[inline]
    fn orient<V: Id>(&self, simplex: &[V]) -> Sign {
        self.sites.orient(simplex)
    }

    #[inline]
    fn lifted<V: Id>(&self, simplex: &[V], q: V) -> Sign {
        self.lifted_staged(simplex, q).0
    }

    #[inline]
    fn orient_staged<V: Id>(&self, simplex: &[V]) -> (Sign, Stage) {
        self.sites.orient_staged(simplex)
    }

    fn lifted_staged<V: Id>(&self, simplex: &[V], q: V) -> (Sign, Stage) {
        let weights = self.weights_of(simplex, q);
        self.sites.with(simplex, Some(q), |points| {
            let count = points.len();
            let weights = &weights[..count];
            let certain =
                if count == D + 2 { filter::any::lifted(points, Some(weights)) } else { None };
            let all = all_axes::<D>();
            certain.unwrap_or_else(|| exact::lifted(&slices(points)[..count], &all, Some(weights)))
        })
    }
}

impl<P: AsRef<[[f64; 2]]>, W: AsRef<[f64]>> PlaneKernel for Weighted<P, W> {
    #[inline]
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        self.sites.cross(vertices)
    }
}
