//! The segments next below and above each site, by a sweep.
//!
//! **In.** Sites ranked in the order of the sweep; segments that meet in common ends only. **Out.** For each site the
//! nearest segment below and above among those that begin before and end after it. **Invariant.** The segments alive at a
//! moment are totally ordered along the sweep line. **Cost.** O(n log n) orientations.

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::ops::Bound;

use delone_predicates::{PlaneKernel, Sign};

use super::Ends;

/// The order from bottom to top of two segments that are alive together.
pub(super) fn compare(kernel: &impl PlaneKernel, segments: &[Ends], e: u32, f: u32) -> Ordering {
    if e == f {
        return Ordering::Equal;
    }
    let ([a, b], [c, d]) = (segments[e as usize], segments[f as usize]);
    let orient = |a: u32, b: u32, v: u32| kernel.orient(&[a as usize, b as usize, v as usize]);
    // The sign of "e is above f", seen from an end of one that lies between the ends of the other.
    let above = if a == c {
        orient(a, d, b)
    } else if a > c {
        orient(c, d, a)
    } else {
        -orient(a, b, c)
    };
    match above {
        Sign::Positive => Ordering::Greater,
        Sign::Negative => Ordering::Less,
        Sign::Zero => panic!("the PSLG is noded: segments alive together do not touch inside"),
    }
}

/// A place along the sweep line: a segment, or a site on none of them.
struct Place<'k, K> {
    kernel: &'k K,
    segments: &'k [Ends],
    at: At,
}

#[derive(Clone, Copy)]
enum At {
    Segment(u32),
    Site(u32),
}

impl<K: PlaneKernel> Place<'_, K> {
    /// The order of a site and a segment.
    fn against(&self, site: u32, segment: u32) -> Ordering {
        let [a, b] = self.segments[segment as usize];
        match self.kernel.orient(&[a as usize, b as usize, site as usize]) {
            Sign::Positive => Ordering::Greater,
            Sign::Negative => Ordering::Less,
            Sign::Zero => panic!("the PSLG is noded: no site lies inside a segment"),
        }
    }
}

impl<K: PlaneKernel> Ord for Place<'_, K> {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self.at, other.at) {
            (At::Segment(e), At::Segment(f)) => compare(self.kernel, self.segments, e, f),
            (At::Site(v), At::Segment(e)) => self.against(v, e),
            (At::Segment(e), At::Site(v)) => self.against(v, e).reverse(),
            (At::Site(u), At::Site(v)) => u.cmp(&v),
        }
    }
}

impl<K: PlaneKernel> PartialOrd for Place<'_, K> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<K: PlaneKernel> PartialEq for Place<'_, K> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<K: PlaneKernel> Eq for Place<'_, K> {}

/// For each site the segments next below and above.
pub(super) fn bounds(
    kernel: &impl PlaneKernel,
    count: usize,
    segments: &[Ends],
) -> Vec<[Option<u32>; 2]> {
    let mut events: Vec<(u32, bool, u32)> = Vec::with_capacity(2 * segments.len()); // site, begins, segment
    for (segment, &[a, b]) in (0u32..).zip(segments) {
        events.extend([(a, true, segment), (b, false, segment)]);
    }
    events.sort_unstable();
    let mut events = events.into_iter().peekable();
    let place = |at: At| Place { kernel, segments, at };
    let segment_at = |place: &Place<'_, _>| match place.at {
        At::Segment(segment) => Some(segment),
        At::Site(_) => None,
    };
    let mut alive = BTreeSet::new();
    let mut bounds = Vec::with_capacity(count);
    for site in (0u32..).take(count) {
        while let Some((_, _, segment)) = events.next_if(|&(v, begins, _)| v == site && !begins) {
            alive.remove(&place(At::Segment(segment)));
        }
        let here = place(At::Site(site));
        let below = alive.range((Bound::Unbounded, Bound::Excluded(&here))).next_back();
        let above = alive.range((Bound::Excluded(&here), Bound::Unbounded)).next();
        bounds.push([below, above].map(|found| found.and_then(segment_at)));
        while let Some((_, _, segment)) = events.next_if(|&(v, begins, _)| v == site && begins) {
            alive.insert(place(At::Segment(segment)));
        }
    }
    bounds
}
