//! Sibson's natural neighbour coordinates in the plane.
//!
//! ```text
//!      a---------b           If q came as a site, its region would take a piece from each of its neighbours' regions:
//!      |\  ..   /|           the piece's share of q's region is the neighbour's coordinate. The shares are positive, add
//!      | . q.  . |           up to 1, and the neighbours' mean with these weights is q (local coordinates property).
//!      |/  ..   \|
//!      d---------c
//! ```
//!
//! **Paper.** [Sib80]. **In.** The Delaunay triangulation of some sites; points. **Out.** For each point its neighbours with
//! their coordinates. *Who* is a neighbour is decided exactly, by the cavity that the point would dig; the coordinates
//! are areas in doubles, relative to the point, and as good as these: no bound on their error is promised.
//! **Cost.** A walk, and O(1) for each cell of the cavity.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | the point is a site | that site, 1 | `sites_and_hull_edges` |
//! | the point is on a hull edge | its ends, linearly: the limit from inside | `sites_and_hull_edges` |
//! | the point is outside the hull | nothing | `outside_there_is_nothing` |
//! | cocircular sites | a neighbour whose piece is empty has coordinate 0 | `the_centre_of_a_square` |

use std::num::NonZeroUsize;

use delone_mesh::{Cavity, CellId, HalfEdge, Mesh, VertexId};
use delone_sites::Sites;

use crate::Delaunay;
use crate::conflict::dig_conflicts;
use crate::located::{Hint, LocateError, Located};
use crate::queries::Queries;
use crate::result::id_of;

/// The natural neighbours of each point, with Sibson's coordinates, counter-clockwise; empty for a point outside the hull.
/// On up to `threads` threads, which make no difference.
///
/// ```
/// use std::num::NonZeroUsize;
/// use delone_delaunay::{Options, delaunay, natural_neighbours};
/// use delone_sites::Sites;
///
/// let sites = Sites::new(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]).unwrap();
/// let triangulation = delaunay(&sites, &Options::default(), &mut ());
/// let found =
///     natural_neighbours(&triangulation, &sites, &[[2.0, 2.0]], NonZeroUsize::MIN).unwrap();
/// assert_eq!(found[0].len(), 4);
/// assert!(found[0].iter().all(|&(_, share)| share == 0.25));
/// ```
///
/// # Errors
/// If a coordinate is not finite, or the sites lie in a line.
pub fn natural_neighbours(
    delaunay: &Delaunay<2>,
    sites: &Sites<2>,
    points: &[[f64; 2]],
    threads: NonZeroUsize,
) -> Result<Vec<Vec<(u32, f64)>>, LocateError> {
    let mesh = delaunay.mesh();
    if mesh.dimension() != Some(2) {
        return Err(LocateError::Flat(mesh.dimension()));
    }
    let queries = Queries::new(sites, points).map_err(LocateError::Points)?;
    Ok(queries.answer(threads, |queries, (hint, cavity): &mut (Hint, Cavity<2>), query| {
        let (q, p) = queries.get(query);
        let from = |v: VertexId| {
            let at = sites.points()[v.index()];
            [at[0] - q[0], at[1] - q[1]]
        };
        let seed = match hint.locate(mesh, &queries.kernel, p) {
            Located::Vertex(v) => return vec![(id_of(v), 1.0)],
            Located::Ghost(_) => return Vec::new(),
            Located::Facet(h) if is_on_hull(mesh, h) => return on_edge(mesh, h, from),
            Located::Facet(h) => h.cell(),
            Located::Cell(cell) | Located::Face { cell, .. } => cell,
        };
        dig_conflicts(mesh, &queries.kernel, seed, p, cavity, &mut ());
        shares(mesh, cavity, from)
    }))
}

fn is_on_hull(mesh: &Mesh<2>, h: HalfEdge) -> bool {
    mesh.is_ghost(h.cell()) || mesh.is_ghost(mesh.twin(h).cell())
}

/// The ends of the edge that the origin lies on.
fn on_edge(mesh: &Mesh<2>, h: HalfEdge, from: impl Fn(VertexId) -> [f64; 2]) -> Vec<(u32, f64)> {
    let (a, b) = (mesh.origin(h), mesh.destination(h));
    let length = |[x, y]: [f64; 2]| x.hypot(y);
    let (to_a, to_b) = (length(from(a)), length(from(b)));
    vec![(id_of(a), to_b / (to_a + to_b)), (id_of(b), to_a / (to_a + to_b))]
}

/// The neighbours with their shares; the cavity holds no ghost, and the origin, which digs it, is inside.
fn shares(
    mesh: &Mesh<2>,
    cavity: &Cavity<2>,
    from: impl Fn(VertexId) -> [f64; 2],
) -> Vec<(u32, f64)> {
    let rim = in_turn(mesh, cavity);
    // New corners of the diagram: the centers of the origin and two neighbours.
    let corner = |&h: &HalfEdge| center(from(mesh.origin(h)), from(mesh.destination(h)));
    let corners: Vec<[f64; 2]> = rim.iter().map(corner).collect();
    let mut found = Vec::with_capacity(rim.len());
    for (i, &h) in rim.iter().enumerate() {
        let before = corners[(i + rim.len() - 1) % rim.len()];
        let mut piece = vec![corners[i]];
        piece.extend(cells_around(mesh, cavity, h).map(|cell| {
            let [a, b, c] = [0, 1, 2].map(|corner| from(mesh.vertex(cell, corner)));
            let [x, y] = center([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
            [x + a[0], y + a[1]]
        }));
        piece.push(before);
        found.push((id_of(mesh.origin(h)), area(&piece)));
    }
    let whole: f64 = found.iter().map(|&(_, area)| area).sum();
    found.into_iter().map(|(site, area)| (site, area / whole)).collect()
}

/// The rim, counter-clockwise, seen from inside.
fn in_turn(mesh: &Mesh<2>, cavity: &Cavity<2>) -> Vec<HalfEdge> {
    let mut rim: Vec<(VertexId, HalfEdge)> = cavity.rim().map(|h| (mesh.origin(h), h)).collect();
    rim.sort_unstable();
    let mut ordered = vec![rim[0].1];
    while ordered.len() < rim.len() {
        let end = mesh.destination(ordered[ordered.len() - 1]);
        let next = rim.binary_search_by_key(&end, |&(origin, _)| origin);
        ordered.push(rim[next.expect("the rim is one cycle")].1);
    }
    ordered
}

/// The cells of the cavity around the origin of the rim edge `h`, counter-clockwise from the one at `h`.
fn cells_around<'a>(
    mesh: &'a Mesh<2>,
    cavity: &'a Cavity<2>,
    h: HalfEdge,
) -> impl Iterator<Item = CellId> + 'a {
    let ring = mesh.ring(mesh.origin(h), h.cell());
    ring.map(HalfEdge::cell).take_while(|&cell| cavity.holds(cell))
}

/// The center of the circle through the origin, `a` and `b`.
fn center(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    let (aa, bb) = (a[0] * a[0] + a[1] * a[1], b[0] * b[0] + b[1] * b[1]);
    let d = 2.0 * (a[0] * b[1] - a[1] * b[0]);
    [(b[1] * aa - a[1] * bb) / d, (a[0] * bb - b[0] * aa) / d]
}

/// Twice the area of a polygon, positive if it turns clockwise.
fn area(polygon: &[[f64; 2]]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(p, q)| p[1] * q[0] - p[0] * q[1]).sum()
}

#[cfg(test)]
mod tests;
