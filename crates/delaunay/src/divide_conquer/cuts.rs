//! Where the sites are cut: the order in which they are laid out, and the axis of each cut.
//!
//! **Paper.** [Dwy87]: blocks are cut in halves, across x and y by turns. **In.** Sites in lexicographic order. **Out.** Their
//! order, such that each block of the recursion is a range of it.
//! **Invariants.** 1. A cut is by a total order that sees a slightly tilted line: (x, y), or (y, -x), the first turned by
//! a quarter. 2. The order is a function of the points alone: the halves are sets, and what is left is sorted.
//! **Cost.** O(n log n). The sites are integers here: their rank, and a number that orders like y.

use std::cmp::Ordering;

use delone_predicates::{Id, Kernel};
use delone_sites::{Sites, sortable};
use rayon::prelude::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

/// Blocks of this many sites and fewer are not cut.
pub(super) const LEAF: usize = 3;

/// Blocks of more sites than this are worth a thread.
pub(super) const THREAD: usize = 1 << 13;

/// Which order a cut is across.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    /// By x, then y: the lexicographic order.
    X,
    /// By y, then -x.
    Y,
}

impl Axis {
    /// The order of two vertices.
    #[inline]
    pub(super) fn compare<V: Id>(self, kernel: &impl Kernel<2>, u: V, v: V) -> Ordering {
        match self {
            Self::X => kernel.compare_lexicographic(u, v),
            Self::Y => kernel.compare(1, u, v).then_with(|| kernel.compare(0, v, u)),
        }
    }

    /// How two blocks lie that are cut across it.
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::X => "side by side",
            Self::Y => "one above the other",
        }
    }

    /// The other one.
    pub(super) const fn other(self) -> Self {
        match self {
            Self::X => Self::Y,
            Self::Y => Self::X,
        }
    }
}

/// A site while it is cut: how high it is and, below, its lexicographic rank, turned round. So the order of numbers is
/// that across y.
#[derive(Clone, Copy, Debug)]
pub(super) struct Item(u128);

impl Item {
    /// Of a lexicographic rank, and a number that orders like y.
    fn new(rank: usize, y: u64) -> Self {
        let rank = u32::try_from(rank).expect("sites have ids of 32 bits");
        Self(u128::from(y) << 32 | u128::from(!rank))
    }

    fn of_site(sites: &Sites<2>, rank: usize, site: u32) -> Self {
        Self::new(rank, sortable(sites.points()[site as usize][1]))
    }

    #[expect(clippy::cast_possible_truncation, reason = "the lower half is the rank")]
    pub(super) const fn rank(self) -> u32 {
        !(self.0 as u32)
    }
}

/// The sites in lexicographic order, to be cut.
pub(super) fn items(sites: &Sites<2>) -> Vec<Item> {
    sites
        .sorted()
        .iter()
        .enumerate()
        .map(|(rank, &site)| Item::of_site(sites, rank, site))
        .collect()
}

/// The same for the vertices of any kernel, `sorted` lexicographically: for y stands the place in the order across y.
pub(super) fn items_by(kernel: &impl Kernel<2>, sorted: &[u32]) -> Vec<Item> {
    let vertex = |rank: usize| sorted[rank] as usize;
    let mut ranks: Vec<usize> = (0..sorted.len()).collect();
    ranks.sort_by(|&i, &j| Axis::Y.compare(kernel, vertex(i), vertex(j)));
    let mut items = vec![Item(0); sorted.len()];
    for (y, rank) in (0u64..).zip(ranks) {
        items[rank] = Item::new(rank, y);
    }
    items
}

/// [`items`] on the threads there are.
pub(super) fn items_in_parallel(sites: &Sites<2>) -> Vec<Item> {
    let ranked = sites.sorted().par_iter().with_min_len(THREAD).enumerate();
    ranked.map(|(rank, &site)| Item::of_site(sites, rank, site)).collect()
}

/// Puts items into the order of the cuts, of which the first is across the axis along which they are `sorted`.
pub(super) fn cut(items: &mut [Item], sorted: Axis) {
    let (left, right) = items.split_at_mut(items.len() / 2);
    halve(left, sorted.other());
    halve(right, sorted.other());
}

/// The same for items that are not sorted, the first cut being across `axis`.
fn halve(items: &mut [Item], axis: Axis) {
    if items.len() <= LEAF {
        items.sort_unstable_by_key(|item| item.rank()); // Inv 2
        return;
    }
    let (left, right) = select(items, axis);
    halve(left, axis.other());
    halve(right, axis.other());
}

/// [`cut`] on the threads there are.
pub(super) fn cut_in_parallel(items: &mut [Item], sorted: Axis) {
    let (left, right) = items.split_at_mut(items.len() / 2);
    rayon::join(
        || halve_in_parallel(left, sorted.other()),
        || halve_in_parallel(right, sorted.other()),
    );
}

fn halve_in_parallel(items: &mut [Item], axis: Axis) {
    if items.len() <= THREAD {
        return halve(items, axis);
    }
    let (left, right) = select(items, axis);
    rayon::join(
        || halve_in_parallel(left, axis.other()),
        || halve_in_parallel(right, axis.other()),
    );
}

/// Brings the lower half along the axis to the front, and parts the two.
fn select(items: &mut [Item], axis: Axis) -> (&mut [Item], &mut [Item]) {
    let middle = items.len() / 2;
    match axis {
        Axis::X => drop(items.select_nth_unstable_by_key(middle, |item| item.rank())),
        Axis::Y => drop(items.select_nth_unstable_by_key(middle, |item| item.0)),
    }
    items.split_at_mut(middle)
}
