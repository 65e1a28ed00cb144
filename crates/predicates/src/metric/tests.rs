use super::*;

/// A grid of 27 points, and its centre.
fn grid() -> Vec<[f64; 3]> {
    (0..27u8).map(|i| [i / 9, i / 3 % 3, i % 3].map(f64::from)).collect()
}

#[test]
fn flat_simplices_have_an_infinite_radius() {
    let kernel = Adaptive::new([[0.1, 0.1], [0.2, 0.2], [0.3, 0.3], [5.0, 1.0], [0.1, 0.1]]);
    assert_eq!(kernel.squared_radius(&[0usize, 4]), f64::INFINITY);
    assert_eq!(kernel.compare_radii(&[0usize, 4], &[0, 1, 2]), Ordering::Equal);
    assert_eq!(kernel.compare_radii(&[0usize, 4], &[0, 1, 3]), Ordering::Greater);
    assert_eq!(kernel.compare_radius(&[0usize, 4], f64::INFINITY), Ordering::Equal);
    assert_eq!(kernel.compare_radius(&[0usize, 4], f64::MAX), Ordering::Greater);
    assert_eq!(kernel.compare_radius(&[0usize, 3], f64::INFINITY), Ordering::Less);
    assert_eq!(kernel.compare_radius(&[0usize, 4], f64::NEG_INFINITY), Ordering::Greater);
}

#[test]
fn the_radius_of_a_vertex_is_its_weight() {
    let points = [[0.3, 0.7], [5e-324, 1e300]];
    let plain = Adaptive::new(points);
    assert_eq!(plain.squared_radius(&[1usize]), 0.0);
    assert_eq!(plain.compare_radius(&[1usize], 0.0), Ordering::Equal);
    let weighted = Weighted::new(points, [0.1, -3.0]);
    assert_eq!(weighted.squared_radius(&[0usize]), -0.1);
    assert_eq!(weighted.compare_radius(&[1usize], 3.0), Ordering::Equal);
    assert_eq!(weighted.compare_radii(&[0usize], &[1]), Ordering::Less);
}

#[test]
fn an_angle_with_an_empty_side_is_zero() {
    let kernel = Adaptive::new([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 1.0], [0.0, 0.0]]);
    let right = [1usize, 0, 3];
    assert_eq!(kernel.compare_angles([1usize, 0, 2], [1, 0, 4]), Ordering::Equal);
    assert_eq!(kernel.compare_angles([1usize, 0, 4], right), Ordering::Less);
    assert_eq!(kernel.compare_angles([0usize, 1, 2], right), Ordering::Greater, "180 degrees");
    assert_eq!(kernel.compare_angles([3usize, 0, 1], right), Ordering::Equal);
}

#[test]
fn radii_on_a_grid_tie() {
    let (adaptive, exact) = (Adaptive::new(grid()), Exact::new(grid()));
    // The 2 x 2 x 2 cube's circumsphere, through four of its corners, as that of a diagonal.
    let cube = [0usize, 2, 6, 18];
    for kernel_says in
        [adaptive.compare_radii(&cube, &[0, 26]), exact.compare_radii(&cube, &[0, 26])]
    {
        assert_eq!(kernel_says, Ordering::Equal);
    }
    assert_eq!(adaptive.squared_radius(&cube), 3.0);
    assert_eq!(adaptive.compare_radii(&cube, &[0, 2, 6]), Ordering::Greater);
    assert_eq!(adaptive.compare_radii(&[0usize, 2, 6], &[2, 6]), Ordering::Equal);
}

/// All right triangles of a grid: the squared radius is a quarter of the squared hypotenuse.
#[test]
fn right_triangles_have_half_the_hypotenuse() {
    let (points, mut count) = (grid(), 0);
    let kernel = Adaptive::new(&points);
    let square =
        |a: usize, b: usize| (0..3).map(|x| (points[a][x] - points[b][x]).powi(2)).sum::<f64>();
    for code in 0..27usize.pow(3) {
        let [a, b, c] = [code % 27, code / 27 % 27, code / 729];
        let [ab, bc, ca] = [square(a, b), square(b, c), square(c, a)];
        if a != b && b != c && ab + bc == ca {
            assert_eq!(kernel.compare_radius(&[a, b, c], ca / 4.0), Ordering::Equal);
            assert_eq!(kernel.compare_radius(&[a, b, c], (ca / 4.0).next_up()), Ordering::Less);
            assert_eq!(
                kernel.compare_radius(&[a, b, c], (ca / 4.0).next_down()),
                Ordering::Greater
            );
            let sides = kernel.compare_lengths([a, b], [b, c]);
            assert_eq!(sides, ab.total_cmp(&bc));
            assert_eq!(kernel.compare_angles([b, c, a], [c, a, b]), sides, "the longer side's");
            assert_eq!(kernel.dot([b, a, b, c]), Sign::Zero);
            assert_eq!(kernel.dot([a, b, a, c]), Sign::Positive);
            assert_eq!(kernel.dot([a, b, c, a]), Sign::Negative);
            count += 1;
        }
    }
    assert!(count > 500, "{count}");
}

#[test]
fn lengths_are_right_at_both_ends_of_the_range() {
    let tiny = Adaptive::new([[0.0, 0.0], [5e-324, 0.0], [5e-324, 5e-324], [0.0, 1e-323]]);
    assert_eq!(tiny.compare_lengths([0usize, 1], [0, 2]), Ordering::Less);
    assert_eq!(tiny.compare_lengths([0usize, 3], [0, 2]), Ordering::Greater);
    assert_eq!(tiny.compare_radii(&[0usize, 1, 2], &[0, 2]), Ordering::Equal);
    let huge =
        Adaptive::new([[-f64::MAX, 0.0], [f64::MAX, 0.0], [0.0, f64::MAX], [0.0, -f64::MAX]]);
    assert_eq!(huge.compare_lengths([0usize, 1], [2, 3]), Ordering::Equal);
    assert_eq!(huge.compare_lengths([0usize, 2], [1, 0]), Ordering::Less);
    assert_eq!(huge.compare_radii(&[0usize, 1, 2], &[2, 3]), Ordering::Equal);
}

/// Numbers below 2^bits in magnitude, odd or even.
fn whole(state: &mut u64, bits: u32) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    let magnitude = *state >> (64 - bits);
    #[expect(clippy::cast_precision_loss, reason = "rounded is as good")]
    let value = magnitude as f64;
    if *state >> 7 & 1 == 0 { value } else { -value }
}

/// `Exact` has no formulas in words: the general ones answer.
fn in_words_as_in_general<const D: usize>(points: &[[f64; D]], unit: f64) {
    let points: Vec<[f64; D]> = points.iter().map(|p| p.map(|x| x * unit)).collect();
    let (ours, general) = (Adaptive::new(&points[..]), Exact::new(&points[..]));
    let ids: Vec<usize> = (0..points.len()).collect();
    for s in 1..=D + 1 {
        for t in 1..=D + 1 {
            let (first, second) = (&ids[..s], &ids[points.len() - t..]);
            assert_eq!(
                ours.compare_radii(first, second),
                general.compare_radii(first, second),
                "{points:?}, {s} and {t}"
            );
            let mut turned = first.to_vec();
            turned.rotate_left(1);
            assert_eq!(ours.compare_radii(first, &turned), Ordering::Equal, "{points:?}, {s}");
        }
    }
    assert_eq!(
        ours.compare_lengths([0usize, 1], [2, 3]),
        general.compare_lengths([0usize, 1], [2, 3]),
        "{points:?}"
    );
}

#[test]
fn radii_in_words_are_those_in_general() {
    let mut state = 3;
    for round in 0..150 {
        // Few bits tie and are flat; full ones are wide.
        let bits = [1, 2, 3, 20, 53, 61][round % 6];
        for unit in [1.0, 2f64.powi(-1000), 2f64.powi(900)] {
            let mut coordinate = || whole(&mut state, bits);
            let plane: [[f64; 2]; 5] = std::array::from_fn(|_| [coordinate(), coordinate()]);
            let space: [[f64; 3]; 6] = std::array::from_fn(|_| [0; 3].map(|_| coordinate()));
            in_words_as_in_general(&plane, unit);
            in_words_as_in_general(&space, unit);
        }
    }
}

#[test]
fn radii_in_words_have_head_room_at_the_largest_differences() {
    // Corners of the largest cube of integers of one limb, one of them off by the least there is at that height.
    let far = 2f64.powi(61) - 256.0;
    for off in [0.0f64, -256.0, -512.0] {
        let corners = [
            [far, far, far],
            [-far, -far, far],
            [-far, far, -far],
            [far, -far, -far],
            [far + off, -far, far],
            [-far, -far, -far],
        ];
        for shift in 0..6 {
            let mut corners = corners;
            corners.rotate_left(shift);
            in_words_as_in_general(&corners, 1.0);
        }
    }
}

/// The power of the last point to the circle or sphere with the others' flat, by Cramer's rule in rationals of small integers:
/// det G (h_q - sum l_i (v_i . c)), with 2 G l = h.
fn power_by_definition(points: &[[f64; 3]], weights: &[f64]) -> f64 {
    let from = |i: usize| [0, 1, 2].map(|x| points[i][x] - points[0][x]);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let last = points.len() - 1;
    let height = |i: usize| dot(from(i), from(i)) - weights[i] + weights[0];
    let c = from(last);
    match last {
        1 => height(1),
        2 => dot(from(1), from(1)) * height(2) - dot(c, from(1)) * height(1),
        3 => {
            let (u, v) = (from(1), from(2));
            let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
            let (l, m) = (height(1) * vv - height(2) * uv, height(2) * uu - height(1) * uv);
            (uu * vv - uv * uv) * height(3) - l * dot(u, c) - m * dot(v, c)
        }
        _ => panic!("two to four points"),
    }
}

#[test]
fn in_smallest_sphere_is_the_sign_of_the_power() {
    let (mut state, mut zeros, mut inside) = (11, 0, 0);
    for round in 0..3000 {
        let points: [[f64; 3]; 4] = std::array::from_fn(|_| [0; 3].map(|_| whole(&mut state, 2)));
        let weights: [f64; 4] =
            std::array::from_fn(|_| if round % 2 == 0 { 0.0 } else { whole(&mut state, 2) });
        let simplex = &[0usize, 1, 2][..1 + round / 2 % 3];
        let q = simplex.len();
        let expected = power_by_definition(&points[..=q], &weights);
        let expected = -Sign::of(expected);
        zeros += usize::from(expected == Sign::Zero);
        inside += usize::from(expected == Sign::Positive);
        let weighted = Weighted::new(points, weights);
        if weighted.squared_radius(simplex) == f64::INFINITY {
            continue; // flat
        }
        assert_eq!(weighted.in_smallest_sphere(simplex, q), expected, "{points:?} {weights:?}");
        if round % 2 == 0 {
            let (adaptive, exact) = (Adaptive::new(points), Exact::new(points));
            assert_eq!(adaptive.in_smallest_sphere(simplex, q), expected, "{points:?}");
            assert_eq!(exact.in_smallest_sphere(simplex, q), expected, "{points:?}");
        }
    }
    assert!(zeros > 50 && inside > 100, "{zeros} {inside}");
}

#[test]
fn radius_bounds_hold_the_radius() {
    let (mut state, mut narrow) = (5, 0);
    for round in 0..600 {
        let bits = [2, 20, 53][round % 3];
        let points: [[f64; 3]; 4] =
            std::array::from_fn(|_| [0; 3].map(|_| whole(&mut state, bits)));
        let weights: [f64; 4] = std::array::from_fn(|_| whole(&mut state, bits));
        let simplex = &[0usize, 1, 2, 3][..1 + round / 3 % 4];
        let (plain, weighted) = (Adaptive::new(points), Weighted::new(points, weights));
        for ([low, high], exact) in [
            (plain.radius_bounds(simplex), plain.exact_squared_radius(simplex)),
            (weighted.radius_bounds(simplex), weighted.exact_squared_radius(simplex)),
        ] {
            let bound = |x: f64| SquaredRadius::new(Dyadic::from(x), Dyadic::from(1));
            assert!(!low.is_finite() || bound(low) <= exact, "{points:?} {weights:?}");
            assert!(!high.is_finite() || exact <= bound(high), "{points:?} {weights:?}");
            narrow += usize::from(high - low <= high.abs() * 1e-9);
        }
    }
    assert!(narrow > 800, "{narrow}");
}

/// Coordinates of 53 bits, and queries near the sphere: rounded points of it.
#[test]
fn in_smallest_sphere_is_exact_near_the_sphere() {
    let mut state = 17;
    for round in 0..2000 {
        let unit = [1.0, 2f64.powi(-600), 2f64.powi(300), 2f64.powi(-90)][round % 4];
        let mut points: [[f64; 3]; 4] =
            std::array::from_fn(|_| [0; 3].map(|_| whole(&mut state, 53) * unit));
        // The antipode of a vertex, mirrored in the middle of an edge or in the centre of a right triangle.
        let simplex = &[0usize, 1, 2][..2 + round % 2];
        let (a, b) = (points[0], points[1]);
        let mirrored = std::array::from_fn(|x| a[x] + b[x] - points[2][x]);
        if round % 3 == 0 {
            points[3] = mirrored;
        }
        let q = if simplex.len() == 2 { 2 } else { 3 };
        if simplex.len() == 2 && round % 3 == 1 {
            points[2] = [a[0], b[1], b[2]]; // a corner of the box of an edge is on its sphere
        }
        let (ours, exact) = (Adaptive::new(points), Exact::new(points));
        assert_eq!(
            ours.in_smallest_sphere(simplex, q),
            exact.in_smallest_sphere(simplex, q),
            "{points:?}"
        );
    }
}

/// Which corners are inside the smallest spheres through the others, and the radius: against exact answers, with points near
/// a flat and near right angles among them (a lattice of tenths, rounded), at both ends of the range and outside.
#[test]
fn circumballs_agree_with_exact_answers() {
    let (mut state, mut told, mut asked) = (23, 0, 0);
    for round in 0..3000 {
        let bits = [3, 20, 53][round % 3];
        let unit = [1.0, 2f64.powi(-118), 2f64.powi(45), 2f64.powi(-600), 0.1][round / 3 % 5];
        let mut points: [[f64; 3]; 4] =
            std::array::from_fn(|_| [0; 3].map(|_| whole(&mut state, bits) * unit));
        if round % 5 == 0 {
            let flat: [f64; 3] =
                std::array::from_fn(|x| points[0][x] + points[1][x] - points[2][x]);
            points[3] = [flat[0], flat[1], flat[2].next_up()];
        }
        let plane = points.map(|[x, y, _]| [x, y]);
        let counts = [agree(&points, 4), agree(&points, 3), agree(&plane, 3)];
        told += counts.iter().map(|count| count[0]).sum::<usize>();
        asked += counts.iter().map(|count| count[1]).sum::<usize>();
    }
    assert!(told * 10 > asked * 6, "{told} of {asked}");
}

/// How many corners of the first `count` points doubles told of, and of how many they were asked.
fn agree<const D: usize>(points: &[[f64; D]; 4], count: usize) -> [usize; 2] {
    let (kernel, exact) = (Adaptive::new(points), Exact::new(points));
    let simplex = &[0usize, 1, 2, 3][..count];
    let Some(ball) = kernel.circumball(simplex) else { return [0, count] };
    let radius = kernel.exact_squared_radius(simplex);
    let bound = |x: f64| SquaredRadius::new(Dyadic::from(x), Dyadic::from(1));
    let [low, high] = ball.squared_radius;
    assert!(!low.is_finite() || bound(low) <= radius, "{points:?}");
    assert!(!high.is_finite() || radius <= bound(high), "{points:?}");
    let mut told = 0;
    for (corner, inside) in ball.inside.iter().enumerate() {
        let Some(sign) = *inside else { continue };
        let others: Vec<usize> = simplex.iter().copied().filter(|&i| i != corner).collect();
        let is_flat = exact.squared_radius(&others) == f64::INFINITY;
        assert!(is_flat || exact.in_smallest_sphere(&others, corner) == sign, "{points:?}");
        told += 1;
    }
    [told, count]
}
