//! Cubes in orthographic projection, painted over one another.

use std::fmt::Write;

use super::{Cube, SIDE};
use crate::text::Short;

/// Rows of the rotation to right and up: 35 degrees or so around z, then 20 down. The eye is at large x, small y, large z.
const VIEW: [[f64; 3]; 2] = [[0.8, 0.6, 0.0], [-0.210, 0.280, 0.9368]];
/// Pixels for a unit: cubes moved apart by a quarter fit as well.
const SCALE: f64 = 200.0;

/// The three faces that are seen, by the corners of the unit cube, and their colours.
const FACES: [([[f64; 3]; 4], &str); 3] = [
    ([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 0.0, 1.0]], "#6f8cab"),
    ([[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]], "#9fb6cd"),
    ([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]], "#dbe5ef"),
];

/// A point of the cube in pixels.
fn place(point: [f64; 3]) -> [Short; 2] {
    let from_middle = point.map(|c| c - 0.5);
    let along = |row: [f64; 3]| row.iter().zip(from_middle).map(|(r, c)| r * c).sum::<f64>();
    let [right, up] = VIEW.map(along);
    [Short(SIDE / 2.0 + SCALE * right), Short(SIDE / 2.0 - SCALE * up)]
}

pub(super) fn write(out: &mut String, cubes: &[Cube]) {
    out.push_str("<g stroke=\"#3c5878\" stroke-width=\"0.5\" stroke-linejoin=\"round\">");
    for cube in cubes {
        for (corners, fill) in FACES {
            let corner = |c: [f64; 3]| {
                place(std::array::from_fn(|axis| cube.lower[axis] + cube.side * c[axis]))
            };
            let [[ax, ay], [bx, by], [cx, cy], [dx, dy]] = corners.map(corner);
            let _ = write!(
                out,
                "<path fill=\"{fill}\" d=\"M{ax} {ay}L{bx} {by}L{cx} {cy}L{dx} {dy}Z\"/>"
            );
        }
    }
    out.push_str("</g>");
}
