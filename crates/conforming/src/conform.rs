//! Conforming Delaunay triangulation: subsegments are split until the constrained triangulation is Delaunay.
//!
//! **Paper.** \[She02\] and \[Rup95\] split at middles and on shells; copied radii and feet of perpendiculars are our own (see
//! [`crate::split`], with the proof that all this ends). \[ET93\], with its bound of O(m^2 n) points, is not here.
//! **In.** A noded PSLG. **Out.** The Delaunay triangulation of its sites and Steiner points on its segments, exactly, in which each segment
//! is a chain of edges.
//! **Method.** The CDT is kept. A subsegment that is not locally Delaunay in it is missing in the Delaunay triangulation; when
//! none is left, the CDT is the Delaunay triangulation. To encroach, in the stronger sense, is to be in the closed diametral
//! disk; if no apex of the two triangles of a subsegment does, and this holds for all, then no vertex does.
//! **Rounds.** All subsegments to be split at one time are split in their order along the plane, those that come of it in the
//! next round: the result does not depend on the order of input.
//! **Invariants.** 1. Those not on the list of the next round are not to be split: only triangles at a new vertex are new.
//! **Cost.** O(1) for each cell that changes; sorting.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | an apex on the diametral circle | encroaches; the Delaunay criterion asks the perturbation | `a_right_angle_encroaches` |
//! | all sites in line | each segment is an edge already | `a_line_conforms` |
//! | angles of 1e-6 degrees and less | as many bits as they ask for | `fans_of_the_specification` |

use delone_cdt::cavity;
use delone_delaunay::Options;
use delone_mesh::VertexId;
use delone_predicates::{Kernel, Side};
use delone_probe::{Event, Probe};
use delone_sites::Pslg;

use crate::Conforming;
use crate::apexes::Apexes;
use crate::live::{Live, PieceId};
use crate::saalfeld;
use crate::split::{Placement, encroachers, encroaches, parameter};

/// When a subsegment is to be split.
pub trait Criterion {
    /// Whether the subsegment is.
    fn must_split(&self, subsegment: &Subsegment<'_>) -> bool;
}

/// A subsegment in its triangulation.
pub struct Subsegment<'a> {
    pub(crate) live: &'a Live,
    pub(crate) piece: PieceId,
}

impl std::fmt::Debug for Subsegment<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("Subsegment").field(&self.piece).finish()
    }
}

impl Subsegment<'_> {
    /// Whether it is an edge of the Delaunay triangulation of what is seen from it.
    #[must_use]
    pub fn is_locally_delaunay(&self) -> bool {
        let Self { live, piece } = self;
        let h = live.half_edge(*piece);
        let t = live.mesh.twin(h);
        if live.mesh.is_ghost(h.cell()) || live.mesh.is_ghost(t.cell()) {
            return true;
        }
        live.kernel.in_sphere(live.mesh.corners(h.cell()), live.mesh.apex(t)) == Side::Negative
    }

    /// Whether one of its two apexes is in its closed diametral disk.
    #[must_use]
    pub fn is_encroached(&self) -> bool {
        self.live.apexes(self.piece).any(|v| encroaches(self.live, self.piece, v))
    }
}

/// Split what is missing: the least that makes it conforming.
#[derive(Clone, Copy, Debug)]
pub struct Missing;

impl Criterion for Missing {
    fn must_split(&self, subsegment: &Subsegment<'_>) -> bool {
        !subsegment.is_locally_delaunay()
    }
}

/// Split what is encroached: the diametral disk of each subsegment is empty afterwards, closed.
#[derive(Clone, Copy, Debug)]
pub struct Encroached;

impl Criterion for Encroached {
    fn must_split(&self, subsegment: &Subsegment<'_>) -> bool {
        subsegment.is_encroached()
    }
}

/// How far to go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The most vertices, sites included.
    pub vertices_max: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { vertices_max: usize::MAX }
    }
}

/// Few graphs without narrow gaps have segments that take more.
const CUTS_MAX: usize = 256;

/// How to place and when to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ConformOptions {
    /// Where points go.
    pub placement: Placement,
    /// The most cuts of one segment by protection. Segments that take more are left to splitting, for which a gap may be of any width: cuts are as
    /// many as the gap goes into the length. `usize::MAX` is \[Saa91\]'s method and nothing else.
    pub cuts_max: usize,
    /// When to give up.
    pub limits: Limits,
}

impl Default for ConformOptions {
    fn default() -> Self {
        Self { placement: Placement::default(), cuts_max: CUTS_MAX, limits: Limits::default() }
    }
}

/// Splits subsegments until none is to be split. See the module's text.
///
/// With a limit the result may be incomplete ([`Conforming::is_complete`]): a valid constrained Delaunay triangulation of the
/// segments, in pieces of which some are still to be split.
///
/// ```
/// use delone_conforming::{Missing, conform};
/// use delone_sites::Pslg;
///
/// let kite = [[0.0, 0.0], [3.0, 1.0], [6.0, 0.0], [3.0, -1.0]];
/// let pslg = Pslg::new(&kite, &[[0, 2]]).unwrap(); // the long diagonal, which is not Delaunay
/// let conforming = conform(&pslg, &Missing, &Default::default(), &mut ());
/// assert_eq!(conforming.positions()[4..], [[3.0, 0.0]]); // one Steiner point, in its middle
/// assert_eq!(conforming.canonical(), [0, 1, 4, 0, 3, 4, 1, 2, 4, 2, 3, 4]);
/// ```
pub fn conform(
    pslg: &Pslg,
    criterion: &impl Criterion,
    options: &ConformOptions,
    probe: &mut impl Probe,
) -> Conforming {
    from_cdt(pslg, probe, |live, apexes, probe| split_all(live, apexes, criterion, options, probe))
}

/// The non-adaptive method: see `saalfeld.rs`.
pub fn conform_by_protection(
    pslg: &Pslg,
    options: &ConformOptions,
    probe: &mut impl Probe,
) -> Conforming {
    from_cdt(pslg, probe, |live, apexes, probe| {
        saalfeld::protect(live, apexes, options, probe)
            && split_all(live, apexes, &Encroached, options, probe)
    })
}

/// The constrained triangulation, after `work` on it, which says whether it is all done. Sites in line need none.
fn from_cdt<P: Probe>(
    pslg: &Pslg,
    probe: &mut P,
    work: impl FnOnce(&mut Live, &Apexes, &mut P) -> bool,
) -> Conforming {
    let cdt = cavity(pslg, &Options::default(), probe);
    if cdt.mesh().dimension() != Some(2) {
        return Conforming::chain(&cdt, pslg);
    }
    let mut live = Live::new(&cdt, pslg);
    let apexes = Apexes::new(&cdt, &live);
    let is_complete = work(&mut live, &apexes, probe);
    Conforming::new(live, is_complete)
}

/// Whether all that was to be split was.
pub(crate) fn split_all(
    live: &mut Live,
    apexes: &Apexes,
    criterion: &impl Criterion,
    options: &ConformOptions,
    probe: &mut impl Probe,
) -> bool {
    let order = Along::new(live);
    let count = u32::try_from(live.pieces.len()).expect("pieces are fewer than ids");
    let mut round: Vec<PieceId> = (0..count).collect();
    let mut next = Vec::new();
    while !round.is_empty() {
        order.sort(live, &mut round);
        for &piece in &round {
            if !criterion.must_split(&Subsegment { live, piece }) {
                continue;
            }
            if live.kernel.len() >= options.limits.vertices_max || !probe.goes_on() {
                return false;
            }
            let near = encroachers(live, piece);
            let t = parameter(live, apexes, piece, &near, options.placement);
            let p = live.split_piece(piece, t, probe);
            let done = live.kernel.len();
            probe.on(Event::Site { done, total: done });
            touched(live, piece, p, &mut next); // Inv 1
        }
        std::mem::swap(&mut round, &mut next);
        next.clear();
    }
    true
}

/// The pieces that a new vertex on a piece makes, and those opposite it.
fn touched(live: &Live, piece: PieceId, p: VertexId, out: &mut Vec<PieceId>) {
    let h = live.half_edge(piece);
    let cell = h.cell();
    for h in live.mesh.ring(p, cell) {
        out.extend(live.piece_of(h));
        out.extend(live.piece_of(live.mesh.next(h)));
    }
}

/// The order of pieces that no order of input changes: by segment in lexicographic order, then along it.
struct Along {
    ranks: Vec<u32>,
}

impl Along {
    fn new(live: &Live) -> Self {
        let count = u32::try_from(live.segments.len()).expect("segments are fewer than ids");
        let mut sorted: Vec<u32> = (0..count).collect();
        let ends = |&s: &u32| live.segments[s as usize];
        sorted.sort_by(|s, t| {
            let compare =
                |u: u32, v: u32| live.kernel.compare_lexicographic(u as usize, v as usize);
            let ([a, b], [c, d]) = (ends(s), ends(t));
            compare(a, c).then_with(|| compare(b, d))
        });
        let mut ranks = vec![0; sorted.len()];
        for (rank, &segment) in (0u32..).zip(&sorted) {
            ranks[segment as usize] = rank;
        }
        Self { ranks }
    }

    /// Sorted, each once.
    fn sort(&self, live: &Live, round: &mut Vec<PieceId>) {
        let first = |piece: PieceId| live.pieces[piece as usize].ends[0];
        let segment = |piece: PieceId| live.pieces[piece as usize].segment;
        round.sort_unstable_by(|&p, &q| {
            let order = self.ranks[segment(p) as usize].cmp(&self.ranks[segment(q) as usize]);
            order.then_with(|| live.kernel.compare_lexicographic(first(p), first(q)))
        });
        round.dedup();
    }
}

#[cfg(test)]
mod tests;
