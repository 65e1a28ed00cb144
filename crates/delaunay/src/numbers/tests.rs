use super::*;

#[test]
fn distances_are_compared_exactly() {
    let q = [0.0, 0.0];
    assert_eq!(compare_distances(&q, &[3.0, 4.0], &[5.0, 0.0]), Ordering::Equal);
    let above = 5.0f64.next_up();
    assert_eq!(compare_distances(&q, &[3.0, 4.0], &[above, 0.0]), Ordering::Less);
    assert_eq!(compare_distances(&q, &[above, 0.0], &[3.0, 4.0]), Ordering::Greater);
    // What doubles lose: underflow, overflow, and 1 against 1 + 2^-60.
    assert_eq!(compare_distances(&q, &[5e-324, 0.0], &[5e-324, 5e-324]), Ordering::Less);
    let huge = [f64::MAX, f64::MAX];
    assert_eq!(compare_distances(&q, &huge, &[f64::MAX, -f64::MAX]), Ordering::Equal);
    assert_eq!(compare_distances(&huge, &[-f64::MAX, 0.0], &[-f64::MAX, -1.0]), Ordering::Less);
    let tiny = 1.0 / f64::from(1u32 << 30);
    assert_eq!(compare_distances(&q, &[1.0, 0.0], &[1.0, tiny]), Ordering::Less);
}

fn big(rows: &[&[i32]]) -> Vec<Vec<IBig>> {
    rows.iter().map(|row| row.iter().map(|&x| IBig::from(x)).collect()).collect()
}

#[test]
fn determinants_by_elimination() {
    assert_eq!(determinant(big(&[&[7]])), IBig::from(7));
    assert_eq!(determinant(big(&[&[1, 2], &[3, 4]])), IBig::from(-2));
    assert_eq!(determinant(big(&[&[0, 2, 1], &[1, 0, 3], &[2, 5, 0]])), IBig::from(17));
    assert_eq!(determinant(big(&[&[1, 2, 3], &[4, 5, 6], &[7, 8, 9]])), IBig::ZERO);
    let upper = big(&[&[2, 9, 9, 9], &[0, 3, 9, 9], &[0, 0, 0, 5], &[0, 0, 7, 9]]);
    assert_eq!(determinant(upper), IBig::from(-210));
}

#[test]
fn centers_are_at_one_distance() {
    let points = [[0.1, 0.7, 3.0], [2.3, -1.1, 0.3], [0.7, 5.1, 1e-3], [1.0, 1.0, 9.0]];
    let center = orthocenter(&points, &[]);
    // |c - p|^2 as a fraction with the denominator d^2, on the center's own power of two.
    let squares: Vec<IBig> = points
        .iter()
        .map(|p| {
            let along = p.iter().zip(&center.numerators);
            along
                .map(|(&x, n)| integer(x, center.exponent) * &center.denominator - n)
                .map(|d| &d * &d)
                .sum()
        })
        .collect();
    assert!(squares.windows(2).all(|pair| pair[0] == pair[1]), "{squares:?}");
    assert!(squares[0] > IBig::ZERO);
}

#[test]
fn weights_move_the_center() {
    // On a line, the point of equal power: x^2 - 3 = (x - 4)^2 + 5.
    let center = orthocenter(&[[0.0], [4.0]], &[3.0, -5.0]);
    assert_eq!(center.rounded(), [3.0]);
    assert_eq!(orthocenter(&[[0.0], [4.0]], &[7.0, 7.0]), orthocenter(&[[0.0], [4.0]], &[]));
    assert_eq!(orthocenter(&[[0.0], [4.0]], &[5e-324, 5e-324]).rounded(), [2.0]);
}

#[test]
fn points_round_to_the_nearest_double() {
    let point = |n: i64, d: i64, exponent: i32| {
        let point =
            ExactPoint { numerators: [IBig::from(n)], denominator: IBig::from(d), exponent };
        point.rounded()[0]
    };
    assert_eq!(point(1, 3, 0), 1.0 / 3.0);
    assert_eq!(point(-2, 3, 0), -2.0 / 3.0);
    assert_eq!(point(0, 7, 5), 0.0);
    assert_eq!(point(10, 1, -1), 5.0);
    assert_eq!(point(1, 1, 2000), f64::INFINITY);
    assert_eq!(point(1, 1, -1074), 5e-324);
    // Half-way between two doubles, and a little more.
    let one = 1i64 << 53;
    assert_eq!(point(one + 1, one, 0), 1.0);
    assert_eq!(point((one + 1) * 512 + 1, one * 512, 0), 1.0f64.next_up());
    for n in 1..200 {
        for d in 1..40 {
            let (n, d) = (n * 7_919, d * 104_729);
            let quotient =
                f64::from(i32::try_from(n).unwrap()) / f64::from(i32::try_from(d).unwrap());
            assert_eq!(point(n, d, 0), quotient, "{n} / {d}");
        }
    }
}
