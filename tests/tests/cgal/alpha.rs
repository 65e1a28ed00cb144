//! Alpha values: every simplex's, as a reduced fraction, over CGAL's exact kernel.

use delone::alpha::{SimplexId, fraction};
use delone::sites::Sites;
use delone::workloads::{Rng, generate};
use delone_tests::alpha::filtration;
use delone_tests::cgal::Cgal;
use delone_tests::data::{documents, files, points_of};
use delone_tests::say;

/// Demands equal values; how many there are. Points in a flat, which CGAL's shapes do not know, are left out.
fn equal<const D: usize>(
    cgal: &mut Cgal,
    name: &str,
    points: &[[f64; D]],
    weights: Option<&[f64]>,
) -> usize {
    let points = Sites::new(points).expect("finite").points().to_vec();
    let weights = weights.map(|weights| &weights[..points.len()]);
    let ours = filtration(&points, weights);
    if ours.simplices().dimension() != Some(D) {
        return 0;
    }
    let least = if D == 2 { 1 } else { 0 };
    let all = (0..ours.simplices().len()).map(SimplexId::new);
    let compared = all.filter(|&simplex| ours.simplices().dimension_of(simplex) >= least);
    let value = |simplex: SimplexId| {
        (ours.simplices().vertices(simplex).to_vec(), fraction(&ours.value(simplex)))
    };
    let mut values: Vec<(Vec<u32>, String)> = compared.map(value).collect();
    values.sort_unstable();
    let theirs = cgal.alpha_values(&points, weights).expect("CGAL answers");
    let different = values.iter().zip(&theirs).find(|(ours, theirs)| ours != theirs);
    assert_eq!(different, None, "{name}: ours, theirs");
    assert_eq!(values.len(), theirs.len(), "{name}");
    values.len()
}

#[test]
fn alpha_values_of_workloads() {
    let Some(mut cgal) = Cgal::with_alpha_shapes() else { return };
    let mut rng = Rng::named("alpha weights", 1);
    let mut counts = [0; 2];
    for name in
        ["uniform", "grid", "circle", "clusters", "gauss", "uniform-3d", "grid-3d", "sphere"]
    {
        let input = generate(name, 150, 3).expect("a workload");
        let weights: Vec<f64> =
            (0..input.points.len()).map(|_| rng.below(16) as f64 / 1024.0).collect();
        for weights in [None, Some(&weights[..])] {
            let kind = usize::from(weights.is_some());
            if let Some(points) = input.points.plane() {
                counts[kind] += equal(&mut cgal, name, points, weights);
            } else if let Some(points) = input.points.space() {
                counts[kind] += equal(&mut cgal, name, points, weights);
            }
        }
    }
    say(format!("CGAL, alpha values: {} equal, with weights {}", counts[0], counts[1]));
    assert!(counts.iter().all(|&count| count > 3000), "{counts:?}");
}

#[test]
fn alpha_values_of_small_integers() {
    let Some(mut cgal) = Cgal::with_alpha_shapes() else { return };
    let mut rng = Rng::named("alpha integers", 2);
    let mut count = 0;
    for round in 0..60 {
        let mut coordinate = || rng.below(4 + round / 10) as f64;
        let plane: Vec<[f64; 2]> = (0..12).map(|_| [coordinate(), coordinate()]).collect();
        let space: Vec<[f64; 3]> = (0..12).map(|_| [0; 3].map(|_| coordinate())).collect();
        // Off the integers: CGAL marks what is attached by the value -2.
        let weights: Vec<f64> = (0..12).map(|_| coordinate() + 0.3).collect();
        for weights in [None, Some(&weights[..])] {
            count += equal(&mut cgal, "small integers", &plane, weights);
            count += equal(&mut cgal, "small integers", &space, weights);
        }
    }
    say(format!("CGAL, alpha values of small integers: {count} equal"));
    assert!(count > 3000, "{count}");
}

/// Files of at most so many points: CGAL's exact rationals are slow.
const POINTS_MAX: usize = 300;

#[test]
fn alpha_values_of_collected_files() {
    let Some(mut cgal) = Cgal::with_alpha_shapes() else { return };
    let (mut inputs, mut count) = (0, 0);
    for path in ["points2d", "points3d"].into_iter().flat_map(files) {
        for document in documents(&path) {
            if document.point_count() > POINTS_MAX {
                continue;
            }
            let equal = match document.dimension {
                2 => points_of::<2>(&document)
                    .map_or(0, |case| equal(&mut cgal, &case.name, &case.points, None)),
                _ => points_of::<3>(&document)
                    .map_or(0, |case| equal(&mut cgal, &case.name, &case.points, None)),
            };
            inputs += usize::from(equal > 0);
            count += equal;
        }
    }
    say(format!("CGAL, alpha values of {inputs} collected inputs: {count} equal"));
}
