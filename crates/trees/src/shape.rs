//! Shapes of the plane given by their boundary.

mod grow;

use std::fmt;

use crate::{Frame, FrameFault, OrthTree};

#[cfg(test)]
#[expect(clippy::cast_possible_truncation, reason = "the numbers of the tests are small")]
mod tests;

/// Which winding numbers are inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Odd ones. Directions of segments do not matter.
    EvenOdd,
    /// All but zero. Segments have the inside on their left or on their right.
    NonZero,
}

/// What the smallest cells become through which the boundary passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeafRule {
    /// White: what is black is inside.
    Inner,
    /// Black: what is inside is black.
    Outer,
    /// As the centre is; if the boundary goes through it, as what is infinitely near it to the right, and above it along vertical ones.
    Centre,
}

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

/// A segment from the lexicographically smaller end to the larger.
#[derive(Clone, Copy, Debug)]
struct Edge {
    ends: [[f64; 2]; 2],
    /// How much the winding number is larger on the left than on the right.
    weight: i64,
}

/// Why segments bound nothing.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ShapeFault {
    /// Points with a coordinate that is no finite number.
    NotFinite(Vec<usize>),
    /// Segments that name no point.
    NoSuchPoint(Vec<usize>),
    /// Where the boundary is not closed: an odd number of segments ends there, or under [`Rule::NonZero`] not as many come as go.
    Open(Vec<[f64; 2]>),
}

impl fmt::Display for ShapeFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite(points) => write!(
                f,
                "points {points:?} have coordinates that are no numbers: give finite ones"
            ),
            Self::NoSuchPoint(segments) => {
                write!(f, "segments {segments:?} name points that are not there: check indices")
            }
            Self::Open(places) => write!(f, "the boundary is open at {places:?}: close it"),
        }
    }
}

impl std::error::Error for ShapeFault {}

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
        let strange = |&i: &usize| points[i].iter().any(|c| !c.is_finite());
        let not_finite: Vec<usize> = (0..points.len()).filter(strange).collect();
        if !not_finite.is_empty() {
            return Err(ShapeFault::NotFinite(not_finite));
        }
        let nowhere = |&i: &usize| segments[i].iter().any(|&end| end >= points.len());
        let no_such: Vec<usize> = (0..segments.len()).filter(nowhere).collect();
        if !no_such.is_empty() {
            return Err(ShapeFault::NoSuchPoint(no_such));
        }
        let place = |i: usize| points[i].map(|c| c + 0.0);
        let edges = chain(segments.iter().map(|ends| ends.map(place)), rule);
        let open = open_places(&edges, rule);
        if open.is_empty() { Ok(Self { edges, rule }) } else { Err(ShapeFault::Open(open)) }
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
        grow::grow(self, frame, rule)
    }

    fn is_inside(&self, winding: i64) -> bool {
        match self.rule {
            Rule::EvenOdd => winding % 2 != 0,
            Rule::NonZero => winding != 0,
        }
    }
}

/// Segments as a chain: each once, with its weight, none of weight zero. Under the even-odd rule weights are modulo two.
fn chain(segments: impl Iterator<Item = [[f64; 2]; 2]>, rule: Rule) -> Vec<Edge> {
    let directed = segments.filter(|[a, b]| a != b).map(|[a, b]| match before(&a, &b) {
        true => Edge { ends: [a, b], weight: 1 },
        false => Edge { ends: [b, a], weight: -1 },
    });
    let mut edges: Vec<Edge> = directed.collect();
    edges.sort_by(|a, b| a.ends.partial_cmp(&b.ends).expect("coordinates are finite"));
    edges.dedup_by(|next, kept| {
        let same = next.ends == kept.ends;
        kept.weight += if same { next.weight } else { 0 };
        same
    });
    if rule == Rule::EvenOdd {
        edges.iter_mut().for_each(|edge| edge.weight = edge.weight.rem_euclid(2));
    }
    edges.retain(|edge| edge.weight != 0);
    edges
}

fn before(a: &[f64; 2], b: &[f64; 2]) -> bool {
    a.partial_cmp(b).expect("coordinates are finite").is_lt()
}

/// The boundary of a chain of edges.
fn open_places(edges: &[Edge], rule: Rule) -> Vec<[f64; 2]> {
    let both = |edge: &Edge| [(edge.ends[0], -edge.weight), (edge.ends[1], edge.weight)];
    let mut ends: Vec<([f64; 2], i64)> = edges.iter().flat_map(both).collect();
    ends.sort_by(|a, b| a.0.partial_cmp(&b.0).expect("coordinates are finite"));
    let open = |run: &&[([f64; 2], i64)]| {
        let sum: i64 = run.iter().map(|(_, weight)| weight).sum();
        if rule == Rule::EvenOdd { sum % 2 != 0 } else { sum != 0 }
    };
    ends.chunk_by(|a, b| a.0 == b.0).filter(open).map(|run| run[0].0).collect()
}
