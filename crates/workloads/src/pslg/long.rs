//! Long segments: the worst cases of insertion and of filters.

use super::Graph;
use crate::num::{pow2, real};
use crate::{Input, Rng};

/// Long near-horizontal segments, not parallel, with sites strewn between them: each segment crosses about sqrt(n)
/// Delaunay edges of the sites.
pub(crate) fn rails(n: usize, rng: &mut Rng) -> Input {
    if n < 2 {
        return Graph::isolated(n).finish();
    }
    let rails = n.isqrt() / 2 + usize::from(n >= 4);
    let rails = rails.max(1);
    let width = real(2 * n);
    let mut graph = Graph::default();
    for i in 0..rails {
        let y = real(8 * i);
        graph.segment([0.0, y], [width, y + real(rng.index(3))]);
    }
    for k in 0..n - 2 * rails {
        graph.site([real(2 * k + 1), real(8 * rng.index(rails) + 3 + rng.index(5))]);
    }
    graph.finish()
}

/// Two columns of sites, the i-th on the left joined to the i-th on the right, which stands half a column higher: each
/// rung crosses a constant part of all Delaunay edges, so one-by-one insertion walks n^2 of them.
pub(crate) fn ladder(n: usize, _: &mut Rng) -> Input {
    let rungs = n / 2;
    let width = real((rungs / 4).max(1));
    let mut graph = Graph::default();
    for i in 0..rungs {
        graph.segment([0.0, real(i)], [width, real(i + rungs / 2)]);
    }
    if n % 2 == 1 {
        graph.site([-1.0, 0.0]);
    }
    graph.finish()
}

/// Vertical segments a few ULPs apart, leaning by at most one ULP.
pub(crate) fn ulp_slopes(n: usize, rng: &mut Rng) -> Input {
    let mut graph = Graph::default();
    let at = |steps: usize| 1.0 + real(steps) * pow2(-52);
    for i in 0..n / 2 {
        graph.segment([at(4 * i + 1), 0.0], [at(4 * i + rng.index(3)), 1.0]);
    }
    if n % 2 == 1 {
        graph.site([0.5, 0.0]);
    }
    graph.finish()
}
