//! The smallest case that still fails: fewer segments, fewer points, smaller numbers with fewer bits.
//!
//! **Paper.** \[ZH02\], delta debugging, over points and segments; then each number is replaced by simpler ones as long as
//! the case fails.
//! **In.** A case that fails; a test that says whether another one fails in the same way. **Out.** A case that fails.
//! **Invariants.** 1. The case kept fails. 2. Every step accepted is smaller in (points, segments, cost of numbers), so that
//! rounds end.
//! **Cost.** [`Effort`] bounds the tests; O(n log n) of them where failures are local, O(n^2) at worst.
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | the test fails nothing smaller | the case itself | `what_cannot_shrink_stays` |
//! | no points | itself | `nothing_shrinks_to_nothing` |
//! | effort runs out | the smallest so far | `effort_bounds_the_tests` |

use std::collections::BTreeMap;

use crate::case::Case;
use crate::id;

/// How many more tests may be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Tests left.
    pub tests: usize,
}

impl Default for Effort {
    fn default() -> Self {
        Self { tests: 5000 }
    }
}

/// The smallest case found, from `case` on, that `fails`.
pub fn shrink<const D: usize>(
    case: &Case<D>,
    effort: &mut Effort,
    fails: impl FnMut(&Case<D>) -> bool,
) -> Case<D> {
    let mut search = Search { best: case.clone(), effort, fails };
    while search.effort.tests > 0 {
        let before = size(&search.best);
        search.drop_segments();
        search.drop_points();
        search.merge_points();
        search.simplify_together();
        search.simplify_numbers();
        if size(&search.best) == before {
            break;
        }
    }
    search.best
}

/// What becomes smaller. Inv 2.
fn size<const D: usize>(case: &Case<D>) -> (usize, usize, u64) {
    let cost = case.points.as_flattened().iter().map(|&x| cost(x)).sum();
    (case.points.len(), case.segments.len(), cost)
}

/// How hard a number is to read: significant bits, how far its scale is from 1, and its sign.
fn cost(x: f64) -> u64 {
    if x == 0.0 {
        return u64::from(x.is_sign_negative());
    }
    let bits = x.abs().to_bits();
    let mantissa = (bits & ((1 << 52) - 1)) | u64::from(bits >> 52 != 0) << 52;
    let significant = 64 - mantissa.leading_zeros() - mantissa.trailing_zeros();
    let exponent = (bits >> 52).max(1).cast_signed() - 1075 + i64::from(mantissa.trailing_zeros());
    let scale = if (0..10).contains(&exponent) { 0 } else { 20 + exponent.unsigned_abs() / 8 };
    let magnitude = u64::from(64 - (bits >> 52).abs_diff(1023).leading_zeros());
    u64::from(significant) * 8 + scale * 4 + magnitude * 2 + u64::from(x < 0.0)
}

struct Search<'e, const D: usize, F> {
    best: Case<D>,
    effort: &'e mut Effort,
    fails: F,
}

impl<const D: usize, F: FnMut(&Case<D>) -> bool> Search<'_, D, F> {
    /// Keeps `candidate` if it is smaller and fails. Inv 1, 2.
    fn offer(&mut self, candidate: Case<D>) -> bool {
        if self.effort.tests == 0 || size(&candidate) >= size(&self.best) {
            return false;
        }
        self.effort.tests -= 1;
        let fails = (self.fails)(&candidate);
        if fails {
            self.best = candidate;
        }
        fails
    }

    fn drop_segments(&mut self) {
        drop_runs(self.best.segments.len(), |start, end| {
            let mut fewer = self.best.clone();
            fewer.segments.drain(start..end);
            self.offer(fewer)
        });
    }

    fn drop_points(&mut self) {
        drop_runs(self.best.points.len(), |start, end| {
            self.offer(without_points(&self.best, start, end))
        });
    }

    /// Lets one point's segments end at another instead, and takes it out.
    fn merge_points(&mut self) {
        let mut gone = 0;
        while gone < self.best.points.len() && !self.best.segments.is_empty() {
            let merged = (0..self.best.points.len()).filter(|&kept| kept != gone).any(|kept| {
                let mut image = self.best.clone();
                for v in image.segments.as_flattened_mut().iter_mut().filter(|v| **v == id(gone)) {
                    *v = id(kept);
                }
                self.offer(without_points(&image, gone, gone + 1))
            });
            gone += usize::from(!merged);
        }
    }

    /// Simpler numbers for all coordinates at once: ranks in place of values, everything moved or scaled towards 1.
    fn simplify_together(&mut self) {
        let ranks: [BTreeMap<u64, f64>; D] = std::array::from_fn(|axis| ranked(&self.best, axis));
        self.offer_map(|axis, x| ranks[axis][&(x + 0.0).to_bits()]);
        let shared: BTreeMap<u64, f64> = shared_ranks(&self.best);
        self.offer_map(|_, x| shared[&(x + 0.0).to_bits()]);
        let first = self.best.points.first().copied().unwrap_or([0.0; D]);
        self.offer_map(|axis, x| x - first[axis]);
        for k in [-512, -64, -8, -1, 512, 64, 8, 1] {
            while self.offer_map(|_, x| x * crate::exact::power_of_two(k)) {}
        }
        self.offer_map(|_, x| x.round());
        self.offer_map(|_, x| x.abs());
    }

    fn offer_map(&mut self, map: impl Fn(usize, f64) -> f64) -> bool {
        let mut image = self.best.clone();
        for point in &mut image.points {
            *point = std::array::from_fn(|axis| map(axis, point[axis]));
        }
        let is_finite = image.points.as_flattened().iter().all(|x| x.is_finite());
        is_finite && self.offer(image)
    }

    /// Each number on its own; equal numbers of one axis together first, so that what is in line stays so.
    fn simplify_numbers(&mut self) {
        for axis in 0..D {
            for point in 0..self.best.points.len() {
                let x = self.best.points[point][axis];
                for simpler in simpler(x) {
                    let together =
                        |at: usize, y: f64| if at == axis && y == x { simpler } else { y };
                    let mut alone = self.best.clone();
                    alone.points[point][axis] = simpler;
                    if self.offer_map(together) || self.offer(alone) {
                        break;
                    }
                }
            }
        }
    }
}

/// Takes runs of halving length out of so many things until none can go. [ZH02]
pub(crate) fn drop_runs(mut length: usize, mut drop: impl FnMut(usize, usize) -> bool) {
    let mut run = length.div_ceil(2);
    while run > 0 {
        let mut start = 0;
        while start < length {
            let end = (start + run).min(length);
            if drop(start, end) {
                length -= end - start;
            } else {
                start = end;
            }
        }
        run = if run == 1 { 0 } else { run.div_ceil(2) };
    }
}

/// The case without the points of a range, and without their segments.
fn without_points<const D: usize>(case: &Case<D>, start: usize, end: usize) -> Case<D> {
    let gone = id(start)..id(end);
    let mut fewer = case.clone();
    fewer.points.drain(start..end);
    fewer.segments.retain(|ends| !ends.iter().any(|v| gone.contains(v)));
    for v in fewer.segments.as_flattened_mut() {
        *v -= if *v >= gone.end { gone.end - gone.start } else { 0 };
    }
    fewer
}

/// The values along one axis, by bits, and their ranks as doubles.
fn ranked<const D: usize>(case: &Case<D>, axis: usize) -> BTreeMap<u64, f64> {
    ranks(case.points.iter().map(|point| point[axis]))
}

/// The same for all axes together.
fn shared_ranks<const D: usize>(case: &Case<D>) -> BTreeMap<u64, f64> {
    ranks(case.points.as_flattened().iter().copied())
}

fn ranks(values: impl Iterator<Item = f64>) -> BTreeMap<u64, f64> {
    let mut values: Vec<f64> = values.map(|x| x + 0.0).collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values.iter().map(|x| x.to_bits()).zip((0u32..).map(f64::from)).collect()
}

/// Numbers to try in place of one, simplest first.
fn simpler(x: f64) -> Vec<f64> {
    let mut all = vec![0.0, 1.0, -1.0, 2.0, x.abs(), x.round(), x.trunc()];
    // Half the bits, a quarter less, and so on: rounding towards zero.
    for kept in [0, 4, 8, 16, 26, 39, 46, 50, 51] {
        all.push(f64::from_bits(x.to_bits() & (u64::MAX << (52 - kept))));
    }
    all.extend([x / 2.0, x - 1.0, x + 1.0]);
    all.retain(|y| y.is_finite() && cost(*y) < cost(x));
    all
}

#[cfg(test)]
mod tests;
