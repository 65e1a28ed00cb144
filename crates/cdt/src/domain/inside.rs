//! Which regions are inside: what areas, kinds and points of a [`Domain`](crate::Domain) rest on, and all that refinement asks.

use delone_sites::Noded;

use super::{Fill, FillError, chain, seeds};
use crate::Cdt;
use crate::regions::{RegionId, Regions, Shore};

/// The regions of a CDT, and which of them are inside by a rule; no areas, which take longer than all the rest.
///
/// ```
/// use delone_cdt::{Fill, Inside, cavity};
/// use delone_sites::Pslg;
///
/// let triangle = Pslg::new(&[[0., 0.], [4., 0.], [0., 4.]], &[[0, 1], [1, 2], [2, 0]]).unwrap();
/// let cdt = cavity(&triangle, &Default::default(), &mut ());
/// let inside = Inside::new(&cdt, &triangle, &Fill::EvenOdd).unwrap();
/// assert_eq!(inside.by_region(), [false, true]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Inside {
    pub(super) regions: Regions,
    pub(super) depths: Vec<u32>,
    pub(super) chain: Option<Vec<i64>>,
    inside: Vec<bool>,
}

impl Inside {
    /// Fills the CDT of a noded graph by a rule. O(n) (seeds: each O(n) more).
    ///
    /// # Errors
    /// If the rule asks for a chain and the input does not close; if seeds are not finite or lie on segments; if there are
    /// not as many roles as segments. Every violation is listed.
    pub fn new(cdt: &Cdt, graph: &impl Noded, fill: &Fill) -> Result<Self, FillError> {
        let shore = if *fill == Fill::Hull { Shore::Hull } else { Shore::Segments };
        let regions = Regions::up_to(shore, cdt, graph);
        let depths = chain::depths(&regions);
        let chain = chain::of_rule(&regions, graph, fill)?;
        let count = regions.count();
        let inside: Vec<bool> = match (fill, &chain) {
            (Fill::NonZero, Some(winding)) => winding.iter().map(|&w| w != 0).collect(),
            (_, Some(chain)) => chain.iter().map(|&c| c > 0).collect(),
            (Fill::Nesting, None) => depths.iter().map(|depth| depth % 2 == 1).collect(),
            (Fill::Seeds(seeds), None) => {
                let mut inside: Vec<bool> = (0..count).map(|region| region > 0).collect();
                for region in seeds::regions(cdt, graph, &regions, seeds)? {
                    inside[region as usize] = false;
                }
                inside
            }
            (_, None) => (0..count).map(|region| region > 0).collect(),
        };
        Ok(Self { regions, depths, chain, inside })
    }

    /// The regions.
    #[must_use]
    pub fn regions(&self) -> &Regions {
        &self.regions
    }

    /// Whether a region is inside.
    #[must_use]
    pub fn is_inside(&self, region: RegionId) -> bool {
        self.inside[region as usize]
    }

    /// The same of all, by region.
    #[must_use]
    pub fn by_region(&self) -> &[bool] {
        &self.inside
    }
}
