//! PR trees: cells are cut until none holds more sites than it may.
//!
//! **Paper.** \[Sam84\]: point-region quadtrees; the tree depends on the sites alone, not on their order.
//!
//! **In / Out.** Sites, a frame, a capacity; leaves with the sites in them. A site on a side is in the upper cell, but on the
//! frame's own upper sides in the lower.
//!
//! **Cost.** O(n (depth + log n)).
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | more equal or nearly equal sites than the capacity | a leaf of the smallest cells holds them all | `crowds_are_told` |
//! | a site outside the frame, or no number | refused | `sites_outside_are_refused` |

use std::fmt;

use crate::buckets::{Buckets, id};
use crate::leaves::Leaves;
use crate::{Cell, Frame, Key};

#[cfg(test)]
mod tests;

/// The PR tree of sites.
///
/// ```
/// use delone_trees::{Frame, PrTree};
///
/// let sites = [[0.5, 0.5], [1.5, 0.5], [3.5, 3.5]];
/// let frame = Frame::around(&[[0.0, 0.0], [4.0, 4.0]], 8)?;
/// let tree = PrTree::new(&sites, &frame, 1)?;
/// assert_eq!(tree.leaves().len(), 7);
/// assert_eq!(tree.sites(1), [1]);
/// assert_eq!(tree.within(&sites, [1.0, 0.0], [4.0, 4.0]), [1, 2]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PrTree<const N: usize> {
    frame: Frame<N>,
    capacity: usize,
    leaves: Leaves<N>,
    sites: Buckets,
}

/// A site is not in the frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutsideFrame {
    /// The index of the site.
    pub site: usize,
}

impl fmt::Display for OutsideFrame {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "site {} is not in the frame: make a frame around all sites", self.site)
    }
}

impl std::error::Error for OutsideFrame {}

impl<const N: usize> PrTree<N> {
    /// The tree whose leaves hold at most `capacity` sites each, unless they are of the frame's smallest cells.
    ///
    /// # Errors
    /// At the first site that is not in the frame.
    pub fn new(
        sites: &[[f64; N]],
        frame: &Frame<N>,
        capacity: usize,
    ) -> Result<Self, OutsideFrame> {
        let mut sorted: Vec<(Key<N>, u32)> = Vec::with_capacity(sites.len());
        for (site, &point) in sites.iter().enumerate() {
            let cell = frame.cell_at(point).ok_or(OutsideFrame { site })?;
            sorted.push((Key::of(cell), id(site)));
        }
        sorted.sort_unstable();
        let ids: Vec<u32> = sorted.iter().map(|&(_, site)| site).collect();
        let (mut keys, mut black, mut buckets) = (Vec::new(), Vec::new(), Buckets::default());
        let mut next = 0;
        let mut pending = vec![Cell::ROOT];
        while let Some(cell) = pending.pop() {
            let key = Key::of(cell);
            let [_, end] = key.span();
            let count = sorted[next..].partition_point(|(site, _)| site.span()[0] < end);
            if count > capacity && cell.level() < frame.depth() {
                pending.extend((0..1 << N).rev().map(|son| cell.son(son)));
                continue;
            }
            keys.push(key);
            black.push(count > 0);
            buckets.push(&ids[next..next + count]);
            next += count;
        }
        Ok(Self { frame: *frame, capacity, leaves: Leaves::new(keys, black), sites: buckets })
    }

    /// The leaves; those with sites are black.
    #[must_use]
    pub fn leaves(&self) -> &Leaves<N> {
        &self.leaves
    }

    /// The sites in a leaf.
    ///
    /// # Panics
    /// If there are not as many leaves.
    #[must_use]
    pub fn sites(&self, leaf: usize) -> &[u32] {
        self.sites.of(leaf)
    }

    /// The leaves with more sites than they may have: those of the smallest cells.
    pub fn crowded(&self) -> impl Iterator<Item = usize> + Clone + '_ {
        (0..self.leaves.len()).filter(|&leaf| self.sites(leaf).len() > self.capacity)
    }

    /// The leaf that a point is in, if it is in the frame. O(depth + log n).
    #[must_use]
    pub fn leaf_at(&self, point: [f64; N]) -> Option<usize> {
        self.leaves.holder(self.frame.cell_at(point)?)
    }

    /// The sites in a closed box, in increasing order. The sites are those that the tree is of.
    ///
    /// # Panics
    /// If there are fewer sites than the tree has.
    #[must_use]
    pub fn within(&self, sites: &[[f64; N]], lower: [f64; N], upper: [f64; N]) -> Vec<u32> {
        let [low, high] = self.frame.corners(Cell::ROOT);
        let clamped =
            |p: [f64; N]| std::array::from_fn(|axis| p[axis].max(low[axis]).min(high[axis]));
        let corners = [lower, upper].map(|corner| self.frame.cell_at(clamped(corner)));
        let [Some(first), Some(last)] = corners else { return Vec::new() };
        let leaves = self.leaves.within(first.anchor(), last.anchor(), self.frame.depth());
        let is_in = |&site: &u32| {
            let point = sites[site as usize];
            (0..N).all(|axis| lower[axis] <= point[axis] && point[axis] <= upper[axis])
        };
        let mut found: Vec<u32> =
            leaves.into_iter().flat_map(|leaf| self.sites(leaf)).copied().filter(is_in).collect();
        found.sort_unstable();
        found
    }
}
