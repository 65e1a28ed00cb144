//! New points from earlier ones, and maps of all points at once.

use crate::choices::Choices;
use crate::exact::{nudged, power_of_two};

/// How a point is made from earlier ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Move {
    /// The same point.
    Duplicate,
    /// One coordinate of one point, the others of another.
    Share,
    /// The middle of two, rounded.
    Midpoint,
    /// As far beyond `q` as `p` is before it.
    Extend,
    /// The fourth corner of a parallelogram.
    Parallelogram,
    /// A quarter turn of one around another, in a plane of two axes: with it and its mirror image, a circle.
    QuarterTurn,
    /// Around one, a point of a circle or sphere of integers.
    Pythagorean,
    /// Between two, at a ratio, rounded: almost in line.
    Interpolate,
    /// Some units in the last place away.
    Nudge,
    /// A power of two away along an axis.
    Offset,
}

const ALL: [Move; 10] = [
    Move::Duplicate,
    Move::Share,
    Move::Midpoint,
    Move::Extend,
    Move::Parallelogram,
    Move::QuarterTurn,
    Move::Pythagorean,
    Move::Interpolate,
    Move::Nudge,
    Move::Offset,
];

/// Up to order and sign, integers whose squares sum to 25, to 1105 and to 81.
const ROUND_2: [[i32; 2]; 6] = [[3, 4], [5, 0], [33, 4], [32, 9], [31, 12], [24, 23]];
const ROUND_3: [[i32; 3]; 5] = [[7, 4, 4], [1, 4, 8], [9, 0, 0], [3, 6, 6], [2, 2, 1]];

impl Move {
    /// One of them, or none.
    pub fn choose(choices: &mut dyn Choices) -> Option<Self> {
        let which = choices.index(ALL.len() * 2);
        ALL.get(which).copied()
    }
}

/// A point made from some of `points`; it may have overflowed.
///
/// # Panics
/// If there are no points.
pub fn moved<const D: usize>(
    step: Move,
    points: &[[f64; D]],
    choices: &mut dyn Choices,
) -> [f64; D] {
    let mut any = || points[choices.index(points.len())];
    let (p, q, r) = (any(), any(), any());
    let axis = choices.index(D);
    let each = |f: &dyn Fn(usize) -> f64| std::array::from_fn(f);
    match step {
        Move::Duplicate => p,
        Move::Share => each(&|i| if i == axis { q[i] } else { p[i] }),
        Move::Midpoint => each(&|i| p[i] / 2.0 + q[i] / 2.0),
        Move::Extend => each(&|i| q[i] + (q[i] - p[i])),
        Move::Parallelogram => each(&|i| p[i] + (q[i] - r[i])),
        Move::QuarterTurn => {
            let other = (axis + 1) % D;
            let (dx, dy) = (p[axis] - q[axis], p[other] - q[other]);
            each(&|i| match i {
                _ if i == axis => q[i] - dy,
                _ if i == other => q[i] + dx,
                _ => p[i],
            })
        }
        Move::Pythagorean => {
            let step = round::<D>(choices);
            each(&|i| p[i] + step[i])
        }
        Move::Interpolate => {
            let t = f64::from(choices.integer(1, 9)) / 10.0;
            each(&|i| p[i] + t * (q[i] - p[i]))
        }
        Move::Nudge => {
            let steps = choices.integer(-3, 3);
            each(&|i| if i == axis { nudged(p[i], steps) } else { p[i] })
        }
        Move::Offset => {
            let by = power_of_two(choices.integer(-60, 8));
            each(&|i| if i == axis { p[i] + by } else { p[i] })
        }
    }
}

/// A vector of integers whose length is one of a few.
fn round<const D: usize>(choices: &mut dyn Choices) -> [f64; D] {
    let (turn, signs) = (choices.index(D), choices.below(1 << D));
    let which = choices.index(30);
    std::array::from_fn(|axis| {
        let place = (axis + turn) % D;
        let row: &[i32] = if D == 2 { &ROUND_2[which % 6] } else { &ROUND_3[which % 5] };
        let x = f64::from(row.get(place).copied().unwrap_or(0));
        if signs >> axis & 1 == 1 { -x } else { x }
    })
}

/// A map of all points, now and then: far from 1, thin, or turned. What overflows stays as it was.
pub(super) fn whole<const D: usize>(points: &mut [[f64; D]], choices: &mut dyn Choices) {
    let kind = choices.below(8);
    let axis = choices.index(D);
    let factor = power_of_two(choices.integer(-1000, 1000));
    for point in points {
        let image: [f64; D] = std::array::from_fn(|i| match kind {
            0 => point[i] * factor,
            1 if i == axis => point[i] * factor,
            2 => point[i] * power_of_two(-30) + 1.0,
            _ => point[i],
        });
        if image.iter().all(|x| x.is_finite()) {
            *point = image;
        }
    }
}
