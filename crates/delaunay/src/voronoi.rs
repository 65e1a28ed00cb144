//! The dual of a Delaunay or regular mesh: Voronoi's diagram, or the power diagram, with exact vertices.
//!
//! ```text
//!         \     |     /           A solid cell is dual to the center of its sphere, a facet between two solid cells to
//!       s  v----v  s /            the segment between their centers, a hull facet to a ray, straight away from the hull;
//!         /  s   \  /             a vertex to the region of all that is nearest to it (with weights: of least power).
//!        v--------v               Cells of one sphere have one center: an edge may have length zero, by ties alone.
//! ```
//!
//! **Paper.** [Bow81] computes the diagram as the dual of the mesh; with weights [ES96]. **In.** A mesh of full dimension.
//! **Out.** Which cells make up a region, an edge: handles of the mesh. Positions: rational numbers, exact.
//! **Cost.** O(n) to begin; O(D^4) products of big integers for each vertex, when asked for.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | cospherical sites | vertices that are equal, exactly | `a_square_has_one_vertex_twice` |
//! | a site on the hull | an unbounded region, between two ghosts | `regions_of_the_hull_are_unbounded` |
//! | a hidden site | no region | `a_hidden_site_has_no_region` |
//! | all sites in a flat of lower dimension | no diagram | `flat_sites_have_no_diagram` |

use dashu_int::IBig;
use dashu_int::ops::BitTest;
use delone_mesh::{CellId, FacetId, Mesh, VertexId};
use delone_sites::{Sites, WeightedSites};

use crate::numbers::{ExactPoint, determinant, integer, orthocenter, unit};
use crate::{Delaunay, Regular};

/// A Voronoi or power diagram, read off a mesh. See the module's text.
///
/// ```
/// use delone_delaunay::{Options, PowerDiagram, delaunay};
/// use delone_sites::Sites;
///
/// let sites = Sites::new(&[[0.0, 0.0], [4.0, 0.0], [0.0, 2.0]]).unwrap();
/// let triangulation = delaunay(&sites, &Options::default(), &mut ());
/// let diagram = PowerDiagram::of_delaunay(&triangulation, &sites).unwrap();
/// let cell = triangulation.cells().next().unwrap();
/// assert_eq!(diagram.vertex(cell).rounded(), [2.0, 1.0]);
/// ```
#[derive(Clone, Debug)]
pub struct PowerDiagram<'a, const D: usize> {
    mesh: &'a Mesh<D>,
    points: &'a [[f64; D]],
    /// One for each point; none if all are equal.
    weights: &'a [f64],
    cells: Vec<Option<CellId>>,
}

/// The dual of a facet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dual {
    /// The segment between the vertices of two solid cells.
    Segment([CellId; 2]),
    /// The ray from the vertex of a solid cell, across the facet that this ghost cell has on the hull.
    Ray {
        /// Where it starts.
        from: CellId,
        /// Where it goes.
        ghost: CellId,
    },
}

/// The region of a site in the plane: the cells around it, counter-clockwise, whose vertices are its corners.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Region {
    /// All cells around the site are solid.
    Bounded(Vec<CellId>),
    /// The solid cells, between the ghosts across which the first and the last ray go.
    Unbounded {
        /// The ghost before the first cell.
        first: CellId,
        /// The solid cells.
        cells: Vec<CellId>,
        /// The ghost after the last cell.
        last: CellId,
    },
}

impl<'a, const D: usize> PowerDiagram<'a, D> {
    /// Voronoi's diagram; `None` if the sites lie in a flat of lower dimension.
    #[must_use]
    pub fn of_delaunay(delaunay: &'a Delaunay<D>, sites: &'a Sites<D>) -> Option<Self> {
        Self::new(delaunay.mesh(), sites.points(), &[])
    }

    /// The power diagram; `None` if the sites lie in a flat of lower dimension.
    #[must_use]
    pub fn of_regular(regular: &'a Regular<D>, sites: &'a WeightedSites<D>) -> Option<Self> {
        Self::new(regular.mesh(), sites.sites().points(), sites.weights())
    }

    fn new(mesh: &'a Mesh<D>, points: &'a [[f64; D]], weights: &'a [f64]) -> Option<Self> {
        let cells = mesh.cells_by_vertex(points.len());
        (mesh.dimension() == Some(D)).then_some(Self { mesh, points, weights, cells })
    }

    /// The vertex that is dual to a solid cell: the center of its circumsphere; with weights, of its orthosphere.
    ///
    /// # Panics
    /// If the cell is a ghost.
    #[must_use]
    pub fn vertex(&self, cell: CellId) -> ExactPoint<D> {
        assert!(!self.mesh.is_ghost(cell), "a ghost cell has no center");
        let corners = self.mesh.corners(cell);
        let points: Vec<[f64; D]> = corners.iter().map(|v| self.points[v.index()]).collect();
        let weight = |v: &VertexId| self.weights.get(v.index()).copied();
        let weights: Vec<f64> = corners.iter().filter_map(weight).collect();
        orthocenter(&points, &weights)
    }

    /// The edges of the diagram: the duals of the mesh's facets but for those of two ghosts, by index.
    pub fn edges(&self) -> impl Iterator<Item = (FacetId<D>, Dual)> + Clone + '_ {
        let facets = self.mesh.solid_cells().flat_map(|cell| self.mesh.facets(cell));
        facets.filter_map(|facet| {
            let (from, twin) = (facet.cell(), self.mesh.twin(facet));
            if self.mesh.is_ghost(twin.cell()) {
                return Some((facet, Dual::Ray { from, ghost: twin.cell() }));
            }
            (facet < twin).then_some((facet, Dual::Segment([from, twin.cell()])))
        })
    }

    /// The direction of the ray across a ghost cell's facet: its normal, away from the hull, exact up to a factor.
    ///
    /// # Panics
    /// If the cell is solid.
    #[must_use]
    pub fn direction(&self, ghost: CellId) -> [IBig; D] {
        let corner = self.mesh.corner_of(ghost, VertexId::GHOST);
        let inner = self.mesh.apex(self.mesh.twin(FacetId::new(ghost, corner)));
        let facet = self.mesh.corners(ghost).iter().filter(|v| !v.is_ghost());
        let points: Vec<[f64; D]> = facet.chain([&inner]).map(|v| self.points[v.index()]).collect();
        let unit = unit(points.iter().flatten().copied());
        let row = |p: &[f64; D]| -> Vec<IBig> {
            (0..D).map(|axis| integer(p[axis], unit) - integer(points[0][axis], unit)).collect()
        };
        let (inside, facet) = (row(&points[D]), &points[1..D]);
        // Component i of the normal is the determinant with the i-th unit vector for last row.
        let with = |last: Vec<IBig>| determinant(facet.iter().map(row).chain([last]).collect());
        let outward = if with(inside) > IBig::ZERO { -1 } else { 1 };
        std::array::from_fn(|axis| {
            let axis_vector = (0..D).map(|i| IBig::from(u8::from(i == axis)));
            with(axis_vector.collect()) * outward
        })
    }

    /// The same in doubles, of length about 1, to be drawn.
    ///
    /// # Panics
    /// If the cell is solid.
    #[must_use]
    pub fn direction_rounded(&self, ghost: CellId) -> [f64; D] {
        let numerators = self.direction(ghost);
        let bits = numerators.iter().map(BitTest::bit_len).max().unwrap_or(0);
        let exponent = -i32::try_from(bits).expect("fewer than 2^31 bits");
        ExactPoint { numerators, denominator: IBig::ONE, exponent }.rounded()
    }
}

impl PowerDiagram<'_, 2> {
    /// The region of a site; `None` if it is hidden, or there is no such site.
    #[must_use]
    pub fn region(&self, site: u32) -> Option<Region> {
        let cell = (*self.cells.get(site as usize)?)?;
        let ring = self.mesh.ring(VertexId::new(site as usize), cell);
        let mut cells: Vec<CellId> = ring.map(FacetId::cell).collect();
        // The two ghosts of a site on the hull are neighbours in the ring.
        let Some(ghost) = cells.iter().position(|&cell| self.mesh.is_ghost(cell)) else {
            return Some(Region::Bounded(cells));
        };
        let after = cells[(ghost + 1) % cells.len()];
        let first = if self.mesh.is_ghost(after) { ghost + 1 } else { ghost };
        let count = cells.len();
        cells.rotate_left(first % count);
        let last = cells.pop()?;
        Some(Region::Unbounded { first: cells.remove(0), cells, last })
    }

    /// The part of a site's region in a window, from its low to its high corner: a convex polygon, counter-clockwise, in
    /// doubles, to be drawn. Empty if there is none.
    #[must_use]
    pub fn polygon(&self, site: u32, [low, high]: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
        let Some(Some(cell)) = self.cells.get(site as usize) else { return Vec::new() };
        let s = self.points[site as usize];
        let weigh = |v: usize| self.weights.get(v).copied().unwrap_or(0.0);
        let mut polygon = vec![low, [high[0], low[1]], high, [low[0], high[1]]];
        for spoke in self.mesh.ring(VertexId::new(site as usize), *cell) {
            let neighbour = self.mesh.destination(spoke);
            if neighbour.is_ghost() {
                continue;
            }
            let n = self.points[neighbour.index()];
            let d = [n[0] - s[0], n[1] - s[1]];
            let offset =
                (d[0] * d[0] + d[1] * d[1] - weigh(neighbour.index()) + weigh(site as usize)) / 2.0;
            // Positive beyond the bisector.
            polygon = clipped(&polygon, |p| d[0] * (p[0] - s[0]) + d[1] * (p[1] - s[1]) - offset);
        }
        polygon
    }
}

/// The part of a convex polygon where `beyond` is not positive.
fn clipped(polygon: &[[f64; 2]], beyond: impl Fn([f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        let (at_p, at_q) = (beyond(p), beyond(q));
        if at_p <= 0.0 {
            kept.push(p);
        }
        if (at_p < 0.0 && at_q > 0.0) || (at_p > 0.0 && at_q < 0.0) {
            let t = at_p / (at_p - at_q);
            kept.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
        }
    }
    kept
}

#[cfg(test)]
mod tests;
