//! Polygons: comb, fan, spiral, star, nested rings, city blocks.

use super::Graph;
use crate::num::{int, real, side, signed};
use crate::points2d::circles::{quarter, turned};
use crate::{Input, Rng};

/// One polygon with needle-like teeth, a thousand times as long as they are wide.
pub(crate) fn comb(n: usize, _: &mut Rng) -> Input {
    if n < 4 {
        return Graph::isolated(n).finish();
    }
    let tips = n - 2;
    let mut graph = Graph::default();
    let zigzag = (0..tips).map(|i| [real(i), if i % 2 == 0 { 1.0 } else { 1000.0 }]);
    graph.polygon(zigzag.chain([[real(tips - 1), 0.0], [0.0, 0.0]]));
    graph.finish()
}

/// Segments from one site to all others, which stand on a line: a vertex of the highest degree there is.
pub(crate) fn fan(n: usize, _: &mut Rng) -> Input {
    let mut graph = Graph::default();
    for i in 0..n {
        let tip = graph.site(if i == 0 { [0.0, 0.0] } else { [real(n), real(i) - real(n / 2)] });
        if i > 0 {
            graph.join(0, tip);
        }
    }
    graph.finish()
}

/// A square spiral of width 1, wound with gaps of 1, as one polygon: corners out, corners back.
pub(crate) fn spiral(n: usize, _: &mut Rng) -> Input {
    if n < 8 {
        return Graph::isolated(n).finish();
    }
    const STEPS: [[i64; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];
    let (mut outer, mut inner) = (Vec::new(), Vec::new());
    let [mut x, mut y] = [0_i64, 0_i64];
    for j in 0..n / 2 {
        // The inner corner is one step left of the way in and one step left of the way on.
        let ([a, b], [c, d]) = (STEPS[(j + 3) % 4], STEPS[j % 4]);
        outer.push([signed(x), signed(y)]);
        inner.push([signed(x - b - d), signed(y + a + c)]);
        let length = 2 * (2 + int(j / 2));
        [x, y] = [x + c * length, y + d * length];
    }
    let mut graph = Graph::default();
    graph.polygon(outer.into_iter().chain(inner.into_iter().rev()));
    graph.finish()
}

/// A star-shaped polygon: directions in order, each at a random distance from the centre.
pub(crate) fn star(n: usize, rng: &mut Rng) -> Input {
    if n < 4 {
        return Graph::isolated(n).finish();
    }
    let mut graph = Graph::default();
    let corner = |i: usize| {
        // Position in quarter turns; stratified, so that no gap reaches half a turn.
        let position = (real(i) + 0.8 * rng.unit()) * 4.0 / real(n);
        let turns = (1..4).rev().find(|&turns| position >= real(turns)).unwrap_or(0);
        let direction = turned(quarter(position - real(turns)), turns as u64);
        let r = rng.between(0.2, 1.0);
        direction.map(|x| r * x)
    };
    graph.polygon((0..n).map(corner));
    graph.finish()
}

/// The twelve lattice points of the circle of radius 5, in order.
const DODECAGON: [[f64; 2]; 12] = [
    [5.0, 0.0],
    [4.0, 3.0],
    [3.0, 4.0],
    [0.0, 5.0],
    [-3.0, 4.0],
    [-4.0, 3.0],
    [-5.0, 0.0],
    [-4.0, -3.0],
    [-3.0, -4.0],
    [0.0, -5.0],
    [3.0, -4.0],
    [4.0, -3.0],
];

/// Concentric dodecagons at integers, each exactly cocircular; what `n` leaves over is a smaller polygon inside all.
pub(crate) fn nested(n: usize, _: &mut Rng) -> Input {
    let mut graph = Graph::default();
    match n % 12 {
        few @ 0..3 => DODECAGON[..few].iter().for_each(|&p| {
            graph.site(p);
        }),
        corners => graph.polygon(DODECAGON.into_iter().take(corners)),
    }
    for ring in 0..n / 12 {
        graph.polygon(DODECAGON.map(|p| p.map(|x| x * real(ring + 2))));
    }
    graph.finish()
}

/// City blocks between streets, one in five missing; integers.
pub(crate) fn streets(n: usize, rng: &mut Rng) -> Input {
    if n < 4 {
        return Graph::isolated(n).finish();
    }
    let k = side(n.div_ceil(4) * 5 / 4);
    let mut graph = Graph::default();
    for cell in 0.. {
        if graph.len() + 4 > n {
            break;
        }
        if rng.one_in(5) {
            continue;
        }
        let [x, y] = [16 * (cell % k), 16 * (cell / k)];
        let mut inset = || rng.index(4);
        let [left, right] = [real(x + 1 + inset()), real(x + 15 - inset())];
        let [bottom, top] = [real(y + 1 + inset()), real(y + 15 - inset())];
        graph.polygon([[left, bottom], [right, bottom], [right, top], [left, top]]);
    }
    graph.finish()
}
