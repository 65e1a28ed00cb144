//! What refinement returns.

use delone_cdt::Cdt;
use delone_mesh::{CellId, VertexId};
use delone_predicates::{Constructed, Kernel};
use delone_sites::Pslg;

use super::Work;
use super::quality::near_edges;
use crate::Conforming;
use crate::live::id;

/// Of the magnitude of coordinates, what is long enough for their rounding to turn an edge by less than 10^-5 degrees.
const COARSE: f64 = 1.0 / (1u64 << 26) as f64;

/// Why a triangle inside does not keep the bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Its shortest edge joins two segments that meet at less than 60 degrees, at one distance from where they meet.
    InputAngle,
    /// The place for a point that would destroy it is beyond an edge of the hull that is no segment, so that it is not split. Where segments
    /// are around all that is inside, there is no such triangle.
    Unreachable,
    /// A limit was reached before it was its turn.
    Limit,
}

/// A triangle inside that does not keep the bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LeftAlone {
    /// The cell.
    pub cell: CellId,
    /// Why.
    pub reason: Reason,
}

/// A refined triangulation.
#[derive(Clone, Debug)]
pub struct Refined {
    triangulation: Conforming,
    /// By cell.
    regions: Vec<u32>,
    inside: Vec<bool>,
    left_alone: Vec<LeftAlone>,
}

impl Refined {
    /// Of sites in line: nothing is inside.
    pub(super) fn chain(cdt: &Cdt, pslg: &Pslg) -> Self {
        let count = cdt.mesh().cell_count();
        Self {
            triangulation: Conforming::chain(cdt, pslg),
            regions: vec![0; count],
            inside: vec![false; count],
            left_alone: Vec::new(),
        }
    }

    /// The triangulation: constrained Delaunay, whether or not it conforms.
    #[must_use]
    pub const fn triangulation(&self) -> &Conforming {
        &self.triangulation
    }

    /// Whether all is done that could be, within the limits.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.triangulation.is_complete()
    }

    /// Whether a cell is inside.
    #[must_use]
    pub fn is_inside(&self, cell: CellId) -> bool {
        self.inside[cell.index()]
    }

    /// The region of the input's CDT that a cell is part of: see [`delone_cdt::Regions`].
    #[must_use]
    pub fn region_of(&self, cell: CellId) -> u32 {
        self.regions[cell.index()]
    }

    /// The cells inside, by index.
    pub fn cells(&self) -> impl Iterator<Item = CellId> + Clone + '_ {
        self.triangulation.cells().filter(|&cell| self.is_inside(cell))
    }

    /// The cells inside that do not keep the bounds, by index.
    #[must_use]
    pub fn left_alone(&self) -> &[LeftAlone] {
        &self.left_alone
    }

    /// What is promised of angles, for a judge: for each solid cell in their order whether it counts, being inside and not out of reach
    /// or cut off by a limit; and the places in that order of those that are left alone at small input angles. All others
    /// that count keep the bound on angles.
    #[must_use]
    pub fn promised(&self) -> (Vec<bool>, Vec<usize>) {
        let reason = |cell: CellId| {
            let place = self.left_alone.binary_search_by_key(&cell, |left| left.cell);
            place.ok().map(|place| self.left_alone[place].reason)
        };
        let counts =
            |cell| self.is_inside(cell) && matches!(reason(cell), None | Some(Reason::InputAngle));
        let cells = self.triangulation.cells();
        let inside = cells.clone().map(counts).collect();
        let exceptions = cells.enumerate().filter(|&(_, c)| reason(c) == Some(Reason::InputAngle));
        (inside, exceptions.map(|(place, _)| place).collect())
    }

    /// How many cells inside do not keep the bounds for this reason.
    #[must_use]
    pub fn left_alone_for(&self, reason: Reason) -> usize {
        self.left_alone.iter().filter(|left| left.reason == reason).count()
    }

    /// The least angle of the cells inside, in degrees, in doubles; 180 if there are none.
    #[must_use]
    pub fn angle_deg_min(&self) -> f64 {
        self.cells().map(|cell| self.least_angle(cell)).fold(180.0, f64::min)
    }

    /// The same of those that are not left alone.
    #[must_use]
    pub fn angle_deg_min_elsewhere(&self) -> f64 {
        let is_left = |cell| self.left_alone.binary_search_by_key(&cell, |left| left.cell).is_ok();
        let others = self.cells().filter(|&cell| !is_left(cell));
        others.map(|cell| self.least_angle(cell)).fold(180.0, f64::min)
    }

    fn least_angle(&self, cell: CellId) -> f64 {
        let corners = self.triangulation.mesh().corners(cell);
        let edges = edges(self.triangulation.kernel(), [corners[0], corners[1], corners[2]]);
        let angle = |i: usize| {
            let (u, [x, y]) = (edges[i], edges[(i + 2) % 3]);
            let (cross, dot) = (x * u[1] - y * u[0], -(x * u[0] + y * u[1]));
            cross.abs().atan2(dot).to_degrees()
        };
        angle(0).min(angle(1)).min(angle(2))
    }
}

/// The edges of a triangle, from each corner to the next, over about the longest: exact where doubles are too coarse for the shortest.
fn edges(kernel: &Constructed<2>, corners: [VertexId; 3]) -> [[f64; 2]; 3] {
    let at = corners.map(|v| kernel.position(id(v)));
    let minus = |p: [f64; 2], q: [f64; 2]| [q[0] - p[0], q[1] - p[1]];
    let near = [minus(at[0], at[1]), minus(at[1], at[2]), minus(at[2], at[0])];
    let size = |edge: &[f64; 2]| edge[0].abs().max(edge[1].abs());
    let sizes = near.each_ref().map(size);
    let (least, most) =
        (sizes.into_iter().fold(f64::INFINITY, f64::min), sizes.into_iter().fold(0.0, f64::max));
    let far = at.as_flattened().iter().fold(0.0, |far: f64, x| far.max(x.abs()));
    if least > COARSE * far && most < f64::INFINITY && least.is_normal() {
        return near.map(|edge| edge.map(|x| x / most));
    }
    near_edges(kernel, corners)
}

impl Work<'_> {
    /// Closes gaps in the numbers of cells and vertices, and says what was left alone.
    pub(super) fn finish(mut self, is_complete: bool) -> Refined {
        let mut reasons = self.reasons();
        self.compact(&mut reasons);
        let cells = self.live.mesh.cells();
        let inside: Vec<bool> = cells.clone().map(|cell| self.is_inside(cell)).collect();
        let mut left_alone = Vec::new();
        for cell in cells.filter(|cell| inside[cell.index()]) {
            let mut reason = reasons[cell.index()];
            // Inv 2: what is in none of the lists keeps the bounds.
            if reason.is_none() && (!is_complete || cfg!(debug_assertions)) {
                reason = self.reason_at_the_limit(self.live.mesh.triangle(cell));
                assert!(reason.is_none() || !is_complete, "Inv 2: it was queued, or listed");
            }
            left_alone.extend(reason.map(|reason| LeftAlone { cell, reason }));
        }
        let regions = std::mem::take(&mut self.live.region_at);
        Refined {
            triangulation: Conforming::new(self.live, is_complete),
            regions,
            inside,
            left_alone,
        }
    }

    /// Why a triangle does not keep the bounds whose turn did not come, if it does not.
    fn reason_at_the_limit(&self, corners: [VertexId; 3]) -> Option<Reason> {
        self.quality.flaw(&self.live, corners)?;
        Some(if self.is_exception(corners) { Reason::InputAngle } else { Reason::Limit })
    }

    /// Why a cell was left alone, by cell.
    fn reasons(&self) -> Vec<Option<Reason>> {
        let mut reasons = vec![None; self.live.mesh.cell_count()];
        for &(cell, corners, reason) in &self.left_alone {
            if self.live.is_still(cell, corners) {
                reasons[cell.index()] = Some(reason);
            }
        }
        reasons
    }

    /// Closes the slots of cells and the numbers of vertices that are gone.
    fn compact(&mut self, reasons: &mut [Option<Reason>]) {
        let live = &mut self.live;
        let regions = &mut live.region_at;
        live.mesh.compact(|from, to| {
            regions[to.index()] = regions[from.index()];
            reasons[to.index()] = reasons[from.index()];
        });
        regions.truncate(live.mesh.cell_count());
        if self.removed.is_empty() {
            return;
        }
        let count = live.kernel.len();
        let mut gone = vec![false; count];
        self.removed.iter().for_each(|v| gone[v.index()] = true);
        let mut order: Vec<u32> = Vec::with_capacity(count);
        let mut names = Vec::with_capacity(count);
        for (v, &is_gone) in (0u32..).zip(&gone) {
            names.push(if is_gone { VertexId::GHOST } else { VertexId::new(order.len()) });
            if !is_gone {
                order.push(v);
            }
        }
        live.kernel = live.kernel.reordered(&order);
        live.mesh.relabel(|v| names[v.index()]);
        let sites = live.sites;
        live.steiner.retain(|place| !gone[sites + place]);
        for piece in &mut live.pieces {
            piece.ends = piece.ends.map(|v| names[v.index()]);
        }
    }
}
