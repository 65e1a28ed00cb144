//! The definition, as an algorithm: every simplex whose circumball is empty, found by trying all.
//!
//! **In.** A kernel over a few vertices. **Out.** The cells, each sorted, in lexicographic order, as
//! [`crate::Delaunay::canonical`] gives them. **Cost.** O(n^(D+2)): for n up to 40 in the plane, 20 in space.
//! **Not** the judge's oracle, which shares nothing with the kernels (`delone-check`); this is the twin that runs under
//! any kernel.

use delone_predicates::{Kernel, Side, Sign};

/// All Delaunay cells of vertices 0 to `count - 1`, which must span R^D.
///
/// # Panics
/// If there are 2^32 vertices or more.
pub fn naive_delaunay<const D: usize>(kernel: &impl Kernel<D>, count: usize) -> Vec<u32> {
    let mut cells = Vec::new();
    let mut simplex: Vec<usize> = (0..=D).collect();
    while simplex.last().is_some_and(|&last| last < count) {
        if is_delaunay(kernel, &simplex, count) {
            cells.extend(simplex.iter().map(|&v| u32::try_from(v).expect("few vertices")));
        }
        next_subset(&mut simplex, count);
    }
    cells
}

fn is_delaunay<const D: usize>(kernel: &impl Kernel<D>, simplex: &[usize], count: usize) -> bool {
    let mut oriented = simplex.to_vec();
    match kernel.orient(&oriented) {
        Sign::Zero => return false,
        Sign::Negative => oriented.swap(0, 1),
        Sign::Positive => {}
    }
    let others = (0..count).filter(|v| !simplex.contains(v));
    others.into_iter().all(|q| kernel.in_sphere(&oriented, q) == Side::Negative)
}

/// The next subset of `0..count` of this size, in lexicographic order; past the last one its end is `count`.
fn next_subset(subset: &mut [usize], count: usize) {
    let size = subset.len();
    let Some(place) = (0..size).rev().find(|&i| subset[i] + size - i < count) else {
        subset[size - 1] = count;
        return;
    };
    let start = subset[place] + 1;
    for (offset, slot) in subset[place..].iter_mut().enumerate() {
        *slot = start + offset;
    }
}
