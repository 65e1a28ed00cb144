//! Inputs on which named programs are wrong: measured on `robust`, `geometry-predicates`, `apfp`, Shewchuk's
//! `predicates.c`, geogram, `axiolid-predicates`, `delaunay`.

use delone::predicates::{
    Adaptive, Kernel, RobustCrate, Sign, in_circle, in_sphere, orient2d, orient3d,
};
use delone_tests::exact::power_of_two;

use crate::oracle;

fn turn([a, b, c]: [[f64; 2]; 3], expected: Sign) {
    assert_eq!(oracle::orient(&[&a, &b, &c]), expected, "the oracle on {a:?} {b:?} {c:?}");
    assert_eq!(orient2d(a, b, c), expected, "{a:?} {b:?} {c:?}");
    assert_eq!(orient2d(b, c, a), expected, "{b:?} {c:?} {a:?}");
    assert_eq!(orient2d(c, b, a), -expected, "{c:?} {b:?} {a:?}");
}

fn circle([a, b, c, d]: [[f64; 2]; 4], expected: Sign) {
    assert_eq!(
        oracle::lifted(&[&a, &b, &c, &d]),
        expected,
        "the oracle on {a:?} {b:?} {c:?} {d:?}"
    );
    assert_eq!(in_circle(a, b, c, d), expected, "{a:?} {b:?} {c:?} {d:?}");
    assert_eq!(in_circle(c, a, b, d), expected, "{c:?} {a:?} {b:?} {d:?}");
}

/// `robust` and others answer zero: products underflow.
#[test]
fn turns_whose_products_underflow() {
    turn([[0.0, 0.0], [1e-163, 0.0], [0.0, 1e-163]], Sign::Positive);
    turn([[0.0, 0.0], [5e-324, 0.0], [0.0, 5e-324]], Sign::Positive);
    let up = 1e-110 * 1f64.next_up();
    turn([[1e-200, 1e-200], [1e-110, up], [0.0, 0.0]], Sign::Positive);
}

/// `robust`, geogram and others answer zero, `apfp` the wrong sign: products or differences overflow.
#[test]
fn turns_whose_products_overflow() {
    turn([[3e160, 1e160], [1e160, 3e160], [0.0, 0.0]], Sign::Positive);
    turn([[1e160, 1e160], [-1e160, 1e160], [0.0, 0.0]], Sign::Positive);
    turn([[-1e308, -1e308], [1e308, -1e308], [1e308, 1e308]], Sign::Positive);
}

/// Nothing overflows but the splitting of a double for an exact product.
#[test]
fn a_turn_whose_split_overflows() {
    let big = power_of_two(1000);
    turn([[big * 1f64.next_up(), 1.0], [big, 1.0], [0.0, 0.0]], Sign::Positive);
}

#[test]
fn circles_far_from_one() {
    let unit = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -0.5]];
    for k in [-280, 0, 260] {
        circle(unit.map(|p| p.map(|x| x * power_of_two(k))), Sign::Positive);
    }
}

#[test]
fn tetrahedra_and_spheres_far_from_one() {
    let unit = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for s in [1e-108, 1e-66, 1e63, 1e102] {
        let [a, b, c, d] = unit.map(|p| p.map(|x| x * s));
        assert_eq!(orient3d(a, b, c, d), Sign::Positive, "{s:e}");
        assert_eq!(in_sphere(a, b, c, d, [s * 0.25; 3]), Sign::Positive, "{s:e}");
        assert_eq!(in_sphere(a, b, c, d, [s; 3]), Sign::Zero, "{s:e}");
        assert_eq!(in_sphere(a, b, c, d, [-s, 0.0, 0.0]), Sign::Negative, "{s:e}");
    }
}

/// `apfp`: +1.
#[test]
fn a_circle_near_a_point() {
    let d = [35.999_999_999_999_99, 122.0];
    circle([[81.0, 107.0], [96.0, 2.0], [111.0, 47.0], d], Sign::Negative);
}

/// `apfp`: -1.
#[test]
fn a_turn_over_eighteen_decades() {
    turn(
        [
            [3.185_385_380_646_29e-6, 9.556_156_141_938_871e-6],
            [107.747_193_135_839_21, 323.241_579_407_517_63],
            [1_983_332_765_266.705, 5_949_998_295_800.115],
        ],
        Sign::Positive,
    );
}

/// `axiolid-predicates`: +1.
#[test]
fn a_turn_over_sixteen_decades() {
    turn(
        [
            [1.563_122_935_906_886_3e-9, 4.689_368_807_720_66e-9],
            [1.493_943_165_091_748, 4.481_829_495_275_244],
            [-51_036_093.005_968_57, -153_108_279.017_905_7],
        ],
        Sign::Negative,
    );
}

/// `delaunay` 0.7.8: +1.
#[test]
fn a_circle_of_small_integers_but_one() {
    let a = [21.999_999_999_999_993, 35.0];
    circle([a, [31.0, 8.0], [13.0, 8.0], [31.0, 32.0]], Sign::Negative);
}

/// `predicates.c` compiled with contraction to fused products: +1.
#[test]
fn a_turn_of_the_kettner_grid() {
    turn(
        [[0.500_000_000_000_01, 0.500_000_000_000_008], [12.0, 12.0], [24.0, 24.0]],
        Sign::Negative,
    );
}

/// One vector's permutations with signs: cospherical. Expansions lose their last parts to underflow, and what is left is not
/// zero: `robust` says inside.
#[test]
fn a_sphere_near_two_to_the_minus_180() {
    let (x, y, z) =
        (3.395_008_296_017_831e-62, 8.777_606_908_650_025e-64, 5.751_711_326_075_678e-55);
    let points = [[-x, -y, -z], [-y, x, z], [-y, -x, -z], [-z, y, x], [-y, -x, z]];
    let [a, b, c, d, e] = points;
    assert_eq!(oracle::lifted(&[&a, &b, &c, &d, &e]), Sign::Zero);
    assert_eq!(in_sphere(a, b, c, d, e), Sign::Zero);
    assert_eq!(Adaptive::new(points).lifted(&[0usize, 1, 2, 3], 4), Sign::Zero);
    assert_ne!(RobustCrate::new(points).lifted(&[0usize, 1, 2, 3], 4), Sign::Zero);
}

/// Scales 2^k at which `robust` has lost the sign of a unit configuration (an orientation in the plane survives overflow),
/// and we have not.
#[test]
fn the_range_of_expansions() {
    let plane = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.25, 0.25]];
    let space = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.25; 3]];
    let (triangle, tetrahedron) = ([0usize, 1, 2], [0usize, 1, 2, 3]);
    for k in [-1060, -540, 520, 1000] {
        let points = plane.map(|p| p.map(|x| x * power_of_two(k)));
        assert_eq!(Adaptive::new(points).orient(&triangle), Sign::Positive, "2^{k}");
        assert_eq!(RobustCrate::new(points).orient(&triangle) == Sign::Positive, k > 0, "2^{k}");
    }
    for k in [-1060, -270, 270, 1000] {
        let points = plane.map(|p| p.map(|x| x * power_of_two(k)));
        assert_eq!(Adaptive::new(points).lifted(&triangle, 3), Sign::Positive, "2^{k}");
        assert_ne!(RobustCrate::new(points).lifted(&triangle, 3), Sign::Positive, "2^{k}");
    }
    for k in [-1060, -360, 1000] {
        let points = space.map(|p| p.map(|x| x * power_of_two(k)));
        assert_eq!(Adaptive::new(points).orient(&tetrahedron), Sign::Positive, "2^{k}");
        assert_ne!(RobustCrate::new(points).orient(&tetrahedron), Sign::Positive, "2^{k}");
    }
    for k in [-1060, -220, 220, 1000] {
        let points = space.map(|p| p.map(|x| x * power_of_two(k)));
        assert_eq!(Adaptive::new(points).lifted(&tetrahedron, 4), Sign::Positive, "2^{k}");
        assert_ne!(RobustCrate::new(points).lifted(&tetrahedron, 4), Sign::Positive, "2^{k}");
    }
}
