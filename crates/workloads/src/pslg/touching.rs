//! Contacts other than shared ends: sites inside segments, overlaps, and polygons that touch themselves at a vertex.

use super::Graph;
use crate::num::{real, side};
use crate::points2d::lattices::square;
use crate::{Input, Rng};

/// A checkerboard of diamonds, each sharing its corners with its neighbours. Two sides meet only at a shared site.
pub(crate) fn diamonds(n: usize, _: &mut Rng) -> Input {
    let k = (1..=n).take_while(|k| 2 * k * (k + 1) <= n).last().unwrap_or(0);
    if k == 0 {
        return Graph::isolated(n).finish();
    }
    let mut graph = Graph::default();
    for i in 0..k {
        for j in 0..=k {
            graph.site([real(2 * i + 1), real(2 * j)]);
        }
    }
    for i in 0..=k {
        for j in 0..k {
            graph.site([real(2 * i), real(2 * j + 1)]);
        }
    }
    let (flat, steep) = (|i, j| i * (k + 1) + j, |i, j| k * (k + 1) + i * k + j);
    for i in 0..k {
        for j in 0..k {
            let ring = [flat(i, j), steep(i + 1, j), flat(i, j + 1), steep(i, j)];
            (0..4).for_each(|c| graph.join(ring[c], ring[(c + 1) % 4]));
        }
    }
    graph.finish()
}

/// Horizontal rails and vertical ties whose ends lie inside the rails: T-junctions without a shared site.
pub(crate) fn t_junctions(n: usize, rng: &mut Rng) -> Input {
    if n < 2 {
        return Graph::isolated(n).finish();
    }
    let rails = (n.isqrt() / 2).max(1);
    let ties = n / 2 - rails;
    let width = real(2 * ties + 2);
    let mut graph = Graph::default();
    for i in 0..rails {
        graph.segment([0.0, real(4 * i)], [width, real(4 * i)]);
    }
    for i in 0..ties {
        let (x, bottom) = (real(2 * i + 1), 4 * rng.index(rails));
        let height = if rng.coin() { 4 } else { 2 };
        graph.segment([x, real(bottom)], [x, real(bottom + height)]);
    }
    graph.finish()
}

/// A lattice whose rows carry random segments between their sites: overlapping, nested, repeated, with sites inside.
pub(crate) fn overlaps(n: usize, rng: &mut Rng) -> Input {
    let k = side(n);
    let mut graph = Graph::on(square(n).collect());
    for first in (0..n).step_by(k.max(1)) {
        let row = k.min(n - first);
        for _ in 1..row {
            let (a, b) = (rng.index(row), rng.index(row));
            if a != b {
                graph.join(first + a, first + b);
                if rng.one_in(8) {
                    graph.join(first + b, first + a);
                }
            }
        }
    }
    graph.finish()
}
