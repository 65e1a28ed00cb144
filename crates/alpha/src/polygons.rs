//! The boundary of a shape of the plane as rings: outer ones and holes, and what bounds nothing.
//!
//! ```text
//!      .---.---.        Edges with one of their triangles in, that triangle on the left. At a vertex where wedges of triangles
//!       \ / \ /         touch, each ring turns through the triangles of its own wedge: rings meet there, and do not cross.
//!        v   .          Through a wedge: from the edge that comes in to v, clockwise over the triangles that are in, to the edge
//!       / \             that leaves.
//!      .---.
//! ```
//!
//! **Paper.** [EM94] for the shape; the walk is that of the half-edges of a mesh.
//! **In.** A filtration of the plane and a cut. **Out.** Rings by components of triangles, which hang together across edges.
//! **Invariants.** 1. Each regular edge is in one ring, once. 2. A component has one outer ring, counter-clockwise; its other rings
//! are holes, clockwise. 3. Each ring begins at its least vertex, and rings are sorted.
//! **Cost.** O(N).
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | triangles that touch at a vertex alone | components of their own | `wedges_that_touch_are_apart` |
//! | a hole that touches the outer ring, or itself, at a vertex | a ring that passes the vertex more than once | `rings_bound_their_area` |
//! | two lobes of a hole that meet in its least vertex | still a hole | `lobes_of_a_hole_may_meet` |
//! | no triangle | no component; edges and vertices alone are listed | `what_bounds_nothing_is_listed` |
//! | sites in line | no triangle | `what_bounds_nothing_is_listed` |

use delone_predicates::{Kernel, Sign};

use crate::bulk::{Sets, narrow};
use crate::geometry::{Geometry, Site};
use crate::{AlphaFiltration, Cut, SimplexId, Status, VertexConvention};

/// Triangles that hang together, by their boundary.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Region {
    /// The vertices of the outer ring, counter-clockwise.
    pub outer: Vec<u32>,
    /// Those of holes, clockwise.
    pub holes: Vec<Vec<u32>>,
}

/// A shape of the plane. See the module's text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polygons {
    /// The components of triangles.
    pub regions: Vec<Region>,
    /// Edges that are in no triangle.
    pub edges: Vec<[u32; 2]>,
    /// Vertices that are in no edge.
    pub vertices: Vec<u32>,
}

impl Polygons {
    /// The edges that bound the alpha hull, as arcs do there: each with the shape on its left, those in no triangle both ways. The arc
    /// of an edge is the shorter one, on its left, of the circle of the cut's radius through its ends. That circle's disk lies on the
    /// other side and holds no site inside; the hull is what no such disk covers \\[EM94\\]. Without weights.
    #[must_use]
    pub fn hull_arcs(&self) -> Vec<[u32; 2]> {
        let rings = self
            .regions
            .iter()
            .flat_map(|region| std::iter::once(&region.outer).chain(&region.holes));
        let around = rings.flat_map(|ring| {
            let next = ring.iter().cycle().skip(1);
            ring.iter().zip(next).map(|(&a, &b)| [a, b])
        });
        around.chain(self.edges.iter().flat_map(|&[a, b]| [[a, b], [b, a]])).collect()
    }
}

/// The edges of triangles that are in: edge `i` of triangle `t` is `3 t + i`, counter-clockwise, opposite its corner `i`.
struct Sides {
    /// By triangle of the complex, its vertices counter-clockwise.
    corners: Vec<[u32; 3]>,
    /// By side, the same edge in another triangle that is in.
    twins: Vec<Option<u32>>,
}

impl AlphaFiltration<2> {
    /// The boundary of a complex's triangles, and the simplices that are in none.
    ///
    /// ```
    /// use delone_alpha::{AlphaFiltration, AlphaParam};
    /// use delone_delaunay::{Options, delaunay};
    /// use delone_sites::Sites;
    ///
    /// let sites = Sites::new(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [9.0, 9.0]]).unwrap();
    /// let filtration = AlphaFiltration::of(&sites, &delaunay(&sites, &Options::default(), &mut ()));
    /// let shape = filtration.polygons(filtration.cut(AlphaParam::Radius(1.5)).unwrap());
    /// assert_eq!((&shape.regions[0].outer[..], &shape.vertices[..]), (&[0, 1, 2][..], &[3][..]));
    /// ```
    ///
    /// # Panics
    /// If an invariant of the module's text is broken, which is a bug.
    #[must_use]
    pub fn polygons(&self, cut: Cut) -> Polygons {
        let sides = self.sides(cut);
        let rings = sides.rings();
        let mut components = sides.components();
        let mut of_component: Vec<Option<Region>> = vec![None; sides.corners.len()];
        let mut by_component: Vec<(u32, Vec<u32>)> =
            rings.into_iter().map(|(triangle, ring)| (components.find(triangle), ring)).collect();
        by_component.sort_unstable();
        for of_one in by_component.chunk_by(|a, b| a.0 == b.0) {
            let (outer, holes): (Vec<_>, Vec<_>) =
                of_one.iter().map(|(_, ring)| ring.clone()).partition(|ring| self.is_outer(ring));
            assert_eq!(outer.len(), 1, "Inv 2");
            let outer = outer.into_iter().next().unwrap_or_default();
            of_component[of_one[0].0 as usize] = Some(Region { outer, holes });
        }
        let mut regions: Vec<Region> = of_component.into_iter().flatten().collect();
        regions.sort_unstable();
        let statuses = self.classify(cut, VertexConvention::Em94);
        let singular = |k: usize| {
            let all = self.simplices().of_dimension(k);
            let alone = all.filter(|&id| statuses[id] == Status::Singular);
            alone.map(|id| self.simplices().vertices(SimplexId::new(id)))
        };
        // On a line edges are cells: they are in no triangle, and interior.
        let is_line = self.simplices().dimension() == Some(1);
        let cells =
            self.simplices().of_dimension(1).filter(|&id| is_line && cut.holds(self.ranks()[id]));
        let cells = cells.map(|id| self.simplices().vertices(SimplexId::new(id)));
        let edges = singular(1).chain(cells).map(|ends| [ends[0], ends[1]]).collect();
        let is_point = self.simplices().dimension() == Some(0) && cut.holds(0);
        let point = self.simplices().of_dimension(0).filter(|_| is_point);
        let point = point.map(|id| self.simplices().vertices(SimplexId::new(id)));
        Polygons { regions, edges, vertices: singular(0).chain(point).map(|v| v[0]).collect() }
    }

    fn orient(&self, vertices: [u32; 3]) -> Sign {
        let vertices = vertices.map(Site);
        match self.geometry() {
            Geometry::Plain(kernel) => kernel.orient(&vertices),
            Geometry::Weighted(kernel) => kernel.orient(&vertices),
        }
    }

    /// The triangles that are in, counter-clockwise, with their neighbours.
    fn sides(&self, cut: Cut) -> Sides {
        let simplices = self.simplices();
        let present = |id: usize| simplices.dimension() == Some(2) && cut.holds(self.ranks()[id]);
        let mut corners = Vec::new();
        let mut first_side = vec![None; simplices.of_dimension(1).len()];
        let mut twins = Vec::new();
        let start = simplices.of_dimension(1).start;
        for id in simplices.of_dimension(2).filter(|&id| present(id)) {
            let triangle = SimplexId::new(id);
            let (&[a, b, c], &[e, f, g]) =
                (simplices.vertices(triangle), simplices.facets(triangle))
            else {
                panic!("a triangle has three corners");
            };
            let is_positive = self.orient([a, b, c]) == Sign::Positive;
            corners.push(if is_positive { [a, b, c] } else { [a, c, b] });
            for edge in if is_positive { [e, f, g] } else { [e, g, f] } {
                let side = narrow(twins.len());
                let first: &mut Option<u32> = &mut first_side[edge as usize - start];
                twins.push(*first);
                if let Some(other) = *first {
                    twins[other as usize] = Some(side);
                }
                *first = Some(side);
            }
        }
        Sides { corners, twins }
    }

    /// Whether a ring is an outer one: it turns left at its lexicographically least vertex, each time it passes. A hole turns right
    /// there, at least once: where two lobes of it meet in that vertex, the wedge between the lobes makes a left turn.
    fn is_outer(&self, ring: &[u32]) -> bool {
        let compare = |a: u32, b: u32| match self.geometry() {
            Geometry::Plain(kernel) => kernel.compare_lexicographic(Site(a), Site(b)),
            Geometry::Weighted(kernel) => kernel.compare_lexicographic(Site(a), Site(b)),
        };
        let n = ring.len();
        let least = ring.iter().copied().min_by(|&a, &b| compare(a, b));
        let mut passes = (0..n).filter(|&i| Some(ring[i]) == least);
        passes.all(|i| {
            self.orient([ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]]) == Sign::Positive
        })
    }
}

impl Sides {
    /// The side after this one around its triangle.
    fn next(side: u32) -> u32 {
        side - side % 3 + (side % 3 + 1) % 3
    }

    /// The vertex that a side leaves: side i is opposite corner i, and runs from corner i + 1.
    fn origin(&self, side: u32) -> u32 {
        self.corners[side as usize / 3][(side as usize + 1) % 3]
    }

    /// The side of the boundary that follows one of it: through the triangles at its end.
    fn follow(&self, side: u32) -> u32 {
        let mut next = Self::next(side);
        for _ in 0..=self.twins.len() {
            match self.twins[next as usize] {
                None => return next,
                Some(twin) => next = Self::next(twin),
            }
        }
        panic!("a fan of triangles that a boundary side is in ends at another");
    }

    /// The rings, each from its least vertex on, with a triangle of it.
    fn rings(&self) -> Vec<(u32, Vec<u32>)> {
        let mut is_done = vec![false; self.twins.len()];
        let mut rings = Vec::new();
        for start in 0..narrow(self.twins.len()) {
            if is_done[start as usize] || self.twins[start as usize].is_some() {
                continue;
            }
            let (mut ring, mut side) = (Vec::new(), start);
            while !is_done[side as usize] {
                is_done[side as usize] = true; // Inv 1
                ring.push(self.origin(side));
                side = self.follow(side);
            }
            assert_eq!(side, start, "Inv 1: rings close where they began");
            let least = (0..ring.len()).min_by_key(|&i| {
                // Of several passes the one that goes on to the least vertex.
                (ring[i], ring[(i + 1) % ring.len()])
            });
            ring.rotate_left(least.unwrap_or(0));
            rings.push((start / 3, ring));
        }
        rings
    }

    /// Triangles that share sides.
    fn components(&self) -> Sets {
        let mut sets = Sets::new(self.corners.len());
        for (side, twin) in (0u32..).zip(&self.twins) {
            let Some(twin) = twin else { continue };
            let (a, b) = (sets.find(side / 3), sets.find(twin / 3));
            if a != b {
                sets.unite(a, b);
            }
        }
        sets
    }
}

#[cfg(test)]
mod tests;
