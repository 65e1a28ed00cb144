//! Volume, surface, Euler number and components of what is black.
//!
//! **Paper.** \[Gra71\] for the Euler number from the 2^N cells around each vertex, here for any N: a face of dimension k gives each
//! of its 2^k vertices an equal share of its (-1)^k. Shares cancel where the pattern around the vertex is constant along an axis,
//! and all other vertices are corners of leaves. \[Sam81\] for components through leaves and their neighbours of at least their size.
//!
//! **In / Out.** A tree; numbers in units of the cells of a level that the caller chooses, all exact.
//!
//! **Cost.** Volume O(n); surface and components O(n 2^N depth), with N replaced by 3^N for [`Joined::AtCorners`]; Euler number O(n 4^N depth).
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | cells that meet in corners only | one component or two, as asked; the Euler number agrees | `cells_at_a_corner_are_joined_as_asked` |
//! | black at the root's border | what is beyond is white | `all_black_is_a_ball` |

mod components;
mod euler;

use crate::orth::Index;
use crate::{Cell, Colour, OrthTree};
pub use components::Components;

#[cfg(test)]
mod tests;

/// When black cells are one piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joined {
    /// Through facets only: the open set. 4 neighbours in the plane, 6 in space.
    ByFacets,
    /// Also in lower faces: the closed set. 8 neighbours in the plane, 26 in space.
    AtCorners,
}

impl Joined {
    /// The steps to the neighbours of a cell.
    #[must_use]
    pub fn steps<const N: usize>(self) -> Vec<[i8; N]> {
        match self {
            Self::ByFacets => facet_steps().collect(),
            Self::AtCorners => all_steps().collect(),
        }
    }
}

impl<const N: usize> OrthTree<N> {
    /// The black leaves' volume (in the plane: area) in cells of a level, none if a black leaf is smaller or the level is too deep.
    #[must_use]
    pub fn volume(&self, depth: u8) -> Option<u128> {
        let cells = |cell: Cell<N>| Some(1u128 << (N * levels_below(cell, depth)?));
        self.black().map(cells).sum()
    }

    /// How much border (in the plane: perimeter) is between black and white, in facets of cells of a level; none as for the
    /// volume. Beyond the root is white.
    #[must_use]
    pub fn surface(&self, depth: u8) -> Option<u128> {
        let index = Index::new(self);
        let mut surface = 0;
        for (cell, colour) in self.cells().filter(|&(_, colour)| colour != Colour::Gray) {
            let facet = 1u128 << ((N - 1) * levels_below(cell, depth)?);
            for steps in facet_steps::<N>() {
                // The facet is the smaller one's; of equal leaves, the black one's.
                let differs = match cell.neighbour(steps).map(|beyond| index.find(beyond)) {
                    None => colour == Colour::Black,
                    Some(found) if found.level < cell.level() => {
                        found.colour == colour.complement()
                    }
                    Some(found) => colour == Colour::Black && found.colour == Colour::White,
                };
                surface += if differs { facet } else { 0 };
            }
        }
        Some(surface)
    }
}

fn levels_below<const N: usize>(cell: Cell<N>, depth: u8) -> Option<usize> {
    (depth <= crate::DEPTH_MAX).then_some(())?;
    depth.checked_sub(cell.level()).map(usize::from)
}

/// The steps over facets.
fn facet_steps<const N: usize>() -> impl Iterator<Item = [i8; N]> + Clone {
    (0..2 * N).map(|i| {
        std::array::from_fn(|axis| {
            if axis != i / 2 {
                0
            } else if i % 2 == 0 {
                -1
            } else {
                1
            }
        })
    })
}

/// The steps to all neighbours.
fn all_steps<const N: usize>() -> impl Iterator<Item = [i8; N]> + Clone {
    let places = 3usize.pow(u32::try_from(N).expect("N is small"));
    let step = |i: usize, axis: u32| [-1, 0, 1][i / 3usize.pow(axis) % 3];
    let steps = (0..places).map(move |i| {
        let mut axis = 0..;
        [0; N].map(|_: i8| step(i, axis.next().expect("axes go on")))
    });
    steps.filter(|steps| *steps != [0; N])
}
