//! Delaunay refinement: points are added until no triangle has a small angle or is too large.
//!
//! ```text
//!         c                 A triangle with a small angle, or too large, is destroyed by a vertex at the centre of its
//!        / \     .x         circumcircle, or nearer on the way there (off-centre). If that would encroach upon a subsegment,
//!       /   \               or lies behind one, the subsegment is split instead.
//!      a-----b
//! ```
//!
//! **Paper.** [`Encroachment::Disk`] with [`Centre::Circumcentre`] is \[Rup95\]; [`Encroachment::Lens`] is \[Che93\]'s second
//! algorithm as \[She02\] has it: free vertices in the diametral disk of a subsegment go before it is split, and less encroaches;
//! [`Centre::OffCentre`] is \[Ung09\]. Small input angles: shells, and triangles whose shortest edge joins two segments of an
//! apex at one distance from it are left alone (\[MPW03\], with the proof that this ends, for angles up to 26.4 degrees).
//! **In.** A noded PSLG, a rule for what is inside, bounds. **Out.** A constrained Delaunay triangulation whose triangles inside
//! keep the bounds, but for those left alone, which are listed with the reason.
//! **Invariants.** 1. The mesh is the CDT after each point. 2. A triangle inside that does not keep the bounds is queued, or
//! listed. 3. Bounds on angles are decided exactly: doubles first, with their errors; then dyadic numbers.
//! **Precision.** Centres are doubles, but where these are off by more than a small part of the shortest edge (`refine/centre.rs`).
//! **Cost.** O(1) for each cell that changes, a short walk. Triangles wait in lists by urgency: nothing is sorted or compared.
//! **Limits.** Up to 20.7 degrees this is proven to end, up to 26.4 without segments at less than 60 degrees; beyond, it usually
//! does up to 33: give a limit on vertices. Narrow gaps take as many triangles as they go into what is along them ([`narrowest_gap`]).
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | triangles so small that doubles are too coarse for their centres | centres of as many bits as it takes | `triangles_are_smaller_than_doubles_can_tell` |
//! | a centre on a free edge | both triangles are split | `a_square_is_refined` |
//! | a centre on a segment | the segment is split, exactly | `a_square_is_refined` |
//! | a centre beyond an edge of the hull that is no piece | the triangle is listed as [`Reason::Unreachable`] | `centres_beyond_a_bare_hull_are_told` |
//! | a point on an edge of the hull that is no piece | the edge is cut; the point is never taken out | `a_point_on_a_bare_hull_stays` |
//! | a gap narrower than doubles can tell | exact numbers say what encroaches | `a_gap_far_below_the_doubles_ends` |
//! | all sites in line, or nothing inside | nothing to refine | `nothing_inside_is_nothing_to_do` |

mod centre;
mod gap;
mod quality;
mod queue;
mod result;
mod shells;

use std::collections::VecDeque;

use delone_cdt::{Fill, FillError, Inside, cavity};
use delone_delaunay::Options;
use delone_mesh::{CellId, HalfEdge, VertexId};
use delone_probe::{Event, Probe};
use delone_sites::Pslg;

use crate::apexes::Apexes;
use crate::conform::Limits;
use crate::live::{Live, PieceId, Place, Region, Steiner};
use crate::split::{Placement, encroachers, parameter};
use quality::{Flaw, Quality};
use queue::Queue;
use shells::subtends_input_angle;

pub use gap::{Gap, narrowest_gap};
pub use result::{LeftAlone, Reason, Refined};

/// Where the point that destroys a triangle goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Centre {
    /// To the centre of its circumcircle.
    Circumcentre,
    /// On the way there from its shortest edge, where a triangle that just keeps the bound has its third corner.
    OffCentre,
}

/// When a vertex is too near a subsegment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encroachment {
    /// In its closed diametral disk.
    Disk,
    /// In a lens within that: seeing it at an angle of 180 degrees less twice the least angle asked for. Free vertices in the
    /// disk are taken out before the subsegment is split.
    Lens,
}

/// The longest edge that a triangle about a point may have.
pub type SizeField<'a> = &'a dyn Fn([f64; 2]) -> f64;

/// What to reach, and how.
#[derive(Clone, Copy)]
pub struct RefineOptions<'a> {
    /// Where points go.
    pub centre: Centre,
    /// What encroaches.
    pub encroachment: Encroachment,
    /// The least angle inside, in degrees; 0 for any.
    pub angle_deg_min: f64,
    /// The largest area of a triangle inside.
    pub area_max: f64,
    /// The longest edge of a triangle inside, by the place of its middle.
    pub size: Option<SizeField<'a>>,
    /// When to give up.
    pub limits: Limits,
}

impl Default for RefineOptions<'_> {
    fn default() -> Self {
        Self {
            centre: Centre::OffCentre,
            encroachment: Encroachment::Lens,
            angle_deg_min: 20.7,
            area_max: f64::INFINITY,
            size: None,
            limits: Limits::default(),
        }
    }
}

impl RefineOptions<'_> {
    /// The bound on angles that is kept, exactly: the square of its cosine, the double that the degrees come to.
    #[must_use]
    pub fn cosine_square(&self) -> f64 {
        self.angle_deg_min.clamp(0.0, 60.0).to_radians().cos().powi(2)
    }
}

impl std::fmt::Debug for RefineOptions<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("RefineOptions")
            .field("centre", &self.centre)
            .field("encroachment", &self.encroachment)
            .field("angle_deg_min", &self.angle_deg_min)
            .field("area_max", &self.area_max)
            .field("size", &self.size.is_some())
            .field("limits", &self.limits)
            .finish()
    }
}

/// Refines what is inside. See the module's text.
///
/// ```
/// use delone_cdt::Fill;
/// use delone_conforming::{RefineOptions, refine};
/// use delone_sites::Pslg;
///
/// let sliver = [[0.0, 0.0], [10.0, 0.0], [10.0, 4.0], [0.0, 1.0]];
/// let pslg = Pslg::new(&sliver, &[[0, 1], [1, 2], [2, 3], [3, 0]]).unwrap();
/// let options = RefineOptions { angle_deg_min: 30.0, ..RefineOptions::default() };
/// let refined = refine(&pslg, &Fill::Exterior, &options, &mut ()).unwrap();
/// assert!(refined.angle_deg_min() >= 30.0 && refined.left_alone().is_empty());
/// ```
///
/// # Errors
/// If the rule for what is inside does not apply: see [`Inside::new`].
pub fn refine(
    pslg: &Pslg,
    fill: &Fill,
    options: &RefineOptions<'_>,
    probe: &mut impl Probe,
) -> Result<Refined, FillError> {
    let cdt = cavity(pslg, &Options::default(), probe);
    let inside = Inside::new(&cdt, pslg, fill)?;
    if cdt.mesh().dimension() != Some(2) {
        return Ok(Refined::chain(&cdt, pslg));
    }
    let mut live = Live::new(&cdt, pslg);
    for cell in cdt.mesh().cells() {
        live.region_at[cell.index()] = inside.regions().of_cell(cell);
    }
    let inside = inside.by_region().to_vec();
    debug_assert!(!inside[0], "the exterior, which has all ghosts, is not inside");
    let apexes = Apexes::new(&cdt, &live);
    let quality = Quality::new(options, farthest(pslg.sites().points()));
    let mut work = Work {
        live,
        apexes,
        quality,
        inside,
        options,
        pieces: VecDeque::new(),
        triangles: Queue::default(),
        region: Region::default(),
        left_alone: Vec::new(),
        removed: Vec::new(),
    };
    let is_complete = work.run(probe);
    Ok(work.finish(is_complete))
}

struct Work<'a> {
    live: Live,
    apexes: Apexes,
    quality: Quality<'a>,
    /// By region.
    inside: Vec<bool>,
    options: &'a RefineOptions<'a>,
    /// Pieces that may be encroached; with `true` those that are to be split whatever is there.
    pieces: VecDeque<(PieceId, Option<[VertexId; 2]>)>,
    triangles: Queue,
    region: Region,
    /// Those that were there when they were listed.
    left_alone: Vec<(CellId, [VertexId; 3], Reason)>,
    /// Free vertices that were taken out.
    removed: Vec<VertexId>,
}

impl Work<'_> {
    /// Whether all that was to be done was.
    fn run(&mut self, probe: &mut impl Probe) -> bool {
        let count = u32::try_from(self.live.pieces.len()).expect("pieces are fewer than ids");
        self.pieces.extend((0..count).map(|piece| (piece, None)));
        for cell in self.live.mesh.cells() {
            self.test(cell);
        }
        loop {
            let done = self.live.kernel.len();
            if done >= self.options.limits.vertices_max || !probe.goes_on() {
                return self.pieces.is_empty() && self.only_exceptions_wait();
            }
            if let Some((piece, forced)) = self.pieces.pop_front() {
                let must = match forced {
                    Some(ends) => self.live.pieces[piece as usize].ends == ends,
                    None => self.is_encroached(piece),
                };
                if must {
                    self.split(piece, probe);
                    probe.on(Event::Site { done, total: done });
                }
            } else if let Some((cell, corners)) = self.triangles.pop() {
                // Inv 2: those that are gone are forgotten.
                if self.live.is_still(cell, corners) {
                    self.destroy(cell, corners, probe);
                    probe.on(Event::Site { done, total: done });
                }
            } else {
                return true;
            }
        }
    }

    #[inline]
    fn is_inside(&self, cell: CellId) -> bool {
        self.inside[self.live.region_at[cell.index()] as usize]
    }

    /// Queues a triangle that does not keep the bounds.
    fn test(&mut self, cell: CellId) {
        if self.is_inside(cell) {
            self.judge(cell, self.live.mesh.triangle(cell));
        }
    }

    /// The same of one that is inside.
    #[inline]
    fn judge(&mut self, cell: CellId, corners: [VertexId; 3]) {
        if let Some((_, urgency)) = self.quality.flaw(&self.live, corners) {
            self.triangles.push(urgency, cell, corners);
        }
    }

    /// Whether a triangle that does not keep the bounds is one that no point makes better.
    fn is_exception(&self, corners: [VertexId; 3]) -> bool {
        let flaw = || self.quality.flaw(&self.live, corners).map(|(flaw, _)| flaw);
        let ordered = self.quality.shortest_first(&self.live, corners);
        subtends_input_angle(&self.live, &self.apexes, ordered) && flaw() == Some(Flaw::Skinny)
    }

    /// Whether no triangle waits but such as are gone or exceptions.
    fn only_exceptions_wait(&mut self) -> bool {
        while let Some((cell, corners)) = self.triangles.pop() {
            if self.live.is_still(cell, corners) {
                if !self.is_exception(corners) {
                    return false;
                }
                self.left_alone.push((cell, corners, Reason::InputAngle));
            }
        }
        true
    }

    /// Whether an apex inside encroaches upon a piece.
    fn is_encroached(&self, piece: PieceId) -> bool {
        let h = self.live.half_edge(piece);
        [h, self.live.mesh.twin(h)].into_iter().any(|h| self.is_encroached_from(h, piece))
    }

    /// Whether the apex on one side of a piece is inside and encroaches upon it.
    #[inline]
    fn is_encroached_from(&self, h: HalfEdge, piece: PieceId) -> bool {
        self.is_inside(h.cell()) && self.encroaches(piece, self.live.mesh.apex(h))
    }

    fn encroaches(&self, piece: PieceId, v: VertexId) -> bool {
        match self.options.encroachment {
            Encroachment::Disk => crate::split::encroaches(&self.live, piece, v),
            Encroachment::Lens => {
                let [a, b] = self.live.pieces[piece as usize].ends;
                self.quality.is_in_lens(&self.live, v, [a, b])
            }
        }
    }

    /// Splits a piece.
    fn split(&mut self, piece: PieceId, probe: &mut impl Probe) {
        if self.options.encroachment == Encroachment::Lens {
            self.clear_disk(piece, probe);
        }
        let near = encroachers(&self.live, piece);
        let placement = Placement {
            takes_feet: false,
            parts_max: 4,
            always_shells: true,
            ..Placement::default()
        };
        let t = parameter(&self.live, &self.apexes, piece, &near, placement);
        let p = self.live.split_piece(piece, t, probe);
        let cell = self.live.half_edge(piece).cell();
        self.look_around(p, cell);
    }

    /// Takes out the free vertices inside that a piece sees in its diametral disk.
    fn clear_disk(&mut self, piece: PieceId, probe: &mut impl Probe) {
        for side in [false, true] {
            for _ in 0..=self.live.steiner.len() {
                let h = self.live.half_edge(piece);
                let h = if side { self.live.mesh.twin(h) } else { h };
                let v = self.live.mesh.apex(h);
                let is_free = self.live.steiner_of(v) == Some(Steiner::Free);
                if !is_free
                    || !crate::split::encroaches(&self.live, piece, v)
                    || self.is_on_hull(v, h.cell())
                {
                    break;
                }
                self.live.remove_free(v, h.cell(), probe);
                self.removed.push(v);
                for place in 0..self.live.made.len() {
                    let cell = self.live.made[place];
                    self.test(cell);
                    for h in self.live.mesh.facets(cell) {
                        self.pieces.extend(self.live.piece_of(h).map(|piece| (piece, None)));
                    }
                }
            }
        }
    }

    /// Whether a vertex of this cell is on the hull. A free one is if a point came to lie on an edge of the hull that is no piece; there is no
    /// polygon around it to be triangulated anew.
    fn is_on_hull(&self, v: VertexId, cell: CellId) -> bool {
        self.live.mesh.ring(v, cell).any(|spoke| self.live.mesh.is_ghost(spoke.cell()))
    }

    /// Looks at what a new vertex has brought about.
    fn look_around(&mut self, p: VertexId, cell: CellId) {
        let first = self.live.ring_start(p, cell);
        let mut h = first;
        loop {
            self.test(h.cell());
            let opposite = self.live.mesh.next(h);
            if let Some(piece) = self.live.piece_of(h)
                && self.is_encroached(piece)
            {
                self.pieces.push_back((piece, None));
            }
            if let Some(piece) = self.live.piece_of(opposite)
                && self.is_encroached_from(opposite, piece)
            {
                self.pieces.push_back((piece, None));
            }
            h = self.live.mesh.twin(self.live.mesh.prev(h));
            if h == first {
                return;
            }
        }
    }

    /// Puts in a vertex that encroaches upon no piece at the rim of its region.
    fn insert(&mut self, place: Place, p: VertexId, probe: &mut impl Probe) {
        let cell = self.live.insert_free(place, p, &mut self.region, probe);
        if !matches!(place, Place::Inside(_)) {
            return self.look_around(p, cell);
        }
        for side in 0..self.region.sides() {
            let (cell, [a, b]) = self.region.replacement(side);
            self.judge(cell, [p, a, b]); // inside, as what it replaces was
        }
    }

    /// Puts a vertex at the centre of a triangle, or splits what is in the way.
    fn destroy(&mut self, cell: CellId, corners: [VertexId; 3], probe: &mut impl Probe) {
        if self.is_exception(corners) {
            return self.left_alone.push((cell, corners, Reason::InputAngle));
        }
        let Some(p) = self.quality.push_centre(&mut self.live, corners) else {
            return self.left_alone.push((cell, corners, Reason::Unreachable));
        };
        let place = self.live.locate(cell, p, probe);
        self.region.pieces.clear();
        match place {
            None | Some(Place::Taken) => {
                self.live.kernel.pop();
                return self.left_alone.push((cell, corners, Reason::Unreachable));
            }
            Some(Place::Behind(piece)) => self.region.pieces.push(piece),
            Some(place) => {
                self.live.search(place, p, &mut self.region, probe);
                if !self.region.pieces.is_empty() {
                    let mut pieces = std::mem::take(&mut self.region.pieces);
                    pieces.retain(|&piece| self.encroaches(piece, p));
                    self.region.pieces = pieces;
                }
                if self.region.pieces.is_empty() {
                    return self.insert(place, p, probe);
                }
            }
        }
        self.live.kernel.pop();
        for &piece in &self.region.pieces {
            self.pieces.push_back((piece, Some(self.live.pieces[piece as usize].ends)));
        }
        if let Some((_, urgency)) = self.quality.flaw(&self.live, corners) {
            self.triangles.push(urgency, cell, corners);
        }
    }
}

/// The largest magnitude of a coordinate.
fn farthest(points: &[[f64; 2]]) -> f64 {
    points.as_flattened().iter().fold(0.0, |m: f64, x| m.max(x.abs()))
}

#[cfg(test)]
mod tests;
