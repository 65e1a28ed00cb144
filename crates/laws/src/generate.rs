//! Structured inputs: few points, most of them made from earlier ones so that something is exactly, or almost, degenerate.
//!
//! Uniform points break nothing. What breaks triangulators is a coordinate copied, a line extended, a circle completed, a
//! midpoint, a double nudged by one unit in the last place, all of it far from 1 by a power of two; each of these is a [`Move`].
//!
//! **In.** [`Choices`]. **Out.** Finite points, with duplicates and -0.0; a pure function of the choices.

mod coordinate;
mod moves;

use delone::workloads::{Kind, Points, all};

use crate::case::Case;
use crate::choices::Choices;
use crate::corpus::taken;
use crate::id;
pub use coordinate::{Palette, coordinate};
pub use moves::{Move, moved};

/// The name of every generated case: two inputs that break a law in one way then say so in the same words.
pub const NAME: &str = "case";

/// The most points of a generated case.
pub const POINTS_MAX: usize = 14;

/// Points of the plane or of space.
pub fn points<const D: usize>(choices: &mut dyn Choices) -> Case<D> {
    drawn(choices).without_segments()
}

/// The same; pieces of a corpus have their segments with them.
fn drawn<const D: usize>(choices: &mut dyn Choices) -> Case<D> {
    let Case { mut points, segments, .. } = taken(choices);
    let palette = Palette::choose(choices);
    if choices.one_in(6) {
        points.extend(seeds::<D>(choices));
        points.truncate(POINTS_MAX);
    }
    let count = choices.index(POINTS_MAX + 1).max(points.len());
    while points.len() < count {
        let point = match Move::choose(choices) {
            Some(step) if !points.is_empty() => moved(step, &points, choices),
            _ => std::array::from_fn(|_| coordinate(palette, choices)),
        };
        // What overflows is replaced: every finite double is an input, and nothing else is.
        points.push(point.map(|x| if x.is_finite() { x } else { 0.0 }));
    }
    moves::whole(&mut points, choices);
    Case { name: NAME.to_owned(), points, segments }
}

/// Points and segments that do not cross.
pub fn graph(choices: &mut dyn Choices) -> Case<2> {
    let mut case = drawn::<2>(choices);
    let taken = std::mem::take(&mut case.segments);
    for ends in taken.into_iter().chain(candidates(case.points.len(), choices)) {
        case.segments.push(ends);
        if case.try_pslg().is_none() {
            case.segments.pop();
        }
    }
    case
}

/// Points and segments that may cross.
pub fn crossing(choices: &mut dyn Choices) -> Case<2> {
    let mut case = drawn::<2>(choices);
    case.segments.extend(candidates(case.points.len(), choices));
    case
}

/// A few points of a workload.
fn seeds<const D: usize>(choices: &mut dyn Choices) -> Vec<[f64; D]> {
    let fits = |kind| if D == 2 { kind != Kind::Points3d } else { kind == Kind::Points3d };
    let workloads: Vec<_> = all().iter().filter(|w| fits(w.kind())).collect();
    let workload = workloads[choices.index(workloads.len())];
    let count = 3 + choices.index(POINTS_MAX - 4);
    let made = workload.generate(count, choices.below(1 << 16)).points;
    let flat: &[f64] = match &made {
        Points::Plane(points) => points.as_flattened(),
        Points::Space(points) => points.as_flattened(),
    };
    let mut points = flat.as_chunks::<D>().0.to_vec();
    points.truncate(POINTS_MAX);
    points
}

/// Pairs of points: at random, in a path, around one point.
fn candidates(points: usize, choices: &mut dyn Choices) -> Vec<[u32; 2]> {
    if points == 0 {
        return Vec::new();
    }
    let (style, hub) = (choices.below(4), choices.index(points));
    let count = choices.index(16);
    let pair = |i: usize, choices: &mut dyn Choices| match style {
        0 => [hub, choices.index(points)],
        1 => [i % points, (i + 1) % points],
        _ => [choices.index(points), choices.index(points)],
    };
    (0..count).map(|i| pair(i, choices).map(id)).collect()
}

#[cfg(test)]
mod tests;
