//! Solids of space given by their surface.

mod facet;

use crate::chain::{BoundaryFault, placed, summed};
use crate::grow::{decide, grow};
use crate::{Frame, FrameFault, LeafRule, OrthTree, Rule};
use facet::Facet;

#[cfg(test)]
mod tests;

/// A closed surface: triangles that may cross, overlap, touch and repeat, and the rule that says what is inside.
///
/// ```
/// use delone_trees::{LeafRule, Rule, Solid};
///
/// let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
/// let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
/// let tetrahedron = Solid::new(&points, &faces, Rule::NonZero)?;
/// let frame = tetrahedron.frame(2)?;
/// let volume = |rule| tetrahedron.tree(&frame, rule).volume(2);
/// assert_eq!((volume(LeafRule::Inner), volume(LeafRule::Outer)), (Some(4), Some(20)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Solid {
    facets: Vec<Facet>,
    rule: Rule,
}

/// Why triangles bound nothing; open at segments.
pub type SolidFault = BoundaryFault<[[f64; 3]; 2]>;

impl Solid {
    /// The solid inside triangles, triples of point indices.
    ///
    /// Points are equal if their coordinates are. Triangles that cancel under the rule are dropped; so are flat ones, which
    /// bound nothing, but they count for whether the surface is closed. O(n log n).
    ///
    /// # Errors
    /// With all points that are not finite, or all triangles that name no point, or all edges where the surface is open.
    pub fn new(
        points: &[[f64; 3]],
        triangles: &[[usize; 3]],
        rule: Rule,
    ) -> Result<Self, SolidFault> {
        let facets = summed(placed(points, triangles)?.filter_map(sorted), rule);
        let sides = facets.iter().flat_map(|&([a, b, c], weight)| {
            [([a, b], weight), ([b, c], weight), ([a, c], -weight)]
        });
        let open = summed(sides, rule);
        if !open.is_empty() {
            return Err(SolidFault::Open(open.into_iter().map(|(side, _)| side).collect()));
        }
        // On the side of the normal of a triangle seen counter-clockwise from outside, the winding number is less by one.
        let facets = facets.into_iter().filter_map(|(corners, sum)| Facet::new(corners, -sum));
        Ok(Self { facets: facets.collect(), rule })
    }

    /// A frame around the surface for trees of a depth.
    ///
    /// # Errors
    /// If the cube or its cells are beyond doubles.
    pub fn frame(&self, depth: u8) -> Result<Frame<3>, FrameFault> {
        let corners: Vec<[f64; 3]> = self.facets.iter().flat_map(|facet| facet.corners()).collect();
        Frame::around(&corners, depth)
    }

    /// The octree of the solid in a frame, down to its depth.
    ///
    /// A cell is gray as long as a triangle passes through its interior. All is decided by exact predicates.
    #[must_use]
    pub fn tree(&self, frame: &Frame<3>, rule: LeafRule) -> OrthTree<3> {
        grow(&self.facets, self.rule, frame, decide(rule, self.rule, frame))
    }
}

/// A triangle with its corners in lexicographic order, and the sign of that permutation; none with equal corners.
fn sorted(mut corners: [[f64; 3]; 3]) -> Option<([[f64; 3]; 3], i64)> {
    let mut sign = 1;
    for (i, j) in [(0, 1), (1, 2), (0, 1)] {
        if corners[i] > corners[j] {
            corners.swap(i, j);
            sign = -sign;
        }
    }
    (corners[0] < corners[1] && corners[1] < corners[2]).then_some((corners, sign))
}
