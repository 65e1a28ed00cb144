//! The regular triangulation of sites with weights: Bowyer and Watson's construction under the weighted kernel.
//!
//! ```text
//!     |p|^2 - w                      Each site is lifted to |p|^2 - w. The triangulation is the lower hull of the lifted
//!       \ .           /              sites, seen from below; with equal weights it is Delaunay. A site whose lifted point
//!        \   h   ___./               is not on the lower hull is hidden (h): it is the vertex of no cell.
//!         `.____.                    The power diagram is its dual, as Voronoi's is of Delaunay.
//! ```
//!
//! **Paper.** [Bow81] and [Wat81], for weights [ES96]; ties after [DT11].
//! **In.** Sites with weights. **Out.** The regular mesh under the lexicographic perturbation, and the hidden sites.
//! **Invariants.** 1. Which site is hidden depends on the sites and weights alone: the perturbation leaves no tie. 2. A site
//! hidden once stays hidden when more come.
//! **Cost.** As `bowyer_watson`, one more test for each site; a hidden site costs its location.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | equal positions | only the heaviest counts, the others are hidden inputs | `equal_positions_hide_all_but_the_heaviest` |
//! | a lifted site exactly on the lower hull, no vertex of it | its rank decides whether it is hidden | `hidden_sites_are_those_of_the_definition` |
//! | all sites in a flat | the regular triangulation in it | `regular_in_a_flat` |

use delone_mesh::Mesh;
use delone_predicates::Weighted;
use delone_probe::{Probe, Unstoppable};
use delone_sites::WeightedSites;

use crate::bowyer_watson::construct;
use crate::registry::unless_stopped;
use crate::{Fingerprint, Options, Stopped};

/// The regular triangulation of sites with weights, ties broken by the sites' lexicographic order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Regular<const D: usize> {
    mesh: Mesh<D>,
    hidden: Vec<u32>,
}

impl<const D: usize> Regular<D> {
    /// Takes an algorithm's word that the mesh is regular.
    pub(crate) fn new(mesh: Mesh<D>, sites: usize) -> Self {
        let cells = (0u32..).zip(mesh.cells_by_vertex(sites));
        let hidden = cells.filter(|(_, cell)| cell.is_none()).map(|(site, _)| site).collect();
        Self { mesh, hidden }
    }

    /// The mesh; vertex `i` is site `i`.
    #[must_use]
    pub const fn mesh(&self) -> &Mesh<D> {
        &self.mesh
    }

    /// The mesh, to be changed: from here on it is no longer known to be regular.
    #[must_use]
    pub fn into_mesh(self) -> Mesh<D> {
        self.mesh
    }

    /// The sites that are the vertex of no cell, in increasing order.
    #[must_use]
    pub fn hidden(&self) -> &[u32] {
        &self.hidden
    }

    /// The input points that are the vertex of no cell: hidden sites, and all at a site's position but the one that it
    /// stands for; in increasing order.
    #[must_use]
    pub fn hidden_inputs(&self, sites: &WeightedSites<D>) -> Vec<u32> {
        let site_of = (0u32..).zip(sites.sites().site_of());
        let is_hidden = |&(input, &site): &(u32, &u32)| {
            sites.input_of()[site as usize] != input || self.hidden.binary_search(&site).is_ok()
        };
        site_of.filter(is_hidden).map(|(input, _)| input).collect()
    }

    /// The solid cells as sorted site ids, in lexicographic order; flat, dimension + 1 ids each.
    #[must_use]
    pub fn canonical(&self) -> Vec<u32> {
        self.mesh.canonical(crate::result::id_of)
    }

    /// A hash of sites, weights and cells that depends on these only, not on the order of input.
    #[must_use]
    pub fn fingerprint(&self, sites: &WeightedSites<D>) -> Fingerprint {
        let ranks = sites.sites().ranks();
        let mut hash = Fingerprint::new();
        hash.sites(sites.sites());
        for &site in sites.sites().sorted() {
            hash.word(sites.weights()[site as usize].to_bits());
        }
        hash.ids(&self.mesh.canonical(|vertex| ranks[vertex.index()]));
        hash
    }
}

/// The regular triangulation, inserting in the order that the options say. There is one kernel for weights, and one
/// algorithm: nothing else of the options is looked at.
///
/// ```
/// use delone_delaunay::{Options, regular};
/// use delone_sites::WeightedSites;
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0]];
/// let sites = WeightedSites::new(&points, &[0.0, 0.0, 0.0, -9.0]).unwrap();
/// let triangulation = regular(&sites, &Options::default(), &mut ());
/// assert_eq!((triangulation.canonical(), triangulation.hidden()), (vec![0, 1, 2], &[3][..]));
/// ```
pub fn regular<const D: usize>(
    sites: &WeightedSites<D>,
    options: &Options,
    probe: &mut impl Probe,
) -> Regular<D> {
    Regular::new(by_bowyer_watson(sites, options, &mut Unstoppable(probe)), sites.sites().len())
}

/// The mesh of sites; of some of them, if the probe does not go on.
fn by_bowyer_watson<const D: usize>(
    sites: &WeightedSites<D>,
    options: &Options,
    probe: &mut impl Probe,
) -> Mesh<D> {
    let kernel = Weighted::new(sites.sites().points(), sites.weights());
    construct(&kernel, options.order(sites.sites()), probe)
}

/// The same as [`regular()`], unless the probe says, between two sites, not to go on. As
/// [`crate::delaunay_unless_stopped`].
///
/// # Errors
/// If the probe stopped it.
pub fn regular_unless_stopped<const D: usize>(
    sites: &WeightedSites<D>,
    options: &Options,
    probe: &mut impl Probe,
) -> Result<Regular<D>, Stopped> {
    let mesh = unless_stopped(probe, |probe| by_bowyer_watson(sites, options, probe))?;
    Ok(Regular::new(mesh, sites.sites().len()))
}

#[cfg(test)]
mod tests;
