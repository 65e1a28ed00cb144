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
//! | doubts about a filter | [`Exact`], the same answers without filters |
//! | points of R^D in a K-flat | [`Projected`] |
//!
//! # Contract
//!
//! Coordinates are finite doubles, any of them: from 5e-324 to the largest, in one call. Answers are exact. A wrong
//! number of vertices panics and says how many were expected. No allocation, no recursion that depends on values.
//!
//! # Inside
//!
//! `filter` (doubles, when they suffice), `determinant` over `int` (aligned integers, always right), [`perturb`] (ties).
//!
//! **Not here.** Validation of input: `delone-sites`.

mod adaptive;
mod determinant;
mod filter;
mod int;
mod kernel;
pub mod perturb;
mod projected;
mod sign;

pub use adaptive::{Adaptive, Exact};
pub use kernel::{Id, Kernel, PlaneKernel, all_axes};
pub use projected::Projected;
pub use sign::{Side, Sign};

/// The largest dimension that predicates go to.
pub const DIMENSION_MAX: usize = determinant::AXES_MAX;

/// Positive if `a`, `b`, `c` make a left turn.
#[inline]
#[must_use]
pub fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Sign {
    orient(&[a, b, c])
}

/// The sign of `det[b - a; c - a; d - a]`: positive for the origin and the three unit vectors in order.
#[inline]
#[must_use]
pub fn orient3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Sign {
    orient(&[a, b, c, d])
}

/// Positive if `d` is strictly inside the circle through `a`, `b`, `c`, these being counter-clockwise.
#[inline]
#[must_use]
pub fn in_circle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Sign {
    Adaptive::new([a, b, c, d]).lifted(&[0usize, 1, 2], 3)
}

/// Positive if `e` is strictly inside the sphere through `a`, `b`, `c`, `d`, these being positively oriented.
#[inline]
#[must_use]
pub fn in_sphere(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3], e: [f64; 3]) -> Sign {
    Adaptive::new([a, b, c, d, e]).lifted(&[0usize, 1, 2, 3], 4)
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
    Adaptive::new(points).orient(&ids[..=D])
}

#[cfg(test)]
#[expect(clippy::cast_possible_truncation, reason = "the numbers of the tests are small")]
mod tests;
