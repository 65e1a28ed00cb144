//! Exactly cocircular polygons with chords.

use super::Graph;
use crate::num::signed;
use crate::points2d::circles::{lattice, turned};
use crate::{Input, Rng};

/// A polygon of exactly cocircular integers with random non-crossing chords: every triangulation of every pocket is
/// Delaunay, so only a rule for ties makes the answer one. At most 236,196 sites.
pub(crate) fn chords(n: usize, rng: &mut Rng) -> Input {
    let mut points = lattice(n, rng);
    points.sort_unstable_by_key(|&p| angle_key(p));
    let n = points.len();
    let mut graph = Graph::default();
    if n < 3 {
        return Graph::isolated(n).finish();
    }
    graph.polygon(points.into_iter().map(|p| p.map(signed)));
    // Chords of a random triangulation: split the arc first..last at a random corner, keep half of the chords.
    let mut arcs = vec![(0, n - 1)];
    while let Some((first, last)) = arcs.pop() {
        if last - first < 2 {
            continue;
        }
        let middle = first + 1 + rng.index(last - first - 1);
        for (a, b) in [(first, middle), (middle, last)] {
            if b - a > 1 && rng.coin() {
                graph.join(a, b);
            }
            arcs.push((a, b));
        }
    }
    graph.finish()
}

/// Sorts the points of a circle by angle: the quarter, then how far the point has come down towards the next axis.
fn angle_key(p: [i64; 2]) -> (u64, i64) {
    let turns = (0..4).find(|&turns| in_first_quarter(turned(p, 4 - turns))).unwrap_or(0);
    (turns, -turned(p, 4 - turns)[0])
}

fn in_first_quarter([x, y]: [i64; 2]) -> bool {
    x > 0 && y >= 0
}
