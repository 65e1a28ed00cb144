//! A tree of boxes over the plane: which items can a segment meet?
//!
//! **Design.** Items (points or segments, as boxes) are put along Hilbert's curve and grouped by eight, the groups by
//! eight again, up to one root: a packed R-tree [KF93]. A query descends where the segment meets the box: the boxes
//! overlap, and the box's corners are not all strictly on one side of the segment's line, by exact orientation. So a long
//! slanted segment visits the boxes along it and not those of its whole bounding box.
//! **Cost.** O(n log n) to build; a query visits O(sqrt n + answers) nodes on spread-out items.

use delone_predicates::{Sign, orient2d};

use crate::order::Curve;

const FANOUT: usize = 8;

/// An axis-parallel box, closed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Box2 {
    low: [f64; 2],
    high: [f64; 2],
}

impl Box2 {
    pub(crate) fn of(a: [f64; 2], b: [f64; 2]) -> Self {
        let [low, high] = [f64::min, f64::max].map(|pick| [pick(a[0], b[0]), pick(a[1], b[1])]);
        Self { low, high }
    }

    fn union(self, other: Self) -> Self {
        Self { low: Self::of(self.low, other.low).low, high: Self::of(self.high, other.high).high }
    }

    fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|axis| self.low[axis] <= other.high[axis] && other.low[axis] <= self.high[axis])
    }

    /// Whether the closed segment `ab`, whose box is `bounds`, may meet this box.
    fn meets(&self, bounds: &Self, a: [f64; 2], b: [f64; 2]) -> bool {
        if !self.overlaps(bounds) {
            return false;
        }
        let ([x0, y0], [x1, y1]) = (self.low, self.high);
        let first = orient2d(a, b, [x0, y0]);
        first == Sign::Zero
            || [[x1, y0], [x1, y1], [x0, y1]].iter().any(|&c| orient2d(a, b, c) != first)
    }
}

/// The tree. Level 0 holds the items' boxes in order of the curve, level `l + 1` the boxes of eight of level `l`.
#[derive(Clone, Debug)]
pub(crate) struct BoxTree {
    items: Vec<u32>,
    levels: Vec<Vec<Box2>>,
}

impl BoxTree {
    pub(crate) fn new(boxes: &[Box2]) -> Self {
        let middles: Vec<[f64; 2]> = boxes
            .iter()
            .map(|b| [0, 1].map(|axis| b.low[axis] / 2.0 + b.high[axis] / 2.0))
            .collect();
        let curve = Curve::around(&middles);
        let mut keyed: Vec<(u64, u32)> =
            middles.iter().zip(0u32..).map(|(middle, item)| (curve.key(middle), item)).collect();
        keyed.sort_unstable();
        let items: Vec<u32> = keyed.into_iter().map(|(_, item)| item).collect();
        let mut levels = vec![items.iter().map(|&item| boxes[item as usize]).collect::<Vec<_>>()];
        while let Some(below) = levels.last()
            && below.len() > 1
        {
            let group = |boxes: &[Box2]| boxes[1..].iter().fold(boxes[0], |a, &b| a.union(b));
            levels.push(below.chunks(FANOUT).map(group).collect());
        }
        Self { items, levels }
    }

    /// Calls `visit` with every item whose box the closed segment `ab` may meet.
    pub(crate) fn for_each_near(&self, a: [f64; 2], b: [f64; 2], mut visit: impl FnMut(u32)) {
        let bounds = Box2::of(a, b);
        let mut stack = vec![(self.levels.len() - 1, 0)];
        while let Some((level, place)) = stack.pop() {
            let Some(node) = self.levels[level].get(place) else { continue };
            if !node.meets(&bounds, a, b) {
                continue;
            }
            if level == 0 {
                visit(self.items[place]);
            } else {
                let end = (FANOUT * (place + 1)).min(self.levels[level - 1].len());
                stack.extend((FANOUT * place..end).map(|child| (level - 1, child)));
            }
        }
    }
}
