//! Degenerate inputs made by hand: small, each with a reason.

mod plane;
mod pslg;
mod space;

pub use plane::plane;
pub use pslg::pslgs;
pub use space::space;

/// The largest double, the smallest, and the smallest normal one.
const HUGE: f64 = f64::MAX;
const TINY: f64 = 5e-324;

/// Integers as a coordinate.
fn real(i: i32) -> f64 {
    f64::from(i)
}
