//! At the filter's bound: inputs whose determinant, computed in doubles, lies within a factor 64 of the error bound on
//! either side. A bound that is too small is wrong on some of them; `Adaptive` must agree with `Exact` on all.
//!
//! The determinants and their permanents are computed here once more, without guards, to choose the inputs.

use delone::predicates::{Adaptive, Exact, Kernel};
use delone::workloads::Rng;
use delone_tests::exact::nudged;

const U: f64 = f64::EPSILON / 2.0;

/// A determinant and the same with all products in magnitude, by cofactors.
fn with_permanent(rows: &[Vec<f64>]) -> (f64, f64) {
    if rows.is_empty() {
        return (1.0, 1.0);
    }
    let (mut value, mut permanent) = (0.0, 0.0);
    for (row, entries) in rows.iter().enumerate() {
        let rest = rows.iter().enumerate().filter(|(other, _)| *other != row);
        let rest: Vec<Vec<f64>> = rest.map(|(_, entries)| entries[1..].to_vec()).collect();
        let (minor, magnitude) = with_permanent(&rest);
        value += if row % 2 == 0 { entries[0] * minor } else { -entries[0] * minor };
        permanent += entries[0].abs() * magnitude;
    }
    (value, permanent)
}

/// The determinant over `constant * permanent`: 1 is at the bound.
fn ratio<const D: usize>(points: &[[f64; D]], lifted: bool, constant: f64) -> f64 {
    let (last, others) = points.split_last().expect("there are points");
    let rows: Vec<Vec<f64>> = others
        .iter()
        .map(|p| {
            let mut row: Vec<f64> = p.iter().zip(last).map(|(x, y)| x - y).collect();
            if lifted {
                row.insert(0, row.iter().map(|x| x * x).sum());
            }
            row
        })
        .collect();
    let (value, permanent) = with_permanent(&rows);
    value.abs() / (constant * U * permanent)
}

/// On a line, plane or sphere up to rounding, then off it by a few thousand ULPs at most.
fn near<const D: usize>(n: usize, lifted: bool, rng: &mut Rng) -> Vec<[f64; D]> {
    let spread = i64::from([1, 8, 64][rng.index(3)]);
    let centre: [f64; D] = std::array::from_fn(|_| rng.between(-8.0, 8.0));
    let normal: [f64; D] = std::array::from_fn(|_| rng.between(0.1, 1.0));
    (0..n)
        .map(|_| {
            let mut p: [f64; D] = std::array::from_fn(|_| rng.gauss());
            if lifted {
                let length = p.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-9);
                p = p.map(|x| x / length);
            } else {
                let (last, rest) = p.split_last_mut().expect("D is not 0");
                let dot: f64 = rest.iter().zip(&normal).map(|(x, y)| x * y).sum();
                *last = -dot / normal[D - 1];
            }
            std::array::from_fn(|axis| {
                let ulps = i32::try_from(rng.integer(-spread, spread)).expect("small");
                nudged(p[axis] + centre[axis], ulps)
            })
        })
        .collect()
}

fn at_the_bound<const D: usize>(lifted: bool, constant: f64) {
    let mut rng = Rng::named("bound", 1);
    let (mut below, mut above, mut rounds) = (0, 0, 0);
    while below < 4000 || above < 2000 {
        rounds += 1;
        assert!(rounds < 400_000, "{below} below, {above} above: the generator misses the bound");
        let points = near::<D>(D + 1 + usize::from(lifted), lifted, &mut rng);
        let ratio = ratio(&points, lifted, constant);
        if !(1.0 / 64.0..64.0).contains(&ratio) {
            continue;
        }
        *(if ratio < 1.0 { &mut below } else { &mut above }) += 1;
        let ids: Vec<usize> = (0..=D).collect();
        let (adaptive, exact) = (Adaptive::new(&points[..]), Exact::new(&points[..]));
        if lifted {
            assert_eq!(adaptive.lifted(&ids, D + 1), exact.lifted(&ids, D + 1), "{points:?}");
        } else {
            assert_eq!(adaptive.orient(&ids), exact.orient(&ids), "{points:?}");
        }
    }
}

#[test]
fn orient_in_the_plane_at_the_bound() {
    at_the_bound::<2>(false, 3.0);
}

#[test]
fn orient_in_space_at_the_bound() {
    at_the_bound::<3>(false, 7.0);
}

#[test]
fn lifted_in_the_plane_at_the_bound() {
    at_the_bound::<2>(true, 10.0);
}

#[test]
fn lifted_in_space_at_the_bound() {
    at_the_bound::<3>(true, 16.0);
}
