//! Inputs on which other implementations are known to answer wrongly, each with the true sign.
//!
//! Found by comparing them with exact rationals; `robust` is tried on its cases here, so that the list stays true.

use crate::{Exact, Kernel, RobustCrate, Sign, in_circle, in_sphere, orient2d, orient3d};

/// Ours are right; whether `robust` is.
fn orient2d_case(points: [[f64; 2]; 3], sign: Sign) -> bool {
    let [a, b, c] = points;
    assert_eq!(orient2d(a, b, c), sign, "{points:?}");
    assert_eq!(orient2d(b, a, c), -sign, "{points:?}, swapped");
    assert_eq!(Exact::new(points).orient(&[0usize, 1, 2]), sign, "{points:?}, exact");
    RobustCrate::new(points).orient(&[0usize, 1, 2]) == sign
}

fn in_circle_case(points: [[f64; 2]; 4], sign: Sign) -> bool {
    let [a, b, c, d] = points;
    assert_eq!(in_circle(a, b, c, d), sign, "{points:?}");
    assert_eq!(in_circle(b, a, c, d), -sign, "{points:?}, swapped");
    assert_eq!(Exact::new(points).lifted(&[0usize, 1, 2], 3), sign, "{points:?}, exact");
    RobustCrate::new(points).lifted(&[0usize, 1, 2], 3) == sign
}

#[test]
fn products_that_underflow_do_not_look_collinear() {
    for tiny in [1e-163, 5e-324] {
        let right = orient2d_case([[0.0, 0.0], [tiny, 0.0], [0.0, tiny]], Sign::Positive);
        assert!(!right, "robust answers zero");
    }
    let mixed = [[1e-200, 1e-200], [1e-110, 1e-110 * (1.0 + f64::EPSILON)], [0.0, 0.0]];
    assert!(!orient2d_case(mixed, Sign::Positive), "tails of products underflow in robust");
}

#[test]
fn products_that_overflow_are_not_lost() {
    let both = [[3e160, 1e160], [1e160, 3e160], [0.0, 0.0]];
    assert!(!orient2d_case(both, Sign::Positive), "infinity minus infinity in robust");
    let one = [[1e160, 1e160], [-1e160, 1e160], [0.0, 0.0]];
    assert!(!orient2d_case(one, Sign::Positive), "infinity compared with infinity in robust");
    let splitter = 2f64.powi(1000);
    let wide = [[splitter * (1.0 + f64::EPSILON), 1.0], [splitter, 1.0], [0.0, 0.0]];
    assert!(!orient2d_case(wide, Sign::Positive), "Dekker's split overflows in robust");
}

#[test]
fn differences_that_overflow_are_not_lost() {
    let corners = [[-1e308, -1e308], [1e308, -1e308], [1e308, 1e308]];
    assert!(!orient2d_case(corners, Sign::Positive), "robust answers zero");
}

#[test]
fn nearly_collinear_on_steep_lines() {
    // Answered wrongly by apfp 0.1.1 and by axiolid-predicates 0.3.4, on the line y = 3x.
    let first = [
        [3.18538538064629e-6, 9.556156141938871e-6],
        [107.74719313583921, 323.24157940751763],
        [1983332765266.705, 5949998295800.115],
    ];
    assert!(orient2d_case(first, Sign::Positive));
    let second = [
        [1.5631229359068863e-9, 4.68936880772066e-9],
        [1.493943165091748, 4.481829495275244],
        [-51036093.00596857, -153108279.0179057],
    ];
    assert!(orient2d_case(second, Sign::Negative));
    // Answered wrongly by predicates.c where the compiler contracts products and sums.
    let ulps = [[0.50000000000001, 0.500000000000008], [12.0, 12.0], [24.0, 24.0]];
    assert!(orient2d_case(ulps, Sign::Negative));
}

#[test]
fn nearly_cocircular() {
    let apfp = [[81.0, 107.0], [96.0, 2.0], [111.0, 47.0], [35.99999999999999, 122.0]];
    assert!(in_circle_case(apfp, Sign::Negative));
    let rounded = [[21.999999999999993, 35.0], [31.0, 8.0], [13.0, 8.0], [31.0, 32.0]];
    assert!(in_circle_case(rounded, Sign::Negative));
}

#[test]
fn circles_scaled_out_of_the_range_of_expansions() {
    for k in [-1070, -280, 260, 1000] {
        let s = 2f64.powi(k);
        let circle = [[s, 0.0], [0.0, s], [-s, 0.0], [0.0, -0.5 * s]];
        assert!(!in_circle_case(circle, Sign::Positive), "robust answers zero at 2^{k}");
    }
}

#[test]
fn tetrahedra_and_spheres_scaled_out_of_the_range_of_expansions() {
    for s in [1e-108, 1e-66, 1e63, 1e200, 5e-324] {
        let [a, b, c, d] = [[0.0; 3], [s, 0.0, 0.0], [0.0, s, 0.0], [0.0, 0.0, s]];
        assert_eq!(orient3d(a, b, c, d), Sign::Positive, "{s}");
        assert_eq!(in_sphere(a, b, c, d, [s, s, s]), Sign::Zero, "{s}");
        assert_eq!(in_sphere(a, b, c, d, [s, s, 0.0]), Sign::Zero, "{s}");
        assert_eq!(in_sphere(a, b, c, d, [-s, s, s]), Sign::Negative, "{s}");
    }
    let points = [[0.0; 3], [1e-108, 0.0, 0.0], [0.0, 1e-108, 0.0], [0.0, 0.0, 1e-108]];
    assert_eq!(RobustCrate::new(points).orient(&[0usize, 1, 2, 3]), Sign::Zero, "wrongly");
}
