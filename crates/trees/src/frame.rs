//! Root cubes whose cells have corners in doubles, exactly.
//!
//! **In / Out.** Points and a depth m; a cube of side L = 2^e that holds them, its corner a multiple of L / 2^k with k = max(m, 10).
//! So all depths up to ten have the same cube. The resolution is r = L / 2^m.
//!
//! **Invariants.** 1. All corners and centres of cells of levels up to m are doubles: multiples of L / 2^(k+1), none beyond 2^53 of them.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | no points, or all equal | a cube of side 1, or as large as the largest coordinate | `points_without_extent_have_a_frame` |
//! | L / 2^(k+1) is below what doubles tell apart there | refused | `frames_finer_than_doubles_are_refused` |
//! | coordinates as far apart as doubles go | refused | `frames_larger_than_doubles_are_refused` |

use std::fmt;

use crate::{Cell, DEPTH_MAX};

#[cfg(test)]
mod tests;

/// A cube of R^N to grow a tree in, down to a depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<const N: usize> {
    corner: [f64; N],
    side: f64,
    depth: u8,
}

/// Why there is no such frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FrameFault {
    /// Deeper than [`DEPTH_MAX`], or corners of cells are no doubles.
    TooFine {
        /// The depth asked for.
        depth: u8,
    },
    /// The cube's side, or its corner, is beyond the largest double.
    TooLarge,
    /// A coordinate is no finite number.
    NotFinite {
        /// The index of the point.
        point: usize,
    },
}

impl fmt::Display for FrameFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFine { depth } => {
                write!(
                    f,
                    "cells of depth {depth} have corners that are no doubles: ask for fewer levels"
                )
            }
            Self::TooLarge => {
                f.write_str("the cube around the points is beyond doubles: scale them down")
            }
            Self::NotFinite { point } => {
                write!(f, "point {point} has a coordinate that is no number: give finite ones")
            }
        }
    }
}

impl std::error::Error for FrameFault {}

impl<const N: usize> Frame<N> {
    /// A cube around points, its side the least power of two for which there is such a corner.
    ///
    /// ```
    /// use delone_trees::Frame;
    ///
    /// let frame = Frame::around(&[[1.0, 5.0], [3.5, 2.0]], 4)?;
    /// assert_eq!((frame.corner(), frame.side(), frame.resolution()), ([1.0, 2.0], 4.0, 0.25));
    /// # Ok::<(), delone_trees::FrameFault>(())
    /// ```
    ///
    /// # Errors
    /// If a coordinate is no finite number, or the cube or its cells are beyond doubles.
    pub fn around(points: &[[f64; N]], depth: u8) -> Result<Self, FrameFault> {
        if depth > DEPTH_MAX {
            return Err(FrameFault::TooFine { depth });
        }
        if let Some(point) = points.iter().position(|p| p.iter().any(|c| !c.is_finite())) {
            return Err(FrameFault::NotFinite { point });
        }
        let (lower, upper) = extremes(points);
        let extent = (0..N).map(|axis| upper[axis] - lower[axis]).fold(0.0, f64::max);
        let largest = lower.iter().chain(&upper).fold(0.0f64, |max, c| max.max(c.abs()));
        let about = if extent > 0.0 {
            extent
        } else if largest > 0.0 {
            largest
        } else {
            1.0
        };
        let levels = i32::from(depth.max(CORNER_LEVELS));
        // The extent was rounded, and the corner goes down to a multiple of at most side / 2: the third cube holds all.
        for exponent in exponent(about)..=exponent(about) + 2 {
            let side = power(exponent).ok_or(FrameFault::TooLarge)?;
            let Some(step) = power(exponent - levels - 1).map(|half| 2.0 * half) else {
                continue; // a larger cube has larger cells
            };
            if largest / step > LATTICE_MAX {
                continue;
            }
            let corner = lower.map(|c| below(c, step));
            if (0..N).all(|axis| corner[axis] + side >= upper[axis]) {
                let fits = (0..N).all(|axis| (corner[axis].abs() + side) / step <= LATTICE_MAX);
                let frame = Self { corner, side, depth };
                return if fits { Ok(frame) } else { Err(FrameFault::TooFine { depth }) };
            }
        }
        Err(FrameFault::TooFine { depth })
    }

    /// The corner with the least coordinates.
    #[must_use]
    pub fn corner(&self) -> [f64; N] {
        self.corner
    }

    /// The side L of the cube, a power of two.
    #[must_use]
    pub fn side(&self) -> f64 {
        self.side
    }

    /// The level m of the smallest cells.
    #[must_use]
    pub fn depth(&self) -> u8 {
        self.depth
    }

    /// The side L / 2^m of the smallest cells.
    #[must_use]
    pub fn resolution(&self) -> f64 {
        self.side_of(self.depth)
    }

    fn side_of(&self, level: u8) -> f64 {
        self.side / f64::from(1u32 << level)
    }

    /// The least and the largest corner of a cell, exactly.
    #[must_use]
    pub fn corners(&self, cell: Cell<N>) -> [[f64; N]; 2] {
        let side = self.side_of(cell.level());
        let at = |place: u32, axis: usize| self.corner[axis] + f64::from(place) * side; // Inv 1
        let anchor = cell.anchor();
        [0, 1].map(|upper| std::array::from_fn(|axis| at(anchor[axis] + upper, axis)))
    }

    /// A corner of the smallest cells by its place among them, exactly.
    pub(crate) fn lattice(&self, place: [u32; N]) -> [f64; N] {
        let side = self.resolution();
        std::array::from_fn(|axis| self.corner[axis] + f64::from(place[axis]) * side) // Inv 1
    }

    /// The smallest cell that holds a point: on a side, the upper one's, but for the cube's own upper sides. None if the point
    /// is outside, or no number.
    ///
    /// ```
    /// use delone_trees::Frame;
    ///
    /// let frame = Frame::around(&[[0.0, 0.0], [4.0, 4.0]], 2)?;
    /// let place = |point| frame.cell_at(point).map(|cell| cell.anchor());
    /// assert_eq!(place([1.5, 2.0]), Some([1, 2]));
    /// assert_eq!((place([4.0, 4.0]), place([4.5, 0.0])), (Some([3, 3]), None));
    /// # Ok::<(), delone_trees::FrameFault>(())
    /// ```
    #[must_use]
    pub fn cell_at(&self, point: [f64; N]) -> Option<Cell<N>> {
        let mut anchor = [0; N];
        for (axis, place) in anchor.iter_mut().enumerate() {
            let lower = self.corner[axis];
            if !(lower <= point[axis] && point[axis] <= lower + self.side) {
                return None;
            }
            // Halving by comparisons: no difference is rounded.
            for level in 1..=self.depth {
                let step = 1u32 << (self.depth - level);
                let middle = lower + f64::from(*place + step) * self.resolution(); // Inv 1
                *place += if point[axis] >= middle { step } else { 0 };
            }
        }
        Cell::new(anchor, self.depth)
    }

    /// The middle of a cell of a level up to the depth, exactly.
    #[must_use]
    pub fn centre(&self, cell: Cell<N>) -> [f64; N] {
        let half = self.side_of(cell.level()) / 2.0;
        self.corners(cell)[0].map(|c| c + half)
    }
}

/// The corner is a multiple of the side of cells of this level, or of the depth if that is more.
const CORNER_LEVELS: u8 = 10;

/// Places on each axis, in steps, that are doubles along with the middles between them.
const LATTICE_MAX: f64 = (1u64 << 52) as f64;

fn extremes<const N: usize>(points: &[[f64; N]]) -> ([f64; N], [f64; N]) {
    let Some(&first) = points.first() else { return ([0.0; N], [0.0; N]) };
    let each = |a: [f64; N], b: &[f64; N], pick: fn(f64, f64) -> f64| {
        std::array::from_fn(|axis| pick(a[axis], b[axis]) + 0.0)
    };
    let lower = points.iter().fold(first, |all, p| each(all, p, f64::min));
    let upper = points.iter().fold(first, |all, p| each(all, p, f64::max));
    (lower, upper)
}

/// The largest multiple of a power of two that is not above; below [`LATTICE_MAX`] of them.
fn below(value: f64, step: f64) -> f64 {
    let multiple = (value / step).floor() * step + 0.0;
    // Only where the quotient was rounded away.
    if multiple > value { multiple - step } else { multiple }
}

/// e for 2^e <= value < 2^(e+1), or for denormals -1074.
fn exponent(value: f64) -> i32 {
    let biased = i32::try_from(value.to_bits() >> 52 & 0x7ff).expect("eleven bits");
    if biased == 0 { -1074 } else { biased - 1023 }
}

/// 2^e, if it is a double.
fn power(exponent: i32) -> Option<f64> {
    match exponent {
        -1074..-1022 => Some(f64::from_bits(1 << (exponent + 1074))),
        -1022..=1023 => Some(f64::from_bits(u64::try_from(exponent + 1023).ok()? << 52)),
        _ => None,
    }
}
