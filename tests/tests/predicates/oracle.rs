//! The exact sign of a determinant, in two ways: Gaussian elimination over rationals of the homogeneous matrix, and
//! cofactors over aligned integers of the matrix of differences.

use std::cmp::Ordering;

use delone::predicates::Sign;
use rug::{Integer, Rational};

/// A matrix, row by row.
type Matrix<T> = Vec<Vec<T>>;

/// `det[p1 - p0; ..; pk - p0]`: the orientation.
pub(crate) fn orient(points: &[&[f64]]) -> Sign {
    let by_rationals = {
        let rows = points.iter().map(|p| {
            let row = p.iter().map(|&x| rational(x));
            std::iter::once(Rational::from(1)).chain(row).collect()
        });
        eliminated(rows.collect())
    };
    let points = aligned(points);
    let rows = points[1..].iter().map(|p| differences(p, &points[0])).collect();
    agreed(by_rationals, Sign::from(cofactors(rows).cmp0()))
}

/// Positive if the last of k+2 points is inside the sphere of the others, these being positively oriented.
pub(crate) fn lifted(points: &[&[f64]]) -> Sign {
    let k = points[0].len();
    let by_rationals = {
        let rows = points.iter().map(|p| {
            let row: Vec<Rational> = p.iter().map(|&x| rational(x)).collect();
            let height = row.iter().map(|x| Rational::from(x * x)).sum::<Rational>();
            let one = std::iter::once(Rational::from(1));
            one.chain(row).chain([height]).collect()
        });
        eliminated(rows.collect())
    };
    let points = aligned(points);
    let (query, simplex) = points.split_last().expect("there is a query");
    let rows = simplex.iter().map(|p| {
        let mut row = differences(p, query);
        row.push(row.iter().map(|x| Integer::from(x * x)).sum());
        row
    });
    let by_integers = Sign::from(cofactors(rows.collect()).cmp0());
    // The query above the lifted hyperplane, which is outside, makes [1 p |p|^2] positive.
    agreed(-by_rationals, if k % 2 == 1 { -by_integers } else { by_integers })
}

/// `(b - a) x (d - c)`.
pub(crate) fn cross([a, b, c, d]: [[f64; 2]; 4]) -> Sign {
    let r = |p: [f64; 2], q: [f64; 2], axis: usize| rational(q[axis]) - rational(p[axis]);
    let left = r(a, b, 0) * r(c, d, 1);
    let by_rationals = Sign::from(left.cmp(&(r(a, b, 1) * r(c, d, 0))));
    let points = aligned(&[&a, &b, &c, &d]);
    let rows = vec![differences(&points[1], &points[0]), differences(&points[3], &points[2])];
    agreed(by_rationals, Sign::from(cofactors(rows).cmp0()))
}

/// The sign of a matrix of rationals times a power of two: used by tests that perturb heights explicitly.
pub(crate) fn determinant(rows: Matrix<Rational>) -> Sign {
    eliminated(rows)
}

pub(crate) fn rational(x: f64) -> Rational {
    Rational::from_f64(x).expect("coordinates are finite")
}

fn agreed(by_rationals: Sign, by_integers: Sign) -> Sign {
    assert_eq!(by_rationals, by_integers, "the two oracles");
    by_rationals
}

/// Gaussian elimination, the pivot being the first entry that is not zero.
fn eliminated(mut rows: Matrix<Rational>) -> Sign {
    let n = rows.len();
    let mut sign = Sign::Positive;
    for column in 0..n {
        let Some(pivot) = (column..n).find(|&row| rows[row][column] != 0) else {
            return Sign::Zero;
        };
        if pivot != column {
            rows.swap(pivot, column);
            sign = -sign;
        }
        sign = sign * Sign::from(rows[column][column].cmp0());
        let (above, below) = rows.split_at_mut(column + 1);
        let top = &above[column];
        for row in below.iter_mut().filter(|row| row[column] != 0) {
            let factor = Rational::from(&row[column] / &top[column]);
            for x in column..n {
                row[x] -= Rational::from(&factor * &top[x]);
            }
        }
    }
    sign
}

/// All coordinates times the power of two that makes them integers.
fn aligned(points: &[&[f64]]) -> Matrix<Integer> {
    let exponents = points.iter().flat_map(|p| p.iter()).map(|&x| {
        let shift = Rational::from_f64(x).expect("finite").denom().significant_bits();
        shift - 1 // the denominator is a power of two
    });
    let shift = exponents.max().unwrap_or(0);
    let integer = |x: f64| {
        let scaled = rational(x) << shift;
        assert_eq!(*scaled.denom(), 1, "aligned");
        scaled.into_numer_denom().0
    };
    points.iter().map(|p| p.iter().map(|&x| integer(x)).collect()).collect()
}

fn differences(p: &[Integer], q: &[Integer]) -> Vec<Integer> {
    p.iter().zip(q).map(|(x, y)| Integer::from(x - y)).collect()
}

fn cofactors(rows: Matrix<Integer>) -> Integer {
    if rows.is_empty() {
        return Integer::from(1);
    }
    let mut sum = Integer::new();
    for (row, first) in rows.iter().enumerate() {
        if first[0].cmp0() == Ordering::Equal {
            continue;
        }
        let rest = rows.iter().enumerate().filter(|(other, _)| *other != row);
        let term = cofactors(rest.map(|(_, entries)| entries[1..].to_vec()).collect()) * &first[0];
        if row % 2 == 0 { sum += term } else { sum -= term }
    }
    sum
}
