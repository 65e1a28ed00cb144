//! The leaves of the division: a slab of one site, and two sites of one region.
//!
//! Two sites of one region see each other: a segment between them would need an end in the region, and would pass between
//! the two of them only if it went on as a bound of both. So a pair needs no merge: the edge between them goes into both rings, and the halves
//! of the two take their places in the region's lists below and above it. **Paper.** [Che89] begins with single sites; where segments are
//! many, most merges are of two of them.

use delone_predicates::{PlaneKernel, Sign};
use delone_probe::{Event, Probe};
use delone_sites::Ends;

use super::Chew;
use super::region::{List, Region, Wall};

impl<K: PlaneKernel, P: Probe> Chew<'_, '_, K, P> {
    /// The slab of one site: one region, with the halves of the segments at the site.
    pub(super) fn single(&mut self, v: u32) -> Region {
        let [low, high] = self.bounds[v as usize];
        let (mut left, mut right) = (List::EMPTY, List::EMPTY);
        for h in self.rings.halves(v) {
            // Counter-clockwise is from bottom to top on the right, and from top to bottom on the left.
            if self.rings.destination(h) > v {
                self.lists.push(&mut right, Wall::Right, h / 2);
            } else {
                self.lists.push_below(&mut left, Wall::Left, h / 2);
            }
        }
        Region { low, high, left, right, first: v, last: v }
    }

    /// Two sites that are all of a region above the spanning segment `low`.
    pub(super) fn pair(&mut self, [a, b]: Ends, low: Option<u32>) -> Region {
        let [before_b, before_a] = [self.halves_before(a, b), self.halves_before(b, a)];
        let rings = &self.rings;
        let after_a = rings.halves(a).skip(before_b).filter(|&h| rings.destination(h) > a);
        let after_b = rings.halves(b).skip(before_a);
        let between = rings.halves(a).nth(before_b).filter(|&h| rings.destination(h) == b);
        let mut right = List::EMPTY;
        // From bottom to top.
        let halves = rings.halves(a).take(before_b);
        let halves = halves.chain(rings.halves(b).take_while(|&h| rings.destination(h) > b));
        for h in halves.chain(after_a).filter(|&h| Some(h) != between) {
            self.lists.push(&mut right, Wall::Right, h / 2);
        }
        let mut left = List::EMPTY;
        // From top to bottom.
        let halves = rings.halves(b).take(before_a).filter(|&h| rings.destination(h) < b);
        let halves = halves.chain(rings.halves(a).filter(|&h| rings.destination(h) < a));
        let after_b = after_b.filter(|&h| rings.destination(h) < b && rings.destination(h) != a);
        for h in halves.chain(after_b) {
            self.lists.push_below(&mut left, Wall::Left, h / 2);
        }
        if between.is_none() {
            let [at_a, at_b] = [(a, before_b), (b, before_a)].map(|(v, before)| {
                let first = rings.start(v)?;
                before
                    .checked_sub(1)
                    .map_or(Some(rings.previous(first)), |n| rings.halves(v).nth(n))
            });
            self.rings.join(a, b, at_a, at_b);
        }
        // What is next above `a` spans the slab, or ends at `b`, which sees what does.
        let above = |v: u32| self.bounds[v as usize][1];
        let high = above(a).filter(|&e| self.segments[e as usize][1] != b);
        let high = if high.is_none() && above(a).is_some() { above(b) } else { high };
        Region { low, high, left, right, first: a, last: b }
    }

    /// How many halves of the ring of `v`, which holds segments alone, come before the direction to `w`, counter-clockwise from
    /// straight down.
    fn halves_before(&mut self, v: u32, w: u32) -> usize {
        let passed = self.rings.halves(v).take_while(|&h| {
            let d = self.rings.destination(h);
            match (w > v, d > v) {
                (true, false) => false,
                (false, true) => true,
                _ => {
                    self.probe.on(Event::Orient);
                    let turn = self.kernel.orient(&[v, d, w].map(|v| v as usize));
                    turn == Sign::Positive
                }
            }
        });
        passed.count()
    }
}
