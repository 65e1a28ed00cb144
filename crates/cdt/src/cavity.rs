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
//! **In.** Segments and the Delaunay mesh of the sites. Segments that are not noded are noded on the way: a piece ends where
//! the walk comes upon a site, and a crossing shows as a constrained edge in the way. **Out.** The constrained Delaunay mesh,
//! which of its half-edges are constrained, and the pieces; or that segments cross.
//! **Invariants.** 1. After each piece the mesh is the CDT of the sites and the pieces so far. 2. [`insert_segments`] is given a
//! noded PSLG: no site is inside a subsegment, and no subsegment crosses another.
//! **Cost.** Expected O(1) for each edge crossed, and the lower of the degrees of the segment's ends.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | the segment is an edge already | marked | `an_edge_that_is_there_is_only_marked` |
//! | an edge with both triangles crossed, itself not | comes twice in a chain, its new triangles are glued to each other | `a_dangling_edge_is_triangulated_on_both_sides` |
//! | all sites in line | the mesh is a chain, its cells are the edges | `a_chain_has_its_segments` |
//! | a site inside the segment | the piece ends there | `every_soup_of_a_grid_is_noded_on_the_way` |
//! | pieces of several segments are one | the edge is there when the later comes | `every_soup_of_a_grid_is_noded_on_the_way` |
//! | segments cross | nothing is returned | `every_soup_of_a_grid_is_noded_on_the_way` |

use delone_mesh::{CellId, HalfEdge, Mesh, VertexId};
use delone_predicates::{PlaneKernel, Sign};
use delone_probe::{Event, Probe};
use delone_sites::{Piece, scatter};

use crate::fill::{Beyond, Filler};

mod present;

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
    let present = work.mark_present(sites, subsegments, probe);
    for (random, number) in in_random_order(&present) {
        let ends = subsegments[number].map(|site| VertexId::new(site as usize));
        if let Err([a, b]) = work.mark_edge(ends, probe) {
            let end = work.advance([a, b], random, probe).expect("Inv 2: segments do not cross");
            assert_eq!(end, b, "Inv 2: no site is inside a subsegment");
        }
    }
    work.finish()
}

/// The segments that are not present, in random order, on which the expected cost rests.
fn in_random_order(present: &[bool]) -> Vec<(u64, usize)> {
    let missing = (0..).zip(present).filter(|&(_, &present)| !present);
    let mut missing: Vec<(u64, usize)> =
        missing.map(|(number, _)| (scatter(number as u64), number)).collect();
    missing.sort_unstable();
    missing
}

/// Two segments cross.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Crossed;

/// What [`node_and_insert`] makes: the mesh, which half-edges are constrained, the pieces of the segments.
pub(crate) type Noded = (Mesh<2>, Vec<bool>, Vec<Piece>);

/// [`insert_segments`] for segments between sites that are not noded. Those of no length have no pieces.
pub(crate) fn node_and_insert(
    mesh: Mesh<2>,
    kernel: &impl PlaneKernel,
    sites: usize,
    segments: &[[u32; 2]],
    probe: &mut impl Probe,
) -> Result<Noded, Crossed> {
    let mut work = Work::new(mesh, kernel, sites);
    let present = work.mark_present(sites, segments, probe);
    let whole = (0u32..).zip(segments).zip(&present).filter(|(_, present)| **present);
    let mut pieces: Vec<Piece> =
        whole.map(|((segment, &ends), _)| Piece::new(ends, segment, 0)).collect();
    let mut stops = Vec::new();
    for (random, number) in in_random_order(&present) {
        let ends = segments[number].map(|site| VertexId::new(site as usize));
        if ends[0] == ends[1] {
            continue;
        }
        work.insert(ends, random, &mut stops, probe)?;
        let segment = u32::try_from(number).expect("segments are fewer than ids");
        let stops = (0u32..).zip(stops.windows(2));
        pieces.extend(
            stops.map(|(place, ends)| Piece::new([id(ends[0]), id(ends[1])], segment, place)),
        );
    }
    let (mesh, constrained) = work.finish();
    Ok((mesh, constrained, pieces))
}

fn id(v: VertexId) -> u32 {
    u32::try_from(v.index()).expect("a site's id fits 32 bits")
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

    /// Inserts a segment, from its end of lower degree. `stops`: the sites on it from its first end to its second.
    fn insert(
        &mut self,
        ends: Ends,
        random: u64,
        stops: &mut Vec<VertexId>,
        probe: &mut impl Probe,
    ) -> Result<(), Crossed> {
        stops.clear();
        let Err([a, b]) = self.mark_edge(ends, probe) else {
            stops.extend(ends);
            return Ok(());
        };
        stops.push(a);
        let mut from = a;
        while from != b {
            from = self.advance([from, b], random, probe)?;
            stops.push(from);
        }
        if a != ends[0] {
            stops.reverse();
        }
        Ok(())
    }

    /// Makes the first piece of the segment from `a` to `b` a constrained edge: as far as `b`, or the first site inside the
    /// segment. Returns where it ends.
    fn advance(
        &mut self,
        [a, b]: Ends,
        random: u64,
        probe: &mut impl Probe,
    ) -> Result<VertexId, Crossed> {
        let crossed = match way(&self.mesh, self.kernel, self.cell_of[a.index()], [a, b], probe) {
            Way::Along(h) => {
                self.mark(h);
                probe.on(Event::Subsegment);
                return Ok(self.mesh.destination(h));
            }
            Way::Across(h) => h,
        };
        let end = self.dig_along(crossed, [a, b], probe)?;
        self.replaced.clear();
        let lower = std::mem::take(&mut self.lower);
        let below = self.fill(&lower, end, random, probe);
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
        Ok(end)
    }

    /// Collects all triangles that the segment crosses from `a`, where it leaves through `crossed`, to the next site on it,
    /// which is returned; and the two chains between these sites.
    fn dig_along(
        &mut self,
        mut crossed: HalfEdge,
        [a, b]: Ends,
        probe: &mut impl Probe,
    ) -> Result<VertexId, Crossed> {
        self.dug.clear();
        self.dug.push(crossed.cell());
        self.lower.clear();
        self.upper.clear();
        self.lower.push(self.mesh.prev(crossed));
        self.upper.push(self.mesh.next(crossed));
        loop {
            if self.constrained[crossed.index()] {
                return Err(Crossed);
            }
            probe.on(Event::EdgeCrossed);
            let h = self.mesh.twin(crossed);
            let x = self.mesh.apex(h);
            assert!(!x.is_ghost(), "a segment stays inside the hull");
            self.dug.push(h.cell());
            let (right, left) = (self.mesh.next(h), self.mesh.prev(h)); // r to x, x to l
            let side = if x == b {
                Sign::Zero
            } else {
                probe.on(Event::Orient);
                self.kernel.orient(&[a, b, x])
            };
            match side {
                Sign::Positive => {
                    self.upper.push(left);
                    crossed = right;
                }
                Sign::Negative => {
                    self.lower.push(right);
                    crossed = left;
                }
                Sign::Zero => {
                    self.lower.push(right);
                    self.upper.push(left);
                    return Ok(x);
                }
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

/// How a segment leaves its first end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// Along this half-edge, whose destination is on it.
    Along(HalfEdge),
    /// Through the inside of this half-edge, which is opposite the end.
    Across(HalfEdge),
}

/// How the segment from `a`, which `cell` has, to `b` leaves `a`.
fn way(
    mesh: &Mesh<2>,
    kernel: &impl PlaneKernel,
    cell: CellId,
    [a, b]: Ends,
    probe: &mut impl Probe,
) -> Way {
    let [from, to] = [a, b].map(VertexId::index);
    for h in mesh.ring(a, cell) {
        let (r, l) = (mesh.destination(h), mesh.apex(h));
        if r == b {
            return Way::Along(h);
        }
        if r.is_ghost() {
            continue;
        }
        probe.on(Event::Orient);
        match kernel.orient(&[a, b, r]) {
            Sign::Positive => {}
            Sign::Zero => {
                let ahead = kernel.compare_lexicographic(from, r.index());
                if ahead == kernel.compare_lexicographic(from, to) {
                    return Way::Along(h);
                }
            }
            Sign::Negative if l.is_ghost() || l == b => {}
            Sign::Negative => {
                probe.on(Event::Orient);
                if kernel.orient(&[a, b, l]) == Sign::Positive {
                    return Way::Across(mesh.next(h));
                }
            }
        }
    }
    panic!("a segment stays inside the hull, and leaves {a:?} along an edge or through one");
}

/// The half-edge opposite `a`, which `cell` has, through which the segment to `b` leaves a's star.
///
/// # Panics
/// If it does not leave through the inside of an edge.
pub(crate) fn way_out(
    mesh: &Mesh<2>,
    kernel: &impl PlaneKernel,
    cell: CellId,
    ends: Ends,
    probe: &mut impl Probe,
) -> HalfEdge {
    match way(mesh, kernel, cell, ends, probe) {
        Way::Across(h) => h,
        Way::Along(_) => {
            panic!("Inv 2: a segment that is no edge leaves its end through a triangle")
        }
    }
}
