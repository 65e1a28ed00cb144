//! Merging two slabs: along their common wall, from bottom to top, window by window.
//!
//! All segments that cross the wall and that either side knows cut it into windows. In each window at most one region of the
//! left slab and one of the right look at each other; those two are zipped. A segment that spans both slabs separates the
//! merged regions. A spanning segment that neither side knows passes through no region, since each region knows the
//! nearest ones.

use std::cmp::Ordering;
use std::ops::Range;

use delone_predicates::PlaneKernel;
use delone_probe::Probe;
use delone_sites::compare_along;

use super::Chew;
use super::region::{Lists, Region, Wall};

/// One side of a merge: the regions of a slab, from bottom to top, as the wall is walked along.
struct Side {
    /// The region that looks at the wall now, by place.
    current: Option<usize>,
    /// Those to come.
    coming: Range<usize>,
}

impl Side {
    const fn new(coming: Range<usize>) -> Self {
        Self { current: None, coming }
    }

    /// Steps into the coming region if `segment` is its lower bound.
    fn enter(&mut self, regions: &[Region], segment: Option<u32>) -> Option<Region> {
        let place = self.coming.clone().next().filter(|&place| regions[place].low == segment)?;
        self.coming.start += 1;
        self.current = Some(place);
        Some(regions[place])
    }

    /// Steps out of the current region if `segment` is its upper bound.
    fn leave(&mut self, regions: &[Region], segment: u32) {
        if self.current.is_some_and(|current| regions[current].high == Some(segment)) {
            self.current = None;
        }
    }
}

impl<K: PlaneKernel, P: Probe> Chew<'_, '_, K, P> {
    /// Merges the slabs `[i, m)` and `[m, j)`, whose regions are on top of the others, from places `left` and `right` on.
    pub(super) fn merge(&mut self, slab: [u32; 3], left: usize, right: usize) {
        let [i, _, j] = slab;
        self.find_wall(left, right);
        let (base, end) = (left, self.regions.len());
        let (mut left, mut right) = (Side::new(left..right), Side::new(right..end));
        let mut growing = Region::above(None);
        self.enter(&mut left, &mut right, None, &mut growing);
        let mut floor = None;
        for place in 0..=self.wall.len() {
            let ceiling = self.wall.get(place).copied();
            if let (Some(a), Some(b)) = (left.current, right.current) {
                let (a, b) = (self.regions[a], self.regions[b]);
                self.zip(slab, &a, &b, floor, ceiling);
            }
            let Some(segment) = ceiling else { break };
            let [a, b] = self.segments[segment as usize];
            match (a < i, b >= j) {
                (true, true) => {
                    self.close(growing, ceiling);
                    growing = Region::above(ceiling);
                }
                (true, false) => self.lists.push(&mut growing.left, Wall::Left, segment),
                (false, true) => self.lists.push(&mut growing.right, Wall::Right, segment),
                (false, false) => {}
            }
            left.leave(&self.regions, segment);
            right.leave(&self.regions, segment);
            self.enter(&mut left, &mut right, ceiling, &mut growing);
            floor = ceiling;
        }
        self.close(growing, None);
        self.regions.truncate(base);
        self.regions.append(&mut self.merged);
        self.show(slab);
    }

    /// A merged region is done, and kept if a site is in it.
    fn close(&mut self, growing: Region, high: Option<u32>) {
        if growing.holds_a_site() {
            self.merged.push(Region { high, ..growing });
        }
    }

    /// Lets both sides step into the regions above `segment`. Halves through the outer walls go over to the merged region.
    fn enter(
        &mut self,
        left: &mut Side,
        right: &mut Side,
        segment: Option<u32>,
        growing: &mut Region,
    ) {
        if let Some(region) = left.enter(&self.regions, segment) {
            growing.take(&region);
            self.lists.append(&mut growing.left, Wall::Left, region.left);
        }
        if let Some(region) = right.enter(&self.regions, segment) {
            growing.take(&region);
            self.lists.append(&mut growing.right, Wall::Right, region.right);
        }
    }

    /// All segments that cross the wall and that a side knows, from bottom to top, each once.
    fn find_wall(&mut self, left: usize, right: usize) {
        self.wall.clear();
        let (lists, regions) = (&self.lists, &self.regions);
        let mut on_left = Known::new(&regions[left..right], Wall::Right);
        let mut on_right = Known::new(&regions[right..], Wall::Left);
        let (mut e, mut f) = (on_left.next(lists), on_right.next(lists));
        loop {
            let order = match (e, f) {
                (Some(e), Some(f)) => compare_along(self.kernel, self.segments, e, f),
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (None, None) => return,
            };
            self.wall.extend(if order == Ordering::Greater { f } else { e });
            if order != Ordering::Greater {
                e = on_left.next(lists);
            }
            if order != Ordering::Less {
                f = on_right.next(lists);
            }
        }
    }
}

/// The segments that some regions know at a wall, from bottom to top, each once.
struct Known<'r> {
    /// The region at hand and those above.
    regions: &'r [Region],
    wall: Wall,
    /// The place in the region's list.
    list: Option<u32>,
    last: Option<u32>,
    step: Step,
}

/// What comes next of a region.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    Low,
    List,
    High,
}

impl<'r> Known<'r> {
    const fn new(regions: &'r [Region], wall: Wall) -> Self {
        Self { regions, wall, list: None, last: None, step: Step::Low }
    }

    fn next(&mut self, lists: &Lists) -> Option<u32> {
        loop {
            let region = self.regions.first()?;
            let known = match self.step {
                Step::Low => {
                    self.step = Step::List;
                    self.list =
                        if self.wall == Wall::Right { region.right } else { region.left }.first();
                    region.low.filter(|_| region.low != self.last)
                }
                Step::List => match self.list {
                    Some(segment) => {
                        self.list = lists.after(segment, self.wall);
                        Some(segment)
                    }
                    None => {
                        self.step = Step::High;
                        None
                    }
                },
                Step::High => {
                    self.step = Step::Low;
                    self.regions = &self.regions[1..];
                    region.high
                }
            };
            if known.is_some() {
                self.last = known;
                return known;
            }
        }
    }
}
