//! A shape's quadtree: segments are handed down to the cells that they pass through.
//!
//! **Paper.** \[HS79\]: nodes are O(perimeter / r + depth). With winding numbers, so that segments may cross.
//!
//! **In / Out.** A closed chain of segments, a frame, what to do at its depth; the tree in normal form.
//!
//! **Invariants.** 1. A cell has the list of all segments that meet its interior. 2. It knows the winding number of its reference
//! point: the lower left corner moved by (ε, ε²) for an infinitesimal ε, which is in its interior and on no segment. Reference
//! points of its sons are joined to it by ways in its interior, which only its own segments cross. 3. Without segments, the cell is as
//! its reference point.
//!
//! **Cost.** O(1) predicates for each segment, cell that it meets and son; O(segments) memory at any time, and the tree.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a segment along a cell's side, or through its corner only | does not meet it | `cells_that_are_only_touched_are_not_cut` |
//! | a segment through a reference point, or a centre | the point is moved by (ε, ε²) | `trees_are_as_defined` |
//! | the boundary at the frame's own corner | likewise | `cells_that_are_only_touched_are_not_cut` |
//! | no boundary | all white | `nothing_is_white` |

use delone_predicates::{Sign, orient2d};

use super::{Edge, LeafRule, Shape};
use crate::writer::due;
use crate::{Cell, Colour, Frame, OrthTree};

pub(super) fn grow(shape: &Shape, frame: &Frame<2>, rule: LeafRule) -> OrthTree<2> {
    let [lower, upper] = frame.corners(Cell::ROOT);
    let mut grower =
        Grower { shape, frame, rule, lists: Vec::new(), pending: Vec::new(), list: Vec::new() };
    grower.list = (0..shape.edges.len()).collect();
    let winding = shape.edges.iter().map(|edge| edge.step_to(lower)).sum();
    grower.push(winding, lower, upper);
    OrthTree::grown(|cell| grower.colour(cell))
}

struct Grower<'s> {
    shape: &'s Shape,
    frame: &'s Frame<2>,
    rule: LeafRule,
    /// The lists of pending cells, the next one's last.
    lists: Vec<usize>,
    /// Pending cells: the winding number at the reference point, where the list begins. The next one is last.
    pending: Vec<(i64, usize)>,
    /// The list of the cell at hand.
    list: Vec<usize>,
}

impl Grower<'_> {
    fn colour(&mut self, cell: Cell<2>) -> Colour {
        let (winding, start) = due(self.pending.pop());
        if start == self.lists.len() {
            return Colour::of(self.shape.is_inside(winding)); // Inv 3
        }
        self.list.clear();
        self.list.extend(self.lists.drain(start..));
        let [lower, upper] = self.frame.corners(cell);
        let middle = self.frame.centre(cell);
        if cell.level() < self.frame.depth() {
            self.cut(winding, lower, middle, upper);
            return Colour::Gray;
        }
        Colour::of(match self.rule {
            LeafRule::Inner => false,
            LeafRule::Outer => true,
            LeafRule::Centre => {
                let above = self.moved(winding, lower, [lower[0], middle[1]], 0);
                self.shape.is_inside(self.moved(above, [lower[0], middle[1]], middle, 1))
            }
        })
    }

    /// Makes the sons of the cell at hand pending.
    fn cut(&mut self, winding: i64, lower: [f64; 2], middle: [f64; 2], upper: [f64; 2]) {
        let (right, above) = ([middle[0], lower[1]], [lower[0], middle[1]]);
        let winding_right = self.moved(winding, lower, right, 1);
        let winding_above = self.moved(winding, lower, above, 0);
        let winding_middle = self.moved(winding_above, above, middle, 1);
        self.push(winding_middle, middle, upper);
        self.push(winding_above, above, [middle[0], upper[1]]);
        self.push(winding_right, right, [upper[0], middle[1]]);
        self.push(winding, lower, middle);
    }

    /// A pending cell, with what meets it of the list at hand.
    fn push(&mut self, winding: i64, lower: [f64; 2], upper: [f64; 2]) {
        self.pending.push((winding, self.lists.len()));
        let edges = &self.shape.edges;
        self.lists.extend(self.list.iter().filter(|&&e| edges[e].meets(lower, upper)));
    }

    /// The winding number after a way from a reference point to another, on which the coordinate of an axis is constant.
    fn moved(&self, winding: i64, from: [f64; 2], to: [f64; 2], axis: usize) -> i64 {
        let crossed =
            self.list.iter().map(|&e| &self.shape.edges[e]).filter(|e| e.straddles(from, axis));
        let step = |edge: &Edge| {
            edge.weight * (i64::from(edge.is_left(to)) - i64::from(edge.is_left(from)))
        };
        winding + crossed.map(step).sum::<i64>()
    }
}

impl Edge {
    /// Whether the interior of a box meets the segment.
    fn meets(&self, lower: [f64; 2], upper: [f64; 2]) -> bool {
        let [a, b] = self.ends;
        let (bottom, top) = if a[1] < b[1] { (a[1], b[1]) } else { (b[1], a[1]) };
        if a[0] >= upper[0] || b[0] <= lower[0] || bottom >= upper[1] || top <= lower[1] {
            return false;
        }
        // The corners furthest to the left and to the right of the line, which runs to the right or straight up.
        let (left, right) =
            if a[1] < b[1] { ([lower[0], upper[1]], [upper[0], lower[1]]) } else { (upper, lower) };
        orient2d(a, b, left) == Sign::Positive && orient2d(a, b, right) == Sign::Negative
    }

    /// Whether the ends are on both sides of the line through a reference point on which an axis is constant.
    fn straddles(&self, point: [f64; 2], axis: usize) -> bool {
        let [a, b] = self.ends;
        (a[axis] <= point[axis]) != (b[axis] <= point[axis])
    }

    /// Whether a reference point is on the left of the line. With d from end to end, the cross product of d and (ε, ε²) decides
    /// for a corner on the line: d_x ε² - d_y ε.
    fn is_left(&self, point: [f64; 2]) -> bool {
        let [a, b] = self.ends;
        match orient2d(a, b, point) {
            Sign::Positive => true,
            Sign::Negative => false,
            Sign::Zero => b[1] < a[1] || (b[1] == a[1] && b[0] > a[0]),
        }
    }

    /// How the winding number changes over this segment on the horizontal way to a reference point from far on the left.
    fn step_to(&self, point: [f64; 2]) -> i64 {
        if !self.straddles(point, 1) {
            return 0;
        }
        let begins_left = self.ends[0][1] < self.ends[1][1];
        self.weight * (i64::from(self.is_left(point)) - i64::from(begins_left))
    }
}
