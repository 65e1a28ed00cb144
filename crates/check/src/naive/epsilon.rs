//! The perturbation with actual numbers in place of infinitesimals.
//!
//! The height of the point of rank `r` is `|p|^2 + 2^(B (r - n))`, and all is scaled by `2^(B n)`
//! to be an integer. The lifted determinant is linear in the heights, with coefficients `O` of at
//! most `k! 2^(k (b+1))` for `b`-bit coordinates; there are `k + 2` of them. With `2^B` more than
//! twice `k+2` times that, each rank outweighs all lower ones together, and a nonzero unperturbed
//! determinant outweighs all ranks: no tie is left, and the sign is that of the symbolic rule.

use super::{framed, simplices};
use crate::exact::determinant::determinant;
use crate::exact::lattice::Span;
use crate::exact::{Integer, Lattice, Number, Pure, Sign};
use crate::space::Space;

/// The Delaunay triangulation as the lower hull of explicitly perturbed heights. For small integer
/// coordinates.
#[must_use]
pub fn delaunay_by_epsilon<const D: usize>(points: &[[f64; D]]) -> Vec<Vec<u32>> {
    let (ids, space) = framed(Space::<'_, D, Pure>::new(points, false));
    let span = Span::of(points.iter().flatten().copied()).unwrap_or(Span { low: 0, high: 0 });
    let lattice: Lattice<Pure> = Lattice::new(span.low);
    let integers: Vec<Vec<Pure>> =
        points.iter().map(|p| p.iter().map(|&x| lattice.integer(x)).collect()).collect();
    let heights = heights(&space, &ids, &integers, span.bits());
    simplices(&space, &ids, |simplex, orientation| {
        ids.iter().filter(|q| !simplex.contains(q)).all(|&q| {
            let mut rows = Vec::new();
            for &v in simplex {
                for &x in &space.axes {
                    rows.push(integers[v as usize][x].minus(&integers[q as usize][x]));
                }
                rows.push(heights[v as usize].minus(&heights[q as usize]));
            }
            let m = determinant(simplex.len(), &rows).exact_sign();
            let m = m.flipped_if(space.axes.len().is_multiple_of(2));
            orientation.times(m) == Sign::Positive
        })
    })
}

/// The perturbed height of each point, scaled.
fn heights<const D: usize>(
    space: &Space<'_, D, Pure>,
    ids: &[u32],
    integers: &[Vec<Pure>],
    bits: u32,
) -> Vec<Pure> {
    let k: u32 = (0u32..).zip(&space.axes).map(|(i, _)| i + 1).last().unwrap_or(0);
    let step = k * (bits + 1) + 4 * k + 8; // B: k! (k + 2) 2 < 2^(4k + 8)
    let mut by_rank = ids.to_vec();
    by_rank.sort_by(|&u, &v| space.compare(u, v));
    let n = (0u32..).zip(ids).map(|(i, _)| i + 1).last().unwrap_or(0);
    let mut heights: Vec<Pure> = integers
        .iter()
        .map(|p| {
            let square = p.iter().fold(Pure::shifted(0, 0), |s, x| s.plus(&x.times(x)));
            square.times(&Pure::shifted(1, step * n))
        })
        .collect();
    for (rank, v) in (0u32..).zip(by_rank) {
        let raised = heights[v as usize].plus(&Pure::shifted(1, step * rank));
        heights[v as usize] = raised;
    }
    heights
}
