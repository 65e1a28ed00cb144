//! Merging two slabs: along their common wall, from bottom to top, window by window.
//!
//! All segments that cross the wall and that either side knows cut it into windows. In each window at most one region of the
//! left slab and one of the right look at each other; those two are zipped. A segment that spans both slabs separates the
//! merged regions. A spanning segment that neither side knows passes through no region, since each region knows the
//! nearest ones.

use std::cmp::Ordering;

use delone_predicates::PlaneKernel;
use delone_probe::Probe;
use delone_sites::compare_along;

use super::{Chew, Region};

/// One side of a merge: the regions of a slab, from bottom to top, as the wall is walked along.
struct Side {
    regions: Vec<Region>,
    /// The region that looks at the wall now.
    current: Option<usize>,
    /// The one to come.
    coming: usize,
}

impl Side {
    fn new(regions: Vec<Region>) -> Self {
        // The lowest region reaches down without end if no segment is below it.
        Self { regions, current: None, coming: 0 }
    }

    /// Steps into the coming region if `segment` is its lower bound.
    fn enter(&mut self, segment: Option<u32>) -> Option<usize> {
        let coming = self.regions.get(self.coming).filter(|region| region.low == segment)?;
        debug_assert!(segment.is_some() || coming.low.is_none());
        self.current = Some(self.coming);
        self.coming += 1;
        self.current
    }

    /// Steps out of the current region if `segment` is its upper bound.
    fn leave(&mut self, segment: u32) {
        if self.current.is_some_and(|current| self.regions[current].high == Some(segment)) {
            self.current = None;
        }
    }
}

/// A merged region in the making; `holds` says whether a region has come into it.
struct Growing {
    region: Region,
    holds: bool,
}

impl Growing {
    fn above(low: Option<u32>) -> Self {
        let region = Region { low, first: u32::MAX, last: 0, ..Region::default() };
        Self { region, holds: false }
    }

    fn take(&mut self, region: &Region) {
        self.holds = true;
        self.region.first = self.region.first.min(region.first);
        self.region.last = self.region.last.max(region.last);
    }

    fn close(self, high: Option<u32>, merged: &mut Vec<Region>) {
        if self.holds {
            merged.push(Region { high, ..self.region });
        }
    }
}

impl<K: PlaneKernel, P: Probe> Chew<'_, '_, K, P> {
    /// Merges the regions of slabs `[i, m)` and `[m, j)`.
    pub(super) fn merge(
        &mut self,
        slab: [u32; 3],
        left: Vec<Region>,
        right: Vec<Region>,
    ) -> Vec<Region> {
        let [i, _, j] = slab;
        let crossing = self.wall(&left, &right);
        let (mut left, mut right) = (Side::new(left), Side::new(right));
        let mut merged = Vec::new();
        let mut growing = Growing::above(None);
        enter(&mut left, &mut right, None, &mut growing);
        let mut floor = None;
        for ceiling in crossing.into_iter().map(Some).chain([None]) {
            if let (Some(a), Some(b)) = (left.current, right.current) {
                self.zip(slab, &left.regions[a], &right.regions[b], floor, ceiling);
            }
            let Some(segment) = ceiling else { break };
            let [a, b] = self.segments[segment as usize];
            match (a < i, b >= j) {
                (true, true) => {
                    let done = std::mem::replace(&mut growing, Growing::above(ceiling));
                    done.close(ceiling, &mut merged);
                }
                (true, false) => growing.region.left.push(segment),
                (false, true) => growing.region.right.push(segment),
                (false, false) => {}
            }
            left.leave(segment);
            right.leave(segment);
            enter(&mut left, &mut right, ceiling, &mut growing);
            floor = ceiling;
        }
        growing.close(None, &mut merged);
        merged
    }

    /// All segments that cross the wall and that a side knows, from bottom to top, each once.
    fn wall(&self, left: &[Region], right: &[Region]) -> Vec<u32> {
        let on_left = left
            .iter()
            .flat_map(|region| region.low.iter().chain(&region.right).chain(&region.high).copied());
        let on_right = right
            .iter()
            .flat_map(|region| region.low.iter().chain(&region.left).chain(&region.high).copied());
        let (mut on_left, mut on_right) = (on_left.peekable(), on_right.peekable());
        let mut wall: Vec<u32> = Vec::new();
        loop {
            let next = match (on_left.peek(), on_right.peek()) {
                (Some(&e), Some(&f)) => match compare_along(self.kernel, self.segments, e, f) {
                    Ordering::Greater => on_right.next(),
                    Ordering::Less | Ordering::Equal => on_left.next(),
                },
                (Some(_), None) => on_left.next(),
                (None, _) => on_right.next(),
            };
            let Some(segment) = next else { return wall };
            if wall.last() != Some(&segment) {
                wall.push(segment);
            }
        }
    }
}

/// Lets both sides step into the regions above `segment`. Halves through the outer walls go over to the merged region.
fn enter(left: &mut Side, right: &mut Side, segment: Option<u32>, growing: &mut Growing) {
    if let Some(place) = left.enter(segment) {
        let region = &mut left.regions[place];
        growing.take(region);
        growing.region.left.append(&mut region.left);
    }
    if let Some(place) = right.enter(segment) {
        let region = &mut right.regions[place];
        growing.take(region);
        growing.region.right.append(&mut region.right);
    }
}
