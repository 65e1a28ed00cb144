//! PM quadtrees: cells are cut until what is in them is simple, of planar straight-line graphs.
//!
//! **Paper.** \[SW85\]. All cells are closed. PM3: at most one vertex in a leaf. PM2: besides, all edges in it have a common vertex, the
//! one in the leaf if there is one. PM1: besides, more than one edge only with the vertex in the leaf.
//!
//! **In / Out.** Points, segments between them, a frame, a rule; leaves with the vertices and the edges that are in them. Where
//! the rule cannot be kept, as where edges cross, leaves go down to the frame's smallest cells.
//!
//! **Invariants.** 1. A leaf lists all points and all segments that its closed cell meets.
//!
//! **Cost.** O(1) predicates for each segment and node that it meets.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a vertex or an edge on a side, or at a corner | it is in all cells there | `leaves_hold_what_they_meet` |
//! | crossing edges, equal points, vertices nearer than the smallest cells | crowded leaves | `crossings_crowd_the_smallest_cells` |
//! | a segment without extent | an edge, of one vertex | `leaves_hold_what_they_meet` |

use delone_predicates::{Sign, orient2d};

use crate::buckets::{Buckets, id};
use crate::leaves::Leaves;
use crate::nudge::leftmost;
use crate::{Cell, Frame, Key};

#[cfg(test)]
mod tests;

/// When a leaf is simple.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PmRule {
    /// One vertex with edges of its own, or no vertex and at most one edge.
    Pm1,
    /// One vertex with edges of its own, or no vertex and edges that have a common one.
    Pm2,
    /// At most one vertex.
    Pm3,
}

/// The PM quadtree of points and segments.
///
/// ```
/// use delone_trees::{Frame, PmRule, PmTree};
///
/// let points = [[0.5, 0.5], [3.5, 0.5], [0.5, 3.5]];
/// let segments = [[0, 1], [0, 2], [1, 2]];
/// let frame = Frame::around(&[[0.0, 0.0], [4.0, 4.0]], 8)?;
/// let [pm1, pm3] = [PmRule::Pm1, PmRule::Pm3].map(|rule| PmTree::new(&points, &segments, &frame, rule));
/// assert_eq!((pm1.leaves().len(), pm3.leaves().len()), (7, 4));
/// assert_eq!((pm1.vertices(0), pm1.edges(0)), ([0].as_slice(), [0, 1].as_slice()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PmTree {
    frame: Frame<2>,
    leaves: Leaves<2>,
    vertices: Buckets,
    edges: Buckets,
    crowded: Vec<usize>,
}

impl PmTree {
    /// The tree in a frame, by a rule. Points that are not finite are in no leaf.
    ///
    /// # Panics
    /// If a segment names a point that is not there, or one that is not finite.
    #[must_use]
    pub fn new(
        points: &[[f64; 2]],
        segments: &[[usize; 2]],
        frame: &Frame<2>,
        rule: PmRule,
    ) -> Self {
        let finite = segments.iter().flatten().all(|&v| points[v].iter().all(|c| c.is_finite()));
        assert!(finite, "segments are between finite points");
        let graph = Graph { points, segments };
        let (mut keys, mut black, mut crowded) = (Vec::new(), Vec::new(), Vec::new());
        let (mut vertices, mut edges) = (Buckets::default(), Buckets::default());
        let all = Content {
            cell: Cell::ROOT,
            vertices: (0..points.len()).map(id).collect(),
            edges: (0..segments.len()).map(id).collect(),
        };
        let mut pending = vec![graph.part(&all, Cell::ROOT, frame)];
        while let Some(content) = pending.pop() {
            let cell = content.cell;
            let is_simple = graph.is_simple(&content, rule);
            if !is_simple && cell.level() < frame.depth() {
                let sons = (0..4).rev().map(|son| graph.part(&content, cell.son(son), frame));
                pending.extend(sons);
                continue;
            }
            if !is_simple {
                crowded.push(keys.len());
            }
            keys.push(Key::of(cell));
            black.push(!(content.vertices.is_empty() && content.edges.is_empty()));
            vertices.push(&content.vertices);
            edges.push(&content.edges);
        }
        Self { frame: *frame, leaves: Leaves::new(keys, black), vertices, edges, crowded }
    }

    /// The leaves; those that hold anything are black.
    #[must_use]
    pub fn leaves(&self) -> &Leaves<2> {
        &self.leaves
    }

    /// The points in a leaf's closed cell, in increasing order.
    ///
    /// # Panics
    /// If there are not as many leaves.
    #[must_use]
    pub fn vertices(&self, leaf: usize) -> &[u32] {
        self.vertices.of(leaf)
    }

    /// The segments that meet a leaf's closed cell, in increasing order.
    ///
    /// # Panics
    /// If there are not as many leaves.
    #[must_use]
    pub fn edges(&self, leaf: usize) -> &[u32] {
        self.edges.of(leaf)
    }

    /// The leaves that are not simple: they are of the smallest cells.
    #[must_use]
    pub fn crowded(&self) -> &[usize] {
        &self.crowded
    }

    /// The leaf that a point is in, if it is in the frame; on a side, the upper one.
    #[must_use]
    pub fn leaf_at(&self, point: [f64; 2]) -> Option<usize> {
        self.leaves.holder(self.frame.cell_at(point)?)
    }
}

struct Graph<'a> {
    points: &'a [[f64; 2]],
    segments: &'a [[usize; 2]],
}

/// What is in a cell.
struct Content {
    cell: Cell<2>,
    vertices: Vec<u32>,
    edges: Vec<u32>,
}

impl Graph<'_> {
    /// What of a cell's content is in a part of it.
    fn part(&self, content: &Content, cell: Cell<2>, frame: &Frame<2>) -> Content {
        let [lower, upper] = frame.corners(cell);
        let holds = |point: [f64; 2]| {
            (0..2).all(|axis| lower[axis] <= point[axis] && point[axis] <= upper[axis])
        };
        let vertices = content.vertices.iter().copied().filter(|&v| holds(self.points[v as usize]));
        let meets = |&edge: &u32| {
            let [a, b] = self.segments[edge as usize].map(|v| self.points[v]);
            touches(a, b, lower, upper)
        };
        let edges = content.edges.iter().copied().filter(meets);
        Content { cell, vertices: vertices.collect(), edges: edges.collect() }
    }

    fn is_simple(&self, content: &Content, rule: PmRule) -> bool {
        let ends = |edge: u32| self.segments[edge as usize];
        let has = |vertex: usize| content.edges.iter().all(|&edge| ends(edge).contains(&vertex));
        match (content.vertices.as_slice(), content.edges.as_slice()) {
            ([], [] | [_]) => true,
            ([], [first, ..]) => match rule {
                PmRule::Pm1 => false,
                PmRule::Pm2 => ends(*first).into_iter().any(has),
                PmRule::Pm3 => true,
            },
            (&[vertex], _) => rule == PmRule::Pm3 || has(vertex as usize),
            _ => false,
        }
    }
}

/// Whether a segment meets a closed box.
fn touches(a: [f64; 2], b: [f64; 2], lower: [f64; 2], upper: [f64; 2]) -> bool {
    let beside =
        |axis: usize| a[axis].max(b[axis]) < lower[axis] || a[axis].min(b[axis]) > upper[axis];
    if beside(0) || beside(1) {
        return false;
    }
    let (left, right) = (leftmost(a, b, lower, upper), leftmost(b, a, lower, upper));
    orient2d(a, b, left) != Sign::Negative && orient2d(a, b, right) != Sign::Positive
}
