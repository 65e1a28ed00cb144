//! Fill: which regions of a CDT are inside, by one of several rules, with the chain that proves it.
//!
//! ```text
//!   +-----------+     even-odd   parity of the segments between here and infinity    +---+  1: inside
//!   | 1  +---+  |     nonzero    their sum, leftwards +1, rightwards -1              |   |  2: outside
//!   |    | 2 |  |     nesting    the fewest segments on any way from infinity, odd   +---+
//!   |    +---+  |     exterior   everything that infinity does not reach
//!   +-----------+     seeds      that, less the regions of given points
//! ```
//!
//! **Definition.** Let z be the chain of the input: each subsegment as often as the input covers it. A fill by even-odd or
//! nonzero is a chain c of regions with boundary z, over Z/2 or Z. Such a c exists exactly if z has no boundary (at each
//! vertex an even number of segments, or as many that come as go); it is then unique, as the exterior has 0. If there is
//! none, the vertices where z does not close are named. Subsegments with one region on both sides separate nothing: they
//! are left out of z, so slits and bridges disturb no rule. Nesting always has an answer, which is that of even-odd where z
//! counts each segment once and closes.
//!
//! **In.** A CDT, its noded graph ([`Pslg`](delone_sites::Pslg) or [`Arrangement`](delone_sites::Arrangement)), a rule. **Out.** Depth, winding and side of each region, the kind of each subsegment.
//! **Cost.** O(n), and for seeds O(n) each.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | all sites in line | no region, no area | `a_line_has_no_inside` |
//! | segments given twice | count twice for even-odd, once for nesting | `multiplicity_counts_for_parity_only` |
//! | z does not close | even-odd, nonzero and tags name the vertices | `open_boundaries_are_named_by_their_vertices` |
//! | a seed on a segment, or not finite | refused, all of them | `seeds_on_segments_are_refused` |
//! | a seed outside the hull, or in the exterior | removes nothing more | `seeds_remove_their_regions` |
//! | slits and bridges | part of no chain | `slits_and_bridges_are_told_apart` |

mod chain;
mod edges;
mod error;
mod inside;
mod measure;
mod rule;
mod seeds;

use delone_mesh::CellId;
use delone_sites::Noded;

use crate::area::total;
use crate::regions::{RegionId, Regions};
use crate::{Area, Cdt};

pub use edges::EdgeKind;
pub use error::{FillError, OpenVertex, SeedFault};
pub use inside::Inside;
pub use rule::{Fill, Role};

/// A CDT's regions, and which of them are inside. See the module's text.
///
/// ```
/// use delone_cdt::{Domain, Fill, cavity};
/// use delone_sites::Pslg;
///
/// // A square of side 4 with a square hole of side 1 that nobody has pointed at.
/// let points = [[0., 0.], [4., 0.], [4., 4.], [0., 4.], [1., 1.], [2., 1.], [2., 2.], [1., 2.]];
/// let segments = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
/// let pslg = Pslg::new(&points, &segments).unwrap();
/// let cdt = cavity(&pslg, &Default::default(), &mut ());
/// let domain = Domain::new(&cdt, &pslg, &Fill::EvenOdd).unwrap();
/// assert_eq!(domain.area().to_string(), "15");
/// assert_eq!(domain.holes().count(), 1);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    inside: Inside,
    areas: Vec<Area>,
    seeds: Vec<Option<[f64; 2]>>,
    kinds: Vec<EdgeKind>,
}

impl Domain {
    /// Fills the CDT of a noded graph by a rule. O(n) (seeds: each O(n) more).
    ///
    /// # Errors
    /// As [`Inside::new`].
    pub fn new(cdt: &Cdt, graph: &impl Noded, fill: &Fill) -> Result<Self, FillError> {
        let inside = Inside::new(cdt, graph, fill)?;
        let measures = measure::measure(cdt, graph, &inside.regions);
        let kinds = edges::kinds(&inside.regions, graph, inside.by_region());
        let (areas, seeds) = measures.into_iter().unzip();
        Ok(Self { inside, areas, seeds, kinds })
    }

    /// The regions.
    #[must_use]
    pub fn regions(&self) -> &Regions {
        &self.inside.regions
    }

    /// Whether a region is inside.
    #[must_use]
    pub fn is_inside(&self, region: RegionId) -> bool {
        self.inside.is_inside(region)
    }

    /// The cells inside, by index.
    pub fn cells<'a>(&'a self, cdt: &'a Cdt) -> impl Iterator<Item = CellId> + Clone + 'a {
        cdt.cells().filter(|&cell| self.is_inside(self.regions().of_cell(cell)))
    }

    /// The area of a region, exactly; of the exterior, the part within the convex hull.
    #[must_use]
    pub fn region_area(&self, region: RegionId) -> &Area {
        &self.areas[region as usize]
    }

    /// The area of all that is inside, exactly. Among k crossings it may be a fraction of some hundred digits for each.
    #[must_use]
    pub fn area(&self) -> Area {
        let inside = self.areas.iter().zip(self.inside.by_region()).filter(|(_, inside)| **inside);
        total(inside.map(|(area, _)| area.clone()).collect())
    }

    /// The fewest subsegments on any way from infinity into a region.
    #[must_use]
    pub fn depth(&self, region: RegionId) -> u32 {
        self.inside.depths[region as usize]
    }

    /// The coefficient of each region in the chain whose boundary is the input: parity for [`Fill::EvenOdd`] and
    /// [`Fill::Tagged`], the winding number for [`Fill::NonZero`] and [`Fill::Positive`]; no chain for other rules.
    #[must_use]
    pub fn chain(&self) -> Option<&[i64]> {
        self.inside.chain.as_deref()
    }

    /// A point strictly inside a region; `None` for the exterior, and if no point was found that doubles can name.
    #[must_use]
    pub fn interior_point(&self, region: RegionId) -> Option<[f64; 2]> {
        self.seeds[region as usize]
    }

    /// The regions that are neither inside nor the exterior.
    pub fn holes(&self) -> impl Iterator<Item = RegionId> + Clone + '_ {
        (1u32..).take(self.regions().count() - 1).filter(|&region| !self.is_inside(region))
    }

    /// The kind of each subsegment.
    #[must_use]
    pub fn kinds(&self) -> &[EdgeKind] {
        &self.kinds
    }

    /// The subsegments of one kind, as pairs of sites.
    pub fn edges<'a>(
        &'a self,
        graph: &'a impl Noded,
        kind: EdgeKind,
    ) -> impl Iterator<Item = [u32; 2]> + Clone + 'a {
        let all = graph.subsegments().iter().zip(&self.kinds);
        all.filter(move |(_, found)| **found == kind).map(|(&ends, _)| ends)
    }
}

#[cfg(test)]
mod tests;
