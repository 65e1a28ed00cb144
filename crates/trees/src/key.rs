//! Morton's keys, and neighbours by arithmetic on them.
//!
//! **Paper.** \[Sch92\]: the bits of one coordinate are added in place, carries running over the bits of the others, which are
//! ones meanwhile.
//!
//! **In / Out.** The key of a cell; the key of a cell of the same level some steps away.
//!
//! **Cost.** O(1): a few operations on 128 bits for each axis.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | beyond the root | none | `keys_have_the_neighbours_of_their_cells` |

use crate::{Cell, DEPTH_MAX};

#[cfg(test)]
mod tests;

/// A cell by its level and the sons on the way to it, N bits each.
///
/// ```
/// use delone_trees::{Cell, Key};
///
/// let cell = Cell::<2>::new([3, 5], 3).ok_or("no such cell")?;
/// let key = Key::of(cell);
/// assert_eq!(key.digits(), 0b10_01_11); // up, right, both
/// assert_eq!(key.neighbour([1, -1]).map(Key::cell), cell.neighbour([1, -1]));
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Key<const N: usize> {
    /// The key of the cell's first part of the smallest level: keys are in order as nodes are depth first.
    start: u128,
    level: u8,
}

/// The bits of axis 0.
const fn first_axis(axes: usize) -> u128 {
    let mut bits = 0;
    let mut digit = 0;
    while digit < DEPTH_MAX as usize {
        bits |= 1 << (digit * axes);
        digit += 1;
    }
    bits
}

impl<const N: usize> Key<N> {
    const FIRST_AXIS: u128 = first_axis(N);

    /// The key of a cell.
    #[must_use]
    pub fn of(cell: Cell<N>) -> Self {
        Self { start: cell.key() << Self::below(cell.level()), level: cell.level() }
    }

    /// The cell.
    ///
    /// # Panics
    /// Never: a key without a cell would be a bug.
    #[must_use]
    pub fn cell(self) -> Cell<N> {
        Cell::of_key(self.level, self.digits()).expect("keys are made from cells")
    }

    /// The level.
    #[must_use]
    pub fn level(self) -> u8 {
        self.level
    }

    /// As [`Cell::key`].
    #[must_use]
    pub fn digits(self) -> u128 {
        self.start >> Self::below(self.level)
    }

    /// Bits of the levels below.
    fn below(level: u8) -> usize {
        N * usize::from(DEPTH_MAX - level)
    }

    /// The keys of the smallest level that are in the cell, from this one on, up to another one.
    pub(crate) fn span(self) -> [u128; 2] {
        [self.start, self.start + (1 << Self::below(self.level))]
    }

    /// The key of the cell of the same size so many steps away, if it is in the root. O(1).
    #[must_use]
    pub fn neighbour(self, steps: [i8; N]) -> Option<Self> {
        let mut start = self.start;
        let level = !((1u128 << Self::below(self.level)) - 1);
        for (axis, step) in steps.into_iter().enumerate() {
            let mask = (Self::FIRST_AXIS << axis) & level;
            let old = start & mask;
            if u64::from(step.unsigned_abs()) >= 1 << self.level && step != 0 {
                return None; // more steps than the root has cells
            }
            let far = spread::<N>(step.unsigned_abs()) << (Self::below(self.level) + axis);
            let new = if step < 0 {
                old.wrapping_sub(far) & mask
            } else {
                (old | !mask).wrapping_add(far) & mask
            };
            let is_around = if step < 0 { new > old } else { new < old };
            if is_around {
                return None;
            }
            start = (start & !mask) | new;
        }
        Some(Self { start, level: self.level })
    }
}

/// A number with N - 1 zeros between its bits.
fn spread<const N: usize>(number: u8) -> u128 {
    (0..8).fold(0, |spread, bit| spread | u128::from(number >> bit & 1) << (bit * N))
}
