//! Curves that fill or roughen: Hilbert, Koch.

use super::Graph;
use crate::num::{real, signed};
use crate::{Input, Rng};

/// The first `n` cells of the Hilbert curve, joined in its order.
pub(crate) fn hilbert(n: usize, _: &mut Rng) -> Input {
    let mut order = 1_usize;
    while order * order < n {
        order *= 2;
    }
    let mut graph = Graph::default();
    graph.path((0..n).map(|i| hilbert_cell(order, i)));
    graph.finish()
}

fn hilbert_cell(order: usize, index: usize) -> [f64; 2] {
    let (mut x, mut y, mut rest, mut size) = (0, 0, index, 1);
    while size < order {
        let right = rest / 2 % 2;
        let up = (rest % 2) ^ right;
        if up == 0 {
            if right == 1 {
                (x, y) = (size - 1 - x, size - 1 - y);
            }
            (x, y) = (y, x);
        }
        (x, y) = (x + size * right, y + size * up);
        (rest, size) = (rest / 4, 2 * size);
    }
    [real(x), real(y)]
}

/// Koch's snowflake on the triangular lattice, seen through the integer map (a, b) -> (8a + 4b, 7b), which is 1% off
/// true. Sides are replaced in order, so the last pass may be partial. Affine maps keep it free of crossings, exactly.
pub(crate) fn koch(n: usize, _: &mut Rng) -> Input {
    if n < 3 {
        return Graph::isolated(n).finish();
    }
    let bumps = n / 3 - 1; // each adds three sites
    let mut size = 1_i64;
    let (mut sides, mut full) = (3_usize, 0_usize);
    while full < bumps {
        (full, sides, size) = (full + sides, sides * 4, size * 3);
    }
    // Clockwise, so that the left of each side is outside.
    let mut corners = vec![[0, 0], [0, size], [size, 0]];
    let mut left = bumps;
    while left > 0 {
        let now = left.min(corners.len());
        corners = bump(&corners, now);
        left -= now;
    }
    let mut graph = Graph::default();
    graph.polygon(corners.into_iter().map(|[a, b]| [signed(8 * a + 4 * b), signed(7 * b)]));
    graph.finish()
}

/// A bump in the middle third of the first `count` sides.
fn bump(corners: &[[i64; 2]], count: usize) -> Vec<[i64; 2]> {
    let mut out = Vec::with_capacity(corners.len() + 3 * count);
    for (i, &[a, b]) in corners.iter().enumerate() {
        out.push([a, b]);
        if i < count {
            let [c, d] = corners[(i + 1) % corners.len()];
            let [u, v] = [(c - a) / 3, (d - b) / 3];
            // A sixth of a turn to the left takes lattice vector (u, v) to (-v, u + v).
            let [p, q] = [[a + u, b + v], [a + 2 * u, b + 2 * v]];
            out.extend([p, [p[0] - v, p[1] + u + v], q]);
        }
    }
    out
}
