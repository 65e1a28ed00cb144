//! Brute force, straight from the definitions: the twins that validate the judge and the algorithms
//! on small inputs.
//!
//! | function | definition | time | for |
//! |---|---|---|---|
//! | [`delaunay`] | simplices with no point in conflict | `n^(k+2)` | n <= 40, in space 20 |
//! | [`regular`] | the same with weights; what is no vertex is hidden | `n^(k+2)` | the same |
//! | [`delaunay_by_epsilon`] | hull of heights plus powers of two | `n^(k+2)`, big | n <= 12 |
//! | [`constrained`] | no visible point in conflict | `n^4 (n + m)^2` | n <= 14 |
//!
//! Each returns cells of ascending ids, sorted; the dimension is that of the points, and cells have
//! one more vertex: points of the plane on a line give pairs, a single point `[[0]]`, no points
//! nothing. Of equal points the first is used. Coordinates must be finite.

mod epsilon;
mod visibility;

pub use epsilon::delaunay_by_epsilon;
pub use visibility::constrained;

use crate::exact::{Integer, Pure, Sign};
use crate::space::Space;

/// The Delaunay triangulation under the lexicographic perturbation, by its definition.
///
/// ```
/// let square = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
/// assert_eq!(delone_check::naive::delaunay(&square), [[0, 1, 2], [1, 2, 3]]);
/// ```
#[must_use]
pub fn delaunay<const D: usize>(points: &[[f64; D]]) -> Vec<Vec<u32>> {
    without_conflict(Space::new(points, true))
}

/// The regular triangulation of points with weights, one for each, under the lexicographic
/// perturbation. Of equal points the heaviest is used, of those the first.
///
/// ```
/// let line = [[0.0], [1.0], [2.0]];
/// assert_eq!(delone_check::naive::regular(&line, &[0.0, 0.0, 0.0]), [[0, 1], [1, 2]]);
/// assert_eq!(delone_check::naive::regular(&line, &[4.0, 0.0, 0.0]), [[0, 2]]);
/// ```
///
/// # Panics
/// If there are not as many weights as points.
#[must_use]
pub fn regular<const D: usize>(points: &[[f64; D]], weights: &[f64]) -> Vec<Vec<u32>> {
    assert_eq!(points.len(), weights.len(), "each point has a weight");
    without_conflict(Space::weighted(points, Some(weights), true))
}

fn without_conflict<const D: usize>(space: Space<'_, D, Pure>) -> Vec<Vec<u32>> {
    let (ids, space) = framed(space);
    simplices(&space, &ids, |simplex, orientation| {
        ids.iter().all(|&q| simplex.contains(&q) || !space.conflict(simplex, orientation, q))
    })
}

/// The heaviest, or first, of each set of equal points, ascending; and the space along axes on which the points
/// keep their dimension.
fn framed<const D: usize, I: Integer>(mut space: Space<'_, D, I>) -> (Vec<u32>, Space<'_, D, I>) {
    let points = space.points;
    let mut ids: Vec<u32> = (0u32..).zip(points).map(|(id, _)| id).collect();
    ids.sort_by(|&u, &v| {
        let heavier = || space.compare_weights(v, u);
        space.compare(u, v).then_with(heavier).then(u.cmp(&v))
    });
    ids.dedup_by(|v, u| points[*v as usize] == points[*u as usize]);
    ids.sort_unstable();
    let mut axes: Vec<usize> = Vec::new();
    let mut simplex: Vec<u32> = ids.iter().take(1).copied().collect();
    for &v in ids.iter().skip(1) {
        simplex.push(v);
        let wider = (0..D).filter(|x| !axes.contains(x)).map(|x| {
            let mut wider = axes.clone();
            wider.push(x);
            wider
        });
        match wider.into_iter().find(|a| space.orient_along(a, &simplex) != Sign::Zero) {
            Some(wider) => axes = wider,
            None => {
                simplex.pop();
            }
        }
    }
    axes.sort_unstable();
    space.axes = axes;
    (ids, space)
}

/// All simplices of full dimension among `ids` that are not flat and satisfy `keep`, which is given
/// their orientation.
fn simplices<const D: usize, I: Integer>(
    space: &Space<'_, D, I>,
    ids: &[u32],
    keep: impl Fn(&[u32], Sign) -> bool,
) -> Vec<Vec<u32>> {
    let size = space.axes.len() + 1;
    let mut found = Vec::new();
    let mut chosen: Vec<usize> = (0..size).collect(); // positions in ids, ascending
    while chosen.last().is_some_and(|&last| last < ids.len()) {
        let simplex: Vec<u32> = chosen.iter().map(|&i| ids[i]).collect();
        let orientation = space.orient(&simplex);
        if orientation != Sign::Zero && keep(&simplex, orientation) {
            found.push(simplex);
        }
        // The next combination: advance the last position that has room.
        let advance = (0..size).rev().find(|&i| chosen[i] + size - i < ids.len()).unwrap_or(0);
        let start = chosen[advance] + 1;
        for (offset, position) in chosen[advance..].iter_mut().enumerate() {
            *position = start + offset;
        }
    }
    found
}

#[cfg(test)]
pub(crate) mod tests;
