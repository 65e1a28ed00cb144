//! Exact predicates on points in doubles, and the kernel through which algorithms ask them.
//!
//! ```
//! use delone_predicates::{Sign, in_circle, orient2d};
//!
//! let (a, b, c) = ([0.0, 0.0], [4.0, 0.0], [0.0, 4.0]);
//! assert_eq!(orient2d(a, b, c), Sign::Positive); // a left turn
//! assert_eq!(in_circle(a, b, c, [1.0, 1.0]), Sign::Positive); // inside
//! assert_eq!(in_circle(a, b, c, [4.0, 4.0]), Sign::Zero); // on the circle, exactly
//! ```
//!
//! # Which one do I want
//!
//! | you have | use |
//! |---|---|
//! | a few points | the free functions [`orient2d`], [`orient3d`], [`in_circle`], [`in_sphere`], [`orient`] |
//! | many points with ids, an algorithm to write | [`Kernel`], with [`Adaptive`] |
//! | one simplex and many points, or the reverse | [`batch`], filters by columns |
//! | sites with weights, for regular triangulations | [`Weighted`] |
//! | points on segments, crossings of lines and planes, exact | [`Constructed`] |
//! | lengths, angles, radii to compare | [`Metric`], which these kernels are |
//! | a sweep of the plane to write | [`SweepKernel`] |
//! | doubts about a filter | [`Exact`], the same answers without filters |
//! | exact numbers of another crate | [`ExactOver`], over any ring; feature `rug` for GMP's |
//! | an opponent to compare with | [`RobustCrate`] (expansions), [`Naive`] (plain doubles) |
//! | to know what is asked, and which stage answers | [`Counting`] around any kernel |
//! | a kernel to watch | [`Checked`]: panics where another kernel answers otherwise |
//! | points of R^D in a K-flat | [`Projected`] |
//!
//! All kernels are there in every dimension up to [`DIMENSION_MAX`]: filters of their own in two and three, one for any
//! beyond. [`RobustCrate`] has the predicates of `robust` in two and three, exact integers beyond. [`PlaneKernel`] is of the
//! plane; of the [`Construction`]s, crossings of lines are of the plane, those of planes of space, points on segments of any.
//!
//! # Contract
//!
//! Coordinates are finite doubles, any of them: from 5e-324 to the largest, in one call. Answers are exact. A wrong
//! number of vertices panics and says how many were expected. No recursion that depends on values; no allocation, but for
//! constructed points, other numbers, and comparisons of radii, where numbers are as long as they need to be.
//!
//! # Inside
//!
//! `filter` (doubles, when they suffice), `exact` over `int` (aligned integers, always right), [`perturb`] (ties).
//!
//! **Not here.** Validation of input: `delone-sites`.

mod adaptive;
mod approximate;
pub mod batch;
mod checked;
mod constructed;
mod counting;
mod dyadic;
mod exact;
mod exact_over;
mod filter;
mod formula;
mod int;
mod kernel;
mod metric;
mod naive;
pub mod perturb;
mod projected;
mod ring;
mod robust_crate;
mod sign;
mod stage;
mod sweep;
mod weighted;

pub use adaptive::{Adaptive, Exact};
pub use approximate::Approximate;
pub use checked::Checked;
pub use constructed::{Constructed, Construction, ConstructionError};
pub use counting::{Counting, Question, Tally};
pub use dyadic::Dyadic;
pub use exact_over::ExactOver;
pub use filter::outlook::{Outlook, Sight};
pub use kernel::{Id, Kernel, PlaneKernel, all_axes};
pub use metric::{Circumball, Metric, SquaredRadius};
pub use naive::Naive;
pub use projected::Projected;
pub use ring::{Homogeneous, Ring};
pub use robust_crate::RobustCrate;
pub use sign::{Side, Sign};
pub use stage::Stage;
pub use sweep::{CircleEvent, SweepKernel};
pub use weighted::Weighted;

/// The largest dimension that predicates go to.
pub const DIMENSION_MAX: usize = exact::AXES_MAX;

/// Positive if `a`, `b`, `c` make a left turn.
#[inline]
#[must_use]
pub fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Sign {
    filter::orient2d(&a, &b, &c, f64::INFINITY).unwrap_or_else(|| exact::orient2d(&a, &b, &c)).0
}

/// The sign of `det[b - a; c - a; d - a]`: positive for the origin and the three unit vectors in order.
#[inline]
#[must_use]
pub fn orient3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Sign {
    let certain = filter::orient3d([&a, &b, &c, &d], f64::INFINITY);
    certain.unwrap_or_else(|| exact::orient3d(&a, &b, &c, &d)).0
}

/// Positive if `d` is strictly inside the circle through `a`, `b`, `c`, these being counter-clockwise.
#[inline]
#[must_use]
pub fn in_circle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Sign {
    let certain = filter::in_circle([&a, &b, &c, &d], f64::INFINITY);
    certain.unwrap_or_else(|| exact::in_circle(&a, &b, &c, &d)).0
}

/// Positive if `e` is strictly inside the sphere through `a`, `b`, `c`, `d`, these being positively oriented.
#[inline]
#[must_use]
pub fn in_sphere(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3], e: [f64; 3]) -> Sign {
    let certain = filter::in_sphere([&a, &b, &c, &d, &e], f64::INFINITY);
    certain.unwrap_or_else(|| exact::in_sphere(&a, &b, &c, &d, &e)).0
}

/// The orientation of D+1 points of R^D: the sign of `det[p1 - p0; ..; pD - p0]`.
///
/// # Panics
/// If there are not D+1 points.
#[inline]
#[must_use]
pub fn orient<const D: usize>(points: &[[f64; D]]) -> Sign {
    assert_eq!(points.len(), D + 1, "orient in {D} dimensions takes {} points", D + 1);
    let ids: [usize; DIMENSION_MAX + 1] = std::array::from_fn(|i| i);
    Adaptive::dynamic(points).orient(&ids[..=D])
}

#[cfg(test)]
#[expect(clippy::cast_possible_truncation, reason = "the numbers of the tests are small")]
mod tests;
