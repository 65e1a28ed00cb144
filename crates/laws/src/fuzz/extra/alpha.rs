//! Laws of alpha filtrations: values by their definition over all sites, and homology by two ways.

use delone::alpha::{AlphaFiltration, SimplexId};
use delone::delaunay::{Options, delaunay, regular};
use delone::mesh::VertexId;
use delone::predicates::{Exact, Metric, Sign, Weighted};
use delone::sites::WeightedSites;
use delone::workloads::Rng;

use crate::case::Case;
use crate::laws::Law;

/// With weights and without.
pub(in crate::fuzz) fn of_alpha<const D: usize>() -> Vec<Law<D>> {
    vec![Law { name: "alpha", hold: plain }, Law { name: "weighted alpha", hold: weighted }]
}

fn plain<const D: usize>(case: &Case<D>) -> usize {
    let sites = case.sites();
    let filtration = AlphaFiltration::of(&sites, &delaunay(&sites, &Options::default(), &mut ()));
    values(case, &filtration, &Exact::new(sites.points()), sites.len());
    homology(case, &filtration);
    filtration.simplices().len()
}

fn weighted<const D: usize>(case: &Case<D>) -> usize {
    let mut rng = Rng::named("alpha weights", 1);
    let weights: Vec<f64> = case
        .points
        .iter()
        .map(|_| f64::from(u32::try_from(rng.below(9)).expect("small")))
        .collect();
    let sites = WeightedSites::new(&case.points, &weights).expect("finite");
    let result = regular(&sites, &Options::default(), &mut ());
    let filtration = AlphaFiltration::of_regular(&sites, &result);
    let points = sites.sites().points();
    values(case, &filtration, &Weighted::new(points, sites.weights()), points.len());
    homology(case, &filtration);
    filtration.simplices().len()
}

/// A simplex whose smallest sphere holds no site inside, of all there are, has its own radius for a value; any other the least
/// value of its cofaces. Faces come first.
fn values<const D: usize>(
    case: &Case<D>,
    filtration: &AlphaFiltration<D>,
    kernel: &impl Metric<D>,
    sites: usize,
) {
    let simplices = filtration.simplices();
    let mut least: Vec<Option<u32>> = vec![None; simplices.len()];
    for index in (0..simplices.len()).rev() {
        let (simplex, rank) = (SimplexId::new(index), filtration.ranks()[index]);
        let vertices = simplices.vertices(simplex);
        let corners: Vec<VertexId> = vertices.iter().map(|&v| VertexId::new(v as usize)).collect();
        let mut others = (0..sites).map(VertexId::new).filter(|site| !corners.contains(site));
        let inside =
            others.find(|&site| kernel.in_smallest_sphere(&corners, site) == Sign::Positive);
        assert_eq!(
            filtration.is_attached(simplex),
            inside.is_some(),
            "{}: {vertices:?} has {inside:?} inside",
            case.name
        );
        if inside.is_none() {
            let own = kernel.exact_squared_radius(&corners);
            assert!(filtration.value(simplex) == own, "{}: value of {vertices:?}", case.name);
        } else {
            assert_eq!(Some(rank), least[index], "{}: {vertices:?} is attached", case.name);
        }
        for &facet in simplices.facets(simplex) {
            let facet = facet as usize;
            assert!(filtration.ranks()[facet] <= rank, "{}: face of {vertices:?}", case.name);
            least[facet] = Some(least[facet].map_or(rank, |other| other.min(rank)));
        }
    }
}

/// Betti numbers are those of the persistent pairs; the whole complex has one component and no hole.
fn homology<const D: usize>(case: &Case<D>, filtration: &AlphaFiltration<D>) {
    let curves = filtration.betti_curves();
    let persistence = filtration.persistence();
    assert_eq!(curves, filtration.betti_of(&persistence), "{}: Betti numbers", case.name);
    let whole = curves.at(filtration.whole());
    let expected = usize::from(!filtration.simplices().is_empty());
    assert_eq!(whole.iter().sum::<usize>(), expected, "{}: {whole:?} of a ball", case.name);
    assert_eq!(whole.first().copied().unwrap_or(0), expected, "{}: {whole:?}", case.name);
}
