//! Brute force in exact arithmetic (`robust`, whose doubles are exact in sign) over every pair of segments and sites.

use crate::num::pow2;
use crate::{Input, Kind, Meets, Workload, all, generate};
use robust::{Coord, orient2d};
use std::cmp::Ordering;

type Point = [f64; 2];

/// `robust` may return a zero of either sign; `+ 0.0` makes both positive.
fn side(a: Point, b: Point, c: Point) -> Ordering {
    let [p, q, r] = [a, b, c].map(|[x, y]| Coord { x, y });
    (orient2d(p, q, r) + 0.0).total_cmp(&0.0)
}

fn strictly_between(a: Point, b: Point, p: Point) -> bool {
    side(a, b, p).is_eq() && a != p && b != p && (0..2).all(|i| within(a[i], b[i], p[i]))
}

fn within(a: f64, b: f64, x: f64) -> bool {
    a.min(b) <= x && x <= a.max(b)
}

fn opposite(s: Ordering, t: Ordering) -> bool {
    s.is_ne() && s == t.reverse()
}

fn meet(s: [Point; 2], t: [Point; 2]) -> Meets {
    let far = |i: usize| {
        s[0][i].max(s[1][i]) < t[0][i].min(t[1][i]) || t[0][i].max(t[1][i]) < s[0][i].min(s[1][i])
    };
    if far(0) || far(1) {
        return Meets::AtEnds;
    }
    let on_s = t.map(|p| side(s[0], s[1], p));
    let on_t = s.map(|p| side(t[0], t[1], p));
    if opposite(on_s[0], on_s[1]) && opposite(on_t[0], on_t[1]) {
        return Meets::Crossing;
    }
    let inside = t.iter().filter(|&&p| strictly_between(s[0], s[1], p)).count()
        + s.iter().filter(|&&p| strictly_between(t[0], t[1], p)).count();
    let same = s == t || s == [t[1], t[0]];
    if same || (on_s == [Ordering::Equal; 2] && inside > 0) {
        return Meets::Along;
    }
    if inside > 0 { Meets::InsideOne } else { Meets::AtEnds }
}

/// `robust` needs products that neither vanish nor overflow: scaled back by a power of two, which is exact.
fn ordinary(points: &[Point]) -> Vec<Point> {
    let size = points.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
    let by = match size {
        1e200.. => pow2(-900),
        0.0..1e-200 => pow2(900),
        _ => 1.0,
    };
    points.iter().map(|p| p.map(|x| x * by)).collect()
}

/// The worst meeting of an input, sites that belong to no segment and equal sites included.
fn worst(input: &Input) -> Meets {
    let points = &ordinary(input.points.plane().unwrap());
    let segments: Vec<[Point; 2]> =
        input.segments.iter().map(|s| s.map(|v| points[v as usize])).collect();
    let mut worst = Meets::AtEnds;
    for (i, &s) in segments.iter().enumerate() {
        for &t in &segments[..i] {
            worst = worst.max(meet(s, t));
        }
        if worst < Meets::InsideOne && points.iter().any(|&p| strictly_between(s[0], s[1], p)) {
            worst = Meets::InsideOne;
        }
    }
    worst
}

fn equal_sites(input: &Input) -> usize {
    let mut points: Vec<[u64; 2]> =
        input.points.plane().unwrap().iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
    points.sort_unstable();
    points.windows(2).filter(|w| w[0] == w[1]).count()
}

fn graphs() -> impl Iterator<Item = &'static Workload> {
    all().iter().filter(|w| w.kind() == Kind::Pslg)
}

#[test]
fn segments_meet_as_announced() {
    for workload in graphs() {
        for n in (0..=33).chain([50, 77, 128, 300]) {
            for seed in 0..3 {
                let input = workload.generate(n, seed);
                let (name, met) = (workload.name, worst(&input));
                assert!(met <= workload.meets, "{name} n {n} seed {seed}: {met:?}");
                assert!(n < 50 || met == workload.meets, "{name} {n} {seed} is tame: {met:?}");
                assert!(workload.crosses() || equal_sites(&input) == 0, "{name} {n} {seed}");
            }
        }
    }
}

/// Too many for all pairs: segments sorted by their left end, each against those that begin before it ends.
#[test]
fn a_coast_of_twenty_thousand_does_not_cross() {
    for seed in 0..2 {
        let input = generate("coast", 20_000, seed).unwrap();
        assert_eq!(input.points.len(), 20_000);
        let points = input.points.plane().unwrap();
        let mut segments: Vec<[Point; 2]> =
            input.segments.iter().map(|s| s.map(|v| points[v as usize])).collect();
        segments.iter_mut().for_each(|s| s.sort_by(|p, q| p[0].total_cmp(&q[0])));
        segments.sort_by(|s, t| s[0][0].total_cmp(&t[0][0]));
        for (i, &s) in segments.iter().enumerate() {
            for &t in segments[i + 1..].iter().take_while(|t| t[0][0] <= s[1][0]) {
                assert_eq!(meet(s, t), Meets::AtEnds, "{s:?} {t:?}");
            }
        }
    }
}

/// A maximal PSLG: 3n - 3 - h edges, h sites on the hull, counted with those inside hull edges.
#[test]
fn the_triangulated_grid_is_maximal() {
    for k in 2..10 {
        let input = generate("triangulated-grid", k * k, 1).unwrap();
        assert_eq!(input.segments.len(), 3 * k * k - 3 - 4 * (k - 1));
    }
}

#[test]
fn the_snowflake_is_closed_and_exact() {
    for n in [3, 12, 48, 51, 192] {
        let input = generate("koch", n, 0).unwrap();
        let points = input.points.plane().unwrap();
        assert_eq!((points.len(), input.segments.len()), (n, n));
        let [a, b, c] = [points[0], points[1], points[2]];
        assert!(n > 3 || side(a, b, c).is_lt());
    }
}

#[test]
fn the_hilbert_curve_walks_unit_steps_over_all_cells() {
    let input = generate("hilbert", 256, 0).unwrap();
    let points = input.points.plane().unwrap();
    let step = |w: &[Point]| (w[0][0] - w[1][0]).abs() + (w[0][1] - w[1][1]).abs();
    assert!(points.windows(2).all(|w| step(w) == 1.0));
    assert!(equal_sites(&input) == 0 && points.iter().flatten().all(|x| (0.0..16.0).contains(x)));
}
