//! Many short segments: sparse, dense, and in a frame.

use super::Graph;
use crate::num::{real, side};
use crate::{Input, Rng};

/// One random segment inside each cell of a square grid: none can meet another.
pub(crate) fn sparse(n: usize, rng: &mut Rng) -> Input {
    let k = side(n.div_ceil(2)).max(1);
    let mut graph = Graph::default();
    let mut end = |cell: usize| {
        [real(cell % k) + rng.between(0.02, 0.98), real(cell / k) + rng.between(0.02, 0.98)]
    };
    for cell in 0..n / 2 {
        graph.segment(end(cell), end(cell));
    }
    if n % 2 == 1 {
        graph.site(end(n / 2));
    }
    graph.finish()
}

/// A lattice jittered by less than a quarter of its step, so that each of its quadrilaterals stays convex; seven in ten
/// of their sides and one diagonal of each.
pub(crate) fn dense(n: usize, rng: &mut Rng) -> Input {
    let k = side(n).max(1);
    let jitter = |i: usize| [real(i % k), real(i / k)];
    let sites = (0..n).map(|i| jitter(i).map(|x| x + rng.between(-0.2, 0.2))).collect();
    let mut graph = Graph::on(sites);
    for i in 0..n {
        let (right, above) = (i % k + 1 < k && i + 1 < n, i + k < n);
        let both = right && i + k + 1 < n;
        let diagonal = if rng.coin() { (i, i + k + 1) } else { (i + 1, i + k) };
        let sides = [(right, (i, i + 1)), (above, (i, i + k)), (both, diagonal)];
        for (_, (a, b)) in sides.into_iter().filter(|&(there, _)| there) {
            if rng.below(10) < 7 {
                graph.join(a, b);
            }
        }
    }
    graph.finish()
}

/// A rectangle with staggered horizontal slits, integers.
pub(crate) fn slits(n: usize, _: &mut Rng) -> Input {
    if n < 4 {
        return Graph::isolated(n).finish();
    }
    let slits = (n - 4) / 2;
    let k = side(slits).max(1);
    let (width, height) = (real(4 * k + 3), real(slits.div_ceil(k) + 1));
    let mut graph = Graph::default();
    graph.polygon([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]]);
    for i in 0..slits {
        let (row, left) = (i / k, 4 * (i % k) + 1 + 2 * (i / k % 2));
        // The last row may be one short: its slits stay inside all the same.
        graph.segment([real(left), real(row + 1)], [real(left + 3), real(row + 1)]);
    }
    graph.finish()
}
