//! Constructed points against rationals: each is solved for from equations of its lines and planes, and each predicate is a
//! determinant by elimination.

use std::cmp::Ordering;

use delone::predicates::{
    Constructed, Construction, Counting, Dyadic, Kernel, PlaneKernel, Question, Sign, Stage, Tally,
};
use delone::workloads::Rng;
use delone_tests::exact::power_of_two;
use delone_tests::say;
use rug::Rational;

use crate::inputs::{CLASSES, Class, points};
use crate::oracle::{self, rational};

/// A point in rationals.
type Point = Vec<Rational>;

/// Plain and constructed points, and what the latter are.
struct World<const D: usize> {
    kernel: Constructed<D>,
    exact: Vec<Point>,
}

fn plain<const D: usize>(p: [f64; D]) -> Point {
    p.map(rational).to_vec()
}

fn world<const D: usize>(class: Class, count: usize, rng: &mut Rng) -> World<D> {
    let points = points::<D>(class, count, rng);
    let mut exact: Vec<Point> = points.iter().map(|&p| plain(p)).collect();
    let mut kernel = Constructed::new(points);
    for _ in 0..40 {
        if exact.len() == 2 * count {
            break;
        }
        let construction = construction::<D>(count, rng);
        let solved = solution(&construction, &exact);
        match kernel.push(&construction) {
            Ok(id) => {
                assert_eq!(id as usize, exact.len());
                exact.push(solved.unwrap_or_else(|| panic!("{construction:?} is no point")));
            }
            Err(_) => assert_eq!(solved, None, "{construction:?} is a point"),
        }
    }
    World { kernel, exact }
}

fn construction<const D: usize>(count: usize, rng: &mut Rng) -> Construction {
    let mut id = || u32::try_from(rng.index(count)).expect("small");
    let [a, b, c, d] = [id(), id(), id(), id()];
    let plane = [c, d, id()];
    let planes = [plane, [id(), id(), id()], [id(), id(), a]];
    match rng.below(4) {
        0 => Construction::SegmentPoint { a, b, t: parameter(rng) },
        _ if D == 2 => Construction::Crossing { a, b, c, d },
        1 => Construction::ThreePlanes { planes },
        _ => Construction::LinePlane { a, b, plane },
    }
}

/// A multiple of 1/8, a double, or a sum of doubles whose exponents lie far apart.
fn parameter(rng: &mut Rng) -> Dyadic {
    match rng.below(3) {
        0 => (0..3).fold(Dyadic::from(rng.integer(-2, 10)), |t, _| t.half()),
        1 => rng.between(0.0, 1.0).into(),
        _ => Dyadic::from(rng.between(0.0, 1.0)) + Dyadic::from(rng.gauss() * power_of_two(-200)),
    }
}

fn dyadic(t: &Dyadic) -> Rational {
    let limbs = t.mantissa().iter().rev();
    let mantissa = limbs.fold(Rational::new(), |sum, &limb| (sum << 64) + Rational::from(limb));
    let exponent = i32::try_from(t.exponent()).expect("small");
    let value =
        if exponent < 0 { mantissa >> exponent.unsigned_abs() } else { mantissa << exponent };
    if t.sign() == Sign::Negative { -value } else { value }
}

/// The point, if there is exactly one.
fn solution(construction: &Construction, plain: &[Point]) -> Option<Point> {
    let at = |id: u32| &plain[id as usize];
    match construction {
        Construction::SegmentPoint { a, b, t } => {
            let (t, one) = (dyadic(t), Rational::from(1));
            let s = one - &t;
            let mix =
                |(a, b): (&Rational, &Rational)| Rational::from(&s * a) + Rational::from(&t * b);
            Some(at(*a).iter().zip(at(*b)).map(mix).collect())
        }
        &Construction::Crossing { a, b, c, d } => {
            solved(vec![hyperplane(&[at(a), at(b)]), hyperplane(&[at(c), at(d)])])
        }
        &Construction::LinePlane { a, b, plane } => {
            // The line as two planes through it and a point off it on an axis.
            let off = |axis: usize| {
                let mut p = at(a).clone();
                p[axis] += 1;
                p
            };
            let through = |axis| hyperplane(&[at(a), at(b), &off(axis)]);
            let plane = hyperplane(&plane.map(at));
            [(0, 1), (1, 2), (2, 0)]
                .into_iter()
                .find_map(|(i, j)| solved(vec![through(i), through(j), plane.clone()]))
        }
        Construction::ThreePlanes { planes } => {
            solved(planes.map(|plane| hyperplane(&plane.map(at))).to_vec())
        }
        _ => None,
    }
}

/// `n . x = m` as `[n m]`: the minors of the points' rows.
fn hyperplane(points: &[&Point]) -> Vec<Rational> {
    let n = points.len();
    let minor = |dropped: usize| {
        let rows: Vec<Vec<Rational>> = points
            .iter()
            .map(|p| {
                let row = p.iter().cloned().chain([Rational::from(1)]).enumerate();
                row.filter(|(column, _)| *column != dropped).map(|(_, x)| x).collect()
            })
            .collect();
        leibniz(&rows)
    };
    (0..=n)
        .map(|column| {
            let value = minor(column);
            // The last column is moved to the right-hand side.
            if (column + usize::from(column == n)) % 2 == 1 { -value } else { value }
        })
        .collect()
}

fn leibniz(rows: &[Vec<Rational>]) -> Rational {
    if rows.is_empty() {
        return Rational::from(1);
    }
    let term = |column: usize| {
        let rest: Vec<Vec<Rational>> =
            rows[1..].iter().map(|row| [&row[..column], &row[column + 1..]].concat()).collect();
        let value = leibniz(&rest) * &rows[0][column];
        if column % 2 == 1 { -value } else { value }
    };
    (0..rows.len()).map(term).sum()
}

/// The solution of n equations, if there is exactly one: by Gauss and Jordan.
fn solved(mut rows: Vec<Vec<Rational>>) -> Option<Point> {
    let n = rows.len();
    for column in 0..n {
        let pivot = (column..n).find(|&row| rows[row][column] != 0)?;
        rows.swap(pivot, column);
        let top = rows[column].clone();
        for (i, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != column) {
            debug_assert_ne!(i, column);
            let factor = Rational::from(&row[column] / &top[column]);
            for (x, t) in row.iter_mut().zip(&top) {
                *x -= Rational::from(&factor * t);
            }
        }
    }
    Some((0..n).map(|i| Rational::from(&rows[i][n] / &rows[i][i])).collect())
}

/// `det [1 x]` on some axes, and with the column of heights.
fn homogeneous(points: &[&Point], axes: &[usize], lifted: bool) -> Sign {
    let row = |p: &&Point| {
        let mut row = vec![Rational::from(1)];
        row.extend(axes.iter().map(|&axis| p[axis].clone()));
        if lifted {
            row.push(p.iter().map(|x| Rational::from(x * x)).sum());
        }
        row
    };
    oracle::determinant(points.iter().map(row).collect())
}

fn lexicographic(p: &Point, q: &Point) -> Ordering {
    p.iter().zip(q).map(|(x, y)| x.cmp(y)).find(|o| o.is_ne()).unwrap_or(Ordering::Equal)
}

/// Whether `x` is the double nearest to `exact`, ties to even.
fn assert_nearest(x: f64, exact: &Rational) {
    if !x.is_finite() {
        let half = rational(f64::MAX - f64::MAX.next_down()) / 2;
        assert!(exact.clone().abs() >= rational(f64::MAX) + half, "{x} is {exact}");
        return;
    }
    let off = |y: f64| (rational(y) - exact).abs();
    for other in [x.next_up(), x.next_down()].into_iter().filter(|y| y.is_finite()) {
        let order = off(x).cmp(&off(other));
        let even = x.to_bits() & 1 == 0;
        assert!(order.is_lt() || order.is_eq() && even, "{x:e} is not nearest to {exact}");
    }
}

/// Random calls on the vertices of a world. The signs that came, by question.
fn check_calls<const D: usize>(world: &World<D>, rng: &mut Rng, counts: &mut [usize; 3]) {
    let World { kernel, exact } = world;
    let all: Vec<usize> = (0..D).collect();
    for _ in 0..20 {
        let ids: Vec<usize> = (0..D + 2).map(|_| rng.index(exact.len())).collect();
        let points: Vec<&Point> = ids.iter().map(|&id| &exact[id]).collect();
        let (simplex, q) = (&ids[..=D], ids[D + 1]);
        let orientation = homogeneous(&points[..=D], &all, false);
        assert_eq!(kernel.orient(simplex), orientation, "{ids:?} of {kernel:?}");
        assert_eq!(kernel.orient_on(&all, simplex), orientation);
        let lifted = -homogeneous(&points, &all, true);
        assert_eq!(kernel.lifted(simplex, q), lifted, "{ids:?} of {kernel:?}");
        assert_eq!(kernel.lifted_on(&all, simplex, q), lifted);
        let axes = [[1, 0], [2, 1], [0, 2]][rng.index(if D == 2 { 1 } else { 3 })];
        for k in 1..=2 {
            let orientation = homogeneous(&points[..=k], &axes[..k], false);
            assert_eq!(kernel.orient_on(&axes[..k], &ids[..=k]), orientation, "{ids:?} {kernel:?}");
        }
        let order = lexicographic(points[0], points[1]);
        assert_eq!(kernel.compare_lexicographic(ids[0], ids[1]), order, "{ids:?} of {kernel:?}");
        for sign in [orientation, lifted] {
            counts[usize::try_from(sign as i8 + 1).expect("-1 to 1")] += 1;
        }
    }
}

fn check_worlds<const D: usize>(name: &str, count: usize, worlds: usize) {
    let (mut counts, tally) = ([0; 3], Tally::default());
    for class in CLASSES {
        let mut rng = Rng::named(name, 1);
        for _ in 0..if class == Class::Wild { worlds / 3 } else { worlds } {
            let world = world::<D>(class, count, &mut rng);
            for (id, exact) in world.exact.iter().enumerate() {
                let position = world.kernel.position(u32::try_from(id).expect("small"));
                position.iter().zip(exact).for_each(|(&x, exact)| assert_nearest(x, exact));
            }
            check_calls(&world, &mut rng, &mut counts);
            count_stages(&world, &tally, &mut rng);
        }
    }
    let stages = Stage::ALL.map(|stage| (stage, tally.answered(Question::Lifted, stage)));
    say(format!("{name}: {counts:?} negative, zero, positive; {stages:?}"));
    assert!(counts.iter().all(|&count| count > 1000), "{name}: every sign comes: {counts:?}");
    for stage in [Stage::StaticFilter, Stage::DynamicFilter, Stage::Dyadic] {
        assert!(tally.answered(Question::Lifted, stage) > 20, "{stage:?}: {tally:?}");
    }
}

fn count_stages<const D: usize>(world: &World<D>, tally: &Tally, rng: &mut Rng) {
    let kernel = Counting::new(world.kernel.clone(), tally);
    for _ in 0..10 {
        let ids: Vec<usize> = (0..D + 2).map(|_| rng.index(world.exact.len())).collect();
        let _ = (kernel.orient(&ids[..=D]), kernel.lifted(&ids[..=D], ids[D + 1]));
    }
}

#[test]
fn constructed_points_in_the_plane() {
    check_worlds::<2>("constructed 2", 6, 60);
}

#[test]
fn constructed_points_in_space() {
    check_worlds::<3>("constructed 3", 7, 30);
}

#[test]
fn segment_points_in_four_dimensions() {
    let mut rng = Rng::named("constructed 4", 1);
    for class in CLASSES {
        for _ in 0..4 {
            let points = points::<4>(class, 5, &mut rng);
            let mut exact: Vec<Point> = points.iter().map(|&p| plain(p)).collect();
            let mut kernel = Constructed::new(points);
            for (a, b) in [(0, 1), (1, 2), (3, 0)] {
                let construction = Construction::SegmentPoint { a, b, t: parameter(&mut rng) };
                exact.extend(solution(&construction, &exact));
                kernel.push(&construction).unwrap();
            }
            check_calls(&World { kernel, exact }, &mut rng, &mut [0; 3]);
        }
    }
}

#[test]
fn cross_products_of_constructed_points() {
    let mut rng = Rng::named("constructed cross", 1);
    let mut zeros = 0;
    for class in CLASSES {
        for _ in 0..60 {
            let World { kernel, exact } = world::<2>(class, 5, &mut rng);
            for _ in 0..20 {
                let ids = [0; 4].map(|_| rng.index(exact.len()));
                let [a, b, c, d] = ids.map(|id| &exact[id]);
                let difference = |p: &Point, q: &Point, x: usize| Rational::from(&q[x] - &p[x]);
                let left = difference(a, b, 0) * difference(c, d, 1);
                let right = difference(a, b, 1) * difference(c, d, 0);
                let sign = Sign::from(left.cmp(&right));
                assert_eq!(kernel.cross(ids), sign, "{ids:?} of {kernel:?}");
                zeros += usize::from(sign == Sign::Zero);
            }
        }
    }
    assert!(zeros > 500, "{zeros}");
}

/// Points of one line or one plane of space: lifted on the axes of a projection.
#[test]
fn within_a_flat_constructed_points_are_lifted_as_in_space() {
    let mut rng = Rng::named("constructed flat", 1);
    let (mut zeros, mut count) = (0, 0);
    for class in CLASSES {
        for round in 0..60 {
            let mut exact: Vec<Point> = Vec::new();
            let mut kernel = Constructed::new(points::<3>(class, 6, &mut rng));
            exact.extend(kernel.positions().iter().map(|&p| plain(p)));
            let mut flat = vec![0, 1, 2];
            for (a, b) in [(3, 4), (4, 5), (5, 3), (0, 3), (1, 2)] {
                let construction = if round % 2 == 0 {
                    Construction::LinePlane { a, b, plane: [0, 1, 2] }
                } else {
                    Construction::SegmentPoint { a: 0, b: 1, t: parameter(&mut rng) }
                };
                if let Ok(id) = kernel.push(&construction) {
                    exact.extend(solution(&construction, &exact));
                    flat.push(id as usize);
                }
            }
            let k = if round % 2 == 0 { 2 } else { flat.remove(2).min(1) };
            let axes = [[0, 1], [1, 2], [0, 2]][rng.index(3)];
            for _ in 0..20 {
                let ids: Vec<usize> = (0..k + 2).map(|_| flat[rng.index(flat.len())]).collect();
                let points: Vec<&Point> = ids.iter().map(|&id| &exact[id]).collect();
                if homogeneous(&points[..=k], &axes[..k], false) == Sign::Zero {
                    continue;
                }
                let lifted = -homogeneous(&points, &axes[..k], true);
                let answer = kernel.lifted_on(&axes[..k], &ids[..=k], ids[k + 1]);
                assert_eq!(answer, lifted, "{axes:?} {ids:?} {kernel:?}");
                zeros += usize::from(lifted == Sign::Zero);
                count += 1;
            }
        }
    }
    assert!(zeros > 100 && count > 2000, "{zeros} {count}");
}
