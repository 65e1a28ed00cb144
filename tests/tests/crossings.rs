//! Segments that cross, every crossing a vertex: all algorithms under the constructed kernel give the same triangulation,
//! which the judge proves in ratios of its own.

use delone::workloads::{Points, Rng, all};
use delone_tests::case::Case;
use delone_tests::laws::crossings as hold;

/// How many crossings became vertices.
fn check(name: &str, points: &[[f64; 2]], segments: &[[usize; 2]]) -> usize {
    let id = |v: usize| u32::try_from(v).expect("a small id");
    let segments = segments.iter().map(|ends| ends.map(id)).collect();
    hold(&Case::new(name, points.to_vec(), segments)) - 1
}

#[test]
fn workloads_that_cross() {
    let mut crossings = 0;
    for workload in all().iter().filter(|workload| workload.crosses()) {
        for (n, seed) in [(12, 1), (40, 2), (90, 3)] {
            let input = workload.generate(n, seed);
            let Points::Plane(points) = &input.points else { panic!("segments are in the plane") };
            let segments: Vec<[usize; 2]> =
                input.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
            crossings += check(&format!("{} {n} {seed}", workload.name), points, &segments);
        }
    }
    assert!(crossings > 300, "{crossings}");
}

#[test]
fn random_segments_on_small_grids() {
    let mut rng = Rng::named("crossings", 1);
    let mut crossings = 0;
    for round in 0..150 {
        let side = 3 + round % 12;
        let mut coordinate = || f64::from(u32::try_from(rng.below(side)).expect("small"));
        let points: Vec<[f64; 2]> = (0..14).map(|_| [coordinate(), coordinate()]).collect();
        let mut end = || usize::try_from(rng.below(14)).expect("small");
        let segments: Vec<[usize; 2]> = (0..9).map(|_| [end(), end()]).collect();
        crossings += check(&format!("round {round}: {points:?} {segments:?}"), &points, &segments);
    }
    assert!(crossings > 300, "{crossings}");
}
