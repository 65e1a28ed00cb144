use super::circles::lattice;
use crate::{Points, Rng, generate};

fn plane(name: &str, n: usize) -> Vec<[f64; 2]> {
    let Points::Plane(points) = generate(name, n, 3).unwrap().points else { panic!("{name}") };
    points
}

fn distinct(points: &[[f64; 2]]) -> usize {
    let mut bits: Vec<_> = points.iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
    bits.sort_unstable();
    bits.dedup();
    bits.len()
}

#[test]
fn circle_exact_is_cocircular_in_integers_and_distinct() {
    for n in [0, 1, 4, 5, 100, 3000, 1_000_000] {
        let points = lattice(n, &mut Rng::new(1));
        assert_eq!(points.len(), n.min(236_196));
        let norm = |p: &[i64; 2]| p.map(|x| i128::from(x) * i128::from(x)).iter().sum::<i128>();
        assert!(points.iter().all(|p| norm(p) == norm(&points[0])));
        assert!(points.iter().flatten().all(|x| x.abs() < 1 << 50), "exact as doubles");
        assert_eq!(
            distinct(&points.iter().map(|p| p.map(|x| x as f64)).collect::<Vec<_>>()),
            points.len()
        );
    }
}

#[test]
fn spread_sets_are_distinct_and_repeating_sets_repeat() {
    for name in
        ["uniform", "gauss", "kuzmin", "grid", "hexagonal", "grid-tilted", "ulp-grid", "spiral"]
    {
        assert_eq!(distinct(&plane(name, 500)), 500, "{name}");
    }
    assert!(distinct(&plane("duplicates", 400)) <= 100);
    assert_eq!(distinct(&plane("all-equal", 100)), 1);
    let near = distinct(&plane("near-duplicates", 400));
    assert!((300..400).contains(&near), "{near}");
}

#[test]
fn range_sets_reach_the_ends() {
    let exponent = |x: f64| x.to_bits() << 1 >> 53;
    let all: Vec<u64> = plane("full-range", 4000).into_iter().flatten().map(exponent).collect();
    assert!(all.iter().min() < Some(&8) && all.iter().max() > Some(&2038));
    assert!(plane("denormals", 100).iter().flatten().all(|x| x.is_subnormal() || *x == 0.0));
    assert!(plane("largest", 100).iter().flatten().all(|x| x.abs() > 1.79e308));
    let unit =
        |name, by: f64| plane(name, 9).iter().flatten().all(|x| (0.0..1.0).contains(&(x / by)));
    assert!(
        unit("scaled-tiny", crate::num::pow2(-900)) && unit("scaled-huge", crate::num::pow2(900))
    );
}

#[test]
fn lines_are_lines_and_near_lines_are_not() {
    use robust::{Coord, orient2d};
    let turns = |name: &str| {
        let points = plane(name, 60);
        let at = |i: usize| Coord { x: points[i][0], y: points[i][1] };
        (2..60).filter(|&i| orient2d(at(0), at(1), at(i)) != 0.0).count()
    };
    for name in ["line-horizontal", "line-vertical", "line-diagonal", "all-equal"] {
        assert_eq!(turns(name), 0, "{name}");
    }
    assert_eq!(turns("one-off-line"), 1);
    assert!(turns("line-inexact") > 40 && turns("near-collinear") > 40);
}
