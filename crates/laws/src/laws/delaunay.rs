//! The laws of Delaunay triangulations.

use delone::Sites;
use delone::check::naive;
use delone::delaunay::{
    Algorithm, Delaunay, Dynamic, Inserted, Options, algorithms, bowyer_watson, delaunay, regular,
};
use delone::predicates::Adaptive;
use delone::sites::WeightedSites;
use delone::workloads::Rng;

use super::{Law, THOROUGH_MAX, all_options, scalings, symmetries, translations};
use crate::case::Case;
use crate::cells::delaunay_cells;
use crate::id;
use crate::judge::{Rigour, accept_delaunay, accept_regular};

/// Every law of point sets, in D dimensions.
#[must_use]
pub fn delaunay_laws<const D: usize>() -> Vec<Law<D>> {
    vec![
        Law { name: "valid", hold: valid },
        Law { name: "agreement", hold: agreement },
        Law { name: "order", hold: order },
        Law { name: "scaling", hold: |case| same_cells(case, scalings(case)) },
        Law { name: "translation", hold: |case| same_cells(case, translations(case)) },
        Law { name: "symmetry", hold: symmetry },
        Law { name: "euler", hold: euler },
        Law { name: "definition", hold: definition },
        Law { name: "removal", hold: removal },
        Law { name: "weights", hold: weights },
    ]
}

fn run<const D: usize>(case: &Case<D>) -> Delaunay<D> {
    delaunay(&case.sites(), &Options::default(), &mut ())
}

/// The algorithms that are meant for as many sites.
fn fitting<const D: usize>(sites: &Sites<D>) -> Vec<Algorithm<D>> {
    algorithms().into_iter().filter(|algorithm| sites.len() <= algorithm.sites_max).collect()
}

fn valid<const D: usize>(case: &Case<D>) -> usize {
    let sites = case.sites();
    let rigour = if case.points.len() <= THOROUGH_MAX { Rigour::EveryWay } else { Rigour::Once };
    let algorithms = fitting(&sites);
    for algorithm in &algorithms {
        let result = (algorithm.run)(&sites, &Options::default());
        accept_delaunay(case, &sites, &result, rigour);
    }
    algorithms.len()
}

fn agreement<const D: usize>(case: &Case<D>) -> usize {
    let sites = case.sites();
    let first = run(case).canonical();
    let (algorithms, options) = (fitting(&sites), all_options());
    for algorithm in &algorithms {
        for options in &options {
            let other = (algorithm.run)(&sites, options).canonical();
            assert_eq!(other, first, "{}: {} {options:?}", case.name, algorithm.name);
        }
    }
    algorithms.len() * options.len()
}

fn order<const D: usize>(case: &Case<D>) -> usize {
    let print = |case: &Case<D>| run(case).fingerprint(&case.sites());
    let first = print(case);
    for seed in 1..=3 {
        let shuffled = case.shuffled(seed);
        assert_eq!(print(&shuffled), first, "{}", shuffled.name);
    }
    3
}

/// The images, same points in the same order of ids and of coordinates, have the cells of the case.
fn same_cells<const D: usize>(case: &Case<D>, images: Vec<Case<D>>) -> usize {
    let first = run(case).canonical();
    for image in &images {
        assert_eq!(run(image).canonical(), first, "{}", image.name);
    }
    images.len()
}

fn symmetry<const D: usize>(case: &Case<D>) -> usize {
    let cells = |case: &Case<D>| {
        let result = run(case);
        let corners = result.mesh().corner_count();
        delaunay_cells(case.sites().points(), &result.canonical(), corners, &[])
    };
    let first = cells(case);
    let images = symmetries(case);
    for image in &images {
        assert_eq!(cells(image), first, "{}", image.name);
    }
    images.len()
}

/// Of the solid cells: `sum (-1)^i (number of i-faces) = 1`; in the plane, `2n - 2 - h` triangles.
fn euler<const D: usize>(case: &Case<D>) -> usize {
    let result = run(case);
    let mesh = result.mesh();
    let corners = mesh.corner_count();
    if corners == 0 {
        assert_eq!((mesh.cell_count(), case.points.len()), (0, 0), "{}", case.name);
        return 1;
    }
    let cells = result.canonical();
    let mut sum = 0isize;
    for size in 1..=corners {
        let count = isize::try_from(face_count(&cells, corners, size)).expect("a small count");
        sum += if size % 2 == 1 { count } else { -count };
    }
    assert_eq!(sum, 1, "{}: euler characteristic", case.name);
    if corners == 3 {
        let (n, h) = (case.sites().len(), mesh.ghost_cells().count());
        assert_eq!(mesh.solid_cells().count() + 2 + h, 2 * n, "{}", case.name);
    }
    1
}

/// The number of distinct faces of `size` vertices.
fn face_count(cells: &[u32], corners: usize, size: usize) -> usize {
    let masks = (1..1u32 << corners).filter(|mask| mask.count_ones() as usize == size);
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for mask in masks {
        let face =
            |cell: &[u32]| (0..corners).filter(|i| mask >> i & 1 == 1).map(|i| cell[i]).collect();
        faces.extend(cells.chunks(corners).map(face));
    }
    faces.sort_unstable();
    faces.dedup();
    faces.len()
}

/// The most points for which brute force is quick.
fn naive_max(dimension: usize) -> usize {
    if dimension <= 2 { 16 } else { 11 }
}

fn definition<const D: usize>(case: &Case<D>) -> usize {
    if case.points.len() > naive_max(D) {
        return 0;
    }
    let result = run(case);
    let input_of = case.sites().input_of().to_vec();
    let found = in_input_ids(&result.canonical(), result.mesh().corner_count(), &input_of);
    assert_eq!(found, naive::delaunay(&case.points), "{}", case.name);
    1
}

/// Cells of sites as sorted cells of input points.
pub(super) fn in_input_ids(cells: &[u32], corners: usize, input_of: &[u32]) -> Vec<Vec<u32>> {
    let mut cells: Vec<Vec<u32>> = cells
        .chunks(corners.max(1))
        .map(|cell| cell.iter().map(|&site| input_of[site as usize]).collect())
        .collect();
    cells.iter_mut().for_each(|cell| cell.sort_unstable());
    cells.sort_unstable();
    cells
}

/// The most sites that are taken out one after the other.
const REMOVED_MAX: usize = 12;

/// Sites taken out leave what the others make from scratch; put back, they make what was there.
fn removal<const D: usize>(case: &Case<D>) -> usize {
    let (sites, whole) = (case.sites(), run(case));
    let kernel = Adaptive::new(sites.points());
    let mut changing = Dynamic::of(&kernel, whole.mesh().clone(), sites.len(), &[]);
    let mut order: Vec<u32> = (0..id(sites.len())).collect();
    Rng::named("removal", 1).shuffle(&mut order);
    let (gone, kept) = order.split_at(sites.len().min(REMOVED_MAX));
    let cells = |mesh: &delone::Mesh<D>| mesh.canonical(|vertex| id(vertex.index()));
    for (count, &site) in (1..).zip(gone) {
        assert!(changing.remove(site, &mut ()), "{}: {site}", case.name);
        let others = [&gone[count..], kept].concat();
        let scratch = bowyer_watson(&kernel, &others, &mut ());
        assert_eq!(cells(changing.mesh()), cells(&scratch), "{}: without {site}", case.name);
    }
    for &site in gone {
        assert_eq!(changing.insert(site, &mut ()), Inserted::Vertex, "{}: {site}", case.name);
    }
    assert_eq!(cells(changing.mesh()), whole.canonical(), "{}: all put back", case.name);
    2 * gone.len()
}

/// The regular triangulation is what the judge calls so, for weights that hide none, some, and most sites.
fn weights<const D: usize>(case: &Case<D>) -> usize {
    let mut rng = Rng::named("weights", 1);
    let near = case.points.windows(2).map(|pair| (pair[0][0] - pair[1][0]).powi(2));
    let scale = near.filter(|square| *square < 1e300).fold(0.0, f64::max);
    let scales = [0.0, 1.0, scale / 64.0];
    for factor in scales {
        let mut weight = || f64::from(u32::try_from(rng.below(8)).expect("small")) * factor;
        let weights: Vec<f64> = case.points.iter().map(|_| weight()).collect();
        let sites = WeightedSites::new(&case.points, &weights).expect("finite");
        let result = regular(&sites, &Options::default(), &mut ());
        accept_regular(case, &weights, &sites, &result);
        if factor == 0.0 {
            assert_eq!(result.canonical(), run(case).canonical(), "{}: no weight", case.name);
        }
        if case.points.len() <= naive_max(D) {
            let corners = result.mesh().corner_count();
            let found = in_input_ids(&result.canonical(), corners, sites.input_of());
            assert_eq!(found, naive::regular(&case.points, &weights), "{}", case.name);
        }
    }
    scales.len()
}
