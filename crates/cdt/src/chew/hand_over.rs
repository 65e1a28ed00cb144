//! From rings to a mesh: a solid cell for each triangle, a ghost for each half-edge whose left is outside.

use delone_mesh::{FacetId, Mesh, VertexId};
use delone_predicates::{PlaneKernel, Sign};

use super::rings::{Half, Rings};

/// No facet yet.
const NONE: u32 = u32::MAX;

/// Stands for the facet of a half-edge whose left is outside, until there are ghosts.
const OUTSIDE: u32 = u32::MAX - 1;

/// The mesh of the triangulation and its constrained half-edges, ranks renamed to `sorted[rank]`; `None` if there is no
/// triangle.
pub(crate) fn hand_over(
    mut rings: Rings,
    kernel: &impl PlaneKernel,
    sorted: &[u32],
) -> Option<(Mesh<2>, Vec<bool>)> {
    let name = |rank: u32| VertexId::new(sorted[rank as usize] as usize);
    let outside = outside(&rings, kernel)?;
    let hull: Vec<VertexId> = outside.iter().map(|&h| name(rings.origin(h))).collect();
    outside.iter().for_each(|&h| rings.hand_over(h, OUTSIDE));
    let mut cells = Cells::new(6 * sorted.len());
    for h in 0..rings.len() {
        if rings.is_waiting(h) {
            let second = rings.around(h);
            let third = rings.around(second);
            debug_assert_eq!(rings.around(third), h, "each face but one is a triangle");
            // The half-edge from corner i to corner i + 1 is the facet opposite corner i + 2.
            let corners = [h, second, third].map(|h| name(rings.origin(h)));
            cells.add(&mut rings, corners, [second, third, h]);
        }
    }
    if cells.corners.is_empty() {
        return None;
    }
    Some(cells.closed(&mut rings, &outside, &hull))
}

/// The mesh's arrays in the making.
struct Cells {
    corners: Vec<VertexId>,
    twins: Vec<u32>,
    constrained: Vec<bool>,
}

impl Cells {
    fn new(facets: usize) -> Self {
        Self {
            corners: Vec::with_capacity(facets),
            twins: Vec::with_capacity(facets),
            constrained: Vec::with_capacity(facets),
        }
    }

    /// The facet that comes next.
    fn coming(&self) -> u32 {
        u32::try_from(self.twins.len()).expect("facets have 32-bit ids")
    }

    /// A triangle, and the half-edges opposite its corners.
    #[inline]
    fn add(&mut self, rings: &mut Rings, corners: [VertexId; 3], halves: [Half; 3]) {
        self.corners.extend(corners);
        halves.into_iter().for_each(|h| self.glue(rings, h));
    }

    /// The facet of a half-edge, glued to its other half's if there is one.
    #[inline]
    fn glue(&mut self, rings: &mut Rings, h: Half) {
        let facet = self.coming();
        let twin = rings.facet(h ^ 1).filter(|&twin| twin != OUTSIDE);
        if let Some(twin) = twin {
            self.twins[twin as usize] = facet;
        }
        self.twins.push(twin.unwrap_or(NONE));
        self.constrained.push(rings.is_segment(h));
        rings.hand_over(h, facet);
    }

    /// With the ghosts around the outside, whose half-edges start at `hull`.
    fn closed(
        mut self,
        rings: &mut Rings,
        outside: &[Half],
        hull: &[VertexId],
    ) -> (Mesh<2>, Vec<bool>) {
        let first = self.coming();
        for (i, &h) in outside.iter().enumerate() {
            self.corners.extend([hull[i], hull[(i + 1) % hull.len()], VertexId::GHOST]);
            // Opposite u and v, on to the next ghost and back to the last one.
            let at = self.coming();
            self.twins.extend([at + 4, at.wrapping_sub(3)]);
            self.constrained.extend([false; 2]);
            self.glue(rings, h);
        }
        let last = self.coming() - 3;
        self.twins[last as usize] = first + 1;
        self.twins[first as usize + 1] = last;
        let twins = self.twins.into_iter().map(|facet| FacetId::from_index(facet as usize));
        (Mesh::from_parts(2, self.corners, twins.collect()), self.constrained)
    }
}

/// The half-edges around the outer face: all edges of the first site go to one side, and the face is on the other.
fn outside(rings: &Rings, kernel: &impl PlaneKernel) -> Option<Vec<Half>> {
    rings.start(0)?;
    let to = |h: Half| rings.destination(h) as usize;
    let is_open = |&h: &Half| kernel.orient(&[0, to(h), to(rings.next(h))]) != Sign::Positive;
    let first =
        rings.halves(0).find(is_open).expect("edges that all go to one side leave an open sector");
    let mut outside = vec![first];
    let mut h = rings.around(first);
    while h != first {
        outside.push(h);
        h = rings.around(h);
    }
    Some(outside)
}
