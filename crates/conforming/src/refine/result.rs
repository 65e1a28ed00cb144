//! What refinement returns.

use std::collections::BTreeMap;

use delone_cdt::Cdt;
use delone_mesh::{CellId, VertexId};
use delone_predicates::Kernel;
use delone_sites::Pslg;

use super::quality::Flaw;
use super::{Work, corners};
use crate::Conforming;
use crate::live::id;

/// Why a triangle inside does not keep the bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Its shortest edge joins two segments that meet at less than 60 degrees, at one distance from where they meet.
    InputAngle,
    /// The place for a point that would destroy it is, in doubles, a vertex, or no place that can be walked to.
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
        let at = |i: usize| self.triangulation.kernel().position(id(corners[i % 3]));
        let angle = |i: usize| {
            let [o, p, q] = [at(i), at(i + 1), at(i + 2)];
            let (u, v) = ([p[0] - o[0], p[1] - o[1]], [q[0] - o[0], q[1] - o[1]]);
            let (cross, dot) = (u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
            cross.atan2(dot).to_degrees()
        };
        angle(0).min(angle(1)).min(angle(2))
    }
}

impl Work<'_> {
    /// Closes gaps in the numbers of cells and vertices, and looks at all that is inside once more.
    pub(super) fn finish(mut self, is_complete: bool) -> Refined {
        self.compact();
        let sorted = |mut corners: [VertexId; 3]| {
            corners.sort_unstable();
            corners
        };
        let reasons: BTreeMap<[VertexId; 3], Reason> =
            self.left_alone.iter().map(|&(corners, reason)| (sorted(corners), reason)).collect();
        let mut left_alone = Vec::new();
        let mut inside = Vec::with_capacity(self.live.mesh.cell_count());
        for cell in self.live.mesh.cells() {
            let is_inside = self.is_inside(cell);
            inside.push(is_inside);
            if !is_inside {
                continue;
            }
            let corners = corners(&self.live, cell);
            if self.quality.flaw(&self.live, corners).0 != Flaw::None {
                let reason = reasons.get(&sorted(corners)).copied();
                assert!(reason.is_some() || !is_complete, "Inv 2: it was queued, or listed");
                left_alone.push(LeftAlone { cell, reason: reason.unwrap_or(Reason::Limit) });
            }
        }
        let regions = std::mem::take(&mut self.live.region_at);
        Refined {
            triangulation: Conforming::new(self.live, is_complete),
            regions,
            inside,
            left_alone,
        }
    }

    /// Closes the slots of cells and the numbers of vertices that are gone.
    fn compact(&mut self) {
        let live = &mut self.live;
        let regions = &mut live.region_at;
        live.mesh.compact(|from, to| regions[to.index()] = regions[from.index()]);
        regions.truncate(live.mesh.cell_count());
        if self.removed == 0 {
            return;
        }
        let cells = live.mesh.cells_by_vertex(live.kernel.len());
        let count = u32::try_from(cells.len()).expect("vertices are fewer than ids");
        // Sites stay, also those that no cell has.
        let stays = |&v: &u32| (v as usize) < live.sites || cells[v as usize].is_some();
        let order: Vec<u32> = (0..count).filter(stays).collect();
        let mut names = vec![None; cells.len()];
        for (name, &v) in order.iter().enumerate() {
            names[v as usize] = Some(VertexId::new(name));
        }
        let name = |v: VertexId| names[v.index()];
        live.kernel = live.kernel.reordered(&order);
        live.mesh.relabel(|v| name(v).expect("a corner stays"));
        let old = std::mem::take(&mut live.steiner);
        let old = (live.sites..).zip(old);
        live.steiner =
            old.filter(|&(v, _)| names[v].is_some()).map(|(_, steiner)| steiner).collect();
        for piece in &mut live.pieces {
            piece.ends = piece.ends.map(|v| name(v).expect("the ends of a piece stay"));
        }
        self.left_alone = std::mem::take(&mut self.left_alone)
            .into_iter()
            .filter_map(|([a, b, c], reason)| Some(([name(a)?, name(b)?, name(c)?], reason)))
            .collect();
    }
}
