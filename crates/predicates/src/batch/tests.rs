use super::*;

/// Coordinates on which filters are sure, unsure, and out of range; 147 points, which is no multiple of a vector nor of a piece.
fn columns(seed: u64) -> Vec<f64> {
    let values = [0.0, -0.0, 1.0, 1.5, -2.0, 3.0, 0.1, 5e-324, f64::MAX, -f64::MAX, 1e160, 1e-163];
    let mut state = seed;
    (0..147)
        .map(|_| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let pick = usize::try_from(state >> 40).unwrap();
            if pick % 5 < 2 {
                values[pick % 12]
            } else {
                f64::from(u8::try_from(pick % 17).unwrap()) / 4.0
            }
        })
        .collect()
}

fn checked(signs: &[i8], count: usize, expected: impl Fn(usize) -> Certain) -> usize {
    let scalar: Vec<i8> = (0..signs.len()).map(|i| byte(expected(i))).collect();
    assert_eq!(signs, scalar);
    assert_eq!(count, scalar.iter().filter(|&&sign| sign == 0).count());
    signs.len() - count
}

#[test]
fn a_batch_is_its_scalars_in_the_plane() {
    let (mut sure, mut all) = (0, 0);
    let inf = f64::INFINITY;
    for seed in 0..200 {
        let columns: [Vec<f64>; 8] = std::array::from_fn(|i| columns(8 * seed + i as u64));
        let [p, q, r, s] = [0, 2, 4, 6].map(|i| [&columns[i][..], &columns[i + 1][..]]);
        let at = |p: [&[f64]; 2], i: usize| p.map(|column| column[i]);
        let [a, b, c] = [p, q, r].map(|p| at(p, 0));
        let mut signs = [7; 147];
        let count = orient2d(a, b, s, &mut signs);
        sure += checked(&signs, count, |i| filter::orient2d(&a, &b, &at(s, i), inf));
        let count = orient2d_of(p, q, c, &mut signs);
        sure += checked(&signs, count, |i| filter::orient2d(&at(p, i), &at(q, i), &c, inf));
        let count = in_circle(a, b, c, s, &mut signs);
        sure += checked(&signs, count, |i| filter::in_circle([&a, &b, &c, &at(s, i)], inf));
        let count = in_circle_of(p, q, s, c, &mut signs);
        sure += checked(&signs, count, |i| {
            filter::in_circle([&at(p, i), &at(q, i), &at(s, i), &c], inf)
        });
        all += 4 * signs.len();
    }
    assert!(sure > all / 5 && sure < all * 9 / 10, "{sure} of {all}");
}

#[test]
fn a_batch_is_its_scalars_in_space() {
    let (mut sure, mut all) = (0, 0);
    let inf = f64::INFINITY;
    for seed in 1000..1200 {
        let columns: [Vec<f64>; 15] = std::array::from_fn(|i| columns(15 * seed + i as u64));
        let [p, q, r, s, t] =
            [0, 3, 6, 9, 12].map(|i| [0, 1, 2].map(|axis| &columns[i + axis][..]));
        let at = |p: [&[f64]; 3], i: usize| p.map(|column| column[i]);
        let [a, b, c, d] = [p, q, r, t].map(|p| at(p, 0));
        let mut signs = [7; 147];
        let count = orient3d(a, b, c, s, &mut signs);
        sure += checked(&signs, count, |i| filter::orient3d([&a, &b, &c, &at(s, i)], inf));
        let count = orient3d_of(p, q, r, d, &mut signs);
        sure += checked(&signs, count, |i| {
            filter::orient3d([&at(p, i), &at(q, i), &at(r, i), &d], inf)
        });
        let count = in_sphere(a, b, c, d, s, &mut signs);
        sure += checked(&signs, count, |i| filter::in_sphere([&a, &b, &c, &d, &at(s, i)], inf));
        let count = in_sphere_of(p, q, r, s, d, &mut signs);
        sure += checked(&signs, count, |i| {
            filter::in_sphere([&at(p, i), &at(q, i), &at(r, i), &at(s, i), &d], inf)
        });
        all += 4 * signs.len();
    }
    assert!(sure > all / 5 && sure < all * 9 / 10, "{sure} of {all}");
}

#[test]
#[should_panic(expected = "2 coordinates for 3 answers")]
fn a_short_column_is_named() {
    let _ = orient2d([0.0; 2], [1.0; 2], [&[0.0; 3], &[0.0; 2]], &mut [0; 3]);
}
