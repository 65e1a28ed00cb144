//! The kernels around and beside the default one.

use std::cmp::Ordering;

use crate::*;

/// The corners of a cube, its centre, and points near its circumsphere.
fn cube() -> Vec<[f64; 3]> {
    let corners = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from));
    corners.chain([[0.5; 3], [1.0f64.next_up(), 1.0, 1.0], [1e-20, 0.0, 0.0]]).collect()
}

/// Calls `visit` with all simplices of three or four of the first `n` ids, and a query that is none of them.
fn for_each_call(n: usize, visit: &mut dyn FnMut(&[usize; 4], usize)) {
    for code in 0..n.pow(5) {
        let [a, b, c, d, q] = [0, 1, 2, 3, 4].map(|digit| code / n.pow(digit) % n);
        if ![a, b, c, d].contains(&q) {
            visit(&[a, b, c, d], q);
        }
    }
}

#[test]
fn all_right_kernels_agree() {
    let space = cube();
    let (adaptive, robust) = (Adaptive::new(&space), RobustCrate::new(&space));
    let checked = Checked::new(adaptive, Exact::new(&space));
    let watched = Checked::new(checked, robust);
    for_each_call(space.len(), &mut |simplex, q| {
        let sign = watched.orient(simplex);
        assert_eq!(sign, Adaptive::dynamic(&space).orient(simplex));
        assert_eq!(sign, adaptive.orient_on(&[0, 1, 2], simplex));
        let lifted = watched.lifted(simplex, q);
        assert_eq!(lifted, Adaptive::dynamic(&space).lifted(simplex, q));
        assert_eq!(lifted, robust.lifted_on(&[0, 1, 2], simplex, q));
        let [a, b, c, _] = *simplex;
        assert_eq!(robust.orient_on(&[0, 2], &[a, b, c]), adaptive.orient_on(&[0, 2], &[a, b, c]));
    });
    let plane: Vec<[f64; 2]> = space.iter().map(|&[x, y, _]| [x, y]).collect();
    let kernel = Checked::new(
        Checked::new(Adaptive::new(&plane), Exact::new(&plane)),
        RobustCrate::new(&plane),
    );
    for_each_call(plane.len(), &mut |&[a, b, c, d], q| {
        let _ =
            (kernel.orient(&[a, b, c]), kernel.lifted(&[a, b, c], q), kernel.cross([a, b, c, d]));
        let _ = kernel.compare_lexicographic(a, b);
    });
}

#[test]
#[should_panic(expected = "orient of [0, 1, 2] is Zero, and should be Negative")]
fn a_wrong_sign_is_named() {
    let points = [[0.50000000000001, 0.500000000000008], [12.0, 12.0], [24.0, 24.0]];
    let _ = Checked::new(Naive::new(points), Exact::new(points)).orient(&[0usize, 1, 2]);
}

#[test]
fn naive_answers_do_not_panic_and_are_right_on_small_integers() {
    let space = cube();
    let (naive, exact) = (Naive::new(&space[..8]), Exact::new(&space[..8]));
    for_each_call(8, &mut |simplex, q| {
        assert_eq!(naive.orient(simplex), exact.orient(simplex));
        assert_eq!(naive.lifted(simplex, q), exact.lifted(simplex, q));
        assert_eq!(naive.orient_on(&[0, 1, 2], simplex), exact.orient(simplex));
        assert_eq!(naive.lifted_on(&[0, 1, 2], simplex, q), exact.lifted(simplex, q));
        let triangle = &simplex[..3];
        assert_eq!(naive.orient_on(&[0, 2], triangle), exact.orient_on(&[0, 2], triangle));
        assert_eq!(naive.lifted_on(&[1, 2], triangle, q), exact.lifted_on(&[1, 2], triangle, q));
    });
    let huge = Naive::new([[3e160, 1e160], [1e160, 3e160], [0.0, 0.0], [-3e300, -1e300]]);
    assert_eq!(huge.orient(&[0usize, 1, 2]), Sign::Zero, "what is not a number counts as zero");
    let _ = (huge.cross([0usize, 1, 2, 3]), huge.in_sphere(&[0usize, 1, 2], 3));
}

#[test]
fn stages_are_counted() {
    let tally = Tally::default();
    let points = [
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [1.0, 1.0],
        [1e-9, 1e-9],
        [1.0, 1e-300],
        [0.1, 0.3],
        [3e-300, 1e-300],
        [1e-300, 2e-300],
    ];
    let kernel = Counting::new(Adaptive::new(points), &tally);
    let orientations = [
        ([0usize, 1, 2], Stage::StaticFilter),
        ([0, 1, 5], Stage::DynamicFilter),
        ([0, 3, 4], Stage::Distilled),
        ([8, 7, 3], Stage::LeadingTerms),
        ([1, 3, 5], Stage::LongSum),
    ];
    for (simplex, stage) in orientations {
        assert_eq!(kernel.orient_staged(&simplex).1, stage, "{simplex:?}");
    }
    assert_eq!(tally.asked(Question::Orient), 5);
    assert_eq!(kernel.lifted_staged(&[0usize, 1, 2], 3), (Sign::Zero, Stage::MachineWords));
    let reordered = kernel.reordered(&[3, 2, 1, 0]);
    assert!(!reordered.in_sphere(&[0usize, 1, 2], 3).is_inside() || tally.perturbed() == 1);
    assert_eq!(tally.perturbed(), 1);
    assert_eq!(tally.asked(Question::Lifted), 2);
    let _ = (kernel.cross([0usize, 1, 2, 3]), kernel.orient_on(&[0], &[0usize, 1]));
    let sum = Tally::default();
    sum.merge(&tally);
    sum.merge(&tally);
    assert_eq!(sum.asked(Question::Cross), 2);
    assert_eq!(sum.asked(Question::OnAxes), 2);
    assert_eq!(sum.perturbed(), 2);
}

#[test]
fn static_bounds_are_off_where_they_would_overflow() {
    let points = [[-f64::MAX, 0.0], [f64::MAX, 0.0], [0.0, 5e-324], [0.0, 0.0]];
    let kernel = Adaptive::new(points);
    assert_eq!(kernel.orient_staged(&[0usize, 1, 2]), (Sign::Positive, Stage::DynamicFilter));
    assert_eq!(kernel.orient_staged(&[0usize, 3, 1]), (Sign::Zero, Stage::OneLimb));
    let single = Adaptive::new([[1.0, 2.0]]);
    assert_eq!(single.compare(0, 0usize, 0), Ordering::Equal);
    let none = Adaptive::new(Vec::<[f64; 3]>::new());
    let _ = none.reordered(&[]);
}

/// Power tests of a grid with small weights against real, tiny heights, by an integer determinant.
#[test]
fn power_ties_equal_explicit_infinitesimals() {
    let grid: Vec<[f64; 2]> = (0..9).map(|i| [f64::from(i / 3), f64::from(i % 3)]).collect();
    let weights = [0.0, 1.0, 0.0, 0.0, 2.0, -1.0, 1.0, 0.0, -3.0];
    let kernel = Weighted::new(&grid, weights);
    let height = |i: usize| {
        let [x, y] = grid[i].map(|x| x as i128);
        ((x * x + y * y - weights[i] as i128) << 100) + (1i128 << (10 * i))
    };
    let row = |i: usize, q: usize| {
        [
            (grid[i][0] - grid[q][0]) as i128,
            (grid[i][1] - grid[q][1]) as i128,
            height(i) - height(q),
        ]
    };
    let mut ties = 0;
    for_each_call(9, &mut |&[a, b, c, _], q| {
        if kernel.orient(&[a, b, c]) != Sign::Positive {
            return;
        }
        let [u, v, w] = [row(a, q), row(b, q), row(c, q)];
        let det = u[2] * (v[0] * w[1] - v[1] * w[0]) - v[2] * (u[0] * w[1] - u[1] * w[0])
            + w[2] * (u[0] * v[1] - u[1] * v[0]);
        ties += usize::from(kernel.lifted(&[a, b, c], q) == Sign::Zero);
        assert_eq!(kernel.in_sphere(&[a, b, c], q).is_inside(), det > 0, "{a} {b} {c} {q}");
    });
    assert!(ties > 100, "{ties}");
}

#[test]
fn equal_weights_change_nothing() {
    let space = cube();
    let plain = Adaptive::new(&space);
    for weight in [0.0, -3.5, 1e300, 5e-324] {
        let kernel = Weighted::new(&space, vec![weight; space.len()]);
        for_each_call(space.len(), &mut |simplex, q| {
            if simplex[0] < simplex[1] && simplex[1] < simplex[2] {
                assert_eq!(kernel.lifted(simplex, q), plain.lifted(simplex, q));
                assert_eq!(
                    kernel.compare_lexicographic(simplex[3], q),
                    plain.compare_lexicographic(simplex[3], q)
                );
                let four = [simplex[0], simplex[1], simplex[2], q];
                if plain.orient(&four) == Sign::Zero {
                    let lifted = plain.lifted_on(&[0, 1], &simplex[..3], q);
                    assert_eq!(kernel.lifted_on(&[0, 1], &simplex[..3], q), lifted);
                }
            }
        });
    }
}

#[test]
fn equal_positions_are_ranked_by_weight() {
    let kernel = Weighted::new([[1.0, 1.0], [1.0, 1.0], [0.0, 2.0]], vec![1.0, 2.0, 9.0]);
    assert_eq!(kernel.compare_lexicographic(0usize, 1), Ordering::Less);
    assert_eq!(kernel.compare_lexicographic(0usize, 2), Ordering::Greater);
    let reordered = kernel.reordered(&[1, 0, 2]);
    assert_eq!(reordered.compare_lexicographic(0usize, 1), Ordering::Greater);
}

#[test]
#[should_panic(expected = "2 sites have 1 weights")]
fn weights_must_be_as_many_as_sites() {
    let _ = Weighted::new([[0.0], [1.0]], [1.0]);
}
