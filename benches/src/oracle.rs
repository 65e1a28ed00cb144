//! The oracle: signs in GMP's integers and rationals, two formulations that share nothing with the library.

use rug::{Integer, Rational};

/// The coordinates times a common power of two, as integers.
fn integers<const D: usize>(points: &[[f64; D]]) -> Vec<[Integer; D]> {
    let rationals = points.iter().flatten().map(|&x| Rational::from_f64(x).expect("finite"));
    let denominator = rationals.map(|x| x.denom().clone()).max().unwrap_or_default();
    let scaled = |x: f64| {
        let (numerator, own) = Rational::from_f64(x).expect("finite").into_numer_denom();
        numerator * Integer::from(&denominator / &own) // powers of two
    };
    points.iter().map(|point| point.map(scaled)).collect()
}

/// Scaled by shifts: quicker than over rationals, for the benchmark and the soak.
pub(crate) fn shifted<const D: usize>(points: &[[f64; D]]) -> Vec<[Integer; D]> {
    let decode = |x: f64| {
        let bits = x.to_bits();
        let field = (bits >> 52 & 0x7ff).max(1);
        let hidden = u64::from(bits >> 52 & 0x7ff != 0) << 52;
        (bits & ((1 << 52) - 1) | hidden, field)
    };
    let values = points.iter().flatten().map(|&x| decode(x));
    let lowest = values.filter(|v| v.0 != 0).map(|v| v.1).min().unwrap_or(1);
    let scaled = |x: f64| {
        let (mantissa, field) = decode(x);
        if mantissa == 0 {
            return Integer::new();
        }
        let integer = Integer::from(mantissa) << u32::try_from(field - lowest).expect("small");
        if x < 0.0 { -integer } else { integer }
    };
    points.iter().map(|point| point.map(scaled)).collect()
}

/// The determinant by cofactors along the first column.
pub(crate) fn cofactors(rows: &[Vec<Integer>]) -> Integer {
    match rows {
        [] => Integer::from(1),
        [row] => row[0].clone(),
        [p, q] => Integer::from(&p[0] * &q[1]) - Integer::from(&p[1] * &q[0]),
        _ => {
            let mut sum = Integer::new();
            for i in 0..rows.len() {
                let others = rows.iter().enumerate().filter(|&(j, _)| j != i);
                let rest: Vec<Vec<Integer>> = others.map(|(_, row)| row[1..].to_vec()).collect();
                let term = cofactors(&rest) * &rows[i][0];
                if i % 2 == 0 { sum += term } else { sum -= term }
            }
            sum
        }
    }
}

pub(crate) fn sign(value: &Integer) -> i8 {
    match value.cmp0() {
        std::cmp::Ordering::Less => -1,
        std::cmp::Ordering::Equal => 0,
        std::cmp::Ordering::Greater => 1,
    }
}

/// The sign of `det[p1 - p0; ..; pD - p0]`.
#[must_use]
pub fn orient<const D: usize>(points: &[[f64; D]]) -> i8 {
    let points = shifted(points);
    let row =
        |p: &[Integer; D]| p.iter().zip(&points[0]).map(|(a, b)| Integer::from(a - b)).collect();
    sign(&cofactors(&points[1..].iter().map(row).collect::<Vec<_>>()))
}

/// Positive if the last point is inside the sphere through the others, these being positively oriented.
///
/// # Panics
/// If there are no points.
#[must_use]
pub fn in_sphere<const D: usize>(points: &[[f64; D]]) -> i8 {
    let points = shifted(points);
    let (last, points) = points.split_last().expect("points");
    let row = |p: &[Integer; D]| {
        let mut row: Vec<_> = p.iter().zip(last).map(|(a, b)| Integer::from(a - b)).collect();
        row.push(row.iter().map(|d| Integer::from(d * d)).sum());
        row
    };
    let rows: Vec<Vec<Integer>> = points.iter().map(row).collect();
    let sign = sign(&cofactors(&rows));
    if D % 2 == 1 { -sign } else { sign }
}

/// As [`in_sphere`] with weights: the homogeneous determinant of heights |p|^2 - weight.
///
/// # Panics
/// If a number is not finite.
#[must_use]
pub fn power<const D: usize>(points: &[[f64; D]], weights: &[f64]) -> i8 {
    let rational = |x: f64| Rational::from_f64(x).expect("finite");
    let row = |(point, &weight): (&[f64; D], &f64)| {
        let point = point.map(rational);
        let squares: Rational = point.iter().map(|x| Rational::from(x * x)).sum();
        let mut row = vec![Rational::from(1)];
        row.extend(point);
        row.push(squares - rational(weight));
        row
    };
    -eliminated(points.iter().zip(weights).map(row).collect())
}

/// As [`orient`] or, if `lifted`, as [`in_sphere`]: the homogeneous determinant, by Gauss over rationals.
#[must_use]
pub fn by_elimination<const D: usize>(points: &[[f64; D]], lifted: bool) -> i8 {
    let rows: Vec<Vec<Rational>> = integers(points)
        .into_iter()
        .map(|p| {
            let height: Integer = p.iter().map(|x| Integer::from(x * x)).sum();
            let mut row = vec![Rational::from(1)];
            row.extend(p.into_iter().map(Rational::from));
            if lifted {
                row.push(Rational::from(height));
            }
            row
        })
        .collect();
    if lifted { -eliminated(rows) } else { eliminated(rows) } // positive is outside: the height is the last column
}

/// The sign of a determinant, by Gauss.
fn eliminated(mut rows: Vec<Vec<Rational>>) -> i8 {
    let n = rows.len();
    let mut sign = 1;
    for column in 0..n {
        let Some(pivot) = (column..n).find(|&row| rows[row][column].cmp0().is_ne()) else {
            return 0;
        };
        if pivot != column {
            rows.swap(pivot, column);
            sign = -sign;
        }
        if rows[column][column].cmp0().is_lt() {
            sign = -sign;
        }
        let (above, below) = rows.split_at_mut(column + 1);
        let pivot = &above[column];
        for row in below {
            let factor = Rational::from(&row[column] / &pivot[column]);
            for (entry, above) in row.iter_mut().zip(pivot).skip(column) {
                *entry -= Rational::from(&factor * above);
            }
        }
    }
    sign
}

/// The sign of `(b - a) x (d - c)`.
#[must_use]
pub fn cross(points: &[[f64; 2]; 4]) -> i8 {
    let points = shifted(points);
    let [a, b, c, d] = &points[..] else { return 0 };
    let difference = |a: &[Integer; 2], b: &[Integer; 2]| -> Vec<Integer> {
        vec![Integer::from(&b[0] - &a[0]), Integer::from(&b[1] - &a[1])]
    };
    sign(&cofactors(&[difference(a, b), difference(c, d)]))
}
