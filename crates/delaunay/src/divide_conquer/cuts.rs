//! Where the sites are cut: the order in which they are laid out, and the axis of each cut.
//!
//! **Paper.** [Dwy87]: blocks are cut in halves, across x and y by turns. **In.** Sites in lexicographic order. **Out.** Their
//! order, such that each block of the recursion is a range of it.
//! **Invariants.** 1. A cut is by a total order that sees a slightly tilted line: (x, y), or (y, -x), the first turned by
//! a quarter. 2. Each block is in lexicographic order, before its cut and after: so a cut across x is in the middle, and
//! the order of all is a function of the points alone.
//! **Cost.** O(n log n): for each site a selection and a stable partition at every other level. The sites are integers here: their
//! rank, and a number that orders like y.

use std::cmp::Ordering;

use delone_predicates::{Id, Kernel};
use delone_sites::{Sites, sortable};
use rayon::prelude::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

/// Blocks of this many sites and fewer are not cut.
pub(super) const LEAF: usize = 3;

/// Blocks of more sites than this are worth a thread.
pub(super) const THREAD: usize = 1 << 13;

/// More sites than this are worth a pool of threads, which takes as long to start as a thousand sites.
pub(super) const POOL: usize = 1 << 15;

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
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
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

/// Puts items, which are in lexicographic order, into that of the cuts. The first cut is across x.
pub(super) fn cut(items: &mut [Item]) {
    let mut scratch = items.to_vec();
    halve(items, &mut scratch, Axis::X);
}

/// [`cut`] on the threads there are. The halves of the first cut are where they are: each finds space to work in for itself.
pub(super) fn cut_in_parallel(items: &mut [Item]) {
    let (left, right) = items.split_at_mut(items.len() / 2);
    let cut = |half: &mut [Item]| halve_in_parallel(half, &mut half.to_vec(), Axis::Y);
    rayon::join(|| cut(left), || cut(right));
}

/// Cuts a block, given as much space to work in.
fn halve(items: &mut [Item], scratch: &mut [Item], axis: Axis) {
    if items.len() <= LEAF {
        return;
    }
    let [(left, left_scratch), (right, right_scratch)] = parted(items, scratch, axis);
    halve(left, left_scratch, axis.other());
    halve(right, right_scratch, axis.other());
}

fn halve_in_parallel(items: &mut [Item], scratch: &mut [Item], axis: Axis) {
    if items.len() <= THREAD {
        return halve(items, scratch, axis);
    }
    let [(left, left_scratch), (right, right_scratch)] = parted(items, scratch, axis);
    rayon::join(
        || halve_in_parallel(left, left_scratch, axis.other()),
        || halve_in_parallel(right, right_scratch, axis.other()),
    );
}

/// A block, and as much space to work in.
type Block<'a> = (&'a mut [Item], &'a mut [Item]);

/// Brings the lower half along the axis to the front, and parts the two.
fn parted<'a>(items: &'a mut [Item], scratch: &'a mut [Item], axis: Axis) -> [Block<'a>; 2] {
    let middle = items.len() / 2;
    if axis == Axis::Y {
        scratch.copy_from_slice(items);
        let (_, &mut bound, _) = scratch.select_nth_unstable(middle);
        partition(items, scratch, bound);
    }
    let (left, right) = items.split_at_mut(middle);
    let (left_scratch, right_scratch) = scratch.split_at_mut(middle);
    [(left, left_scratch), (right, right_scratch)]
}

/// Brings the items below `bound` to the front; either part stays in its order. (Inv 2)
///
/// Each item is written to both places, and a length says which counts: half of the answers would be guessed wrong.
fn partition(items: &mut [Item], scratch: &mut [Item], bound: Item) {
    let (mut below, mut others) = (0, 0);
    for i in 0..items.len() {
        let item = items[i];
        items[below] = item; // not after i
        scratch[others] = item;
        let is_below = item < bound;
        below += usize::from(is_below);
        others += usize::from(!is_below);
    }
    items[below..].copy_from_slice(&scratch[..others]);
}
