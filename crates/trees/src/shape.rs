//! Shapes of the plane given by their boundary.

mod edge;
mod share;

use crate::chain::{BoundaryFault, placed, summed};
use crate::grow::{decide, grow};
use crate::{Frame, FrameFault, LeafRule, OrthTree};
use edge::Edge;

#[cfg(test)]
#[expect(clippy::cast_possible_truncation, reason = "the numbers of the tests are small")]
mod tests;

/// Which winding numbers are inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Odd ones. Directions of segments, sides of triangles do not matter.
    EvenOdd,
    /// All but zero. Segments have the inside on their left or on their right, triangles before or behind them.
    NonZero,
}

impl Rule {
    pub(crate) fn holds(self, winding: i64) -> bool {
        match self {
            Self::EvenOdd => winding % 2 != 0,
            Self::NonZero => winding != 0,
        }
    }
}

/// Why segments bound nothing; open at points.
pub type ShapeFault = BoundaryFault<[f64; 2]>;

/// A boundary: segments that may cross, overlap, touch and repeat, and the rule that says what is inside.
///
/// ```
/// use delone_trees::{Frame, LeafRule, Rule, Shape};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
/// let triangle = Shape::new(&points, &[[0, 1], [1, 2], [2, 0]], Rule::EvenOdd)?;
/// let frame = triangle.frame(2)?;
/// let area = |rule| triangle.tree(&frame, rule).volume(2);
/// assert_eq!((area(LeafRule::Inner), area(LeafRule::Outer)), (Some(6), Some(10)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Shape {
    edges: Vec<Edge>,
    rule: Rule,
}

impl Shape {
    /// The shape inside segments, pairs of point indices.
    ///
    /// Points are equal if their coordinates are. Segments that cancel under the rule are dropped. O(n log n).
    ///
    /// # Errors
    /// With all points that are not finite, or all segments that name no point, or all places where the boundary is open.
    pub fn new(
        points: &[[f64; 2]],
        segments: &[[usize; 2]],
        rule: Rule,
    ) -> Result<Self, ShapeFault> {
        let edges = summed(placed(points, segments)?.filter_map(directed), rule);
        let ends = edges.iter().flat_map(|&([a, b], weight)| [(a, -weight), (b, weight)]);
        let open = summed(ends, rule);
        if !open.is_empty() {
            return Err(ShapeFault::Open(open.into_iter().map(|(place, _)| place).collect()));
        }
        let edges = edges.into_iter().map(|(ends, weight)| Edge { ends, weight }).collect();
        Ok(Self { edges, rule })
    }

    /// A frame around the boundary for trees of a depth.
    ///
    /// # Errors
    /// If the square or its cells are beyond doubles.
    pub fn frame(&self, depth: u8) -> Result<Frame<2>, FrameFault> {
        let ends: Vec<[f64; 2]> = self.edges.iter().flat_map(|edge| edge.ends).collect();
        Frame::around(&ends, depth)
    }

    /// The quadtree of the shape in a frame, down to its depth.
    ///
    /// A cell is gray as long as a segment passes through its interior; so a segment with the inside on both sides keeps the
    /// smallest cells along it from being black under [`LeafRule::Inner`]. All else is decided by exact predicates.
    #[must_use]
    pub fn tree(&self, frame: &Frame<2>, rule: LeafRule) -> OrthTree<2> {
        grow(&self.edges, self.rule, frame, decide(rule, self.rule, frame))
    }

    /// The quadtree of the shape in a frame, down to its depth, where a smallest cell through which the boundary passes is black if at
    /// least half of it is inside, exactly.
    ///
    /// ```
    /// use delone_trees::{Rule, Shape};
    ///
    /// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
    /// let triangle = Shape::new(&points, &[[0, 1], [1, 2], [2, 0]], Rule::EvenOdd)?;
    /// let tree = triangle.tree_by_area(&triangle.frame(2)?);
    /// assert_eq!(tree.volume(2), Some(10)); // four cells are half inside
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn tree_by_area(&self, frame: &Frame<2>) -> OrthTree<2> {
        grow(&self.edges, self.rule, frame, |held, winding, cell| {
            share::is_half_inside(held, self.rule, winding, frame.corners(cell))
        })
    }
}

/// A segment from the lexicographically smaller end, and whether it was so; none without extent.
fn directed([a, b]: [[f64; 2]; 2]) -> Option<([[f64; 2]; 2], i64)> {
    match a.partial_cmp(&b)? {
        std::cmp::Ordering::Less => Some(([a, b], 1)),
        std::cmp::Ordering::Equal => None,
        std::cmp::Ordering::Greater => Some(([b, a], -1)),
    }
}
