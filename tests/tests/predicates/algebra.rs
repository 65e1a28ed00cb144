//! Laws of predicates: permutations change signs by their parity, scaling and exact translation change nothing, the
//! perturbation never ties and is what explicit tiny heights give.

use std::cmp::Ordering;

use delone::predicates::{Adaptive, Exact, Kernel, Side, Sign};
use delone::workloads::Rng;
use delone_tests::exact::{scaled, translated};
use rug::Rational;

use crate::inputs::{CLASSES, Class, points};
use crate::oracle;

/// A random permutation and its parity.
fn permutation(n: usize, rng: &mut Rng) -> (Vec<usize>, usize) {
    let mut order: Vec<usize> = (0..n).collect();
    rng.shuffle(&mut order);
    let inversions =
        (0..n).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| order[i] > order[j]);
    let parity = inversions.count();
    (order, parity)
}

fn both<const D: usize>(points: &[[f64; D]], ids: &[usize], q: usize) -> [Sign; 2] {
    let (adaptive, exact) = (Adaptive::new(points), Exact::new(points));
    let signs = [adaptive.orient(ids), adaptive.lifted(ids, q)];
    assert_eq!([exact.orient(ids), exact.lifted(ids, q)], signs, "{points:?}");
    signs
}

fn laws<const D: usize>() {
    let mut rng = Rng::named("algebra", 1);
    let (mut scalings, mut translations) = (0, 0);
    for class in CLASSES {
        for _ in 0..400 {
            let points = points::<D>(class, D + 2, &mut rng);
            let ids: Vec<usize> = (0..=D).collect();
            let signs = both(&points, &ids, D + 1);
            let (order, parity) = permutation(D + 1, &mut rng);
            let turned = signs.map(|sign| sign.times_minus_one_to(parity));
            assert_eq!(both(&points, &order, D + 1), turned, "{points:?} {order:?}");
            let k = i32::try_from(rng.integer(-400, 400)).expect("small");
            if let Some(image) = scaled(&points, k) {
                assert_eq!(both(&image, &ids, D + 1), signs, "{points:?} times 2^{k}");
                scalings += 1;
            }
            let offset = points[rng.index(D + 2)].map(|x| -x);
            if let Some(image) = translated(&points, offset) {
                assert_eq!(both(&image, &ids, D + 1), signs, "{points:?} moved by {offset:?}");
                translations += 1;
            }
        }
    }
    assert!(scalings > 1000 && translations > 400, "{scalings} {translations}");
}

#[test]
fn permutations_scaling_and_translation_in_the_plane() {
    laws::<2>();
}

#[test]
fn permutations_scaling_and_translation_in_space() {
    laws::<3>();
}

/// The lifted determinant with the height of rank r raised by 2^(100 (r - n) - 3000): for integers below 2^10, this is
/// small enough, and the powers are far enough apart, to be the perturbation.
fn by_epsilon<const D: usize>(points: &[[f64; D]], simplex: &[usize], q: usize) -> Sign {
    let mut ranks: Vec<usize> = (0..points.len()).collect();
    ranks.sort_by(|&i, &j| points[i].partial_cmp(&points[j]).unwrap_or(Ordering::Equal));
    let row = |&v: &usize| {
        let place = ranks.iter().position(|&r| r == v).unwrap_or(0);
        let raised = Rational::from(1) >> u32::try_from(3000 - 100 * place).unwrap_or(0);
        let mut row = vec![Rational::from(1)];
        row.extend(points[v].iter().map(|&x| oracle::rational(x)));
        row.push(points[v].iter().map(|&x| oracle::rational(x * x)).sum::<Rational>() + raised);
        row
    };
    -oracle::determinant(simplex.iter().chain([&q]).map(row).collect())
}

fn perturbed<const D: usize>() {
    let mut rng = Rng::named("perturbed", 1);
    let mut ties = 0;
    while ties < 3000 {
        let class = if rng.coin() { Class::Grid } else { Class::Completed };
        let mut points = points::<D>(class, D + 2, &mut rng);
        if class == Class::Completed {
            // Few cospherical integers: corners of a box.
            points = points.iter().map(|p| p.map(|x| f64::from(u8::from(x > 0.0)))).collect();
        }
        let mut distinct = points.clone();
        distinct.sort_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
        distinct.dedup();
        let (adaptive, exact) = (Adaptive::new(&points[..]), Exact::new(&points[..]));
        let mut simplex: Vec<usize> = (0..=D).collect();
        if distinct.len() < points.len() || exact.orient(&simplex) == Sign::Zero {
            continue;
        }
        if exact.orient(&simplex) == Sign::Negative {
            simplex.swap(0, 1);
        }
        let side = exact.in_sphere(&simplex, D + 1);
        assert_eq!(adaptive.in_sphere(&simplex, D + 1), side, "{points:?}");
        let expected = by_epsilon(&points, &simplex, D + 1);
        assert_eq!(Some(side), expected.side(), "{points:?} {simplex:?}");
        // Even permutations change nothing.
        simplex.rotate_left(if D == 2 { 1 } else { 2 });
        assert_eq!(exact.in_sphere(&simplex, D + 1), side, "{points:?}");
        ties += usize::from(exact.lifted(&simplex, D + 1) == Sign::Zero);
    }
}

#[test]
fn the_perturbation_is_that_of_tiny_heights_in_the_plane() {
    perturbed::<2>();
}

#[test]
fn the_perturbation_is_that_of_tiny_heights_in_space() {
    perturbed::<3>();
}

/// Points (x, y, ax + by) of a plane in space, on integers: inside the circle within the plane, by the oracle on an
/// explicit isometry-free form: the determinant of [1 x y |p|^2] with heights of space, over the orientation of [1 x y].
#[test]
fn within_a_plane_of_space_the_circle_is_that_of_space() {
    let mut rng = Rng::named("within", 1);
    let (mut ties, mut inside, mut count) = (0, 0, 0);
    while count < 6000 {
        let [a, b] = [0, 1].map(|_| small(&mut rng, 2));
        let points: Vec<[f64; 3]> = (0..4)
            .map(|_| {
                let [x, y] = [0, 1].map(|_| small(&mut rng, 2));
                let mut p = [x, y, a * x + b * y];
                p.rotate_left(count % 3);
                p
            })
            .collect();
        let flat: Vec<[f64; 2]> =
            points.iter().map(|p| [p[(3 - count % 3) % 3], p[(4 - count % 3) % 3]]).collect();
        let mut facet = [0usize, 1, 2];
        let turn = Exact::new(&flat[..]).orient(&facet);
        if turn == Sign::Zero || facet.iter().any(|&v| points[v] == points[3]) {
            continue;
        }
        if turn == Sign::Negative {
            facet.swap(0, 1);
        }
        let expected = within(&points, &flat, &facet);
        ties += usize::from(expected.1);
        for kernel_answer in [
            Exact::new(&points[..]).in_sphere_within(&facet, 3),
            Adaptive::new(&points[..]).in_sphere_within(&facet, 3),
            Adaptive::new(&points[..]).in_sphere_within(&[facet[1], facet[0], facet[2]], 3),
        ] {
            assert_eq!(Some(kernel_answer), expected.0.side(), "{points:?} {facet:?}");
        }
        inside += usize::from(expected.0.side() == Some(Side::Positive));
        count += 1;
    }
    assert!(ties > 100 && inside > 1000, "{ties} {inside}");
}

fn small(rng: &mut Rng, max: i64) -> f64 {
    f64::from(i32::try_from(rng.integer(-max, max)).expect("small"))
}

/// The perturbed answer, and whether the plain one is a tie.
fn within(points: &[[f64; 3]], flat: &[[f64; 2]], facet: &[usize; 3]) -> (Sign, bool) {
    let mut ranks: Vec<usize> = (0..4).collect();
    ranks.sort_by(|&i, &j| points[i].partial_cmp(&points[j]).unwrap_or(Ordering::Equal));
    let sign = |raise: bool| {
        let row = |&v: &usize| {
            let place = ranks.iter().position(|&r| r == v).unwrap_or(0);
            let height: f64 = points[v].iter().map(|x| x * x).sum();
            let mut height = oracle::rational(height);
            if raise {
                height += Rational::from(1) >> u32::try_from(3000 - 100 * place).unwrap_or(0);
            }
            let [x, y] = flat[v].map(oracle::rational);
            vec![Rational::from(1), x, y, height]
        };
        -oracle::determinant(facet.iter().chain([&3]).map(row).collect())
    };
    (sign(true), sign(false) == Sign::Zero)
}
