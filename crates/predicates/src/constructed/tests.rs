use std::cmp::Ordering;

use super::*;

fn crossing(a: u32, b: u32, c: u32, d: u32) -> Construction {
    Construction::Crossing { a, b, c, d }
}

#[test]
fn parallel_lines_and_planes_are_refused() {
    let mut plane =
        Constructed::new(vec![[0.0, 0.0], [2.0, 1.0], [1.0, 1.0], [3.0, 1.5], [0.0, 0.0]]);
    let parallel = Err(ConstructionError::Parallel);
    assert_eq!(plane.push(&crossing(0, 1, 2, 3)).map(|_| ()), Ok(()));
    assert_eq!(plane.push(&crossing(0, 1, 3, 0)), parallel, "one line");
    assert_eq!(plane.push(&crossing(0, 4, 1, 2)), parallel, "a line through one point");
    let corners = (0..8u8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from));
    let mut space = Constructed::new(corners.collect());
    assert_eq!(space.push(&Construction::LinePlane { a: 0, b: 1, plane: [4, 5, 6] }), parallel);
    assert_eq!(space.push(&Construction::LinePlane { a: 0, b: 7, plane: [1, 1, 2] }), parallel);
    let sides = [[0, 1, 2], [0, 2, 4], [4, 5, 6]];
    assert_eq!(space.push(&Construction::ThreePlanes { planes: sides }), parallel);
    let corner = [[0, 1, 2], [0, 2, 4], [0, 1, 4]];
    assert_eq!(space.push(&Construction::ThreePlanes { planes: corner }), Ok(8));
    assert_eq!(space.compare_lexicographic(8usize, 0), Ordering::Equal);
}

#[test]
fn constructions_are_from_plain_points() {
    let mut kernel = Constructed::new(vec![[0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0]]);
    let centre = kernel.push(&crossing(0, 1, 2, 3)).unwrap();
    let not_plain = ConstructionError::NotPlain { id: centre };
    assert_eq!(kernel.push(&crossing(0, centre, 2, 3)), Err(not_plain));
    assert_eq!(
        not_plain.to_string(),
        "point 4 is constructed: construct from the plain points that define it"
    );
    let unknown = ConstructionError::Unknown { id: 9 };
    assert_eq!(kernel.push(&crossing(0, 1, 2, 9)), Err(unknown));
    let plane = Construction::LinePlane { a: 0, b: 1, plane: [1, 2, 3] };
    assert_eq!(kernel.push(&plane), Err(ConstructionError::Dimension { dimension: 2 }));
    let mut space = Constructed::new(vec![[0.0; 3], [1.0; 3], [2.0; 3], [3.0; 3]]);
    assert_eq!(
        space.push(&crossing(0, 1, 2, 3)),
        Err(ConstructionError::Dimension { dimension: 3 })
    );
    assert_eq!((space.len(), kernel.len()), (4, 5), "nothing is added");
    let plain = kernel.push_plain([5.0, 1.0]);
    assert_eq!((kernel.is_plain(plain), kernel.is_plain(centre)), (true, false));
}

/// Crossings of diagonals of a grid: at its points, between them, and where three lines meet.
#[test]
fn a_constructed_point_may_equal_a_plain_one() {
    let mut kernel = Constructed::new(vec![
        [0.0, 0.0],
        [2.0, 2.0],
        [0.0, 2.0],
        [2.0, 0.0],
        [1.0, 1.0],
        [4.0, 1.0],
    ]);
    let same = kernel.push(&crossing(0, 1, 2, 3)).unwrap() as usize;
    assert_eq!(kernel.compare_lexicographic(same, 4usize), Ordering::Equal);
    assert_eq!(kernel.orient(&[0usize, 4, same]), Sign::Zero);
    assert_eq!(kernel.lifted(&[0usize, 3, 4], same), Sign::Zero);
    // Not a double: (8/5, 2/5), by two pairs of lines and as a point of a third.
    let first = kernel.push(&crossing(0, 5, 2, 3)).unwrap() as usize;
    let second = kernel.push(&crossing(2, 3, 5, 0)).unwrap() as usize;
    assert!(!kernel.is_exact_position(6 + 1));
    assert_eq!(kernel.compare_lexicographic(first, second), Ordering::Equal);
    assert_eq!(kernel.orient(&[first, second, 0]), Sign::Zero);
    assert_eq!(kernel.orient_staged(&[0, 5, first]), (Sign::Zero, Stage::FixedWidth));
}

#[test]
fn crossings_beyond_the_largest_double() {
    // Lines that part by one unit in 2^-53 of their length, 2^1000 long.
    let far = 2f64.powi(1000);
    let mut kernel = Constructed::new(vec![
        [0.0, 0.0],
        [far, 0.0],
        [0.0, far],
        [1.0, far * (1.0 - f64::EPSILON)],
        [0.0, -1.0],
    ]);
    let id = kernel.push(&crossing(0, 1, 2, 3)).unwrap();
    assert_eq!(kernel.position(id), [2f64.powi(52), 0.0], "far, but a double");
    let mut steep =
        Constructed::new(vec![[0.0, 0.0], [far, 0.0], [0.0, 1.0], [far, 1f64.next_down()]]);
    let id = steep.push(&crossing(0, 1, 2, 3)).unwrap();
    assert_eq!(steep.position(id), [f64::INFINITY, 0.0]);
    let id = id as usize;
    assert_eq!(steep.orient(&[0usize, 1, id]), Sign::Zero);
    assert_eq!(steep.orient(&[2usize, 1, id]), Sign::Positive);
    assert_eq!(steep.compare(0, id, 1usize), Ordering::Greater);
    assert_eq!(steep.orient(&[0usize, 1, 2]), Sign::Positive, "the filters are off, not wrong");
}

/// Halves, to far below the doubles between them: the order along the segment is that of the parameters.
#[test]
fn parameters_may_be_halved_at_will() {
    let mut kernel = Constructed::new(vec![[0.1, 0.7], [0.3, 0.2]]);
    let mut t = Dyadic::from(1.0 / 3.0);
    let mut step = Dyadic::from(1);
    let mut ids = Vec::new();
    for _ in 0..200 {
        step = step.half();
        t += &step;
        ids.push(
            kernel.push(&Construction::SegmentPoint { a: 0, b: 1, t: t.clone() }).unwrap() as usize
        );
    }
    for pair in ids.windows(2) {
        assert_eq!(kernel.compare_lexicographic(pair[0], pair[1]), Ordering::Less);
        assert_eq!(kernel.compare(1, pair[0], pair[1]), Ordering::Greater);
        assert_eq!(kernel.orient(&[0, pair[0], pair[1]]), Sign::Zero);
    }
    assert_eq!(kernel.position(201), kernel.position(190), "in doubles they are one");
}

/// Points on short segments far from the origin, some of them off by what rounding takes: the filter of the call is never wrong,
/// and decides most of what is not degenerate.
#[test]
fn the_local_filter_is_right_far_from_the_origin() {
    let mut state = 9u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((state >> 40) as u32) / f64::from(1u32 << 24)
    };
    let (mut decided, mut calls) = (0, 0);
    for round in 0..400i32 {
        let scale = 2f64.powi(-(round % 40));
        let near = |x: f64| 1e5 + x * scale;
        let ends: Vec<[f64; 2]> = (0..8).map(|_| [near(random()), near(random())]).collect();
        let mut kernel = Constructed::new(ends);
        for i in 0..4u32 {
            let t = Dyadic::from(random() * 0.9 + 0.05);
            kernel.push(&Construction::SegmentPoint { a: 2 * i, b: 2 * i + 1, t }).unwrap();
        }
        // On the segment of two of them, in line up to rounding.
        kernel.push(&Construction::SegmentPoint { a: 0, b: 1, t: (1.0 / 3.0).into() }).unwrap();
        for call in [[8usize, 9, 10, 11], [8, 12, 0, 9], [8, 12, 9, 10], [0, 8, 12, 1]] {
            let [a, b, c, q] = call;
            let (orient, _) = kernel.orient_by_ring(&[0, 1], &[a, b, c]);
            let value = kernel.orient_value(&[a, b, c]);
            let locally = kernel.orient_locally(&[a, b, c], value);
            assert!(locally.is_none_or(|(sign, _)| sign == orient), "{round} {call:?}");
            let (lifted, _) = kernel.lifted_by_ring(&[0, 1], &[a, b, c], q);
            let locally = kernel.lifted_locally(&[a, b, c], q);
            assert!(locally.is_none_or(|(sign, _)| sign == lifted), "{round} {call:?}");
            let points = at(&kernel.positions, [a, b, c, q]);
            let (value, heights) = value::in_circle_and_heights(points);
            let within = local::in_circle_within(value, heights, kernel.far);
            assert!(within.is_none_or(|sign| sign == lifted), "{round} {call:?}");
            let locally = kernel.dot_locally([a, b, c, q]);
            let at = |v: usize| kernel.exact_at(v).x;
            let from = |p: usize, q: usize| {
                let [[x, y], [u, v]] = [at(p), at(q)];
                [u - x, v - y]
            };
            let ([x, y], [u, v]) = (from(a, b), from(c, q));
            let by_ring = (&x * &u + &y * &v).sign();
            assert!(locally.is_none_or(|sign| sign == by_ring), "{round} {call:?}");
            if call[1] == 9 && round % 40 < 20 {
                calls += 1;
                decided += usize::from(locally.is_some() && within.is_some());
            }
        }
    }
    assert!(decided * 10 > calls * 9, "{decided} of {calls}");
}

#[test]
fn the_last_vertex_can_be_taken_away() {
    let mut kernel = Constructed::new(vec![[0.0, 0.0], [5.0, 1.0], [0.0, 2.0], [2.0, 0.0]]);
    let before = kernel.clone();
    let third = Construction::SegmentPoint { a: 1, b: 2, t: (1.0 / 3.0).into() };
    for _ in 0..2 {
        assert_eq!(kernel.push(&third), Ok(4));
        assert_eq!(kernel.orient(&[1usize, 2, 4]), Sign::Zero);
        assert!(!kernel.is_exact_position(4));
        assert!(kernel.pop());
        assert_eq!(kernel.push_plain([1.0, 1.0]), 4, "its id is free again");
        assert_eq!(kernel.orient(&[1usize, 2, 4]), Sign::Positive);
        assert!(kernel.is_exact_position(4) && kernel.is_plain(4));
        assert!(kernel.pop());
    }
    assert_eq!(kernel.positions(), before.positions());
    (0..4).for_each(|_| assert!(kernel.pop()));
    assert!(!kernel.pop() && kernel.is_empty());
}

#[test]
fn a_reordered_kernel_has_the_same_vertices() {
    let mut kernel = Constructed::new(vec![[0.0, 0.0], [4.0, 1.0], [0.0, 2.0], [2.0, 0.0]]);
    let crossed = kernel.push(&crossing(0, 1, 2, 3)).unwrap();
    let order = [crossed, 2, 0, 1, 3];
    let mut reordered = kernel.reordered(&order);
    assert_eq!(reordered.exact(0), kernel.exact(crossed));
    assert_eq!(reordered.orient_staged(&[0usize, 2, 3]), (Sign::Zero, Stage::FixedWidth));
    // One can go on there, in its numbers.
    assert_eq!(reordered.push(&crossing(2, 3, 1, 4)), Ok(5));
    assert_eq!(reordered.exact(5), reordered.exact(0));
    assert_eq!(reordered.push(&crossing(0, 3, 1, 4)), Err(ConstructionError::NotPlain { id: 0 }));
}

#[test]
fn calls_on_plain_points_go_through_the_stages_of_plain_points() {
    let mut kernel =
        Constructed::new(vec![[0.0, 0.0], [4.0, 1.0], [0.0, 2.0], [2.0, 0.0], [2.0, 2.0]]);
    kernel.push(&crossing(0, 1, 2, 3)).unwrap();
    assert_eq!(kernel.orient_staged(&[0usize, 1, 2]).1, Stage::StaticFilter);
    assert_eq!(kernel.lifted_staged(&[0usize, 3, 2], 4), (Sign::Zero, Stage::MachineWords));
    assert_eq!(kernel.orient_staged(&[0usize, 3, 5]).1, Stage::StaticFilter);
}

#[test]
#[should_panic(expected = "orient in 2 axes takes 3 points")]
fn a_wrong_number_of_vertices_is_named() {
    let mut kernel = Constructed::new(vec![[0.0, 0.0], [4.0, 1.0], [0.0, 2.0], [2.0, 0.0]]);
    kernel.push(&crossing(0, 1, 2, 3)).unwrap();
    let _ = kernel.orient(&[4usize, 0]);
}

/// The quick way makes the same vertices as the general one, and refuses the same.
#[test]
fn points_between_are_segment_points() {
    let points = vec![[0.1, 0.7], [3.0, -1.0 / 3.0], [1e300, 5e-324]];
    let (mut quick, mut general) = (Constructed::new(points.clone()), Constructed::new(points));
    for ends in [[0, 1], [1, 0], [0, 2]] {
        for t in [0.5, 0.1, 1.0 / 3.0, 1e-20, 1.0 - f64::EPSILON] {
            let [a, b] = ends;
            let segment_point = Construction::SegmentPoint { a, b, t: t.into() };
            let (p, q) = (quick.push_between(ends, t), general.push(&segment_point));
            let p = p.unwrap();
            assert_eq!(Ok(p), q);
            assert_eq!(quick.position(p), general.position(p));
            assert_eq!(quick.is_exact_position(p), general.is_exact_position(p));
            assert_eq!(
                (quick.exact(p).x, quick.exact(p).w),
                (general.exact(p).x, general.exact(p).w)
            );
        }
    }
    assert_eq!(quick.push_between([0, 3], 0.5), Err(ConstructionError::NotPlain { id: 3 }));
    assert_eq!(quick.push_between([0, 99], 0.5), Err(ConstructionError::Unknown { id: 99 }));
}

/// On a line, and off it by less than any double.
#[test]
fn points_given_exactly_are_just_there() {
    let mut kernel = Constructed::new(vec![[0.0, 0.0], [3.0, 1.0], [0.0, 5.0]]);
    let t = (0..9i64).fold(Dyadic::ZERO, |t, i| t + Dyadic::from(1.0 / 3.0).scaled(-50 * i));
    let (a, b) = (0, 1);
    let point = kernel.push(&Construction::SegmentPoint { a, b, t: t.clone() }).unwrap() as usize;
    let x = &t * &Dyadic::from(3);
    let same = kernel.push_exact([x.clone(), t.clone()]) as usize;
    assert_eq!(kernel.compare_lexicographic(point, same), Ordering::Equal);
    assert_eq!(kernel.position(3), kernel.position(4));
    assert_eq!(kernel.orient(&[0, 1, same]), Sign::Zero);
    let least = Dyadic::from(1).scaled(-5000);
    for (off, sign) in [(least.clone(), Sign::Positive), (-least, Sign::Negative)] {
        let beside = kernel.push_exact([x.clone(), t.clone() + &off]) as usize;
        assert!(!kernel.is_exact_position(u32::try_from(beside).unwrap()));
        assert_eq!(kernel.orient(&[0, 1, beside]), sign);
        assert_eq!(kernel.position(3), kernel.position(u32::try_from(beside).unwrap()));
        assert!(kernel.pop());
    }
    let plain = kernel.push_exact([Dyadic::from(0), Dyadic::from(5)]);
    assert!(kernel.is_exact_position(plain) && !kernel.is_plain(plain));
    assert_eq!(kernel.compare_lexicographic(2usize, plain as usize), Ordering::Equal);
    let beyond = kernel.push_exact([Dyadic::from(1).scaled(3000), Dyadic::ZERO]);
    assert_eq!(kernel.position(beyond), [f64::INFINITY, 0.0]);
    assert_eq!(kernel.orient(&[0, 1, beyond as usize]), Sign::Negative);
}
