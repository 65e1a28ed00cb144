//! A map: a continent in a frame, islands off it, lakes in it, islands in the lakes, fractal down to the last site.

use super::Graph;
use super::kites::{Curves, distance};
use crate::num::{pow2, real, side};
use crate::points2d::circles::{quarter, turned};
use crate::{Input, Points, Rng};

/// Part of the way from an edge to the border of its kite that a displacement may take.
const ROUGHNESS: f64 = 0.8;
/// Each is tried against all that is there, so their number must not grow with n for ever.
const ISLANDS_MAX: usize = 240;

/// Exactly `n` sites, unless doubles run out of room first. Under 16 sites the frame is left out.
pub(crate) fn coast(n: usize, rng: &mut Rng) -> Input {
    if n < 8 {
        return Graph::isolated(n).finish();
    }
    let framed = n >= 16;
    let budget = if framed { n - 4 } else { n };
    let mut curves = Curves::default();
    let mut disks = Vec::new();
    continent(&mut curves, budget.min(8), rng);
    // Bays and capes first, islands and lakes between them, then islands in the lakes, then the detail.
    curves.refine(budget.min(400).div_ceil(2), ROUGHNESS, rng);
    for _ in 0..(side(budget) / 3).min(ISLANDS_MAX) {
        strew(&mut curves, &mut disks, budget, rng);
    }
    // Until their shores are known, kites fill the lakes.
    let shores = curves.points.len() * 8;
    curves.refine(shores.min(budget / 4 * 3), ROUGHNESS, rng);
    inside_lakes(&mut curves, &disks, budget, rng);
    curves.refine(budget, ROUGHNESS, rng);

    let mut graph = Graph::on(curves.points);
    curves.kites.iter().for_each(|kite| graph.join(kite.a, kite.b));
    if framed {
        graph.polygon([[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]);
    }
    graph.finish()
}

fn scaled(mut input: Input, by: f64) -> Input {
    if let Points::Plane(points) = &mut input.points {
        points.iter_mut().flatten().for_each(|x| *x *= by);
    }
    input
}

/// A coast times 2^-900, exact: products of two coordinates vanish.
pub(crate) fn tiny(n: usize, rng: &mut Rng) -> Input {
    scaled(coast(n, rng), pow2(-900))
}

/// A coast times 2^900, exact: products of two coordinates overflow.
pub(crate) fn huge(n: usize, rng: &mut Rng) -> Input {
    scaled(coast(n, rng), pow2(900))
}

/// Corners around a centre, at even angles in the rational parametrisation, each at its own distance.
fn ring(corners: usize, centre: [f64; 2], mut distance: impl FnMut() -> f64) -> Vec<[f64; 2]> {
    let corner = |i: usize| {
        let position = 4 * i;
        let t = real(position % corners) / real(corners);
        let [x, y] = turned(quarter(t), (position / corners) as u64);
        let r = distance();
        [centre[0] + r * x, centre[1] + r * y]
    };
    (0..corners).map(corner).collect()
}

fn continent(curves: &mut Curves, corners: usize, rng: &mut Rng) {
    let centre = [2.0, 1.5];
    let shape = ring(corners, centre, || rng.between(0.6, 0.96));
    let wide = shape.iter().map(|[x, y]| [2.0 + 1.3 * (x - 2.0), *y]).collect::<Vec<_>>();
    curves.ring(&wide, centre);
}

/// One island or lake wherever there is room for it: small ones are common, large ones rare.
fn strew(curves: &mut Curves, disks: &mut Vec<([f64; 2], f64)>, budget: usize, rng: &mut Rng) {
    for _ in 0..60 {
        let u = rng.unit();
        let radius = 0.012 + 0.3 * u * u * u;
        // One in three is tried in the middle of the continent: a lake.
        let [wide, high] = if rng.one_in(3) { [0.9, 0.6] } else { [2.0 - radius, 1.5 - radius] };
        let centre = [2.0 + rng.between(-wide, wide), 1.5 + rng.between(-high, high)];
        let apart = disks.iter().all(|&(c, r)| distance(c, centre) > r + radius);
        if apart && place(curves, centre, radius, budget, rng) {
            disks.push((centre, radius));
            return;
        }
    }
}

/// An island in each lake or island wide enough: its disk is half as wide, and moved a little.
fn inside_lakes(curves: &mut Curves, disks: &[([f64; 2], f64)], budget: usize, rng: &mut Rng) {
    for &(centre, radius) in disks.iter().filter(|disk| disk.1 > 0.05) {
        for _ in 0..12 {
            let size = radius * rng.between(0.1, 0.3);
            let spot = centre.map(|x| x + radius * rng.between(-0.4, 0.4));
            place(curves, spot, size, budget, rng);
        }
    }
}

/// A ring inside the disk, kites included, if the disk is clear and the budget allows.
fn place(curves: &mut Curves, centre: [f64; 2], radius: f64, budget: usize, rng: &mut Rng) -> bool {
    const CORNERS: usize = 6;
    if curves.points.len() + CORNERS > budget || !curves.is_clear(centre, radius) {
        return false;
    }
    // The middle of an edge is at most 0.63 * 0.95 from the centre, and its kite at most 0.63 * 0.95 * 1.66 < 1.
    curves.ring(&ring(CORNERS, centre, || radius * rng.between(0.3, 0.63)), centre);
    true
}
