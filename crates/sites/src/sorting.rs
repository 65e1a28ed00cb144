//! Points in lexicographic order.
//!
//! Coordinates are first thrown into buckets of equal width, what is in a bucket into smaller ones if it is much, and the rest is
//! sorted by comparison: few comparisons where coordinates are evenly spread, and no more than a sort of all makes where they are
//! not. A thread fills some buckets in a row, as much of the whole as the others do: it looks at all coordinates, and leaves those
//! that are not its own.
//!
//! **Invariant.** The bucket never falls as the coordinate rises: each of the roundings on the way is monotone.

use std::ops::Range;

use rayon::prelude::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use crate::order::{low_half, sortable};

/// Fewer items than this are sorted as they are.
const FEW: usize = 64;

/// As many items are worth buckets of their own.
const MANY: usize = 48;

/// So many places are written to by turns without waiting for memory.
const BUCKETS_MAX: usize = 1024;

/// As many items are worth a thread.
const THREAD: usize = 1 << 13;

/// The values of a function below `count`, in `parts` at a time.
pub(crate) fn collected<T: Send>(
    count: usize,
    parts: usize,
    value: impl Fn(usize) -> T + Sync + Send,
) -> Vec<T> {
    if parts == 1 {
        return (0..count).map(value).collect();
    }
    (0..count).into_par_iter().with_min_len(THREAD).map(value).collect()
}

/// What becomes of each task, all at a time; on this thread if there is one.
fn each<T: Send, R: Send>(tasks: Vec<T>, run: impl Fn(T) -> R + Sync + Send) -> Vec<R> {
    if tasks.len() == 1 {
        return tasks.into_iter().map(run).collect();
    }
    tasks.into_par_iter().map(run).collect()
}

/// Equal parts of the numbers below `count`.
fn ranges(count: usize, parts: usize) -> Vec<Range<usize>> {
    (0..parts).map(|part| count * part / parts..count * (part + 1) / parts).collect()
}

/// Whether all coordinates are finite; in `parts` at a time.
pub(crate) fn are_finite<const D: usize>(points: &[[f64; D]], parts: usize) -> bool {
    let finite = |range: Range<usize>| {
        points[range].as_flattened().iter().fold(true, |all, x| all & x.is_finite())
    };
    each(ranges(points.len(), parts), finite).into_iter().all(|finite| finite)
}

/// The indices of the points in lexicographic order, equal ones by index, each below some number; and whether no two are equal. In
/// `parts` at a time.
pub(crate) fn sorted<const D: usize>(points: &[[f64; D]], parts: usize) -> (Vec<u128>, bool) {
    if D == 0 || points.len() < FEW {
        let mut items: Vec<u128> = (0..points.len()).map(|i| u128::from(id(i))).collect();
        let distinct = sort_along(0, points, &mut items);
        return (items, distinct);
    }
    let mut items = vec![0; points.len()];
    let distinct = sort_in_buckets(Axis { axis: 0, points, of: id }, parts, &mut items);
    (items, distinct)
}

/// An index of fewer than 2^32 points.
#[expect(clippy::cast_possible_truncation, reason = "there are no more points than ids")]
#[inline(always)]
pub(crate) fn id(index: usize) -> u32 {
    index as u32
}

/// Sorts points that agree on the axes before `axis`, given by index, by those from it on; equal ones by index. Whether
/// no two are equal. The items carry a coordinate in their upper part, as a number that orders like it.
fn sort_along<const D: usize>(axis: usize, points: &[[f64; D]], items: &mut [u128]) -> bool {
    if axis == D {
        return items.len() < 2; // what is left is in order of index
    }
    if items.len() < FEW {
        let coordinate = |item: u128| points[low_half(item) as usize][axis];
        items.iter_mut().for_each(|item| *item = keyed(low_half(*item), coordinate(*item)));
        items.sort_unstable();
        return sort_ties(axis, points, items);
    }
    let indices: Vec<u32> = items.iter().map(|&item| low_half(item)).collect();
    sort_in_buckets(Axis { axis, points, of: |place| indices[place] }, 1, items)
}

/// Sorts the runs of points that agree on an axis, by the axes behind it. Whether no two are equal.
fn sort_ties<const D: usize>(axis: usize, points: &[[f64; D]], items: &mut [u128]) -> bool {
    let runs = items.chunk_by_mut(|a, b| *a >> 32 == *b >> 32).filter(|run| run.len() > 1);
    runs.fold(true, |distinct, run| distinct & sort_along(axis + 1, points, run))
}

/// Sorts items: many are thrown into buckets by the upper bits in which they differ, for close doubles are spread in these as they
/// are in size.
#[expect(clippy::cast_possible_truncation, reason = "a key is of 64 bits, and buckets are few")]
fn sort_by_bits(items: &mut [u128]) {
    if items.is_sorted() {
        return; // of equal coordinates, as on grids
    }
    if items.len() < MANY {
        return items.sort_unstable();
    }
    let key = |item: u128| (item >> 32) as u64;
    let none = (u64::MAX, 0);
    let (low, high) =
        items.iter().fold(none, |(low, high), &item| (low.min(key(item)), high.max(key(item))));
    let buckets = items.len().min(BUCKETS_MAX).next_power_of_two();
    let shift = (u64::BITS - (high - low).leading_zeros()).saturating_sub(buckets.ilog2());
    let bucket = |item: u128| ((key(item) - low) >> shift) as usize;
    let mut places = vec![0u32; buckets + 1];
    items.iter().for_each(|&item| places[bucket(item) + 1] += 1);
    for bucket in 0..buckets {
        places[bucket + 1] += places[bucket];
    }
    let unsorted = items.to_vec();
    for item in unsorted {
        let place = &mut places[bucket(item)];
        items[*place as usize] = item;
        *place += 1;
    }
    let mut first = 0;
    for &end in &places[..buckets] {
        let bucket = &mut items[first..end as usize];
        if bucket.len() > 1 {
            bucket.sort_unstable();
        }
        first = end as usize;
    }
}

/// An index, and above it a number that orders like its coordinate.
#[inline(always)]
fn keyed(index: u32, coordinate: f64) -> u128 {
    u128::from(sortable(coordinate)) << 32 | u128::from(index)
}

/// An axis, and points: those of the indices that a function gives, by place.
struct Axis<'a, const D: usize, F> {
    axis: usize,
    points: &'a [[f64; D]],
    of: F,
}

impl<const D: usize, F: Fn(usize) -> u32 + Sync> Axis<'_, D, F> {
    #[inline(always)]
    fn coordinate(&self, place: usize) -> f64 {
        self.points[(self.of)(place) as usize][self.axis]
    }

    /// Puts the points of the buckets in `range`, of which the places are `starts`, into order. Whether no two are equal.
    fn fill(
        &self,
        buckets: &Buckets,
        count: usize,
        range: Range<usize>,
        starts: &[usize],
        items: &mut [u128],
    ) -> bool {
        let mut places: Vec<usize> = starts.iter().map(|start| start - starts[0]).collect();
        for place in 0..count {
            let (index, coordinate) = ((self.of)(place), self.coordinate(place));
            let bucket = buckets.of_coordinate(coordinate).wrapping_sub(range.start);
            if bucket < range.len() {
                let place = &mut places[bucket];
                items[*place] = keyed(index, coordinate);
                *place += 1;
            }
        }
        let mut first = 0;
        for &end in &places[..range.len()] {
            sort_by_bits(&mut items[first..end]);
            first = end;
        }
        sort_ties(self.axis, self.points, items)
    }
}

/// Sorts points, in `parts` at a time, into as many items. Whether no two are equal.
fn sort_in_buckets<const D: usize, F: Fn(usize) -> u32 + Sync>(
    points: Axis<'_, D, F>,
    parts: usize,
    items: &mut [u128],
) -> bool {
    let count = items.len();
    let ends = |range: Range<usize>| ends(range.map(|place| points.coordinate(place)));
    let ends = each(ranges(count, parts), ends);
    let low = ends.iter().fold(f64::INFINITY, |low, ends| low.min(ends[0]));
    let high = ends.iter().fold(f64::NEG_INFINITY, |high, ends| high.max(ends[1]));
    let buckets = Buckets::between(low, high, count);
    let counts = each(ranges(count, parts), |range| {
        let mut counts = vec![0; buckets.count];
        range.for_each(|place| counts[buckets.of_coordinate(points.coordinate(place))] += 1);
        counts
    });
    let mut starts = vec![0; buckets.count + 1];
    for bucket in 0..buckets.count {
        let here: usize = counts.iter().map(|counts| counts[bucket]).sum();
        starts[bucket + 1] = starts[bucket] + here;
    }
    let tasks = shared(&starts, parts, items);
    let distinct = each(tasks, |(range, items)| {
        points.fill(&buckets, count, range.clone(), &starts[range.start..=range.end], items)
    });
    distinct.into_iter().all(|distinct| distinct)
}

/// Buckets in a row, and the items for what is in them: about as many for each.
fn shared<'a>(
    starts: &[usize],
    parts: usize,
    mut items: &'a mut [u128],
) -> Vec<(Range<usize>, &'a mut [u128])> {
    let count = items.len();
    let mut first = 0;
    let mut tasks = Vec::with_capacity(parts);
    for part in 1..=parts {
        let goal = count * part / parts;
        let end = starts.partition_point(|&start| start < goal).max(first);
        let (own, others) = items.split_at_mut(starts[end] - starts[first]);
        tasks.push((first..end, own));
        (first, items) = (end, others);
    }
    tasks
}

/// The least and the greatest.
fn ends(coordinates: impl Iterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    coordinates.fold(none, |[low, high], x| [low.min(x), high.max(x)])
}

/// Buckets of equal width.
struct Buckets {
    count: usize,
    low: f64,
    per_unit: f64,
}

impl Buckets {
    /// For so many coordinates, between `low` and `high`.
    fn between(low: f64, high: f64, count: usize) -> Self {
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
