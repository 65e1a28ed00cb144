//! A balanced quadtree as a conforming triangulation without small or obtuse angles.
//!
//! **Paper.** \[BEG94\]: a leaf of a balanced quadtree is cut by one of a few templates, as its sides have middles or not.
//!
//! **In / Out.** A frame, leaves of the plane that are balanced through their sides; triangles whose vertices are corners of leaves.
//!
//! **Invariants.** 1. Vertices are the corners of leaves; a side has its middle as a vertex if and only if smaller leaves are beyond.
//! 2. All angles are between atan(1/2), some 26.6 degrees, and 90 degrees; so those of all templates are.
//!
//! **Cost.** O(n log n).
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | not balanced | refused, with a leaf | `what_is_not_balanced_is_not_triangulated` |
//! | middles of smallest cells of the frame | are no vertices | `triangles_conform_and_have_the_angles_of_the_templates` |

use std::fmt;

use super::Leaves;
use crate::{Cell, Frame, Joined};

/// Triangles of a square, counter-clockwise, and which are inside.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangles {
    /// The vertices, in lexicographic order.
    pub points: Vec<[f64; 2]>,
    /// The triangles, leaf by leaf.
    pub triangles: Vec<[u32; 3]>,
    /// Whether each is in a black leaf.
    pub inside: Vec<bool>,
}

/// Why leaves are not triangulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TrianglesFault {
    /// A neighbour is more than one level deeper.
    Unbalanced {
        /// The leaf, from 0 in Morton's order.
        leaf: usize,
    },
    /// A leaf is smaller than the frame's smallest cells.
    TooFine {
        /// The leaf, from 0 in Morton's order.
        leaf: usize,
    },
}

impl fmt::Display for TrianglesFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unbalanced { leaf } => {
                write!(f, "leaf {leaf} has a neighbour that is too small: balance the leaves first")
            }
            Self::TooFine { leaf } => {
                write!(f, "leaf {leaf} is smaller than the frame's cells: take a deeper frame")
            }
        }
    }
}

impl std::error::Error for TrianglesFault {}

/// The steps over the sides of a square, counter-clockwise: bottom, right, top, left.
const SIDES: [[i8; 2]; 4] = [[0, -1], [1, 0], [0, 1], [-1, 0]];

impl Leaves<2> {
    /// The triangulation of a balanced quadtree: angles from 26.56 to 90 degrees.
    ///
    /// ```
    /// use delone_trees::{Frame, Joined, OrthTree};
    ///
    /// let frame = Frame::around(&[[0.0, 0.0], [4.0, 4.0]], 2)?;
    /// let leaves = OrthTree::<2>::from_text("((BBBWWWW")?.leaves();
    /// let mesh = leaves.balanced(Joined::ByFacets).triangles(&frame)?;
    /// assert_eq!((mesh.points.len(), mesh.triangles.len()), (14, 16));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// At the first leaf that is smaller than the frame's cells, or that has a neighbour more than one level deeper.
    ///
    /// # Panics
    /// Never: a vertex that is no leaf's corner would be a bug.
    pub fn triangles(&self, frame: &Frame<2>) -> Result<Triangles, TrianglesFault> {
        if let Some(leaf) = self.cells().position(|cell| cell.level() > frame.depth()) {
            return Err(TrianglesFault::TooFine { leaf });
        }
        let mut all: Vec<[[u32; 2]; 3]> = Vec::new();
        let mut inside = Vec::new();
        for (leaf, cell) in self.cells().enumerate() {
            let middles = self.middles(leaf).ok_or(TrianglesFault::Unbalanced { leaf })?;
            cut(cell, middles, frame.depth(), &mut all);
            inside.resize(all.len(), self.is_black(leaf));
        }
        let mut vertices: Vec<[u32; 2]> = all.iter().flatten().copied().collect();
        vertices.sort_unstable();
        vertices.dedup();
        let id = |vertex: [u32; 2]| {
            let place = vertices.binary_search(&vertex).expect("all vertices are there");
            u32::try_from(place).expect("a vertex index fits 32 bits")
        };
        let triangles = all.iter().map(|corners| corners.map(id)).collect();
        let points = vertices.iter().map(|&vertex| frame.lattice(vertex)).collect();
        Ok(Triangles { points, triangles, inside })
    }

    /// Which sides have smaller leaves beyond; none if one is more than a level deeper.
    fn middles(&self, leaf: usize) -> Option<[bool; 4]> {
        let level = self.keys[leaf].level();
        let near = self.neighbours(leaf, Joined::ByFacets);
        if near.iter().any(|&other| self.keys[other].level() > level + 1) {
            return None;
        }
        Some(SIDES.map(|side| {
            let beyond = self.keys[leaf].neighbour(side);
            beyond.is_some_and(|beyond| self.holder_of(beyond).is_none())
        }))
    }
}

/// The triangles of one leaf, on the lattice of the level `depth`. Corners are 0 2 4 6 counter-clockwise from the lower left,
/// middles 1 3 5 7 behind them.
fn cut(cell: Cell<2>, middles: [bool; 4], depth: u8, out: &mut Vec<[[u32; 2]; 3]>) {
    let ([x, y], side) = cell.scaled(depth);
    let half = side / 2; // only used where smaller leaves are
    let around = [
        [x, y],
        [x + half, y],
        [x + side, y],
        [x + side, y + half],
        [x + side, y + side],
        [x + half, y + side],
        [x, y + side],
        [x, y + half],
    ];
    let (turn, template) = template(middles);
    out.extend(template.iter().map(|corners| corners.map(|v| around[(v + 2 * turn) % 8])));
}

/// How many quarters the square is turned, and the triangles of the template.
fn template(middles: [bool; 4]) -> (usize, &'static [[usize; 3]]) {
    const NONE: &[[usize; 3]] = &[[0, 2, 4], [0, 4, 6]];
    const ONE: &[[usize; 3]] = &[[1, 2, 4], [1, 4, 6], [1, 6, 0]];
    const ADJACENT: &[[usize; 3]] = &[[1, 2, 3], [3, 4, 6], [1, 3, 6], [6, 0, 1]];
    const OPPOSITE: &[[usize; 3]] = &[[0, 1, 5], [0, 5, 6], [1, 2, 4], [1, 4, 5]];
    const THREE: &[[usize; 3]] = &[[1, 2, 3], [3, 4, 5], [1, 3, 5], [0, 1, 5], [0, 5, 6]];
    const ALL: &[[usize; 3]] = &[[1, 2, 3], [3, 4, 5], [5, 6, 7], [7, 0, 1], [1, 3, 5], [1, 5, 7]];
    let template = match middles.iter().filter(|&&middle| middle).count() {
        0 => return (0, NONE),
        1 => ONE,
        2 if middles[0] == middles[2] => OPPOSITE,
        2 => ADJACENT,
        3 => THREE,
        _ => return (0, ALL),
    };
    // The template's first middle is the first one after a side without, counter-clockwise.
    let first = (0..4).find(|&side| middles[side] && !middles[(side + 3) % 4]);
    (first.unwrap_or(0), template)
}
