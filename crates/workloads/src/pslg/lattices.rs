//! A lattice with all its edges: nothing left to triangulate.

use super::Graph;
use crate::num::side;
use crate::points2d::lattices::square;
use crate::{Input, Rng};

/// The integer lattice with all edges of a triangulation of it, one random diagonal in each square.
pub(crate) fn triangulated(n: usize, rng: &mut Rng) -> Input {
    let k = side(n).max(1);
    let mut graph = Graph::on(square(n).collect());
    for i in 0..n {
        let right = i % k + 1 < k && i + 1 < n;
        if right {
            graph.join(i, i + 1);
        }
        if i + k < n {
            graph.join(i, i + k);
            // Where the last row ends, the square has three corners and this is the side of their triangle.
            if right && (i + k + 1 == n || rng.coin()) {
                graph.join(i + 1, i + k);
            } else if right {
                graph.join(i, i + k + 1);
            }
        }
    }
    graph.finish()
}
