//! Points in lexicographic order.
//!
//! Coordinates are first thrown into buckets of equal width, and each bucket is sorted by comparison: few comparisons
//! where coordinates are evenly spread, and no more than a sort of all makes where they are not.
//!
//! **Invariant.** The bucket never falls as the coordinate rises: each of the roundings on the way is monotone.

use rayon::prelude::{
    IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator, ParallelSliceMut,
};

use crate::order::{low_half, sortable};

/// Fewer items than this are sorted as they are.
const FEW: usize = 64;

/// So many places are written to by turns without waiting for memory.
const BUCKETS_MAX: usize = 1024;

/// As many items are worth a thread.
const THREAD: usize = 1 << 13;

/// Sorts points that agree on the axes before `axis`, given by index, by those from it on; equal ones by index. Whether
/// no two are equal. The items carry the coordinate in their upper part, as a number that orders like it.
pub(crate) fn sort_along<const D: usize>(
    axis: usize,
    points: &[[f64; D]],
    items: &mut [u128],
) -> bool {
    if axis == D {
        return items.len() < 2; // what is left is in order of index
    }
    let coordinate = |item: u128| points[low_half(item) as usize][axis];
    if items.len() < FEW {
        items.iter_mut().for_each(|item| *item = keyed(*item, coordinate(*item)));
        items.sort_unstable();
    } else {
        sort_in_buckets(items, coordinate);
    }
    let mut distinct = true;
    for run in items.chunk_by_mut(|a, b| *a >> 32 == *b >> 32).filter(|run| run.len() > 1) {
        distinct &= sort_along(axis + 1, points, run);
    }
    distinct
}

/// [`sort_along`] the first axis, on the threads there are.
pub(crate) fn sort_in_parallel<const D: usize>(points: &[[f64; D]], items: &mut [u128]) -> bool {
    let key = |item: &mut u128| *item = keyed(*item, points[low_half(*item) as usize][0]);
    items.par_iter_mut().with_min_len(THREAD).for_each(key);
    items.par_sort_unstable();
    let runs = items.par_chunk_by_mut(|a, b| *a >> 32 == *b >> 32).filter(|run| run.len() > 1);
    runs.map(|run| sort_along(1, points, run)).reduce(|| true, |a, b| a & b)
}

/// An index, and above it a number that orders like its coordinate.
fn keyed(item: u128, coordinate: f64) -> u128 {
    u128::from(sortable(coordinate)) << 32 | u128::from(low_half(item))
}

fn sort_in_buckets(items: &mut [u128], coordinate: impl Fn(u128) -> f64) {
    let buckets = Buckets::of(items.len(), items.iter().map(|&item| coordinate(item)));
    // Where each bucket starts; while they are filled, where its next item goes.
    let mut places = vec![0u32; buckets.count + 1];
    for &item in &*items {
        places[buckets.of_coordinate(coordinate(item)) + 1] += 1;
    }
    for bucket in 0..buckets.count {
        places[bucket + 1] += places[bucket];
    }
    let mut sorted = vec![0; items.len()];
    for &item in &*items {
        let coordinate = coordinate(item);
        let place = &mut places[buckets.of_coordinate(coordinate)];
        sorted[*place as usize] = keyed(item, coordinate);
        *place += 1;
    }
    items.copy_from_slice(&sorted);
    let mut first = 0;
    for &end in &places[..buckets.count] {
        items[first..end as usize].sort_unstable();
        first = end as usize;
    }
}

/// Buckets of equal width.
struct Buckets {
    count: usize,
    low: f64,
    per_unit: f64,
}

impl Buckets {
    /// For so many coordinates.
    fn of(count: usize, coordinates: impl Iterator<Item = f64>) -> Self {
        let ends = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = coordinates.fold(ends, |(low, high), x| (low.min(x), high.max(x)));
        let count = (count / 4).min(BUCKETS_MAX);
        let per_unit = f64::from(u32::try_from(count).unwrap_or(u32::MAX)) / (high - low);
        Self { count, low, per_unit }
    }

    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "it is not negative, casts saturate, and no number becomes 0"
    )]
    fn of_coordinate(&self, coordinate: f64) -> usize {
        (((coordinate - self.low) * self.per_unit) as usize).min(self.count - 1)
    }
}
