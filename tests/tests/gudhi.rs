//! Alpha values: every simplex's, beside Gudhi's exact alpha complex, which tells doubles.

use delone::alpha::SimplexId;
use delone::sites::Sites;
use delone::workloads::{Rng, generate};
use delone_tests::alpha::filtration;
use delone_tests::data::{documents, files, points_of};
use delone_tests::gudhi::Gudhi;
use delone_tests::say;

/// How many simplices were compared, and how many of their values differed in the last bit.
#[derive(Debug, Default)]
struct Count {
    simplices: usize,
    last_bit: usize,
}

impl Count {
    /// Demands the same simplices, and values that are ours or the double next to it: Gudhi does not round to nearest.
    fn compare<const D: usize>(
        &mut self,
        gudhi: &mut Gudhi,
        name: &str,
        points: &[[f64; D]],
        weights: Option<&[f64]>,
    ) {
        let points = Sites::new(points).expect("finite").points().to_vec();
        let weights = weights.map(|weights| &weights[..points.len()]);
        let ours = filtration(&points, weights);
        if ours.simplices().dimension() != Some(D) {
            return; // Gudhi's order of what is in a flat is its own
        }
        let all = (0..ours.simplices().len()).map(SimplexId::new);
        let theirs = gudhi.alpha_values(&points, weights);
        assert_eq!(ours.simplices().len(), theirs.len(), "{name}");
        for (simplex, (vertices, value)) in all.zip(theirs) {
            assert_eq!(ours.simplices().vertices(simplex), vertices, "{name}");
            let nearest = ours.value(simplex).to_f64();
            let is_next = value == nearest.next_up() || value == nearest.next_down();
            assert!(value == nearest || is_next, "{name} {vertices:?}: {nearest}, Gudhi {value}");
            self.simplices += 1;
            self.last_bit += usize::from(is_next);
        }
    }
}

#[test]
fn values_of_workloads() {
    let Some(mut gudhi) = Gudhi::start() else { return };
    let mut rng = Rng::named("alpha weights", 3);
    let (mut plain, mut weighted) = (Count::default(), Count::default());
    for name in
        ["uniform", "grid", "circle", "clusters", "gauss", "uniform-3d", "grid-3d", "sphere"]
    {
        let input = generate(name, 300, 5).expect("a workload");
        let weights: Vec<f64> =
            (0..input.points.len()).map(|_| rng.below(1 << 20) as f64 / 1e10).collect();
        for (count, weights) in [(&mut plain, None), (&mut weighted, Some(&weights[..]))] {
            if let Some(points) = input.points.plane() {
                count.compare(&mut gudhi, name, points, weights);
            } else if let Some(points) = input.points.space() {
                count.compare(&mut gudhi, name, points, weights);
            }
        }
    }
    say(format!("Gudhi, alpha values: {plain:?}, with weights {weighted:?}"));
    assert!(plain.simplices > 10_000 && weighted.simplices > 10_000);
}

#[test]
fn values_of_small_integers() {
    let Some(mut gudhi) = Gudhi::start() else { return };
    let mut rng = Rng::named("alpha integers", 4);
    let mut count = Count::default();
    for round in 0..60 {
        let mut coordinate = || rng.below(4 + round / 10) as f64;
        let plane: Vec<[f64; 2]> = (0..12).map(|_| [coordinate(), coordinate()]).collect();
        let space: Vec<[f64; 3]> = (0..12).map(|_| [0; 3].map(|_| coordinate())).collect();
        count.compare(&mut gudhi, "small integers", &plane, None);
        count.compare(&mut gudhi, "small integers", &space, None);
    }
    say(format!("Gudhi, alpha values of small integers: {count:?}"));
    assert!(count.simplices > 3000);
}

/// Files of at most so many points: Gudhi's exact rationals are slow.
const POINTS_MAX: usize = 1000;

#[test]
fn values_of_collected_files() {
    let Some(mut gudhi) = Gudhi::start() else { return };
    let mut count = Count::default();
    for path in ["points2d", "points3d"].into_iter().flat_map(files) {
        for document in documents(&path) {
            if document.point_count() > POINTS_MAX {
                continue;
            }
            if let Some(case) = points_of::<2>(&document) {
                count.compare(&mut gudhi, &case.name, &case.points, None);
            } else if let Some(case) = points_of::<3>(&document) {
                count.compare(&mut gudhi, &case.name, &case.points, None);
            }
        }
    }
    say(format!("Gudhi, alpha values of collected files: {count:?}"));
}
