//! Points and segments of the plane.

use super::{HUGE, TINY, real};
use crate::case::Case;

/// All of them; no segments cross.
#[must_use]
pub fn pslgs() -> Vec<Case<2>> {
    let mut cases = small();
    cases.push(dangling());
    cases.extend([6, 20].map(spikes));
    cases.push(grid_rows());
    cases.extend(ends_of_the_range());
    cases
}

fn case(name: &str, points: &[[f64; 2]], segments: &[[u32; 2]]) -> Case<2> {
    Case::new(format!("hand {name}"), points.to_vec(), segments.to_vec())
}

fn small() -> Vec<Case<2>> {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let and = |more: &[[f64; 2]]| [&square[..], more].concat();
    let kite = [[0.0, 0.0], [3.0, 1.0], [6.0, 0.0], [3.0, -1.0]];
    let line = [[0.0, 0.0], [3.0, 3.0], [1.0, 1.0], [2.0, 2.0]];
    let junctions = and(&[[2.0, 0.0], [1.0, 0.0], [2.0, 9.0]]);
    vec![
        case("nothing", &[], &[]),
        case("a segment of no length", &[[1.0, 1.0]; 2], &[[0, 1], [0, 0]]),
        case("a segment and its reverse", &[[0.0, 0.0], [1.0, 0.0]], &[[0, 1], [1, 0]]),
        case("a chain", &line, &[[0, 1]]),
        case("overlaps in a chain", &line, &[[0, 3], [2, 1], [3, 3]]),
        case("one diagonal", &square, &[[0, 2]]),
        case("the other diagonal", &square, &[[1, 3]]),
        case("the outline", &square, &[[0, 1], [1, 2], [2, 3], [3, 0]]),
        case("the long diagonal of a kite", &kite, &[[0, 2]]),
        case("all segments through a centre", &and(&[[2.0, 2.0]]), &[[0, 2], [3, 1]]),
        case("a segment between duplicates", &and(&square), &[[0, 6], [4, 2], [1, 5]]),
        case("overlaps and T-junctions", &junctions, &[[0, 1], [5, 1], [4, 6], [0, 4]]),
    ]
}

/// Vertex 4 hangs from the upper chain down to the segment: both triangles at its edge are crossed.
fn dangling() -> Case<2> {
    let points = [
        [0.0, 0.0],
        [20.0, 0.0],
        [9.0, 9.0],
        [11.0, 9.0],
        [10.0, 0.125],
        [9.0, -9.0],
        [11.0, -9.0],
        [4.0, 0.25],
        [16.0, -0.25],
        [10.0, 3.0],
        [7.0, -0.0625],
        [13.0, 0.0625],
    ];
    case("a dangling edge", &points, &[[0, 1]])
}

/// One segment through n spikes whose heights fall by powers of two.
fn spikes(n: u32) -> Case<2> {
    let mut points = vec![[0.0, 0.0], [f64::from(n) + 1.0, 0.0]];
    for i in 1..=n {
        let height = f64::from(i * 7 % 5 + 1) / f64::from(1u32 << (i * 11 % 20));
        points.push([f64::from(i), if i % 2 == 0 { height } else { -height }]);
    }
    case(&format!("{n} spikes"), &points, &[[0, 1]])
}

/// Segments over a grid: through many sites, and slanted ones that miss all.
fn grid_rows() -> Case<2> {
    let points: Vec<[f64; 2]> = (0..25).map(|i| [real(i % 5), real(i / 5)]).collect();
    case("a grid with long segments", &points, &[[0, 4], [5, 16], [7, 13], [16, 23], [8, 9]])
}

fn ends_of_the_range() -> Vec<Case<2>> {
    let mut cases = Vec::new();
    for s in [HUGE, TINY, 1e-160, 1e154] {
        let points =
            [[-s, -s], [s, s], [s, -s], [-s, s], [0.0, 0.0], [0.0, s], [0.0, -s], [s, 0.0]];
        let name = format!("a square of half side {s:e}");
        cases.push(case(&name, &points, &[[0, 4], [2, 5], [6, 2]]));
    }
    let needle = [[-HUGE, TINY], [HUGE, TINY], [0.0, 0.0], [TINY, -TINY], [1.0, HUGE], [1.0, -1.0]];
    cases.push(case("a needle over the whole range", &needle, &[[0, 1], [2, 5]]));
    cases
}
