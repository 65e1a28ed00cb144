//! Where the sites are cut: the order in which they are laid out, and the axis of each cut.
//!
//! **Paper.** [Dwy87] cuts blocks in halves across their sites' x and y by turns. Here a block's first cuts, down to
//! [`CELL`] sites, are all across x and then all across y: one sort each instead of a median for each cut. The lines cut
//! a block into as many, as square cells either way. **In.** Sites numbered by lexicographic rank. **Out.** Their order,
//! such that each block of the recursion is a range of it.
//! **Invariants.** 1. A cut is by a total order that sees a slightly tilted line: (x, y), or (y, -x), the first turned by
//! a quarter. 2. The order is a function of the points alone: the halves are sets, and what is left is sorted.
//! **Cost.** O(n log n).

use std::cmp::Ordering;

use delone_predicates::{Id, Kernel};

/// Blocks of this many sites and fewer are cut by turns.
const CELL: usize = 64;

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
    /// Whether `u` comes before `v`, another vertex.
    #[inline]
    pub(super) fn precedes<V: Id>(self, kernel: &impl Kernel<2>, u: V, v: V) -> bool {
        let order = match self {
            Self::X => kernel.compare_lexicographic(u, v),
            Self::Y => kernel.compare(1, u, v).then_with(|| kernel.compare(0, v, u)),
        };
        order == Ordering::Less
    }
}

/// How a block is cut, and its parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Plan {
    across_x: u32,
    across_y: u32,
    turn: Axis,
}

impl Plan {
    /// The plan for a block of `count` sites in all.
    pub(super) fn new(count: usize) -> Self {
        let cuts = (count / CELL).checked_ilog2().map_or(0, |log| log + 1);
        Self { across_x: cuts.div_ceil(2), across_y: cuts / 2, turn: Axis::X }
    }

    /// The axis of the first cut.
    pub(super) const fn axis(self) -> Axis {
        if self.across_x > 0 {
            Axis::X
        } else if self.across_y > 0 {
            Axis::Y
        } else {
            self.turn
        }
    }

    /// The plan of both halves.
    pub(super) const fn halves(mut self) -> Self {
        if self.across_x > 0 {
            self.across_x -= 1;
        } else if self.across_y > 0 {
            self.across_y -= 1;
        } else {
            self.turn = match self.turn {
                Axis::X => Axis::Y,
                Axis::Y => Axis::X,
            };
        }
        self
    }

    /// The cuts to come across the axis of the first one.
    const fn run(self) -> u32 {
        if self.across_x > 0 {
            self.across_x
        } else if self.across_y > 0 {
            self.across_y
        } else {
            1
        }
    }
}

/// A rank as the kernel takes it.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Rank(u32);

impl From<Rank> for usize {
    #[inline(always)]
    fn from(rank: Rank) -> Self {
        rank.0 as Self
    }
}

/// Puts `ranks` into the order of the cuts. `sorted` says along which axis they are in order. `kernel`'s vertices are in
/// lexicographic order.
pub(super) fn cut<K: Kernel<2>>(kernel: &K, ranks: &mut [u32], plan: Plan, sorted: Option<Axis>) {
    if ranks.len() <= LEAF {
        ranks.sort_unstable(); // Inv 2
        return;
    }
    let sorted = arrange(kernel, ranks, plan, sorted);
    let (left, right) = ranks.split_at_mut(ranks.len() / 2);
    cut(kernel, left, plan.halves(), sorted);
    cut(kernel, right, plan.halves(), sorted);
}

/// The same on the threads there are.
pub(super) fn cut_in_parallel<K: Kernel<2> + Sync>(
    kernel: &K,
    ranks: &mut [u32],
    plan: Plan,
    sorted: Option<Axis>,
) {
    if ranks.len() <= THREAD {
        return cut(kernel, ranks, plan, sorted);
    }
    let sorted = arrange(kernel, ranks, plan, sorted);
    let (left, right) = ranks.split_at_mut(ranks.len() / 2);
    rayon::join(
        || cut_in_parallel(kernel, left, plan.halves(), sorted),
        || cut_in_parallel(kernel, right, plan.halves(), sorted),
    );
}

/// Brings the halves of the first cut to their sides; along which axis all are in order then.
fn arrange<K: Kernel<2>>(
    kernel: &K,
    ranks: &mut [u32],
    plan: Plan,
    sorted: Option<Axis>,
) -> Option<Axis> {
    let axis = plan.axis();
    if sorted == Some(axis) {
        return sorted;
    }
    let middle = ranks.len() / 2;
    let by_y = |u: &u32, v: &u32| kernel.compare(1, Rank(*u), Rank(*v)).then(v.cmp(u));
    match (plan.run(), axis) {
        (1, Axis::X) => drop(ranks.select_nth_unstable(middle)),
        (1, Axis::Y) => drop(ranks.select_nth_unstable_by(middle, by_y)),
        (_, Axis::X) => ranks.sort_unstable(),
        (_, Axis::Y) => ranks.sort_unstable_by(by_y),
    }
    (plan.run() > 1).then_some(axis)
}
