//! The definition, as an algorithm: triangle by triangle, the apex of each edge among all vertices that see all of it.
//!
//! **Paper.** [LL86]: gift wrapping by visibility. Where we differ: a vertex is a candidate for the apex of edge ab if no
//! segment meets the open triangle between them, which orientations alone decide. That is enough. The right apex c is a
//! candidate; and another one, d, inside the circle of abc, would see the inside of abc near ab, against the definition. So
//! the candidate whose circle holds no other is c.
//! **In.** A kernel over a few vertices that span the plane; subsegments. **Out.** The cells, counter-clockwise.
//! **Cost.** O(n^2 m) for n vertices and m subsegments.
//! **Not** the judge's oracle, which shares nothing with the kernels (`delone-check`): this is the twin that runs under any
//! kernel.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a vertex on the edge's line | no candidate | `every_segment_of_a_grid_can_be_inserted` |
//! | a segment along the triangle's side, or ending there | does not meet the open triangle | `every_segment_of_a_grid_can_be_inserted` |
//! | vertices in line on the hull | its edges join neighbours | `chew_agrees_on_small_grids` |

use std::collections::BTreeSet;

use delone_mesh::VertexId;
use delone_predicates::{Kernel, Side, Sign};

type Edge = [VertexId; 2];

/// The cells of the CDT of vertices 0 to `count - 1`, which span the plane; flat, three corners each.
pub(crate) fn wrap(
    kernel: &impl Kernel<2>,
    count: usize,
    subsegments: &[[u32; 2]],
) -> Vec<VertexId> {
    let vertices: Vec<VertexId> = (0..count).map(VertexId::new).collect();
    let segments: Vec<Edge> =
        subsegments.iter().map(|ends| ends.map(|site| VertexId::new(site as usize))).collect();
    let mut open: Vec<Edge> = hull(kernel, &vertices);
    let hull: BTreeSet<Edge> = open.iter().copied().collect();
    let mut covered: BTreeSet<Edge> = BTreeSet::new();
    let mut cells = Vec::new();
    // Each edge is opened at most once from each side.
    while let Some([a, b]) = open.pop() {
        if covered.contains(&[a, b]) {
            continue;
        }
        let c = apex(kernel, &vertices, &segments, [a, b]);
        cells.extend([a, b, c]);
        for [u, v] in [[a, b], [b, c], [c, a]] {
            assert!(covered.insert([u, v]), "each side of an edge has one triangle");
            if !hull.contains(&[u, v]) {
                open.push([v, u]);
            }
        }
    }
    cells
}

/// The edges of the hull with all other vertices on the left, or in line and beyond the ends.
fn hull(kernel: &impl Kernel<2>, vertices: &[VertexId]) -> Vec<Edge> {
    let is_between = |[a, b]: Edge, v| {
        let before = |p, q| kernel.compare_lexicographic(p, q).is_lt();
        (before(a, v) && before(v, b)) || (before(b, v) && before(v, a))
    };
    let fits = |edge: Edge, v: VertexId| {
        edge.contains(&v)
            || match kernel.orient(&[edge[0], edge[1], v]) {
                Sign::Positive => true,
                Sign::Zero => !is_between(edge, v),
                Sign::Negative => false,
            }
    };
    let pairs = vertices.iter().flat_map(|&a| vertices.iter().map(move |&b| [a, b]));
    pairs.filter(|&[a, b]| a != b && vertices.iter().all(|&v| fits([a, b], v))).collect()
}

/// The apex of the triangle on the left of an edge.
fn apex(
    kernel: &impl Kernel<2>,
    vertices: &[VertexId],
    segments: &[Edge],
    [a, b]: Edge,
) -> VertexId {
    let is_candidate = |c: VertexId| {
        kernel.orient(&[a, b, c]) == Sign::Positive
            && segments.iter().all(|&segment| !meets(kernel, segment, [a, b, c]))
    };
    let candidates = vertices.iter().copied().filter(|&c| c != a && c != b && is_candidate(c));
    let best = candidates.reduce(|best, c| match kernel.in_sphere(&[a, b, best], c) {
        Side::Positive => c,
        Side::Negative => best,
    });
    best.expect("an edge that is not the hull's, from this side, has a triangle")
}

/// Whether a segment meets an open triangle: neither a side's line nor its own separates the two.
fn meets(kernel: &impl Kernel<2>, [s, e]: Edge, triangle: [VertexId; 3]) -> bool {
    let sign = |u, v, w| if w == u || w == v { Sign::Zero } else { kernel.orient(&[u, v, w]) };
    let [a, b, c] = triangle;
    let is_beyond = |[u, v]: Edge| [s, e].iter().all(|&w| sign(u, v, w) != Sign::Positive);
    let is_aside = |side: Sign| triangle.iter().all(|&w| sign(s, e, w) != side);
    let separated = [[a, b], [b, c], [c, a]].into_iter().any(is_beyond)
        || is_aside(Sign::Positive)
        || is_aside(Sign::Negative);
    !separated
}
