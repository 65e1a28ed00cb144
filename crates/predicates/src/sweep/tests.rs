use super::*;
use crate::Kernel;

/// A number below `below` from a state that it moves on.
fn dice(state: &mut u64, below: u64) -> i64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    i64::try_from((*state >> 33) % below).unwrap()
}

fn left_turn<K: Kernel<2>>(kernel: &K, sites: [usize; 3]) -> Option<[usize; 3]> {
    let [a, b, c] = sites;
    match kernel.orient(&sites) {
        Sign::Negative => Some([a, c, b]),
        Sign::Zero => None,
        Sign::Positive => Some(sites),
    }
}

/// The 12 lattice points on the circle of radius 5 about a centre.
fn circle([x, y]: [f64; 2]) -> Vec<[f64; 2]> {
    let on_circle = [[5, 0], [4, 3], [3, 4], [0, 5], [-3, 4], [-4, 3]].map(|p| p.map(f64::from));
    on_circle.iter().flat_map(|&[a, b]| [[x + a, y + b], [x - a, y - b]]).collect()
}

#[test]
fn arcs_that_meet_at_a_height_are_equal_there() {
    // With the line at the rightmost point of a circle, the arcs of all sites on it meet at its centre.
    for centre in [[0.0, 0.0], [7.0, -2.0], [0.125, 1024.5]] {
        let points = circle(centre);
        let p = points.iter().position(|&point| point == [centre[0] + 5.0, centre[1]]).unwrap();
        let kernel = Adaptive::new(&points);
        for a in (0..12).filter(|&a| a != p) {
            for b in (0..12).filter(|&b| b != p) {
                assert_eq!(kernel.arc_ahead(p, [a, b]), Sign::Zero);
            }
        }
    }
    // Straight behind p the nearest is ahead; beside it, the one whose circle is smaller: radii 1, 2, 2.5.
    let kernel = Adaptive::new([[0.0, 0.0], [-2.0, 0.0], [-4.0, 0.0], [-1.0, 2.0]]);
    assert_eq!(kernel.arc_ahead(0usize, [1, 2]), Sign::Positive);
    assert_eq!(kernel.arc_ahead(0usize, [3, 2]), Sign::Negative);
    assert_eq!(kernel.arc_ahead(0usize, [3, 1]), Sign::Negative);
}

#[test]
fn events_of_one_line_are_equal() {
    // Two circles of radius 5, one above the other, and one that ends a unit further right.
    let mut points = circle([0.0, 0.0]);
    points.extend(circle([0.0, 100.0]));
    points.extend(circle([1.0, 3.0]));
    points.extend([[5.0, 1e9], [6.0, -3.0]]);
    let kernel = Adaptive::new(&points);
    let events = |first: usize| {
        let triples = (0..12).flat_map(move |i| (0..i).map(move |j| [first + i, first + j, first]));
        let turned = triples.filter_map(|sites| left_turn(&kernel, sites));
        turned.map(|sites| kernel.circle_event(sites)).collect::<Vec<_>>()
    };
    let (zero, above, beyond) = (events(0), events(12), events(24));
    assert_eq!(zero.len(), 55);
    for e in &zero {
        for f in &above {
            assert_eq!(kernel.compare_events(e, f), Ordering::Equal);
        }
        for f in &beyond {
            assert_eq!(kernel.compare_events(e, f), Ordering::Less);
            assert_eq!(kernel.compare_events(f, e), Ordering::Greater);
        }
        assert_eq!(kernel.compare_event_with_site(e, 36), Ordering::Equal);
        assert_eq!(kernel.compare_event_with_site(e, 37), Ordering::Less);
    }
    assert_eq!(kernel.compare_event_with_site(&beyond[0], 36), Ordering::Greater);
}

#[test]
fn signs_with_roots_are_those_of_numbers() {
    for x in -7..=7i32 {
        for p in 0..40i32 {
            for q in 0..40i32 {
                let [p_exact, q_exact, x_exact] = [p, q, x].map(|v| Dyadic::from(i64::from(v)));
                let sign = sign_with_roots(&x_exact, &p_exact, &q_exact);
                // Numbers of this kind that are so small and not zero are at least 1 / (7 + 7 + 7)^3 in magnitude: their
                // conjugates, of which there are three others, multiply with them to a whole number.
                let value = f64::from(x) + f64::from(p).sqrt() - f64::from(q).sqrt();
                let expected = if value.abs() < 1e-5 { Sign::Zero } else { Sign::of(value) };
                assert_eq!(sign, expected, "{x} + sqrt {p} - sqrt {q}");
            }
        }
    }
}

/// All comparisons among some sites: the filter's against none, and orders against positions where these are clear.
fn compare_all(points: &[[f64; 2]]) {
    let (adaptive, exact) = (Adaptive::new(points), Exact::new(points));
    let n = points.len();
    let mut events = Vec::new();
    for a in 0..n {
        for b in 0..n {
            for p in (0..n).filter(|&p| points[p][0] > points[a][0].max(points[b][0])) {
                assert_eq!(adaptive.arc_ahead(p, [a, b]), exact.arc_ahead(p, [a, b]), "{points:?}");
                assert_eq!(exact.arc_ahead(p, [b, a]), -exact.arc_ahead(p, [a, b]));
            }
            events.extend((0..b.min(a)).filter_map(|c| left_turn(&exact, [a, b, c])));
        }
    }
    let events: Vec<_> =
        events.into_iter().map(|s| [adaptive.circle_event(s), exact.circle_event(s)]).collect();
    for [near, unknown] in &events {
        assert_eq!(unknown.span, Span::ALL);
        for (p, &point) in points.iter().enumerate() {
            let order = exact.compare_event_with_site(unknown, p);
            assert_eq!(adaptive.compare_event_with_site(near, p), order, "{points:?}");
            let is_corner = near.sites().contains(&p);
            assert!(
                !is_corner || order.is_ge(),
                "a circle ends no earlier than its points: {point:?}"
            );
        }
        for [other, unknown_other] in &events {
            let order = exact.compare_events(unknown, unknown_other);
            assert_eq!(adaptive.compare_events(near, other), order, "{points:?}");
            assert_eq!(exact.compare_events(unknown_other, unknown), order.reverse());
        }
    }
}

#[test]
fn small_integers_are_ordered_as_in_doubles() {
    let mut state = 1;
    for _ in 0..300 {
        let points: [[f64; 2]; 6] =
            std::array::from_fn(|_| std::array::from_fn(|_| dice(&mut state, 9) as f64));
        compare_all(&points[..4]);
        let kernel = Exact::new(points);
        let triples = [[0, 1, 2], [3, 4, 5]].map(|sites| left_turn(&kernel, sites));
        let [Some(s), Some(t)] = triples else { continue };
        let order = kernel.compare_events(&kernel.circle_event(s), &kernel.circle_event(t));
        let [x, y] = [s, t].map(|sites| rightmost(sites.map(|v| points[v])));
        // A gap that is not zero is over 1e-9 by far for so small integers.
        let expected = if (x - y).abs() < 1e-9 { Ordering::Equal } else { x.total_cmp(&y) };
        assert_eq!(order, expected, "{points:?}");
    }
}

/// The rightmost point of a circle, by way of its centre.
fn rightmost([[ax, ay], [bx, by], [cx, cy]]: [[f64; 2]; 3]) -> f64 {
    let [a, b, c] = [ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy];
    let d = 2.0 * (ax * (by - cy) + bx * (cy - ay) + cx * (ay - by));
    let x = (a * (by - cy) + b * (cy - ay) + c * (ay - by)) / d;
    let y = (a * (cx - bx) + b * (ax - cx) + c * (bx - ax)) / d;
    x + (x - ax).hypot(y - ay)
}

#[test]
fn all_doubles_are_ordered() {
    let mut state = 7;
    for round in 0..60 {
        let spread = [4, 60, 400, 2000][round % 4];
        let coordinate = |state: &mut u64| {
            let exponent =
                i32::try_from(dice(state, spread)).unwrap() - i32::try_from(spread / 2).unwrap();
            (dice(state, 15) - 7) as f64 * 2f64.powi(exponent)
        };
        let points: [[f64; 2]; 4] =
            std::array::from_fn(|_| std::array::from_fn(|_| coordinate(&mut state)));
        compare_all(&points);
    }
    let tiny = f64::from_bits(1);
    compare_all(&[[0.0, 0.0], [tiny, 0.0], [0.0, f64::MAX], [f64::MAX, -f64::MAX], [tiny, tiny]]);
}
