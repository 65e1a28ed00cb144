//! Lengths, angles and radii against rationals: the centre of a sphere is solved for, in barycentric coordinates.

use std::cmp::Ordering;

use delone::predicates::{Adaptive, Constructed, Construction, Exact, Metric, Weighted};
use delone::workloads::Rng;
use delone_tests::say;
use rug::Rational;

use crate::constructed::solved;
use crate::inputs::{CLASSES, Class, points};
use crate::oracle::rational;

type Point = Vec<Rational>;

fn dot(p: &Point, q: &Point) -> Rational {
    p.iter().zip(q).map(|(x, y)| Rational::from(x * y)).sum()
}

fn minus(p: &Point, q: &Point) -> Point {
    p.iter().zip(q).map(|(x, y)| Rational::from(x - y)).collect()
}

/// The squared radius, `None` if infinite: the centre is sum b_i p_i with sum b_i = 1, of equal power to all vertices.
fn squared_radius(points: &[Point], weights: &[Rational]) -> Option<Rational> {
    let n = points.len();
    let one = Rational::from(1);
    // sum b_i = 1, and for each j > 0: 2 c . (p_j - p_0) = |p_j|^2 - w_j - |p_0|^2 + w_0.
    let mut rows = vec![vec![one.clone(); n + 1]];
    let height = |j: usize| dot(&points[j], &points[j]) - &weights[j];
    for j in 1..n {
        let edge = minus(&points[j], &points[0]);
        let mut row: Vec<Rational> = points.iter().map(|p| dot(p, &edge) * 2).collect();
        row.push(height(j) - height(0));
        rows.push(row);
    }
    let barycentric = solved(rows)?;
    let coordinate = |x: usize| -> Rational {
        barycentric.iter().zip(points).map(|(b, p)| Rational::from(b * &p[x])).sum()
    };
    let centre: Point = (0..points[0].len()).map(coordinate).collect();
    let off = minus(&centre, &points[0]);
    Some(dot(&off, &off) - &weights[0])
}

fn order(a: &Option<Rational>, b: &Option<Rational>) -> Ordering {
    match (a, b) {
        (Some(a), Some(b)) => a.cmp(b),
        (a, b) => a.is_none().cmp(&b.is_none()),
    }
}

/// The order of the angles by their cosines: the sign and the square.
fn angles(abc: [&Point; 3], def: [&Point; 3]) -> Ordering {
    let cosine = |[p, at, q]: [&Point; 3]| {
        let (p, q) = (minus(p, at), minus(q, at));
        let squares = dot(&p, &p) * dot(&q, &q);
        if squares == 0 {
            return Rational::from(1);
        }
        let dot = dot(&p, &q);
        let square = Rational::from(&dot * &dot) / squares;
        if dot < 0 { -square } else { square }
    };
    cosine(def).cmp(&cosine(abc))
}

#[derive(Default)]
struct Counts([usize; 3]);

impl Counts {
    fn check(&mut self, answer: Ordering, expected: Ordering, what: impl std::fmt::Debug) {
        assert_eq!(answer, expected, "{what:?}");
        self.0[usize::try_from(expected as i8 + 1).expect("-1 to 1")] += 1;
    }
}

fn simplex(exact: &[Point], most: usize, rng: &mut Rng) -> Vec<usize> {
    (0..=rng.index(most + 1)).map(|_| rng.index(exact.len())).collect()
}

/// Random calls on one kernel.
fn check<const D: usize>(
    kernel: &impl Metric<D>,
    exact: &[Point],
    weights: &[Rational],
    rng: &mut Rng,
    counts: &mut Counts,
) {
    for _ in 0..12 {
        let [s, t] = [0; 2].map(|_| simplex(exact, D, rng));
        let radius = |s: &[usize]| {
            let points: Vec<Point> = s.iter().map(|&v| exact[v].clone()).collect();
            let weights: Vec<Rational> = s.iter().map(|&v| weights[v].clone()).collect();
            squared_radius(&points, &weights)
        };
        let (radius_s, radius_t) = (radius(&s), radius(&t));
        let expected = order(&radius_s, &radius_t);
        counts.check(kernel.compare_radii(&s, &t), expected, (&s, &t, exact));
        let nearest = kernel.squared_radius(&s);
        match &radius_s {
            None => assert_eq!(nearest, f64::INFINITY),
            Some(exact) => crate::constructed::assert_nearest(nearest, exact),
        }
        for bound in [nearest, nearest.next_up(), nearest.next_down(), 1.0] {
            if bound.is_finite() {
                let expected = order(&radius_s, &Some(rational(bound)));
                counts.check(kernel.compare_radius(&s, bound), expected, (&s, bound, exact));
            }
        }
        let ids = [0; 6].map(|_| rng.index(exact.len()));
        let [a, b, c, d, e, f] = ids.map(|v| &exact[v]);
        let (ab, cd) = (minus(a, b), minus(c, d));
        let lengths = kernel.compare_lengths([ids[0], ids[1]], [ids[2], ids[3]]);
        counts.check(lengths, dot(&ab, &ab).cmp(&dot(&cd, &cd)), (ids, exact));
        let answer = kernel.compare_angles([ids[0], ids[1], ids[2]], [ids[3], ids[4], ids[5]]);
        counts.check(answer, angles([a, b, c], [d, e, f]), (ids, exact));
    }
}

fn plain<const D: usize>(points: &[[f64; D]]) -> Vec<Point> {
    points.iter().map(|p| p.map(rational).to_vec()).collect()
}

fn check_all<const D: usize>(name: &str, rounds: usize) {
    let mut counts = Counts::default();
    for class in CLASSES {
        let mut rng = Rng::named(name, 1);
        for _ in 0..if class == Class::Wild { rounds / 3 } else { rounds } {
            let points = points::<D>(class, 6, &mut rng);
            let exact = plain(&points);
            let none = vec![Rational::new(); 6];
            check(&Adaptive::new(&points[..]), &exact, &none, &mut rng, &mut counts);
            check(&Exact::new(&points[..]), &exact, &none, &mut rng, &mut counts);
            let weights: Vec<f64> = points.iter().rev().map(|p| p[0]).collect();
            let kernel = Weighted::new(&points[..], &weights[..]);
            let weights: Vec<Rational> = weights.iter().map(|&x| rational(x)).collect();
            check(&kernel, &exact, &weights, &mut rng, &mut counts);
        }
    }
    say(format!("{name}: {:?} less, equal, greater", counts.0));
    assert!(counts.0.iter().all(|&count| count > 1000), "{:?}", counts.0);
}

#[test]
fn radii_lengths_and_angles_in_the_plane() {
    check_all::<2>("metric 2", 30);
}

#[test]
fn radii_lengths_and_angles_in_space() {
    check_all::<3>("metric 3", 15);
}

#[test]
fn radii_lengths_and_angles_of_crossings() {
    let (mut rng, mut counts) = (Rng::named("metric of crossings", 1), Counts::default());
    for class in CLASSES {
        for _ in 0..8 {
            let points = points::<2>(class, 5, &mut rng);
            let mut kernel = Constructed::new(points);
            for (a, b, c, d) in [(0, 1, 2, 3), (1, 2, 3, 4), (0, 2, 1, 4), (0, 4, 2, 3)] {
                let _ = kernel.push(&Construction::Crossing { a, b, c, d });
            }
            let exact: Vec<Point> = (0..kernel.len())
                .map(|v| {
                    let point = kernel.exact(u32::try_from(v).expect("small"));
                    let [x, y] = point.x.map(|x| crate::constructed::dyadic(&x));
                    let w = crate::constructed::dyadic(&point.w);
                    vec![x / &w, y / w]
                })
                .collect();
            let none = vec![Rational::new(); exact.len()];
            check(&kernel, &exact, &none, &mut rng, &mut counts);
        }
    }
    assert!(counts.0.iter().all(|&count| count > 100), "{:?}", counts.0);
}
