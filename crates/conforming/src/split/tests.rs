use delone_check::Promise;
use delone_sites::Pslg;

use super::*;
use crate::testing::{judged, pslg};
use crate::{ConformOptions, Conforming, Encroached, Limits, Missing, conform};

/// By the rules of the specification: radii, if at all, in the middle half, else middles.
fn gabriel(graph: &Pslg, copies_radii: bool, vertices_max: usize) -> Conforming {
    let placement =
        Placement { copies_radii, takes_feet: false, parts_max: 4, ..Placement::default() };
    let options =
        ConformOptions { placement, limits: Limits { vertices_max }, ..ConformOptions::default() };
    conform(graph, &Encroached, &options, &mut ())
}

fn fan(tips: impl Iterator<Item = [f64; 2]>) -> Pslg {
    let points: Vec<[f64; 2]> = std::iter::once([0.0, 0.0]).chain(tips).collect();
    let segments: Vec<[usize; 2]> = (1..points.len()).map(|tip| [0, tip]).collect();
    pslg(&points, &segments)
}

fn judged_both(graph: &Pslg) -> [usize; 2] {
    let options = ConformOptions::default();
    let results = [
        (conform(graph, &Missing, &options, &mut ()), Promise::Conforming),
        (conform(graph, &Encroached, &options, &mut ()), Promise::EmptyDisks),
    ];
    results.map(|(conforming, promise)| {
        let verdict = judged(graph, &conforming, promise);
        assert!(conforming.is_complete() && verdict.ok, "{verdict}");
        conforming.steiner_points().len()
    })
}

/// Five segments of different lengths, 1e-6 apart and less.
#[test]
fn fans_of_the_specification() {
    let tips = (1..=5u32).map(f64::from);
    let graph = fan(tips.clone().map(|i| [1e6 * i, 7.0 * i * i]));
    let with = gabriel(&graph, true, usize::MAX);
    assert_eq!(with.constrained_edges().len(), 51, "as the exact prototype of this rule has it");
    let verdict = judged(&graph, &with, Promise::EmptyDisks);
    assert!(with.is_complete() && verdict.ok, "{verdict}");
    let without = gabriel(&graph, false, 1500);
    assert!(!without.is_complete(), "over 1,500 subsegments without copies");
    let subsegments = judged_both(&graph)[1] + 5;
    assert!(subsegments < 51, "nearer to the ends it takes fewer: {subsegments}");
    judged_both(&fan(tips.map(|i| [1e6, i])));
    judged_both(&fan((0..2u32).map(|i| [1e8, f64::from(i)])));
    judged_both(&fan((0..2u32).map(|i| [1e16, f64::from(i)])));
    judged_both(&fan((0..3u32).map(|i| [1e16 + 5e15 * f64::from(i), 1.0 + f64::from(i)])));
}

#[test]
fn slivers_terminate() {
    judged_both(&pslg(&[[0.0, 0.0], [1e6, 1.0], [1e6, 0.0]], &[[0, 1], [1, 2], [2, 0]]));
    let zigzag = [[0.0, 0.0], [1000.0, 1.0], [0.0, 2.0], [1000.0, 3.0], [0.0, 4.0]];
    judged_both(&pslg(&zigzag, &[[0, 1], [1, 2], [2, 3], [3, 4]]));
}

/// Angles of 1e-6 degrees (1.7e-8) and far less, of equal and of different lengths.
#[test]
fn tiny_angles_terminate() {
    for angle in [1.7e-8, 1e-12, 1e-15] {
        for longer in [1.0, 3.0, 1000.0] {
            let counts = judged_both(&fan([[1.0, 0.0], [longer, longer * angle]].into_iter()));
            assert!(counts[1] <= 40, "{angle} {longer}: {counts:?}");
        }
    }
}

/// A thousand segments from one point, of three lengths. (Of as many lengths as segments: 200,000 points, and an end too.)
#[test]
fn spokes_terminate() {
    let tips = (0..1000u32).map(|i| {
        let angle = f64::from(i) * std::f64::consts::TAU / 1000.0;
        let length = 1.0 + f64::from(i * 7919 % 3);
        [length * angle.cos(), length * angle.sin()]
    });
    let graph = fan(tips);
    for (criterion, promise) in [(0, Promise::Conforming), (1, Promise::EmptyDisks)] {
        let options = ConformOptions::default();
        let conforming = match criterion {
            0 => conform(&graph, &Missing, &options, &mut ()),
            _ => conform(&graph, &Encroached, &options, &mut ()),
        };
        assert!(conforming.steiner_points().len() < 10_000);
        assert!(conforming.is_complete());
        let verdict = judged(&graph, &conforming, promise);
        assert!(verdict.ok, "{verdict}");
    }
}

/// Segments that are parallel up to one unit in the last place: disjoint, and from one point.
#[test]
fn one_ulp_from_parallel_terminates() {
    let up = |x: f64| x + 64.0 * f64::EPSILON;
    // 64 units apart and 2^12 of them long.
    let long = 1.0 + 4096.0 * f64::EPSILON;
    let lines = [[1.0, 1.0], [long, 1.0], [1.0, up(1.0)], [long, up(1.0).next_up()]];
    judged_both(&pslg(&lines, &[[0, 1], [2, 3]]));
    let third = 1.0f64 / 3.0;
    judged_both(&fan([[1.0, third], [1.0, third.next_up()], [3.0, 1.0]].into_iter()));
    judged_both(&fan([[1e6, 1e6 / 3.0], [1e6, (1e6f64 / 3.0).next_up()]].into_iter()));
}

/// Two segments, or three, along gaps of a part 10^-3 to 10^-15 of their lengths, their ends not opposite each other, level or not.
#[test]
fn gaps_of_any_width_take_few_points() {
    for gap in [1e-3, 1e-6, 1e-9, 1e-12, 1e-15] {
        for tilt in [0.0f64, 0.3, -0.5, 50.0] {
            let level = |k: f64, x: f64| [x, k * gap * (1.0 + tilt.max(0.0) + tilt * x)];
            let points: Vec<[f64; 2]> = [(0.0, 0.0), (1.0, 0.3), (2.0, 0.55)]
                .into_iter()
                .flat_map(|(k, from)| [level(k, from), level(k, from + 1.0)])
                .collect();
            for count in [2, 3] {
                let segments: Vec<[usize; 2]> = (0..count).map(|i| [2 * i, 2 * i + 1]).collect();
                let counts = judged_both(&pslg(&points[..2 * count], &segments));
                assert!(counts[1] <= 60 * (count - 1), "{gap} {tilt}: {counts:?}");
            }
        }
    }
}

#[test]
fn of_two_feet_as_good_the_first_is_taken() {
    let points = [[0.0, 0.0], [16.0, 0.0], [4.0, 1.0], [12.0, -1.0]];
    for (segment, order) in [([0, 1], [0, 1, 2, 3]), ([1, 0], [0, 1, 3, 2])] {
        let graph = pslg(&order.map(|v: usize| points[v]), &[segment]);
        let cdt = delone_cdt::cavity(&graph, &delone_delaunay::Options::default(), &mut ());
        let live = Live::new(&cdt, &graph);
        let apexes = Apexes::new(&cdt, &live);
        let near = encroachers(&live, 0);
        assert_eq!(near.len(), 2, "one on each side");
        let t = parameter(&live, &apexes, 0, &near, Placement::default());
        assert_eq!(t, Parameter::Double(0.25));
        let feet = feet::feet(&live, 0, &near);
        let long = exact_parameter(&live, &apexes, 0, &near, &feet, Placement::default());
        assert_eq!(long, Dyadic::from(0.25));
    }
}

/// Two directions of the lemma, exactly: what is at equal radius does not encroach, what encroaches is strictly between.
#[test]
fn two_rays() {
    let ray = |scale: i64, [x, y]: [i64; 2]| [scale * x, scale * y];
    let mut encroached = 0;
    for direction in [[5, 1], [4, 3], [12, 5], [1, 7]] {
        for r in 0..12 {
            for further in r + 1..14 {
                for s in 1..16 {
                    // One ray along x, in units that make radii comparable: (scale * length)^2.
                    let square = direction[0] * direction[0] + direction[1] * direction[1];
                    let [a, b] = [[r, 0], [further, 0]];
                    let v = ray(s, direction);
                    let dot: i64 = (0..2).map(|x| (a[x] - v[x]) * (b[x] - v[x])).sum();
                    if dot <= 0 {
                        encroached += 1;
                        let radius = s * s * square;
                        assert!(r * r < radius && radius < further * further);
                    }
                }
            }
        }
    }
    assert!(encroached > 50, "{encroached}");
}

/// \[ET93\]'s lower bound: m long segments close to each other, n sites close above the first, each of which costs a point on each.
fn rails(m: usize, n: usize) -> Pslg {
    let real = |i: usize| f64::from(u32::try_from(i).unwrap());
    let length = 64.0 * real(n);
    let mut points = Vec::new();
    for j in 0..m {
        points.extend([[0.0, -real(j)], [length, -real(j)]]);
    }
    points.extend((0..n).map(|i| [64.0 * real(i) + 32.0, 1.0]));
    let segments: Vec<[usize; 2]> = (0..m).map(|j| [2 * j, 2 * j + 1]).collect();
    pslg(&points, &segments)
}

#[test]
fn every_site_costs_a_point_on_every_segment() {
    for (m, n) in [(4, 4), (4, 8), (8, 8), (16, 8), (16, 16)] {
        let counts = judged_both(&rails(m, n));
        assert!(counts[0] >= m * n / 2, "{m} {n}: {counts:?}");
        assert_eq!(counts[1], m * n, "a foot each, and no more");
    }
}

/// Fans of random segments, split at random: where doubles say a parameter, it is that of long numbers from both ends, but for a
/// few roundings, far below the precision of any apex that doubles serve.
#[test]
fn doubles_say_what_long_numbers_say() {
    let mut random = delone_workloads::Rng::new(11);
    let mut said = [0; 2];
    for round in 0..60 {
        let tips = (0..4)
            .map(|_| [0; 2].map(|_| f64::from(i32::try_from(random.below(2000)).unwrap() - 1000)));
        let graph = fan(tips.filter(|tip| *tip != [0.0; 2]));
        let cdt = delone_cdt::cavity(&graph, &delone_delaunay::Options::default(), &mut ());
        let mut live = Live::new(&cdt, &graph);
        let apexes = Apexes::new(&cdt, &live);
        let placement = Placement { always_shells: round % 2 == 0, ..Placement::default() };
        for _ in 0..20 {
            let piece = u32::try_from(random.below(live.pieces.len() as u64)).unwrap();
            let near = encroachers(&live, piece);
            let long = exact_parameter(&live, &apexes, piece, &near, &[], placement);
            let short = doubles::parameter(&live, &apexes, piece, &near, &[], placement);
            said[usize::from(short.is_some())] += 1;
            if let Some(short) = short {
                let off = Dyadic::from(short) - &long;
                let from_end = [long.clone(), Dyadic::from(1) - &long];
                assert!(from_end.into_iter().all(|t| (&off * &off).scaled(2 * 28) < &t * &t));
            }
            live.split_piece(piece, parameter(&live, &apexes, piece, &near, placement), &mut ());
        }
    }
    assert!(said[1] > 20 * said[0], "{said:?}");
}
