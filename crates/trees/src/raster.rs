//! Trees and rasters, each from the other.
//!
//! **Cost.** O(n + cells).
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a raster coarser than the tree | refused | `a_raster_too_coarse_is_refused` |
//! | a picture that is no square, or not 2^m wide | white beyond its right and upper sides | `pictures_of_any_size_are_filled_up` |

mod pbm;

use crate::{Cell, CodeFault, Colour, OrthTree};

#[cfg(test)]
mod tests;

/// Rasters have at most `2^RASTER_BITS_MAX` cells.
pub const RASTER_BITS_MAX: usize = 28;

/// The cells of one level, each inside or not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Raster<const N: usize> {
    depth: u8,
    /// Axis 0 runs fastest.
    inside: Vec<bool>,
}

impl<const N: usize> Raster<N> {
    /// The raster of `2^depth` cells along each axis.
    ///
    /// ```
    /// use delone_trees::{OrthTree, Raster};
    ///
    /// let below = Raster::new(3, |[x, y]| y < x)?;
    /// let tree = OrthTree::from_raster(&below);
    /// assert_eq!(tree.to_raster(3)?, below);
    /// assert_eq!(tree.volume(3), Some(28));
    /// # Ok::<(), delone_trees::CodeFault>(())
    /// ```
    ///
    /// # Errors
    /// If there would be more than `2^RASTER_BITS_MAX` cells.
    pub fn new(depth: u8, inside: impl Fn([u32; N]) -> bool) -> Result<Self, CodeFault> {
        let mut raster = Self::white(depth)?;
        for at in 0..raster.inside.len() {
            raster.inside[at] = inside(raster.anchor(at));
        }
        Ok(raster)
    }

    fn white(depth: u8) -> Result<Self, CodeFault> {
        let bits = N * usize::from(depth);
        if bits > RASTER_BITS_MAX {
            return Err(CodeFault::Raster { depth });
        }
        Ok(Self { depth, inside: vec![false; 1 << bits] })
    }

    /// The level of the cells.
    #[must_use]
    pub fn depth(&self) -> u8 {
        self.depth
    }

    /// The cells, axis 0 fastest.
    #[must_use]
    pub fn cells(&self) -> &[bool] {
        &self.inside
    }

    /// The places of the cells that are inside.
    pub fn black(&self) -> impl Iterator<Item = [u32; N]> + Clone + '_ {
        let inside = self.inside.iter().enumerate().filter(|(_, inside)| **inside);
        inside.map(|(at, _)| self.anchor(at))
    }

    fn at(&self, anchor: [u32; N]) -> usize {
        anchor.iter().rev().fold(0, |at, &c| at << self.depth | c as usize)
    }

    fn anchor(&self, at: usize) -> [u32; N] {
        let place = |axis: usize| at >> (axis * usize::from(self.depth)) & ((1 << self.depth) - 1);
        std::array::from_fn(|axis| u32::try_from(place(axis)).expect("rasters are small"))
    }

    fn blacken(&mut self, cell: Cell<N>) {
        let (lower, side) = cell.scaled(self.depth);
        let side_bits = u32::from(self.depth - cell.level());
        for row in 0..1usize << (side_bits * (u32::try_from(N).expect("N is small") - 1)) {
            let mut anchor = lower;
            let mut rest = row;
            for place in &mut anchor[1..] {
                *place += u32::try_from(rest & ((1 << side_bits) - 1)).expect("rasters are small");
                rest >>= side_bits;
            }
            let from = self.at(anchor);
            self.inside[from..from + side as usize].fill(true);
        }
    }
}

impl<const N: usize> OrthTree<N> {
    /// The cells of a level, which is not above the smallest leaves.
    ///
    /// # Errors
    /// If a leaf is smaller, or the raster would be too large.
    pub fn to_raster(&self, depth: u8) -> Result<Raster<N>, CodeFault> {
        if depth < self.depth() {
            return Err(CodeFault::Raster { depth });
        }
        let mut raster = Raster::white(depth)?;
        self.black().for_each(|cell| raster.blacken(cell));
        Ok(raster)
    }

    /// The tree of a raster.
    #[must_use]
    pub fn from_raster(raster: &Raster<N>) -> Self {
        Self::grown(|cell| {
            if cell.level() < raster.depth {
                return Colour::Gray;
            }
            Colour::of(raster.inside[raster.at(cell.anchor())])
        })
    }
}
