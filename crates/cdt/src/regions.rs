//! Regions: what the segments cut the plane into.
//!
//! ```text
//!      +-----------+        Region 0 is the exterior: all that is reached from infinity without crossing a segment, here
//!     /0\    1    / \       also the triangles 0 of the hull. The segments that have one region on both sides (the slit s)
//!    /   \  ---  / 0 \      separate nothing.
//!   +-----+--s--+-----+
//! ```
//!
//! **Definition.** Two cells are in one region if a path leads from one to the other that crosses no constrained edge; all
//! ghosts are in one. Regions are numbered by their leftmost triangle, so that neither order of input nor algorithm matters.
//!
//! **In.** A CDT and its noded graph. **Out.** The region of each cell, and for each subsegment the regions on its two sides.
//! **Cost.** O(n).
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | all sites in line, or none | the exterior alone | `a_line_has_no_inside` |
//! | regions that touch in a vertex | are two | `regions_that_touch_in_a_vertex_are_two` |
//! | a segment with one region on both sides | separates nothing; a bridge if it joins two circuits, else a slit | `slits_and_bridges_are_told_apart` |

use delone_mesh::{CellId, HalfEdge, Mesh};
use delone_sites::Noded;

use crate::Cdt;
use crate::result::constrained_half_edges;

/// The number of a region; 0 is the exterior.
pub type RegionId = u32;

/// Where the exterior ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shore {
    /// At segments.
    Segments,
    /// At the convex hull too.
    Hull,
}

/// The regions of a CDT. See the module's text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Regions {
    of_cell: Vec<RegionId>,
    count: usize,
    sides: Vec<[RegionId; 2]>,
    /// Regions that meet the exterior at edges of the hull that are no segments.
    shore: Vec<RegionId>,
}

impl Regions {
    /// The regions of the CDT of this graph.
    #[must_use]
    pub fn new(cdt: &Cdt, graph: &impl Noded) -> Self {
        Self::up_to(Shore::Segments, cdt, graph)
    }

    pub(crate) fn up_to(shore: Shore, cdt: &Cdt, graph: &impl Noded) -> Self {
        let mesh = cdt.mesh();
        let subsegments = graph.subsegments().len();
        if mesh.dimension() != Some(2) {
            let of_cell = vec![0; mesh.cell_count()];
            return Self { of_cell, count: 1, sides: vec![[0; 2]; subsegments], shore: Vec::new() };
        }
        let is_hull = |h: HalfEdge| mesh.is_ghost(h.cell()) != mesh.is_ghost(mesh.twin(h).cell());
        let is_cut = |h: HalfEdge| cdt.is_constrained(h) || (shore == Shore::Hull && is_hull(h));
        let ranks = graph.ranks();
        let (of_cell, count) = match shore {
            Shore::Segments => flooded(mesh, &ranks, |h| cdt.is_constrained(h)),
            Shore::Hull => flooded(mesh, &ranks, is_cut),
        };
        let shore = mesh.ghost_cells().flat_map(|cell| mesh.facets(cell));
        let shore = shore.filter(|&h| is_cut(h) && !cdt.is_constrained(h));
        let mut shore: Vec<RegionId> =
            shore.map(|h| of_cell[mesh.twin(h).cell().index()]).collect();
        shore.sort_unstable();
        shore.dedup();
        let mut regions = Self { of_cell, count, sides: vec![[0; 2]; subsegments], shore };
        for (h, place) in constrained_half_edges(cdt, graph) {
            let is_right = mesh.origin(h).index() > mesh.destination(h).index();
            regions.sides[place][usize::from(is_right)] = regions.of_cell[h.cell().index()];
        }
        regions
    }

    /// How many there are, the exterior included.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// The region of a cell, solid or ghost.
    #[must_use]
    pub fn of_cell(&self, cell: CellId) -> RegionId {
        self.of_cell[cell.index()]
    }

    /// For each subsegment, directed from its smaller site to its larger, the regions on its left and on its right.
    #[must_use]
    pub fn sides(&self) -> &[[RegionId; 2]] {
        &self.sides
    }

    /// Whether a subsegment has different regions on its sides.
    #[must_use]
    pub fn separates(&self, subsegment: usize) -> bool {
        let [left, right] = self.sides[subsegment];
        left != right
    }

    pub(crate) fn shore(&self) -> &[RegionId] {
        &self.shore
    }

    /// For each region its neighbours: across which subsegment, and whether from its right to its left.
    pub(crate) fn neighbours(&self) -> Vec<Vec<Step>> {
        let mut neighbours = vec![Vec::new(); self.count];
        for (subsegment, &[left, right]) in self.sides.iter().enumerate() {
            if left != right {
                neighbours[right as usize].push(Step { to: left, subsegment, leftwards: true });
                neighbours[left as usize].push(Step { to: right, subsegment, leftwards: false });
            }
        }
        neighbours
    }
}

/// A step from one region into the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub(crate) to: RegionId,
    pub(crate) subsegment: usize,
    /// From the right of the subsegment to its left.
    pub(crate) leftwards: bool,
}

/// The place of the leftmost corner in the order of the plane.
#[inline]
fn leftmost_corner(mesh: &Mesh<2>, ranks: &[u32], cell: CellId) -> u32 {
    let [a, b, c] = mesh.triangle(cell).map(|v| ranks[v.index()]);
    a.min(b).min(c)
}

/// The corners' places in the order of the plane, leftmost first.
fn key(mesh: &Mesh<2>, ranks: &[u32], cell: CellId) -> [u32; 3] {
    let mut corners = mesh.triangle(cell).map(|v| ranks[v.index()]);
    corners.sort_unstable();
    corners
}

/// Numbers the connected sets of cells: that of the ghosts first, the others by their leftmost triangles.
fn flooded(
    mesh: &Mesh<2>,
    ranks: &[u32],
    is_cut: impl Fn(HalfEdge) -> bool,
) -> (Vec<RegionId>, usize) {
    const NONE: RegionId = RegionId::MAX;
    let mut of_cell = vec![NONE; mesh.cell_count()];
    let mut leftmost: Vec<[u32; 3]> = Vec::new();
    let mut stack = Vec::new();
    // All ghosts are met from the first, so that the others are those of solid cells.
    for start in mesh.ghost_cells().take(1).chain(mesh.cells()) {
        if of_cell[start.index()] != NONE {
            continue;
        }
        let number = id(leftmost.len());
        let mut least = [u32::MAX; 3];
        of_cell[start.index()] = number;
        stack.push(start);
        while let Some(cell) = stack.pop() {
            if number > 0 && leftmost_corner(mesh, ranks, cell) <= least[0] {
                least = least.min(key(mesh, ranks, cell));
            }
            for (corner, twin) in mesh.triangle_twins(cell).into_iter().enumerate() {
                let beyond = twin.cell();
                if of_cell[beyond.index()] == NONE && !is_cut(HalfEdge::new(cell, corner)) {
                    of_cell[beyond.index()] = number;
                    stack.push(beyond);
                }
            }
        }
        leftmost.push(least);
    }
    let mut order: Vec<usize> = (1..leftmost.len()).collect();
    order.sort_unstable_by_key(|&number| leftmost[number]);
    let mut names = vec![0; leftmost.len()];
    for (name, number) in (1..).zip(order) {
        names[number] = name;
    }
    of_cell.iter_mut().for_each(|region| *region = names[*region as usize]);
    (of_cell, leftmost.len())
}

pub(crate) fn id(index: usize) -> u32 {
    u32::try_from(index).expect("a handle fits 32 bits")
}
