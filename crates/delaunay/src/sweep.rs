//! Fortune's sweep in the plane: a line moves to the right, and leaves a finished triangulation behind.
//!
//! ```text
//!     c \  |                  The beach line, arcs of parabolas, is what the line, | , has seen for good; b's arc is between
//!        ) |                  those of a and c. A *site event* puts a site's arc into the arc that is ahead at its height. At a
//!     b (  |      arcs from   *circle event* an arc vanishes: the line touches the circle through a, b and c from the right,
//!        ) |      a up to c   no site is in it, and abc is a triangle.
//!     a /  |
//! ```
//!
//! **Paper.** [For87]. We differ in the structure: where two arcs meet is an edge of which one side is not yet known, and that is
//! what a ghost is. So the beach line *is* the chain of ghosts of a mesh that is whole at every moment: a site event hangs an
//! edge, two ghosts back to back, onto a vertex; a circle event flips the edge to the ghost vertex that two ghosts share. The line's
//! course, the two ends of an edge, the hull at the end need no code of their own.
//! **In.** Sites of the plane, for their order; a [`SweepKernel`] over them. **Out.** The Delaunay mesh under the lexicographic
//! perturbation. [`flip_to_delaunay`] has the last word on ties: it looks at each edge once, and rarely finds one to flip. (Inv 5)
//! **Invariants.** 1. Each ghost is `[upper, lower, GHOST]`: its edge has the lower site's arc below and the upper one's above. 2. The
//! ghosts in the [`Beach`] are those where arcs meet, in the order along the line. (Those along the leftmost sites, if several
//! share the least x, face the other way and are not in it.) 3. With the line between two events no arc is empty: what
//! vanishes at x does so before a site at x comes. 4. Two neighbouring ghosts whose three sites turn right from below to above
//! have their circle event in the queue. Others may be there too: an event counts if its two ghosts still have its sites. 5. Of the events
//! of one circle, whose sites are a polygon, the perturbation wants those triangles that come of adding its sites in lexicographic order: each
//! new one with the two ends of those before. So an event whose last site is earlier goes first, and the last word has nothing to say
//! here. (In another order n cocircular sites cost n^2 / 4 flips.)
//! **Cost.** O(n log n). For each of 100,000 uniform sites 3.6 circle events in the queue, of which 2 make triangles, 12 looks at the
//! beach line, 6 orientations, 3 in_sphere tests. Where sites lie on a lattice or a circle, ties go to exact numbers: the sweep
//! is by far the slowest of the algorithms there, by a factor. Unweighted sites only.
//!
//! **Degeneracies.** (Those of the numbers: `predicates/src/sweep.rs`.)
//! | case | answer | test |
//! |---|---|---|
//! | no site; all sites in line | the empty mesh, a chain | `lines_are_chains` |
//! | several leftmost sites | a chain of ghosts, two by two, before the line moves | `every_subset_of_small_grids_is_swept` |
//! | a site where two arcs meet | it is put into the lower one; the piece above is empty, and vanishes next | `a_site_where_two_arcs_meet_cuts_off_an_empty_arc` |
//! | a site and a circle event on one line | the circle event first | `cocircular_sites_are_swept` |
//! | circle events on one line | those of one circle make its triangulation, others come in any order | `events_of_one_circle_come_in_the_order_of_the_perturbation` |

mod beach;
mod moment;
#[cfg(test)]
mod tests;

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use delone_mesh::{CellId, FacetId, HalfEdge, Mesh, VertexId};
use delone_predicates::{CircleEvent, Kernel, Sign, SweepKernel};
use delone_probe::{Event, Probe};
use delone_sites::Sites;

use crate::flip_to_delaunay;
use beach::Beach;

/// The Delaunay mesh of `sites`, which are the vertices of `kernel`. See the module's text.
///
/// # Panics
/// If the kernel is not over the sites.
pub fn sweep<K: Kernel<2, Reordered: SweepKernel>>(
    kernel: &K,
    sites: &Sites<2>,
    probe: &mut impl Probe,
) -> Mesh<2> {
    let order = sites.sorted();
    let name = |vertex: VertexId| VertexId::new(order[vertex.index()] as usize);
    let kernel = kernel.reordered(order);
    let mut mesh = match order.len() {
        0..=2 => None,
        count => Sweep::start(&kernel, order).run(count, probe),
    }
    .unwrap_or_else(|| Mesh::chain(&(0..order.len()).map(VertexId::new).collect::<Vec<_>>()));
    flip_to_delaunay(&mut mesh, &kernel, probe);
    mesh.relabel(name);
    mesh
}

/// The mesh behind the line, the beach line, and the circle events to come. Vertices are numbered in lexicographic order.
struct Sweep<'k, K> {
    kernel: &'k K,
    /// What the caller calls the vertices.
    names: &'k [u32],
    mesh: Mesh<2>,
    beach: Beach,
    queue: BinaryHeap<Pending<'k, K>>,
    /// The sites that the line has met.
    met: usize,
}

/// The facet of a ghost to the next one below, and the one to the next above. (Inv 1)
const BELOW: usize = 0;
const ABOVE: usize = 1;
const INSIDE: usize = 2;

impl<'k, K: SweepKernel> Sweep<'k, K> {
    /// With the line at the leftmost sites, or, if there is only one, at the second.
    fn start(kernel: &'k K, names: &'k [u32]) -> Self {
        let count = names.len();
        let is_leftmost = |v: &usize| kernel.compare(0, 0, *v).is_eq();
        let leftmost = (1..count).take_while(is_leftmost).count() + 1;
        let mut sweep = Self {
            kernel,
            names,
            mesh: Mesh::bare(2),
            beach: Beach::default(),
            queue: BinaryHeap::new(),
            met: leftmost.max(2),
        };
        let pairs: Vec<[CellId; 2]> =
            (1..sweep.met).map(|upper| sweep.add_edge(upper - 1, upper)).collect();
        let mut below = None;
        for &[ahead, _] in &pairs {
            sweep.beach.insert(below, None, ahead);
            below = Some(ahead);
        }
        if leftmost == 1 {
            sweep.beach.insert(below, None, pairs[0][1]); // the first arc goes on above the second
        }
        // Round the chain: up along the line, down behind it.
        let ahead = pairs.iter().map(|pair| pair[0]);
        let round: Vec<CellId> = ahead.chain(pairs.iter().rev().map(|pair| pair[1])).collect();
        for (&ghost, &above) in round.iter().zip(round.iter().cycle().skip(1)) {
            sweep.mesh.glue(FacetId::new(ghost, ABOVE), FacetId::new(above, BELOW));
        }
        sweep
    }

    /// Meets the other sites and all circle events; the mesh, unless all sites are in line.
    fn run(mut self, count: usize, probe: &mut impl Probe) -> Option<Mesh<2>> {
        let mut vanished = 0;
        loop {
            let next = VertexId::new(self.met);
            let circle_first = self.queue.peek().is_some_and(|pending| {
                self.met == count
                    || self.kernel.compare_event_with_site(&pending.event, next).is_le() // Inv 3
            });
            if circle_first {
                vanished += usize::from(self.circle_event(probe));
                assert!(vanished < 2 * count, "each circle event makes a triangle");
            } else if self.met < count {
                self.site_event(next, probe);
                self.met += 1;
                probe.on(Event::Site { done: self.met, total: count });
                self.show(probe, "site event", &[next]);
            } else {
                return (vanished > 0).then_some(self.mesh);
            }
        }
    }

    /// Puts the arc of `p` into the one ahead at its height.
    fn site_event(&mut self, p: VertexId, probe: &mut impl Probe) {
        let (kernel, mesh) = (self.kernel, &self.mesh);
        let (below, above) = self.beach.search(|ghost| {
            probe.on(Event::WalkStep);
            let corners = mesh.corners(ghost);
            is_above(kernel, p, corners[1], corners[0])
        });
        let ring = match (below, above) {
            (_, Some(above)) => FacetId::new(above, BELOW),
            (Some(below), None) => mesh.twin(FacetId::new(below, ABOVE)),
            (None, None) => unreachable!("from the second site on arcs meet"),
        };
        let (above_all, below_all) = (ring, mesh.twin(ring));
        let vertex = mesh.vertex(ring.cell(), 1);
        let [lower, upper] = self.add_edge(vertex.index(), p.index());
        let mesh = &mut self.mesh;
        mesh.glue(below_all, FacetId::new(lower, BELOW));
        mesh.glue(FacetId::new(lower, ABOVE), FacetId::new(upper, BELOW));
        mesh.glue(FacetId::new(upper, ABOVE), above_all);
        self.beach.insert(below, above, lower);
        self.beach.insert(Some(lower), above, upper);
        self.expect(below_all.cell(), probe);
        self.expect(upper, probe);
    }

    /// The edge of two sites, as two ghosts: `lower` below and `upper` above, and the other way round.
    fn add_edge(&mut self, lower: usize, upper: usize) -> [CellId; 2] {
        let [lower, upper] = [lower, upper].map(VertexId::new);
        let there = self.mesh.add_cell(&[upper, lower, VertexId::GHOST]);
        let back = self.mesh.add_cell(&[lower, upper, VertexId::GHOST]);
        self.mesh.glue(FacetId::new(there, INSIDE), FacetId::new(back, INSIDE));
        [there, back]
    }

    /// Queues the circle event of the arc above a ghost, if it will vanish between its two neighbours. (Inv 4)
    fn expect(&mut self, ghost: CellId, probe: &mut impl Probe) {
        let [b, a] = [self.mesh.vertex(ghost, 0), self.mesh.vertex(ghost, 1)];
        let c = self.mesh.vertex(self.above(ghost), 0);
        if a == c {
            return;
        }
        probe.on(Event::Orient);
        if self.kernel.orient(&[c, b, a]) == Sign::Positive {
            let event = self.kernel.circle_event([c, b, a]);
            self.queue.push(Pending { event, ghost, kernel: self.kernel });
            probe.on(Event::CircleEvent);
        }
    }

    fn above(&self, ghost: CellId) -> CellId {
        self.mesh.twin(FacetId::new(ghost, ABOVE)).cell()
    }

    /// The next circle event in the queue: its arc vanishes, unless it has done so or been split in the meantime.
    fn circle_event(&mut self, probe: &mut impl Probe) -> bool {
        let Some(Pending { event, ghost, .. }) = self.queue.pop() else { return false };
        let [c, b, a] = event.sites();
        let above = self.above(ghost);
        let is_now = *self.mesh.corners(ghost) == [b, a, VertexId::GHOST]
            && *self.mesh.corners(above) == [c, b, VertexId::GHOST];
        if is_now {
            // The triangle takes the place of the ghost above; the other one is [c, a, GHOST] now.
            self.mesh.flip(HalfEdge::new(above, BELOW));
            self.beach.remove(above);
            probe.on(Event::CellMade);
            self.expect(self.mesh.twin(FacetId::new(ghost, BELOW)).cell(), probe);
            self.expect(ghost, probe);
            self.show(probe, "circle event", &[c, b, a]);
        }
        is_now
    }
}

/// Whether `p`, with the line at it, is above the point where the arcs of `lower` and `upper` meet.
///
/// The arc of the site nearer to the line is the narrower one, ahead of the other between two heights on both sides of
/// its site. If that is `upper`, the arcs meet at the lower of these heights, else at the upper one. The arc of a site on the line is
/// a ray: `p`, which comes later, is above it.
fn is_above(kernel: &impl SweepKernel, p: VertexId, lower: VertexId, upper: VertexId) -> bool {
    let is_on_line = |site| kernel.compare(0, site, p).is_eq();
    if is_on_line(lower) || is_on_line(upper) {
        return true;
    }
    let ahead = kernel.arc_ahead(p, [lower, upper]); // positive: the lower one
    match kernel.compare(0, lower, upper) {
        Ordering::Equal => ahead == Sign::Negative,
        Ordering::Less => ahead == Sign::Negative || kernel.compare(1, p, upper).is_ge(),
        Ordering::Greater => ahead == Sign::Negative && kernel.compare(1, p, lower).is_gt(),
    }
}

/// A circle event in the queue, and the ghost below the arc. The greatest is the one that comes first; of those that come together,
/// the one whose last site is the earliest. (Inv 5)
struct Pending<'k, K> {
    event: CircleEvent<VertexId>,
    ghost: CellId,
    kernel: &'k K,
}

impl<K: SweepKernel> Ord for Pending<'_, K> {
    fn cmp(&self, other: &Self) -> Ordering {
        let last = |pending: &Self| pending.event.sites().into_iter().max();
        let order = self.kernel.compare_events(&other.event, &self.event);
        order.then_with(|| last(other).cmp(&last(self)))
    }
}

impl<K: SweepKernel> PartialOrd for Pending<'_, K> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<K: SweepKernel> PartialEq for Pending<'_, K> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<K: SweepKernel> Eq for Pending<'_, K> {}
