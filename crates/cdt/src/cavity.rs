//! Segment insertion by cavity: Delaunay first, then one segment after the other.
//!
//! ```text
//!        .---l---.                .---l---.       The triangles that the open segment ab crosses are removed. Their
//!       / \ / \ / \              / . / \ . \      boundary falls into an upper and a lower chain from a to b; each is
//!      a---/---\---b     ->     a-----------b     triangulated for itself, and the two sides meet in ab.
//!       \ / \ / \ /              \ . \ / . /
//!        .---r---.                .---r---.
//! ```
//!
//! **Paper.** [SB15]; walking along the segment as in [Ang97].
//! **In.** A noded PSLG and the Delaunay mesh of its sites. **Out.** The constrained Delaunay mesh, and which of its
//! half-edges are constrained.
//! **Invariants.** 1. After each segment the mesh is the CDT of the sites and the segments so far. 2. The PSLG is noded:
//! no site is inside a subsegment, and no subsegment crosses another.
//! **Cost.** Expected O(1) for each edge crossed, and the lower of the degrees of the segment's ends.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | the segment is an edge already | marked | `an_edge_that_is_there_is_only_marked` |
//! | an edge with both triangles crossed, itself not | comes twice in a chain, its new triangles are glued to each other | `a_dangling_edge_is_triangulated_on_both_sides` |
//! | all sites in line | the mesh is a chain, its cells are the edges | `a_chain_has_its_segments` |

use delone_mesh::{CellId, HalfEdge, Mesh, VertexId};
use delone_predicates::{PlaneKernel, Sign};
use delone_probe::{Event, Probe};
use delone_sites::scatter;

use crate::fill::{Beyond, Filler};

/// Inserts the subsegments of a noded PSLG into the Delaunay mesh of its sites. See the module's text.
///
/// Returns the mesh and, for each half-edge by index, whether it is constrained.
///
/// # Panics
/// If the PSLG is not noded, or the mesh is not the Delaunay mesh of its sites, of dimension 2.
pub fn insert_segments(
    mesh: Mesh<2>,
    kernel: &impl PlaneKernel,
    sites: usize,
    subsegments: &[[u32; 2]],
    probe: &mut impl Probe,
) -> (Mesh<2>, Vec<bool>) {
    let mut work = Work::new(mesh, kernel, sites);
    let mut missing: Vec<(u64, Ends)> = Vec::new();
    for (number, ends) in (0u64..).zip(subsegments) {
        let ends = ends.map(|site| VertexId::new(site as usize));
        if work.mark_edge(ends, probe).is_err() {
            missing.push((scatter(number), ends));
        }
    }
    missing.sort_unstable(); // random order, on which the expected cost rests
    for (random, ends) in missing {
        if let Err([a, b]) = work.mark_edge(ends, probe) {
            work.insert(a, b, random, probe);
        }
    }
    work.finish()
}

/// The two ends of a subsegment.
pub(crate) type Ends = [VertexId; 2];

struct Work<'k, K> {
    mesh: Mesh<2>,
    kernel: &'k K,
    /// A cell of each vertex.
    cell_of: Vec<CellId>,
    /// By half-edge.
    constrained: Vec<bool>,
    /// The cavity: the triangles that the segment crosses.
    dug: Vec<CellId>,
    filler: Filler,
    /// Half-edges of the chains, seen from inside the cavity.
    lower: Vec<HalfEdge>,
    upper: Vec<HalfEdge>,
    polygon: Vec<VertexId>,
    /// Each chain half-edge with the one that takes its place.
    replaced: Vec<(HalfEdge, HalfEdge)>,
}

impl<'k, K: PlaneKernel> Work<'k, K> {
    fn new(mesh: Mesh<2>, kernel: &'k K, sites: usize) -> Self {
        let cell_of = mesh.cells_by_vertex(sites).into_iter();
        let cell_of =
            cell_of.map(|cell| cell.expect("each site is a vertex of the mesh")).collect();
        let constrained = vec![false; 3 * mesh.cell_count()];
        Self {
            mesh,
            kernel,
            cell_of,
            constrained,
            dug: Vec::new(),
            filler: Filler::default(),
            lower: Vec::new(),
            upper: Vec::new(),
            polygon: Vec::new(),
            replaced: Vec::new(),
        }
    }

    fn finish(self) -> (Mesh<2>, Vec<bool>) {
        let Self { mut mesh, mut constrained, .. } = self;
        mesh.compact(|from, to| {
            for corner in 0..3 {
                let [from, to] = [from, to].map(|cell| HalfEdge::new(cell, corner).index());
                constrained[to] = constrained[from];
            }
        });
        constrained.truncate(3 * mesh.cell_count());
        (mesh, constrained)
    }

    fn mark(&mut self, h: HalfEdge) {
        let twin = self.mesh.twin(h);
        self.constrained[h.index()] = true;
        self.constrained[twin.index()] = true;
    }

    /// Marks the edge between `a` and `b` constrained. If there is none: the ends, that of lower degree first.
    fn mark_edge(&mut self, ends: Ends, probe: &mut impl Probe) -> Result<(), Ends> {
        let found = self.find_edge(ends)?;
        self.mark(found);
        probe.on(Event::Subsegment);
        Ok(())
    }

    /// The half-edge between two vertices, turning about both in step: O(the lower of their degrees).
    fn find_edge(&self, [a, b]: Ends) -> Result<HalfEdge, Ends> {
        let mut at_a = self.mesh.ring(a, self.cell_of[a.index()]);
        let mut at_b = self.mesh.ring(b, self.cell_of[b.index()]);
        loop {
            match at_a.next() {
                None => return Err([a, b]),
                Some(h) if self.mesh.destination(h) == b => return Ok(h),
                Some(_) => {}
            }
            match at_b.next() {
                None => return Err([b, a]),
                Some(h) if self.mesh.destination(h) == a => return Ok(h),
                Some(_) => {}
            }
        }
    }

    /// Makes the segment from `a` to `b`, which is no edge, a constrained edge.
    fn insert(&mut self, a: VertexId, b: VertexId, random: u64, probe: &mut impl Probe) {
        self.dig_along(a, b, probe);
        self.replaced.clear();
        let lower = std::mem::take(&mut self.lower);
        let below = self.fill(&lower, b, random, probe);
        self.lower = lower;
        let mut upper = std::mem::take(&mut self.upper);
        upper.reverse();
        let above = self.fill(&upper, a, random, probe);
        self.upper = upper;
        self.glue_chains();
        self.mesh.glue(below, above);
        self.mark(below);
        self.dug.iter().for_each(|&cell| self.mesh.retire(cell));
        probe.on(Event::Cavity { cells: self.dug.len() });
        probe.on(Event::Subsegment);
    }

    /// Digs all triangles that the segment crosses, and collects the two chains from `a` to `b`.
    fn dig_along(&mut self, a: VertexId, b: VertexId, probe: &mut impl Probe) {
        let mut crossed = way_out(&self.mesh, self.kernel, self.cell_of[a.index()], [a, b], probe);
        self.dug.clear();
        self.dug.push(crossed.cell());
        self.lower.clear();
        self.upper.clear();
        self.lower.push(self.mesh.prev(crossed));
        self.upper.push(self.mesh.next(crossed));
        loop {
            assert!(!self.constrained[crossed.index()], "Inv 2: segments do not cross");
            probe.on(Event::EdgeCrossed);
            let h = self.mesh.twin(crossed);
            let x = self.mesh.apex(h);
            assert!(!x.is_ghost(), "Inv 2: a segment stays inside the hull");
            self.dug.push(h.cell());
            let (right, left) = (self.mesh.next(h), self.mesh.prev(h)); // r to x, x to l
            if x == b {
                self.lower.push(right);
                self.upper.push(left);
                return;
            }
            probe.on(Event::Orient);
            match self.kernel.orient(&[a, b, x]) {
                Sign::Positive => {
                    self.upper.push(left);
                    crossed = right;
                }
                Sign::Negative => {
                    self.lower.push(right);
                    crossed = left;
                }
                Sign::Zero => panic!(
                    "Inv 2: no site is inside a subsegment, but {x:?} is between {a:?} and {b:?}"
                ),
            }
        }
    }

    /// Fills the polygon of a chain that ends at `end`; returns the new half-edge along the segment.
    fn fill(
        &mut self,
        chain: &[HalfEdge],
        end: VertexId,
        random: u64,
        probe: &mut impl Probe,
    ) -> HalfEdge {
        self.polygon.clear();
        self.polygon.extend(chain.iter().map(|&h| self.mesh.origin(h)));
        self.polygon.push(end);
        self.filler.fill(self.kernel, &self.polygon, random, probe);
        let triangles = &self.filler.triangles;
        let mut cells: Vec<Option<CellId>> = Vec::with_capacity(triangles.len());
        for triangle in triangles {
            cells.push(triangle.alive.then(|| {
                let corners = triangle.corners.map(|corner| self.polygon[corner]);
                let cell = self.mesh.add_cell(&corners);
                self.constrained
                    .resize(3 * self.mesh.cell_count().max(self.constrained.len() / 3), false);
                corners.iter().for_each(|v| self.cell_of[v.index()] = cell);
                probe.on(Event::CellMade);
                cell
            }));
        }
        let cell_at = |t: usize| cells[t].expect("a triangle beyond one that is alive is alive");
        let mut along = None;
        for (t, triangle) in triangles.iter().enumerate().filter(|(_, triangle)| triangle.alive) {
            for (corner, beyond) in triangle.beyond.into_iter().enumerate() {
                let h = HalfEdge::new(cell_at(t), corner);
                self.constrained[h.index()] = false;
                match beyond {
                    Beyond::Triangle(other, c) => {
                        self.mesh.glue(h, HalfEdge::new(cell_at(other), c))
                    }
                    Beyond::Side(k) => self.replaced.push((chain[k], h)),
                    Beyond::Segment => along = Some(h),
                }
            }
        }
        along.expect("one triangle lies at the segment")
    }

    /// Glues the new half-edges of both chains to what was outside the old ones. An edge that dangles in the cavity is
    /// outside to itself: gluing its first half to the old second one makes it the second's outside in its turn.
    fn glue_chains(&mut self) {
        for &(old, new) in &self.replaced {
            self.constrained[new.index()] = self.constrained[old.index()];
            self.mesh.glue(new, self.mesh.twin(old));
        }
    }
}

/// The half-edge opposite `a`, which `cell` has, through which the segment to `b` leaves a's star.
///
/// # Panics
/// If it does not leave through the inside of an edge.
pub(crate) fn way_out(
    mesh: &Mesh<2>,
    kernel: &impl PlaneKernel,
    cell: CellId,
    [a, b]: Ends,
    probe: &mut impl Probe,
) -> HalfEdge {
    let crossed = mesh.ring(a, cell).find(|&h| {
        let (r, l) = (mesh.destination(h), mesh.apex(h));
        probe.on(Event::Orient);
        !r.is_ghost()
            && !l.is_ghost()
            && kernel.orient(&[a, b, r]) == Sign::Negative
            && kernel.orient(&[a, b, l]) == Sign::Positive
    });
    mesh.next(crossed.expect("Inv 2: a segment that is no edge leaves its end through a triangle"))
}
