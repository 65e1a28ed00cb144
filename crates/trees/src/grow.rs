//! Trees of what is inside a boundary: walls are handed down to the cells that they pass through.
//!
//! **Paper.** \[HS79\]: nodes are O(perimeter / r + depth). With winding numbers, so that walls may cross; in any dimension.
//!
//! **In / Out.** A closed chain of walls (segments of the plane, triangles of space), a frame, what to do at its depth; the tree in
//! normal form.
//!
//! **Invariants.** 1. A cell has the list of all walls that meet its interior. 2. It knows the winding number of its reference
//! point: the lower corner moved by (ε, ε², ..) for an infinitesimal ε, which is in its interior and on no wall. Reference
//! points of its sons are joined to it by ways in its interior, which only its own walls cross. 3. Without walls, the cell is as
//! its reference point.
//!
//! **Cost.** O(1) predicates for each wall, cell that it meets and son; O(walls) memory at any time, and the tree.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a segment along a cell's side, or through its corner only | does not meet it | `cells_that_are_only_touched_are_not_cut` |
//! | a triangle in a cell's facet, or through an edge or corner only | does not meet it | `boxes_of_the_lattice_are_exact` |
//! | a wall through a reference point, or a centre | the point is moved by (ε, ε², ..) | `trees_are_as_defined`, `solids_are_as_defined` |
//! | the boundary at the frame's own corner | likewise | `cells_that_are_only_touched_are_not_cut` |
//! | no boundary | all white | `nothing_is_white` |

use crate::writer::due;
use crate::{Cell, Colour, Frame, OrthTree, Rule};

/// What the smallest cells become through which the boundary passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeafRule {
    /// White: what is black is inside.
    Inner,
    /// Black: what is inside is black.
    Outer,
    /// As the centre is; if the boundary goes through it, as the centre moved by (ε, ε², ..) for an infinitesimal ε.
    Centre,
}

/// A piece of a boundary. Points asked about are moved by (ε, ε², ..).
pub(crate) trait Wall<const N: usize> {
    /// How much the winding number is larger on its left than on its right.
    fn weight(&self) -> i64;
    /// Whether it meets the interior of a box.
    fn meets(&self, lower: [f64; N], upper: [f64; N]) -> bool;
    /// Whether it meets the line through the point along an axis.
    fn covers(&self, point: [f64; N], axis: usize) -> bool;
    /// Whether the point is on its left.
    fn has_left(&self, point: [f64; N]) -> bool;
    /// Whether that line, along axis 0, begins on its left; only asked where it meets the line.
    fn begins_left(&self) -> bool;
}

/// The tree of what is inside walls. `decide` says what the smallest cells become that walls meet: from the winding number at the
/// reference point, the walls, and the cell.
pub(crate) fn grow<const N: usize, W: Wall<N>>(
    walls: &[W],
    rule: Rule,
    frame: &Frame<N>,
    decide: impl Fn(&Held<'_, W>, i64, Cell<N>) -> bool,
) -> OrthTree<N> {
    let [lower, upper] = frame.corners(Cell::ROOT);
    let mut grower = Grower {
        frame,
        lists: Vec::new(),
        pending: Vec::new(),
        held: Held { walls, list: (0..walls.len()).collect() },
    };
    let winding = walls.iter().filter(|wall| wall.covers(lower, 0)).map(|wall| {
        wall.weight() * (i64::from(wall.has_left(lower)) - i64::from(wall.begins_left()))
    });
    grower.push(winding.sum(), lower, upper);
    OrthTree::grown(|cell| {
        let (winding, start) = due(grower.pending.pop());
        if start == grower.lists.len() {
            return Colour::of(rule.holds(winding)); // Inv 3
        }
        grower.held.list.clear();
        grower.held.list.extend(grower.lists.drain(start..));
        if cell.level() == frame.depth() {
            return Colour::of(decide(&grower.held, winding, cell));
        }
        grower.cut(winding, cell);
        Colour::Gray
    })
}

/// What a rule of [`LeafRule`] says of a smallest cell that walls meet.
pub(crate) fn decide<const N: usize, W: Wall<N>>(
    leaves: LeafRule,
    rule: Rule,
    frame: &Frame<N>,
) -> impl Fn(&Held<'_, W>, i64, Cell<N>) -> bool {
    move |held, winding, cell| match leaves {
        LeafRule::Inner => false,
        LeafRule::Outer => true,
        LeafRule::Centre => {
            let [mut at, _] = frame.corners(cell);
            let mut winding = winding;
            for (axis, to) in frame.centre(cell).into_iter().enumerate() {
                winding = held.moved(winding, at, axis, to);
                at[axis] = to;
            }
            rule.holds(winding)
        }
    }
}

/// The walls that meet a cell.
#[derive(Debug)]
pub(crate) struct Held<'w, W> {
    walls: &'w [W],
    list: Vec<usize>,
}

impl<W> Held<'_, W> {
    pub(crate) fn iter(&self) -> impl Iterator<Item = &W> + Clone {
        self.list.iter().map(|&w| &self.walls[w])
    }

    /// The winding number after a way along an axis from a reference point to another.
    pub(crate) fn moved<const N: usize>(
        &self,
        winding: i64,
        from: [f64; N],
        axis: usize,
        coordinate: f64,
    ) -> i64
    where
        W: Wall<N>,
    {
        let mut to = from;
        to[axis] = coordinate;
        let step = |wall: &W| {
            wall.weight() * (i64::from(wall.has_left(to)) - i64::from(wall.has_left(from)))
        };
        winding + self.iter().filter(|wall| wall.covers(from, axis)).map(step).sum::<i64>()
    }
}

struct Grower<'w, const N: usize, W> {
    frame: &'w Frame<N>,
    /// The lists of pending cells, the next one's last.
    lists: Vec<usize>,
    /// Pending cells: the winding number at the reference point, where the list begins. The next one is last.
    pending: Vec<(i64, usize)>,
    /// The list of the cell at hand.
    held: Held<'w, W>,
}

/// The most sons that a cell has.
const SONS_MAX: usize = 16;

impl<const N: usize, W: Wall<N>> Grower<'_, N, W> {
    /// Makes the sons of the cell at hand pending.
    fn cut(&mut self, winding: i64, cell: Cell<N>) {
        let corners = |son: usize| self.frame.corners(cell.son(son));
        let mut windings = [winding; SONS_MAX];
        for son in 1usize..1 << N {
            // From the son on the lower side of its highest axis.
            let axis = son.ilog2() as usize;
            let before = son & !(1 << axis);
            let to = corners(son)[0][axis];
            windings[son] = self.held.moved(windings[before], corners(before)[0], axis, to);
        }
        for son in (0..1 << N).rev() {
            let [lower, upper] = self.frame.corners(cell.son(son));
            self.push(windings[son], lower, upper);
        }
    }

    /// A pending cell, with what meets it of the list at hand.
    fn push(&mut self, winding: i64, lower: [f64; N], upper: [f64; N]) {
        self.pending.push((winding, self.lists.len()));
        let Held { walls, list } = &self.held;
        self.lists.extend(list.iter().filter(|&&w| walls[w].meets(lower, upper)));
    }
}
