//! The boundary of what is black in the plane, as polygons.
//!
//! **Paper.** \[DRS80\] the other way: from the tree to the chain around it.
//!
//! **In / Out.** A quadtree; rings of lattice points, black on the left: outer ones counter-clockwise, holes clockwise. No two sides in
//! succession have one direction.
//!
//! **Invariants.** 1. As many sides end at a lattice point as begin there, one or two. 2. At a point with two, rings turn to the left if
//! black cells are joined by sides only, so that they stay at their cell; to the right if at corners too.
//!
//! **Cost.** O(n log n) for n leaves.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | black cells that meet in a corner only | two rings or one, as asked | `cells_that_meet_in_a_corner_are_joined_as_asked` |
//! | black at the root's border | beyond is white | `rings_bound_what_is_black` |
//! | nothing black | no rings | `rings_bound_what_is_black` |

use delone_lar::Complex;

use crate::orth::Index;
use crate::{Cell, Colour, Frame, Joined, OrthTree};

#[cfg(test)]
mod tests;

/// A point of the lattice of smallest leaves.
type Place = [u32; 2];

/// The sides of a square, counter-clockwise: the step over it; whether it begins on the upper side, and ends there, on each axis.
const SIDES: [([i8; 2], Place, Place); 4] = [
    ([0, -1], [0, 0], [1, 0]),
    ([1, 0], [1, 0], [1, 1]),
    ([0, 1], [1, 1], [0, 1]),
    ([-1, 0], [0, 1], [0, 0]),
];

impl OrthTree<2> {
    /// The boundary of what is black: closed rings of lattice points, in cells of the level [`OrthTree::depth`], black on the left.
    ///
    /// ```
    /// use delone_trees::{Joined, OrthTree};
    ///
    /// let tree = OrthTree::<2>::from_text("(BBWW")?;
    /// assert_eq!(tree.boundary(Joined::ByFacets), [[[0, 0], [2, 0], [2, 1], [0, 1]]]);
    /// # Ok::<(), delone_trees::CodeFault>(())
    /// ```
    #[must_use]
    pub fn boundary(&self, joined: Joined) -> Vec<Vec<Place>> {
        let mut sides = self.sides();
        sides.sort_unstable();
        let mut used = vec![false; sides.len()];
        let mut rings = Vec::new();
        for first in 0..sides.len() {
            if used[first] {
                continue;
            }
            rings.push(without_straight(&ring_from(&sides, first, joined, &mut used)));
        }
        rings
    }

    /// The boundary as a complex (V, EV): a vertex for each corner of a ring, an edge for each side. Where rings meet in a corner, they
    /// have a vertex each.
    ///
    /// # Panics
    /// If the tree is deeper than the frame.
    #[must_use]
    pub fn boundary_complex(&self, frame: &Frame<2>, joined: Joined) -> Complex<2> {
        let depth = self.depth();
        assert!(depth <= frame.depth(), "the frame's cells are as small as the tree's");
        let scale = frame.depth() - depth;
        let (mut vertices, mut edges) = (Vec::new(), Vec::new());
        for ring in self.boundary(joined) {
            let id = |i: usize| u32::try_from(i).expect("a vertex index fits 32 bits");
            let first = vertices.len();
            let next = |i: usize| first + (i + 1) % ring.len();
            edges.extend((0..ring.len()).map(|i| [id(first + i), id(next(i))]));
            vertices.extend(ring.iter().map(|place| frame.lattice(place.map(|c| c << scale))));
        }
        let edges: Vec<&[u32]> = edges.iter().map(<[u32; 2]>::as_slice).collect();
        Complex::closure(vertices, &edges).expect("edges are between the vertices")
    }

    /// Pieces of boundary, black on the left: where they begin and end.
    fn sides(&self) -> Vec<(Place, Place)> {
        let (depth, index) = (self.depth(), Index::new(self));
        let mut sides = Vec::new();
        for (cell, colour) in self.cells().filter(|&(_, colour)| colour != Colour::Gray) {
            for (step, from, to) in SIDES {
                let beyond = cell.neighbour(step).map(|beyond| index.find(beyond));
                let is_black = colour == Colour::Black;
                // The smaller of two leaves tells; of equal ones, the black one.
                let tells = match beyond {
                    None => is_black,
                    Some(found) if found.level < cell.level() => {
                        found.colour == colour.complement()
                    }
                    Some(found) => is_black && found.colour == Colour::White,
                };
                if tells {
                    let ends = [from, to].map(|end| corner(cell, end, depth));
                    sides.push(if is_black { (ends[0], ends[1]) } else { (ends[1], ends[0]) });
                }
            }
        }
        sides
    }
}

fn corner(cell: Cell<2>, upper: Place, depth: u8) -> Place {
    let (lower, side) = cell.scaled(depth);
    std::array::from_fn(|axis| lower[axis] + side * upper[axis])
}

/// The direction of a side: 0 right, 1 up, 2 left, 3 down.
fn direction((from, to): (Place, Place)) -> usize {
    match (to[0].cmp(&from[0]), to[1].cmp(&from[1])) {
        (std::cmp::Ordering::Greater, _) => 0,
        (std::cmp::Ordering::Less, _) => 2,
        (_, std::cmp::Ordering::Greater) => 1,
        _ => 3,
    }
}

/// The points of the ring through a side.
fn ring_from(
    sides: &[(Place, Place)],
    first: usize,
    joined: Joined,
    used: &mut [bool],
) -> Vec<Place> {
    let mut ring = Vec::new();
    let mut at = first;
    while !used[at] {
        used[at] = true;
        ring.push(sides[at].0);
        at = following(sides, at, joined);
    }
    assert!(at == first, "a ring ends where it began"); // Inv 1, 2
    ring
}

/// The side that follows another one in its ring.
fn following(sides: &[(Place, Place)], at: usize, joined: Joined) -> usize {
    let end = sides[at].1;
    let first = sides.partition_point(|side| side.0 < end);
    let count = sides[first..].iter().take_while(|side| side.0 == end).count();
    assert!(count == 1 || count == 2, "one or two sides begin where one ends"); // Inv 1
    let is_left = |next: usize| direction(sides[next]) == (direction(sides[at]) + 1) % 4;
    if count == 1 || is_left(first) == (joined == Joined::ByFacets) { first } else { first + 1 }
}

/// A ring without points between sides of one direction.
fn without_straight(ring: &[Place]) -> Vec<Place> {
    let next = |i: usize| ring[(i + 1) % ring.len()];
    let before = |i: usize| ring[(i + ring.len() - 1) % ring.len()];
    let turns = |i: usize| direction((before(i), ring[i])) != direction((ring[i], next(i)));
    (0..ring.len()).filter(|&i| turns(i)).map(|i| ring[i]).collect()
}
