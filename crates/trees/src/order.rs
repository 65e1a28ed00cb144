//! The orders in which a quadtree's sons can be written down, and the way between them.
//!
//! **Paper.** \[KE80\]: an expression means nothing without the order of its sons.
//!
//! **In / Out.** A tree, an order; the depth-first code with sons in that order, and back.
//!
//! **Cost.** O(n).
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | one leaf | the same in every order | `every_order_leads_back` |

use crate::codes::{colours_of, text_of};
use crate::writer::{checked, ends, son};
use crate::{CodeFault, Colour, DEPTH_MAX, OrthTree};

#[cfg(test)]
mod tests;

/// A quarter of a square, x to the right and y upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quadrant {
    /// Upper left.
    NorthWest,
    /// Upper right.
    NorthEast,
    /// Lower right.
    SouthEast,
    /// Lower left.
    SouthWest,
}

/// The order of the four sons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SonOrder {
    /// South-west, south-east, north-west, north-east.
    Morton,
    /// Clockwise from a quadrant.
    Clockwise(Quadrant),
    /// Along Hilbert's curve from the south-west to the south-east corner: one cell's neighbour follows it.
    Hilbert,
}

impl SonOrder {
    /// The sons, as numbered in Morton's order, and the state in which each is cut; the root's is 0.
    ///
    /// States of Hilbert's curve: bit 0, x and y are exchanged; bit 1, both run backwards.
    fn sons(self, state: usize) -> [(usize, usize); 4] {
        match self {
            Self::Morton => [(0, 0), (1, 0), (2, 0), (3, 0)],
            Self::Clockwise(start) => {
                let mut sons = [(2, 0), (3, 0), (1, 0), (0, 0)];
                sons.rotate_left(match start {
                    Quadrant::NorthWest => 0,
                    Quadrant::NorthEast => 1,
                    Quadrant::SouthEast => 2,
                    Quadrant::SouthWest => 3,
                });
                sons
            }
            Self::Hilbert => {
                let place = |quadrant: usize| {
                    let exchanged =
                        if state & 1 == 1 { quadrant >> 1 | (quadrant & 1) << 1 } else { quadrant };
                    if state & 2 == 2 { exchanged ^ 3 } else { exchanged }
                };
                [(place(0), state ^ 1), (place(2), state), (place(3), state), (place(1), state ^ 3)]
            }
        }
    }
}

impl OrthTree<2> {
    /// The depth-first code with sons in an order.
    #[must_use]
    pub fn colours_in(&self, order: SonOrder) -> Vec<Colour> {
        reordered(self.colours(), |state| order.sons(state))
    }

    /// The tree of a depth-first code with sons in an order.
    ///
    /// # Errors
    /// If the code ends early or late or is too deep.
    pub fn from_colours_in(order: SonOrder, colours: &[Colour]) -> Result<Self, CodeFault> {
        checked(colours, Self::ARITY, usize::from(DEPTH_MAX))?;
        Self::new(&reordered(colours, |state| inverse(order.sons(state))))
    }

    /// The depth-first expression with sons in an order.
    ///
    /// ```
    /// use delone_trees::{OrthTree, Quadrant, SonOrder};
    ///
    /// let tree = OrthTree::<2>::from_text("(BWW(WBWW")?; // south-west first
    /// let clockwise = SonOrder::Clockwise(Quadrant::NorthWest);
    /// assert_eq!(tree.to_text_in(clockwise), "(W(WWBWWB");
    /// assert_eq!(OrthTree::from_text_in(clockwise, "(W(WWBWWB")?, tree);
    /// # Ok::<(), delone_trees::CodeFault>(())
    /// ```
    #[must_use]
    pub fn to_text_in(&self, order: SonOrder) -> String {
        text_of(&self.colours_in(order))
    }

    /// The tree of a depth-first expression with sons in an order.
    ///
    /// # Errors
    /// At the first strange symbol, or if the expression is not one whole tree.
    pub fn from_text_in(order: SonOrder, text: &str) -> Result<Self, CodeFault> {
        Self::from_colours_in(order, &colours_of(text)?)
    }
}

/// A well-formed code whose sons are visited as the state says: which one, and its own state.
fn reordered(colours: &[Colour], sons: impl Fn(usize) -> [(usize, usize); 4]) -> Vec<Colour> {
    let ends = ends(colours, 4);
    let mut pending = vec![(0, 0)];
    let mut reordered = Vec::with_capacity(colours.len());
    while let Some((node, state)) = pending.pop() {
        reordered.push(colours[node]);
        if colours[node] == Colour::Gray {
            let next = sons(state).into_iter().rev();
            pending.extend(next.map(|(which, state)| (son(&ends, node, which), state)));
        }
    }
    reordered
}

/// For each son in Morton's order its place in the other, and its state.
fn inverse(sons: [(usize, usize); 4]) -> [(usize, usize); 4] {
    let mut inverse = [(0, 0); 4];
    for (place, (which, state)) in sons.into_iter().enumerate() {
        inverse[which] = (place, state);
    }
    inverse
}
