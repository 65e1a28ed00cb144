//! Sites in vertical strips: which sites can a segment pass through?
//!
//! **Design.** The sites in lexicographic order are cut into strips of about sqrt n, and each strip is sorted by height. A
//! segment passes through the strips between its ends; in each it takes a range of heights, found by bisection. The range is
//! computed in doubles and widened by a bound of its error: it may hold sites that are off the segment, it misses none.
//! **Cost.** O(n log n) to build, 12 bytes a site. A query takes O(log n) in each strip, and the sites that it returns.
//!
//! **Why the range is wide enough.** With u = 2^-53, t = (x - xa) / (xb - xa) is computed with a relative error below 4u
//! (or an absolute one of 2^-1075, if it underflows), t (yb - ya) with one below 6u |yb - ya|, and the sum with one more u of
//! its magnitude: in all below 16u (|ya| + |yb|), the smallest normal number covering what underflows. If the range is
//! not a number or not finite, that of the whole segment is taken.

use delone_predicates::{Sign, orient2d};

use crate::order::sortable;

/// The sites in strips.
#[derive(Debug)]
pub(crate) struct Strips<'s> {
    points: &'s [[f64; 2]],
    sorted: &'s [u32],
    /// Sites in a strip.
    width: usize,
    /// Strip after strip, from bottom to top in each: heights, and ranks.
    heights: Vec<f64>,
    ranks: Vec<u32>,
}

impl<'s> Strips<'s> {
    /// Of the `points` of some sites, which are `sorted` lexicographically.
    pub(crate) fn new(points: &'s [[f64; 2]], sorted: &'s [u32]) -> Self {
        let width = sorted.len().isqrt().max(32);
        let mut heights = Vec::with_capacity(sorted.len());
        let mut ranks = Vec::with_capacity(sorted.len());
        let mut strip: Vec<(u64, u32)> = Vec::with_capacity(width);
        let mut rank = 0u32..;
        for sites in sorted.chunks(width) {
            strip.clear();
            strip.extend(sites.iter().map(|&s| sortable(points[s as usize][1])).zip(&mut rank));
            strip.sort_unstable();
            ranks.extend(strip.iter().map(|&(_, rank)| rank));
            let site = |rank: u32| points[sorted[rank as usize] as usize];
            heights.extend(strip.iter().map(|&(_, rank)| site(rank)[1]));
        }
        Self { points, sorted, width, heights, ranks }
    }

    fn point(&self, rank: u32) -> [f64; 2] {
        self.points[self.sorted[rank as usize] as usize]
    }

    /// The ranks of the sites strictly inside the segment between two ranks, `first < last`, in increasing order.
    pub(crate) fn inside(&self, first: u32, last: u32) -> Vec<u32> {
        let (a, b) = (self.point(first), self.point(last));
        let mut found = Vec::new();
        for strip in first as usize / self.width..=last as usize / self.width {
            let from = strip * self.width;
            let to = (from + self.width).min(self.sorted.len());
            let [low, high] = self.range(a, b, from, to);
            let heights = &self.heights[from..to];
            let at = from + heights.partition_point(|&height| height < low);
            let near = self.heights[at..to].iter().zip(&self.ranks[at..to]);
            for (_, &rank) in near.take_while(|&(&height, _)| height <= high) {
                let is_between = first < rank && rank < last;
                if is_between && orient2d(a, b, self.point(rank)) == Sign::Zero {
                    found.push(rank);
                }
            }
        }
        found.sort_unstable();
        found
    }

    /// The heights of the segment `ab` over the sites at places `from` to `to` of the order, and perhaps some more.
    fn range(&self, a: [f64; 2], b: [f64; 2], from: usize, to: usize) -> [f64; 2] {
        let (bottom, top) = (a[1].min(b[1]), a[1].max(b[1]));
        let run = b[0] - a[0];
        if run.is_infinite() {
            return [bottom, top]; // parts of it would seem to be nothing
        }
        let abscissa = |place: usize| self.points[self.sorted[place] as usize][0];
        let (left, right) = (abscissa(from).max(a[0]), abscissa(to - 1).min(b[0]));
        let height = |x: f64| a[1] + (x - a[0]) / run * (b[1] - a[1]);
        let error = 8.0 * f64::EPSILON * (a[1].abs() + b[1].abs()) + f64::MIN_POSITIVE;
        let (low, high) = (height(left).min(height(right)), height(left).max(height(right)));
        // NaN compares as false, and leaves the whole range.
        [
            if low - error > bottom && low.is_finite() { low - error } else { bottom },
            if high + error < top && high.is_finite() { high + error } else { top },
        ]
    }
}

#[cfg(test)]
mod tests;
