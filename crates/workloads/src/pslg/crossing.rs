//! Segments that cross: for refusals that name every pair, and for noding.

use super::Graph;
use crate::num::real;
use crate::{Input, Rng};

/// Random segments across the unit square.
pub(crate) fn soup(n: usize, rng: &mut Rng) -> Input {
    let mut graph = Graph::default();
    for _ in 0..n / 2 {
        graph.segment([rng.unit(), rng.unit()], [rng.unit(), rng.unit()]);
    }
    graph.finish()
}

/// Horizontal and vertical segments, each of one kind crossing all of the other; integers.
pub(crate) fn grid(n: usize, _: &mut Rng) -> Input {
    let lines = n / 2;
    let (flat, steep) = (lines / 2, lines - lines / 2);
    let mut graph = Graph::default();
    for i in 0..flat {
        graph.segment([0.0, real(i + 1)], [real(steep + 1), real(i + 1)]);
    }
    for i in 0..steep {
        graph.segment([real(i + 1), 0.0], [real(i + 1), real(flat + 1)]);
    }
    graph.finish()
}

/// All segments through one point, which is not a site; integers.
pub(crate) fn star(n: usize, _: &mut Rng) -> Input {
    let lines = n / 2;
    let mut graph = Graph::default();
    for i in 0..lines {
        let p = [real(lines), 2.0 * real(i) - real(lines) + 1.0];
        let p = if i % 2 == 0 { p } else { [-p[1], p[0]] };
        graph.segment(p, p.map(|x| 0.0 - x));
    }
    graph.finish()
}

/// Short segments in the unit square, so that each crosses a few others only: noding in O(n log n) pays.
pub(crate) fn short(n: usize, rng: &mut Rng) -> Input {
    let reach = 2.0 / real(n.max(1)).sqrt();
    let mut graph = Graph::default();
    for _ in 0..n / 2 {
        let a = [rng.unit(), rng.unit()];
        graph.segment(a, a.map(|x| x + rng.between(-reach, reach)));
    }
    graph.finish()
}
