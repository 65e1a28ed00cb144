//! Cells of the root cube, cut in halves along every axis, again and again.

/// The smallest cells' level: coordinates are `u32`, volumes of four axes `u128`.
pub const DEPTH_MAX: u8 = 31;

/// A cell: its place among the `2^level` cells that each axis is cut into.
///
/// ```
/// use delone_trees::Cell;
///
/// let cell = Cell::<2>::ROOT.son(1).son(2); // to the right, then to the top
/// assert_eq!((cell.level(), cell.anchor()), (2, [2, 1]));
/// assert_eq!(cell.key(), 0b01_10);
/// assert_eq!(cell.neighbour([1, -1]).map(|c| c.anchor()), Some([3, 0]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cell<const N: usize> {
    anchor: [u32; N],
    level: u8,
}

impl<const N: usize> Cell<N> {
    /// All of the cube.
    pub const ROOT: Self = Self { anchor: [0; N], level: 0 };

    /// The cell at a place of a level, if there is one.
    #[must_use]
    pub fn new(anchor: [u32; N], level: u8) -> Option<Self> {
        let exists = level <= DEPTH_MAX && anchor.iter().all(|&c| c < 1 << level);
        exists.then_some(Self { anchor, level })
    }

    /// How often the root was cut.
    #[must_use]
    pub fn level(self) -> u8 {
        self.level
    }

    /// The place on each axis, in cells of this size.
    #[must_use]
    pub fn anchor(self) -> [u32; N] {
        self.anchor
    }

    /// The son on the upper side of the axes whose bits are set: Morton's order.
    ///
    /// # Panics
    /// If the cell is one of the smallest, or has no such son.
    #[must_use]
    pub fn son(self, which: usize) -> Self {
        assert!(self.level < DEPTH_MAX && which < 1 << N, "cell {self:?} has no son {which}");
        let upper = |axis: usize| u32::from((which >> axis) & 1 == 1);
        let anchor = std::array::from_fn(|axis| 2 * self.anchor[axis] + upper(axis));
        Self { anchor, level: self.level + 1 }
    }

    /// Which son of its ancestor at `level` (smaller than its own) this is in.
    pub(crate) fn branch(self, level: u8) -> usize {
        let shift = self.level - level - 1;
        (0..N).map(|axis| ((self.anchor[axis] >> shift & 1) as usize) << axis).sum()
    }

    /// Morton's key: the sons on the way from the root, N bits each.
    #[must_use]
    pub fn key(self) -> u128 {
        (0..self.level).fold(0, |key, level| key << N | self.branch(level) as u128)
    }

    /// The cell of a level with this key, if there is one.
    #[must_use]
    pub fn of_key(level: u8, key: u128) -> Option<Self> {
        if level > DEPTH_MAX || key >> (N * usize::from(level)) != 0 {
            return None;
        }
        Some((0..level).rev().fold(Self::ROOT, |above, level| above.son(digit::<N>(key, level))))
    }

    /// The cell of the same size so many steps away, if it is in the cube. O(1).
    #[must_use]
    pub fn neighbour(self, steps: [i8; N]) -> Option<Self> {
        let mut anchor = self.anchor;
        for (place, step) in anchor.iter_mut().zip(steps) {
            *place = place.checked_add_signed(i32::from(step))?;
        }
        Self::new(anchor, self.level)
    }

    /// The lower corner and the side, in cells of a deeper level.
    pub(crate) fn scaled(self, depth: u8) -> ([u32; N], u32) {
        let shift = depth - self.level;
        (self.anchor.map(|c| c << shift), 1 << shift)
    }

    /// Whether the other cell is this one or a part of it.
    pub(crate) fn holds(self, other: Self) -> bool {
        self.level <= other.level
            && self.anchor == other.anchor.map(|c| c >> (other.level - self.level))
    }
}

/// The son that a key names at so many levels above its last.
fn digit<const N: usize>(key: u128, level: u8) -> usize {
    let digit = key >> (N * usize::from(level)) & ((1 << N) - 1);
    usize::try_from(digit).expect("a digit is less than 2^N")
}
