//! Orientations and lifted determinants on some axes of any points, with or without weights: the tier by the width.
//!
//! Coordinates are aligned from the lowest bit set in any of them. Weights are squares: they are aligned at twice that
//! exponent, and count for the width with half their exponents.

use super::align::{aligned, span};
use super::{AXES_MAX, Answer, any, formulas, leading, long};
use crate::int::Int;
use crate::{Sign, Stage};

/// A common exponent and the width of the coordinates over it.
#[derive(Clone, Copy)]
struct Alignment {
    low: i32,
    width: u32,
}

/// Differences of coordinates of this width fit into so many limbs, with head-room (`exact.rs`).
const fn width_max(limbs: u32) -> u32 {
    64 * limbs - 3
}

/// The narrowest tier for coordinates of this width, if there is one.
const fn limbs_for(width: u32) -> Option<u32> {
    match () {
        () if width <= width_max(1) => Some(1),
        () if width <= width_max(2) => Some(2),
        () if width <= width_max(4) => Some(4),
        () => None,
    }
}

const fn stage_of(limbs: u32) -> Stage {
    match limbs {
        1 => Stage::OneLimb,
        2 => Stage::TwoLimbs,
        _ => Stage::FourLimbs,
    }
}

/// The sign of `det[p1 - p0; ..; pk - p0]` in the k given axes. `points` are k+1.
#[inline(never)]
pub(crate) fn orient(points: &[&[f64]], axes: &[usize]) -> Answer {
    let k = axes.len();
    assert!(k <= AXES_MAX, "{k} axes: predicates go up to {AXES_MAX}");
    assert_eq!(points.len(), k + 1, "orient in {k} axes takes {} points", k + 1);
    if k == 0 {
        return (Sign::Positive, Stage::MachineWords);
    }
    let values = points.iter().flat_map(|p| axes.iter().map(|&axis| &p[axis]));
    let Some((low, width)) = span(values) else {
        return (Sign::Zero, Stage::MachineWords);
    };
    let Some(limbs) = limbs_for(width) else {
        return match leading::orient(points, axes) {
            Some(sign) => (sign, Stage::LeadingTerms),
            None => (long::orient(points, axes), Stage::LongSum),
        };
    };
    let sign = Determinant { points, axes, weights: None, low }.orient_in(limbs);
    (sign.times_minus_one_to(k), stage_of(limbs)) // the reference is the last point, not the first
}

/// The sign of `(b - a) x (d - c)` in the plane.
pub(crate) fn cross(points: &[[f64; 2]; 4]) -> Answer {
    let Some((low, width)) = span(points.iter().flatten()) else {
        return (Sign::Zero, Stage::MachineWords);
    };
    match () {
        () if width <= width_max(2) => (cross_in::<2, 4>(points, low), Stage::TwoLimbs),
        () if width <= width_max(4) => (cross_in::<4, 8>(points, low), Stage::FourLimbs),
        () => (long::cross(*points), Stage::LongSum),
    }
}

fn cross_in<const L: usize, const L2: usize>(points: &[[f64; 2]; 4], low: i32) -> Sign {
    let [a, b, c, d] = points.map(|p| p.map(|x| aligned::<L>(x, low)));
    let rows = [[b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]];
    formulas::plane::<L, L2>(rows.each_ref()).sign()
}

/// The sign of the lifted determinant: positive if the last of the k+2 points is inside the circumsphere of the first
/// k+1, these being positively oriented in the k given axes; heights are squared lengths in *all* coordinates, less the
/// weight.
#[inline(never)]
pub(crate) fn lifted(points: &[&[f64]], axes: &[usize], weights: Option<&[f64]>) -> Answer {
    let k = axes.len();
    assert!(k <= AXES_MAX, "{k} axes: predicates go up to {AXES_MAX}");
    assert_eq!(points.len(), k + 2, "in_sphere in {k} axes takes {} points", k + 2);
    let coordinates = span(points.iter().flat_map(|p| p.iter()));
    let weight = weights.and_then(|weights| span(weights.iter()));
    let Some(Alignment { low, width }) = common(coordinates, weight) else {
        return (Sign::Zero, Stage::MachineWords);
    };
    let Some(limbs) = limbs_for(width) else {
        return match leading::lifted(points, axes, weights) {
            Some(sign) => (-sign, Stage::LeadingTerms),
            None => (-long::lifted(points, axes, weights), Stage::LongSum),
        };
    };
    let sign = Determinant { points, axes, weights, low }.lifted_in(limbs);
    (sign.times_minus_one_to(k), stage_of(limbs))
}

/// The alignment of coordinates that lets weights be aligned at twice its exponent.
fn common(coordinates: Option<(i32, u32)>, weights: Option<(i32, u32)>) -> Option<Alignment> {
    let ends = |(low, width): (i32, u32)| (low, low.saturating_add_unsigned(width));
    let halves = weights.map(ends).map(|(low, high)| (low.div_euclid(2), high.div_euclid(2) + 1));
    let (low, high) = match (coordinates.map(ends), halves) {
        (Some(a), Some(b)) => (a.0.min(b.0), a.1.max(b.1)),
        (a, b) => a.or(b)?,
    };
    Some(Alignment { low, width: high.abs_diff(low) })
}

/// A determinant of rows of differences to the last point, on some axes.
struct Determinant<'p> {
    points: &'p [&'p [f64]],
    axes: &'p [usize],
    weights: Option<&'p [f64]>,
    low: i32,
}

impl Determinant<'_> {
    fn difference<const L: usize>(&self, row: usize, axis: usize) -> Int<L> {
        let last = self.points[self.points.len() - 1][axis];
        aligned::<L>(self.points[row][axis], self.low) - aligned(last, self.low)
    }

    /// Rows on the axes, padded with zeros.
    fn rows<const L: usize, const K: usize, const R: usize>(&self) -> [[Int<L>; K]; R] {
        let mut rows = [[Int::ZERO; K]; R];
        for (i, row) in rows.iter_mut().enumerate().take(self.points.len() - 1) {
            for (slot, &axis) in row.iter_mut().zip(self.axes) {
                *slot = self.difference(i, axis);
            }
        }
        rows
    }

    /// The heights over the last point, of at most R rows.
    fn heights<const L: usize, const L2: usize, const R: usize>(&self) -> [Int<L2>; R] {
        let mut heights = [Int::ZERO; R];
        for (i, height) in heights.iter_mut().enumerate().take(self.points.len() - 1) {
            for axis in 0..self.points[i].len() {
                let d = self.difference::<L>(i, axis);
                *height = *height + d.times(&d);
            }
            if let Some(weights) = self.weights {
                let last = weights[self.points.len() - 1];
                *height = *height + aligned(last, 2 * self.low) - aligned(weights[i], 2 * self.low);
            }
        }
        heights
    }

    fn orient<const L: usize, const L2: usize, const L3: usize>(&self) -> Sign {
        let [p, q, r] = &self.rows::<L, 3, 3>();
        match self.axes.len() {
            1 => p[0].sign(),
            2 => formulas::plane::<L, L2>([&[p[0], p[1]], &[q[0], q[1]]]).sign(),
            _ => formulas::space::<L, L2, L3>([p, q, r]).sign(),
        }
    }

    fn lifted<
        const L: usize,
        const L2: usize,
        const L3: usize,
        const L4: usize,
        const L5: usize,
    >(
        &self,
    ) -> Sign {
        let [p, q, r, s] = &self.rows::<L, 3, 4>();
        let [hp, hq, hr, hs] = &self.heights::<L, L2, 4>();
        match self.axes.len() {
            1 => formulas::interval::<L, L2, L3>([&p[0], &q[0]], [hp, hq]).sign(),
            2 => {
                let [p, q, r] = [p, q, r].map(|row| [row[0], row[1]]);
                formulas::circle::<L, L2, L4>([&p, &q, &r], [hp, hq, hr]).sign()
            }
            _ => -formulas::sphere::<L, L2, L3, L5>([p, q, r, s], [hp, hq, hr, hs]).sign(),
        }
    }

    /// In more than three axes, where two limbs are computed in four.
    fn orient_any(&self, limbs: u32) -> Sign {
        let k = self.axes.len();
        if limbs == 1 {
            any::determinant(&self.rows::<1, AXES_MAX, AXES_MAX>(), &[], k)
        } else {
            any::wide_determinant(&self.rows::<4, AXES_MAX, AXES_MAX>(), &[], k)
        }
    }

    fn lifted_any(&self, limbs: u32) -> Sign {
        const ROWS: usize = AXES_MAX + 1;
        let (k, n) = (self.axes.len(), self.points.len() - 1);
        if limbs == 1 {
            let heights = self.heights::<1, 2, ROWS>();
            any::determinant(&self.rows::<1, AXES_MAX, ROWS>(), &heights[..n], k)
        } else {
            let heights = self.heights::<4, 8, ROWS>();
            any::wide_determinant(&self.rows::<4, AXES_MAX, ROWS>(), &heights[..n], k)
        }
    }

    fn orient_in(&self, limbs: u32) -> Sign {
        match limbs {
            _ if self.axes.len() > 3 => self.orient_any(limbs),
            1 => self.orient::<1, 2, 3>(),
            2 => self.orient::<2, 4, 6>(),
            _ => self.orient::<4, 8, 12>(),
        }
    }

    fn lifted_in(&self, limbs: u32) -> Sign {
        match limbs {
            _ if self.axes.is_empty() || self.points[0].len() > 3 => self.lifted_any(limbs),
            1 => self.lifted::<1, 2, 3, 4, 5>(),
            2 => self.lifted::<2, 4, 6, 8, 10>(),
            _ => self.lifted::<4, 8, 12, 16, 20>(),
        }
    }
}

/// The orientation by long sums, and in one, two and four limbs.
#[cfg(test)]
pub(super) fn orient_in_all_tiers(points: &[&[f64]], axes: &[usize]) -> [Sign; 4] {
    let values = points.iter().flat_map(|p| axes.iter().map(|&axis| &p[axis]));
    let (low, _) = span(values).unwrap_or((0, 0));
    let determinant = Determinant { points, axes, weights: None, low };
    let [one, two, four] =
        [1, 2, 4].map(|limbs| determinant.orient_in(limbs).times_minus_one_to(axes.len()));
    [long::orient(points, axes), one, two, four]
}

/// The lifted determinant by long sums, and in one, two and four limbs.
#[cfg(test)]
pub(super) fn lifted_in_all_tiers(
    points: &[&[f64]],
    axes: &[usize],
    weights: Option<&[f64]>,
) -> [Sign; 4] {
    let coordinates = span(points.iter().flat_map(|p| p.iter()));
    let weight = weights.and_then(|weights| span(weights.iter()));
    let low = common(coordinates, weight).map_or(0, |alignment| alignment.low);
    let determinant = Determinant { points, axes, weights, low };
    let [one, two, four] =
        [1, 2, 4].map(|limbs| determinant.lifted_in(limbs).times_minus_one_to(axes.len()));
    [-long::lifted(points, axes, weights), one, two, four]
}
