//! The worst cases of algorithms, in the order given: what they cost there, but for the beach line's length, is pinned in
//! `tests/tests/worst_cases.rs`.
//!
//! ```text
//!    falling          shuttle                      column        beach            wheel
//!       o 1st         o  . . . . . . . .  o        o               o   o            o o
//!       o 2nd         1st, then to and fro            o          o   o           o    o    o
//!       o ..          between the ends              o          . . . . . .          o o
//!    . . . . .                                         o
//! ```

use super::{Plane, circles};
use crate::Rng;
use crate::num::real;

/// A row of integers, then sites that come down towards its middle from far above: each is inside the circumcircles of all
/// triangles over the row, so that an incremental algorithm digs them all, n^2 / 4 in all. In random order it does not.
pub(crate) fn falling(n: usize, _: &mut Rng) -> Plane {
    let (row, above) = (n.div_ceil(2), n / 2);
    let row = (0..row).map(|i| [real(i) - real(n / 4), 0.0]);
    row.chain((0..above).map(|j| [0.0, real(4 * n - j)])).collect()
}

/// Two rows of integers, from left to right, then sites to and fro beyond their ends: a walk from the last site to the next crosses
/// all triangles between, n^2 / 2 in all.
pub(crate) fn shuttle(n: usize, _: &mut Rng) -> Plane {
    let strip = n.div_ceil(2);
    let rows = (0..strip).map(|i| [real(i / 2), real(i % 2)]);
    let ends = (0..n / 2).map(|j| {
        let beyond = real(1 + j / 2);
        [if j % 2 == 0 { -beyond } else { real(strip) + beyond }, 0.5]
    });
    rows.chain(ends).collect()
}

/// A column whose sites have distinct x in random order, n times as high as wide: a vertical cut parts it into halves as high as the
/// whole, so that each merge zips from end to end and undoes most of what the halves had.
pub(crate) fn column(n: usize, rng: &mut Rng) -> Plane {
    let mut places: Vec<usize> = (0..n).collect();
    rng.shuffle(&mut places);
    places.iter().enumerate().map(|(i, &x)| [real(x), real(i) * real(n)]).collect()
}

/// A row of integers, then sites above it from left to right in turn with the middle: a sweep from below has a beach line of n / 2
/// arcs before the first of these, and each of them splits one.
pub(crate) fn beach(n: usize, rng: &mut Rng) -> Plane {
    let row = n.div_ceil(2);
    let shore = (0..row).map(|i| [real(i), 0.0]);
    let mut places: Vec<usize> = (0..n / 2).collect();
    rng.shuffle(&mut places);
    let later = places.iter().enumerate().map(|(j, &x)| [real(x) + 0.5, 1.0 + real(j) / real(n)]);
    shore.chain(later).collect()
}

/// The origin, and exactly cocircular sites around it: a vertex of degree n - 1. Its removal, and what hopes for vertices of
/// small degree, must not be quadratic.
pub(crate) fn wheel(n: usize, rng: &mut Rng) -> Plane {
    let hub = (n > 0).then_some([0.0, 0.0]);
    hub.into_iter().chain(circles::exact(n.saturating_sub(1), rng)).collect()
}
