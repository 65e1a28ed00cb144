//! The alpha filtration: for every simplex of a Delaunay or regular triangulation the least squared radius at which it belongs to
//! the alpha complex, as a rank among exact values.
//!
//! **Paper.** [EM94] for the complexes and what is attached; [Ede92] with weights. The value of a simplex is the least power that a
//! point of its Voronoi face has to it. If the centre of the smallest sphere through (orthogonal to) the simplex lies in that face,
//! it is that sphere's squared radius; else the simplex is *attached*, and the value is the least of its cofaces'. The centre
//! lies in the face if no vertex of a coface is inside the sphere: only these bound the face.
//! **In.** A Delaunay triangulation and its sites, or a regular one and its weighted sites. Not a constrained one: an edge that is
//! not Delaunay may have a vertex inside its sphere on both sides, and the rule fails.
//! **Out.** Ranks of exact values, and for each simplex the one, itself or a coface, whose sphere gives its value.
//! **Invariants.** 1. Faces come before cofaces: the rank of a face is at most that of the simplex, its dimension is lower.
//! 2. Values are never computed, but compared: by bounds in doubles, then exactly.
//! **Cost.** O(N log N) for N simplices; a sphere and a few signs for each. Equal values take exact comparisons: as many as there
//! are simplices, times the logarithm of the number of different values among equal-looking ones.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a vertex exactly on the smallest sphere | not attached; the coface has the same value | `a_square_grid_has_three_values` |
//! | cospherical cells | each of the simplices made by the perturbation has the value of its cell | `a_square_grid_has_three_values` |
//! | weights | vertices may be attached, values negative | `values_are_those_of_the_definition` |
//! | all sites in a flat | spheres within the flat | `sites_in_a_flat_have_the_values_of_the_flat` |
//! | a squared radius over the largest double | compared all the same | `scaling_keeps_the_order_at_both_ends_of_the_range` |

use delone_delaunay::{Delaunay, Regular};
use delone_mesh::Mesh;
use delone_predicates::{Adaptive, Metric, SquaredRadius, Weighted};
use delone_sites::{Sites, WeightedSites};

use crate::bulk::{Lists, narrow};
use crate::geometry::Geometry;
use crate::{SimplexId, Simplices};
use ranks::Measures;

mod ranks;

/// A filtration of a Delaunay or regular triangulation. See the module's text.
///
/// ```
/// use delone_alpha::AlphaFiltration;
/// use delone_delaunay::{Options, delaunay};
/// use delone_sites::Sites;
///
/// let sites = Sites::new(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]]).unwrap();
/// let filtration = AlphaFiltration::of(&sites, &delaunay(&sites, &Options::default(), &mut ()));
/// let hypotenuse = filtration.simplices().find(&[1, 2]).unwrap();
/// assert_eq!(filtration.value(hypotenuse).to_f64(), 6.25); // 2.5 squared: that of the triangle, too
/// assert_eq!(filtration.spectrum().map(|value| value.to_f64()).collect::<Vec<_>>(), [0.0, 2.25, 4.0, 6.25]);
/// ```
#[derive(Clone, Debug)]
pub struct AlphaFiltration<const D: usize> {
    simplices: Simplices,
    geometry: Geometry<D>,
    /// By simplex: the rank of its value.
    ranks: Vec<u32>,
    /// By simplex: the one whose sphere gives its value.
    owners: Vec<u32>,
    /// By rank: the first simplex whose own sphere has that value.
    spectrum: Vec<u32>,
}

impl<const D: usize> AlphaFiltration<D> {
    /// Of a Delaunay triangulation.
    ///
    /// # Panics
    /// If the triangulation is of other sites.
    #[must_use]
    pub fn of(sites: &Sites<D>, delaunay: &Delaunay<D>) -> Self {
        let kernel = Adaptive::new(sites.points().to_vec());
        build(delaunay.mesh(), kernel, false, Geometry::Plain)
    }

    /// Of a regular triangulation; weights are squared radii of the balls that grow.
    ///
    /// # Panics
    /// If the triangulation is of other sites.
    #[must_use]
    pub fn of_regular(sites: &WeightedSites<D>, regular: &Regular<D>) -> Self {
        let kernel = Weighted::new(sites.sites().points().to_vec(), sites.weights().to_vec());
        build(regular.mesh(), kernel, true, Geometry::Weighted)
    }

    /// The simplices.
    #[must_use]
    pub const fn simplices(&self) -> &Simplices {
        &self.simplices
    }

    /// How many different values there are.
    #[must_use]
    pub fn rank_count(&self) -> usize {
        self.spectrum.len()
    }

    /// The rank of a simplex's value among all values, from 0.
    #[must_use]
    pub fn rank(&self, simplex: SimplexId) -> u32 {
        self.ranks[simplex.index()]
    }

    /// The rank of every simplex.
    #[must_use]
    pub fn ranks(&self) -> &[u32] {
        &self.ranks
    }

    /// The simplex whose smallest sphere gives the value: itself, or a coface if it is attached. That sphere holds no site inside:
    /// it is the witness of the value.
    #[must_use]
    pub fn witness(&self, simplex: SimplexId) -> SimplexId {
        SimplexId::new(self.owners[simplex.index()] as usize)
    }

    /// Whether the value is not that of the simplex's own smallest sphere, some vertex being inside of that.
    #[must_use]
    pub fn is_attached(&self, simplex: SimplexId) -> bool {
        self.witness(simplex) != simplex
    }

    /// The exact value of a simplex.
    #[must_use]
    pub fn value(&self, simplex: SimplexId) -> SquaredRadius {
        self.geometry.squared_radius(self.simplices.vertices(self.witness(simplex)))
    }

    /// The exact value of a rank.
    ///
    /// # Panics
    /// If the rank is not below [`Self::rank_count`].
    #[must_use]
    pub fn value_of_rank(&self, rank: u32) -> SquaredRadius {
        let owner = SimplexId::new(self.spectrum[rank as usize] as usize);
        self.geometry.squared_radius(self.simplices.vertices(owner))
    }

    /// The different values, increasing.
    pub fn spectrum(&self) -> impl Iterator<Item = SquaredRadius> + Clone + '_ {
        (0..narrow(self.rank_count())).map(|rank| self.value_of_rank(rank))
    }

    /// All simplices in order of value, then dimension, then vertices: every prefix is a complex.
    #[must_use]
    pub fn order(&self) -> Vec<u32> {
        let by_rank = self.ranks.iter().enumerate().map(|(id, &rank)| (rank as usize, narrow(id)));
        Lists::new(self.rank_count(), by_rank).into_items()
    }

    pub(crate) const fn geometry(&self) -> &Geometry<D> {
        &self.geometry
    }
}

fn build<const D: usize, K: Metric<D>>(
    mesh: &Mesh<D>,
    kernel: K,
    has_weights: bool,
    wrap: impl Fn(K) -> Geometry<D>,
) -> AlphaFiltration<D> {
    let simplices = Simplices::of(mesh);
    let measures = Measures::of(&simplices, &kernel, has_weights);
    let (mut ranks, spectrum) = measures.ranks(&simplices, &kernel);
    let owners = inherit(&simplices, &mut ranks);
    AlphaFiltration { simplices, geometry: wrap(kernel), ranks, owners, spectrum }
}

/// Gives the attached simplices, which have no rank yet, the least one of their cofaces; for each simplex, whose sphere gives its
/// value. All others have a lower rank than their cofaces, or the same (Inv 1).
fn inherit(simplices: &Simplices, ranks: &mut [u32]) -> Vec<u32> {
    let mut owners: Vec<u32> = (0..narrow(simplices.len())).collect();
    for k in (1..=simplices.dimension().unwrap_or(0)).rev() {
        for (id, _, facets) in simplices.level(k) {
            let (rank, owner) = (ranks[id], owners[id]);
            debug_assert!(rank != u32::MAX, "what is attached has a coface");
            for facet in facets.iter().map(|&facet| facet as usize) {
                if rank < ranks[facet] {
                    debug_assert!(
                        ranks[facet] == u32::MAX || owners[facet] as usize != facet,
                        "Inv 1"
                    );
                    ranks[facet] = rank;
                    owners[facet] = owner;
                }
            }
        }
    }
    owners
}

#[cfg(test)]
mod tests;
