use std::cmp::Ordering;

use super::*;

mod kernels;
mod known;
mod lattices;

#[test]
fn signs_multiply_and_zero_is_zero() {
    assert_eq!(Sign::of(0.0), Sign::Zero);
    assert_eq!(Sign::of(-0.0), Sign::Zero);
    assert_eq!(Sign::of(-5e-324), Sign::Negative);
    assert_eq!(Sign::Negative * Sign::Negative, Sign::Positive);
    assert_eq!(Sign::Negative * Sign::Zero, Sign::Zero);
    assert_eq!(Sign::Positive.times_minus_one_to(3), Sign::Negative);
}

#[test]
fn unit_simplices_are_positive_and_hold_their_centre() {
    let simplex = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(orient(&simplex), Sign::Positive);
    let [a, b, c, d] = simplex;
    assert_eq!(in_sphere(a, b, c, d, [0.25; 3]), Sign::Positive);
    assert_eq!(in_sphere(a, b, c, d, [1.0, 1.0, 1.0]), Sign::Zero);
    assert_eq!(in_sphere(a, b, c, d, [-1.0, 0.0, 0.0]), Sign::Negative);
    let exact = Exact::new([[2.0], [5.0], [3.0], [7.0]]);
    assert_eq!(exact.orient(&[0usize, 1]), Sign::Positive);
    assert_eq!(exact.lifted(&[0usize, 1], 2), Sign::Positive);
    assert_eq!(exact.lifted(&[0usize, 1], 3), Sign::Negative);
}

/// Inputs on which filters and expansions of others underflow or overflow (spec: predicates-measured, section 3).
#[test]
fn orient2d_is_right_where_products_leave_the_range() {
    let cases = [
        ([[0.0, 0.0], [1e-163, 0.0], [0.0, 1e-163]], Sign::Positive),
        ([[0.0, 0.0], [5e-324, 0.0], [0.0, 5e-324]], Sign::Positive),
        ([[3e160, 1e160], [1e160, 3e160], [0.0, 0.0]], Sign::Positive),
        ([[1e160, 1e160], [-1e160, 1e160], [0.0, 0.0]], Sign::Positive),
        ([[-1e308, -1e308], [1e308, -1e308], [1e308, 1e308]], Sign::Positive),
        ([[-1e308, -1e308], [1e308, 1e308], [0.0, 5e-324]], Sign::Positive),
        ([[f64::MAX, f64::MAX], [-f64::MAX, -f64::MAX], [5e-324, 5e-324]], Sign::Zero),
    ];
    for ([a, b, c], sign) in cases {
        assert_eq!(orient2d(a, b, c), sign, "{a:?} {b:?} {c:?}");
        assert_eq!(orient2d(b, a, c), -sign, "{b:?} {a:?} {c:?}");
    }
}

#[test]
fn the_whole_range_fits_one_call() {
    let (tiny, huge) = (5e-324, f64::MAX);
    let corners =
        [[-huge, -huge, -huge], [huge, -huge, -huge], [-huge, huge, -huge], [-huge, -huge, huge]];
    let [a, b, c, d] = corners;
    assert_eq!(orient3d(a, b, c, d), Sign::Positive);
    assert_eq!(in_sphere(a, b, c, d, [huge, huge, huge]), Sign::Zero);
    assert_eq!(in_sphere(a, b, c, d, [tiny, tiny, tiny]), Sign::Positive);
    let below = f64::from_bits(huge.to_bits() - 1);
    assert_eq!(in_sphere(a, b, c, d, [huge, huge, below]), Sign::Positive);
}

/// A square's corners: the highest in the lexicographic order is 3.
const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]];

#[test]
fn the_highest_of_cocircular_points_is_outside() {
    let kernel = Adaptive::new(SQUARE);
    assert_eq!(kernel.compare_lexicographic(2usize, 3), Ordering::Less);
    assert_eq!(kernel.in_sphere(&[0usize, 2, 1], 3), Side::Negative);
    // Of the square's two diagonals exactly one is legal, from both its sides.
    assert_eq!(kernel.in_sphere(&[1usize, 2, 3], 0), Side::Negative);
    assert_eq!(kernel.in_sphere(&[0usize, 2, 3], 1), Side::Positive);
    assert_eq!(kernel.in_sphere(&[0usize, 3, 1], 2), Side::Positive);
}

#[test]
fn a_coplanar_tie_passes_to_the_next_rank() {
    // Vertex 4 is the highest; q = 3 lies in the plane of the facet opposite it, so 4 cannot decide.
    let points =
        [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [1.0, 0.0, 0.0]];
    let kernel = Adaptive::new(points);
    let simplex = [0usize, 1, 2, 4];
    let simplex =
        if kernel.orient(&simplex) == Sign::Positive { simplex } else { [1usize, 0, 2, 4] };
    assert_eq!(kernel.orient(&simplex), Sign::Positive);
    assert_eq!(kernel.lifted(&simplex, 3), Sign::Zero);
    // Next rank is q's own: outside.
    assert_eq!(kernel.in_sphere(&simplex, 3), Side::Negative);
}

/// The perturbation against real, tiny heights: `2^-(60 - 12 rank)` added to the lifted points of a small grid, decided
/// by an integer determinant of its own.
#[test]
fn ties_equal_explicit_infinitesimals() {
    let grid: Vec<[f64; 2]> = (0..9).map(|i| [f64::from(i / 3), f64::from(i % 3)]).collect();
    let kernel = Adaptive::new(grid.clone());
    let height = |i: usize| {
        let integer = |axis: usize| grid[i][axis] as i128;
        ((integer(0).pow(2) + integer(1).pow(2)) << 100) + (1i128 << (10 * i))
    };
    let coordinate = |i: usize, axis: usize| grid[i][axis] as i128;
    let mut ties = 0;
    for code in 0..9usize.pow(4) {
        let [a, b, c, q] = [0, 1, 2, 3].map(|digit| code / 9usize.pow(digit) % 9);
        if [a, b, c].contains(&q) || kernel.orient(&[a, b, c]) != Sign::Positive {
            continue;
        }
        let row = |i: usize| {
            [
                coordinate(i, 0) - coordinate(q, 0),
                coordinate(i, 1) - coordinate(q, 1),
                height(i) - height(q),
            ]
        };
        let [u, v, w] = [row(a), row(b), row(c)];
        // Heights above the lifted plane are outside: the determinant with absolute heights.
        let det = u[2] * (v[0] * w[1] - v[1] * w[0]) - v[2] * (u[0] * w[1] - u[1] * w[0])
            + w[2] * (u[0] * v[1] - u[1] * v[0]);
        ties += usize::from(kernel.lifted(&[a, b, c], q) == Sign::Zero);
        assert_ne!(det, 0);
        assert_eq!(kernel.in_sphere(&[a, b, c], q).is_inside(), det > 0, "{a} {b} {c} {q}");
    }
    assert!(ties > 100, "a grid has ties");
}

#[test]
fn within_a_line_inside_means_between() {
    let kernel = Adaptive::new([[0.0, 0.0], [2.0, 2.0], [1.0, 1.0], [3.0, 3.0], [-1.0, -1.0]]);
    for facet in [[0usize, 1], [1, 0]] {
        assert_eq!(kernel.in_sphere_within(&facet, 2), Side::Positive);
        assert_eq!(kernel.in_sphere_within(&facet, 3), Side::Negative);
        assert_eq!(kernel.in_sphere_within(&facet, 4), Side::Negative);
    }
}

#[test]
fn within_a_plane_heights_are_those_of_space() {
    // A steep plane: projected to any two axes the circle is an ellipse, yet the answer is the circle's.
    let points =
        [[0.0, 0.0, 0.0], [4.0, 0.0, 400.0], [0.0, 1.0, 0.0], [4.0, 1.0, 400.0], [2.0, 3.0, 200.0]];
    let kernel = Adaptive::new(points);
    assert_eq!(kernel.orient(&[0usize, 1, 2, 3]), Sign::Zero);
    assert_eq!(kernel.in_sphere_within(&[0usize, 1, 2], 4), Side::Positive);
    let flat = Projected::new(Adaptive::new(points), [0, 1]);
    assert_eq!(flat.lifted(&[0usize, 1, 2], 3), Sign::Zero);
    assert_eq!(flat.in_sphere(&[0usize, 1, 2], 4), Side::Positive);
    let shadow = Adaptive::new(points.map(|[x, y, _]| [x, y]));
    assert_eq!(shadow.lifted(&[0usize, 1, 2], 4), Sign::Negative);
}

#[test]
#[should_panic(expected = "orient in 2 dimensions takes 3 points")]
fn a_wrong_number_of_points_is_named() {
    let _ = orient(&[[0.0, 0.0], [1.0, 1.0]]);
}

#[test]
fn cross_compares_heights_above_a_line() {
    let points = [[0.0, 0.0], [3.0, 1.0], [5.0, 5.0], [5e-324, 1e300], [8.0, 6.0]];
    let (adaptive, exact) = (Adaptive::new(points), Exact::new(points));
    for (vertices, sign) in [
        ([0usize, 1, 2, 3], Sign::Positive),
        ([0, 1, 3, 2], Sign::Negative),
        ([0, 1, 2, 4], Sign::Zero),
        ([1, 0, 2, 3], Sign::Negative),
    ] {
        assert_eq!(adaptive.cross(vertices), sign, "{vertices:?}");
        assert_eq!(exact.cross(vertices), sign, "{vertices:?}");
    }
}
