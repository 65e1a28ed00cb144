use super::*;
use crate::Pslg;

/// A linear congruence: whole numbers below `bound`.
fn whole(seed: &mut u64, bound: u32) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    f64::from(u32::try_from(*seed >> 33).expect("31 bits") % bound)
}

/// Random segments with full mantissas: spokes of a wheel that miss its hub by little, so that many crossings lie close.
fn wheel(seed: u64, spokes: usize) -> (Vec<[f64; 2]>, Vec<[usize; 2]>) {
    let mut seed = seed;
    let mut point = |far: f64| {
        let [x, y] = [0; 2].map(|_| (whole(&mut seed, 1 << 30) + 1.0) / f64::from(1 << 30));
        [far * x / 3.0, y / 3.0]
    };
    let points: Vec<[f64; 2]> =
        (0..2 * spokes).map(|i| if i % 2 == 0 { point(1e-3) } else { point(-1e-3) }).collect();
    (points, (0..spokes).map(|i| [2 * i, 2 * i + 1]).collect())
}

/// How far a point is from a segment, in plain doubles.
fn distance(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let length = u[0].hypot(u[1]);
    if length == 0.0 { v[0].hypot(v[1]) } else { (u[0] * v[1] - u[1] * v[0]).abs() / length }
}

#[test]
fn pieces_do_not_cross_and_stay_by_their_segments() {
    let mut most = 0;
    for seed in 0..40 {
        let (points, segments) = wheel(seed, 25);
        let snapped = Snapped::new(&points, &segments, 30).expect("finite points");
        assert!(snapped.is_settled, "seed {seed}");
        Pslg::new(&snapped.points, &snapped.segments).expect("no crossings");
        assert_eq!(snapped.points[..points.len()], points);
        for (piece, &origin) in snapped.segments.iter().zip(&snapped.origins) {
            let [a, b] = segments[origin as usize].map(|end| points[end]);
            for &end in piece {
                assert!(distance(snapped.points[end], a, b) < 1e-14, "seed {seed}");
            }
        }
        most = most.max(snapped.rounds);
    }
    assert!(most > 0);
}

#[test]
fn pieces_lead_from_end_to_end() {
    let (points, segments) = wheel(3, 12);
    let snapped = Snapped::new(&points, &segments, 30).expect("finite points");
    for (segment, &[a, b]) in (0u32..).zip(&segments) {
        let pieces = snapped.segments.iter().zip(&snapped.origins);
        let mut at = a;
        for (&[from, to], _) in pieces.filter(|(_, origin)| **origin == segment) {
            assert_eq!(from, at);
            at = to;
        }
        assert_eq!(at, b);
    }
}

#[test]
fn rounding_may_cross_again() {
    // Between 2^52 and 2^53 doubles are the integers: a crossing moves by up to half of the distance to the next one.
    let again = (0..20).any(|mut seed| {
        let points: Vec<[f64; 2]> =
            (0..60).map(|_| [0; 2].map(|_| 2f64.powi(52) + whole(&mut seed, 200))).collect();
        let segments: Vec<[usize; 2]> = (0..30).map(|i| [2 * i, 2 * i + 1]).collect();
        let snapped = Snapped::new(&points, &segments, 50).expect("finite points");
        assert!(snapped.is_settled);
        Pslg::new(&snapped.points, &snapped.segments).expect("no crossings");
        snapped.rounds > 1
    });
    assert!(again, "no input needed a second round");
}

#[test]
fn pieces_may_collapse() {
    // All crossings are at distances below an ulp of 1 from (1, 1), which is a site.
    let e = f64::EPSILON;
    let points =
        [[1.0, 1.0], [0.0, 1.0 - e], [2.0, 1.0 + 2.0 * e], [1.0 + 2.0 * e, 0.0], [1.0 - e, 2.0]];
    let snapped = Snapped::new(&points, &[[1, 2], [3, 4]], 10).expect("finite points");
    assert!(snapped.is_settled);
    let graph = Pslg::new(&snapped.points, &snapped.segments).expect("no crossings");
    assert_eq!(snapped.points.len(), 6);
    assert!(graph.sites().len() <= 6);
}

#[test]
fn what_does_not_settle_says_so() {
    let square = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]];
    let snapped = Snapped::new(&square, &[[0, 2], [1, 3]], 0).expect("finite points");
    assert!(!snapped.is_settled);
    assert_eq!(snapped.segments, [[0, 2], [1, 3]]);
}
