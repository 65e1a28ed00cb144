//! Point sets on small lattices, where doubles are exact, and at their limits; and determinants on some axes of space.

use crate::*;

/// Numbers below `count`, the same ones each time.
fn random(state: &mut u64, count: u32) -> u32 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    u32::try_from(((*state >> 33) * u64::from(count)) >> 31).unwrap()
}

/// Points of the lattice `0 ..= top` times `unit`, corners among them.
fn lattice<const D: usize>(top: u32, unit: f64) -> Vec<[f64; D]> {
    let (mut state, mut points) = (u64::from(top), vec![[0.0; D], [f64::from(top) * unit; D]]);
    for i in 0..14 {
        // Coarse ones, so that there are many ties, and any.
        let step = if i % 2 == 0 { top.div_ceil(2) } else { 1 };
        let mut coordinate = || f64::from(random(&mut state, top / step + 1) * step) * unit;
        points.push(std::array::from_fn(|_| coordinate()));
    }
    points
}

/// The stages that answered; all signs being those of the exact kernel.
fn stages<const D: usize>(points: &[[f64; D]]) -> [Vec<Stage>; 2] {
    let (kernel, exact) = (Adaptive::new(points), Exact::new(points));
    let (mut state, mut stages) = (7, [Vec::new(), Vec::new()]);
    let count = u32::try_from(points.len()).unwrap();
    for _ in 0..2000 {
        let simplex: Vec<usize> = (0..=D).map(|_| random(&mut state, count) as usize).collect();
        let q = random(&mut state, count) as usize;
        let (sign, stage) = kernel.orient_staged(&simplex);
        assert_eq!(sign, exact.orient(&simplex));
        stages[0].push(stage);
        let (sign, stage) = kernel.lifted_staged(&simplex, q);
        assert_eq!(sign, exact.lifted(&simplex, q));
        stages[1].push(stage);
    }
    stages
}

fn all_static(stages: &[Stage]) -> bool {
    stages.iter().all(|&stage| stage == Stage::StaticFilter)
}

/// The height of a point.
type Lift = fn([f64; 2]) -> f64;

#[test]
fn small_lattices_are_decided_in_doubles() {
    // 12 * 5234^4 < 2^53 < 12 * 5235^4, and 72 * 659^5 < 2^53 < 72 * 660^5.
    for unit in [1.0, 2f64.powi(-200), 2f64.powi(180), 2f64.powi(-30)] {
        assert!(stages(&lattice::<2>(5234, unit)).iter().all(|stages| all_static(stages)));
        assert!(stages(&lattice::<3>(659, unit)).iter().all(|stages| all_static(stages)));
    }
}

#[test]
fn lattices_over_the_limits_are_not() {
    for unit in [1.0, 2f64.powi(-201), 2f64.powi(181), 2f64.powi(-1000), 2f64.powi(1000)] {
        assert!(!all_static(&stages(&lattice::<2>(5235, unit))[1]), "{unit:e}");
        assert!(!all_static(&stages(&lattice::<3>(660, unit))[1]), "{unit:e}");
    }
    let mut off = lattice::<3>(4, 1.0);
    off.push([0.1, 0.0, 0.0]);
    assert!(!all_static(&stages(&off)[0]));
}

/// Points of the plane whose exponents vary by `spread`, and neighbours of some.
fn scattered(spread: u32) -> Vec<[f64; 2]> {
    let mut state = u64::from(spread);
    let mut coordinate = || {
        let exponent = f64::from(random(&mut state, spread)) - f64::from(spread / 2);
        (f64::from(random(&mut state, 1000)) / 7.0 - 70.0) * exponent.exp2()
    };
    let points: Vec<_> = (0..8).map(|_| [coordinate(), coordinate()]).collect();
    points.iter().flat_map(|&[x, y]| [[x, y], [x.next_up(), y]]).collect()
}

#[test]
fn determinants_on_two_axes_of_a_plane_in_space_are_exact() {
    let circle = [[5.0, 0.0], [0.0, 5.0], [-3.0, 4.0], [4.0, -3.0], [3.0, -4.0]];
    let near = circle.iter().flat_map(|&[x, y]: &[f64; 2]| [[x, y], [x.next_up(), y]]);
    let mut sets = vec![near.collect(), lattice::<2>(2, 1.0), lattice(1 << 20, 2f64.powi(-60))];
    sets.extend([lattice(3, 1e300), scattered(2), scattered(40), scattered(900)]);
    let mut ties = 0;
    for plane in sets {
        // z = 2x, z = 0, z = -y: on these axes the plane is not seen edge-on.
        let lifts: [(Lift, &[[usize; 2]]); 3] = [
            (|[x, _]| 2.0 * x, &[[0, 1], [1, 2], [2, 1]]),
            (|_| 0.0, &[[0, 1], [1, 0]]),
            (|[_, y]| -y, &[[0, 1], [0, 2], [2, 0]]),
        ];
        for (lift, pairs) in lifts {
            let points: Vec<_> = plane.iter().map(|&[x, y]| [x, y, lift([x, y])]).collect();
            let (kernel, exact) = (Adaptive::new(&points), Exact::new(&points));
            let (mut state, count) = (3, u32::try_from(points.len()).unwrap());
            for _ in 0..500 {
                let [a, b, c, q] = [0; 4].map(|_| random(&mut state, count) as usize);
                for axes in pairs {
                    let sign = kernel.orient_on(axes, &[a, b, c]);
                    assert_eq!(sign, exact.orient_on(axes, &[a, b, c]));
                    let lifted = kernel.lifted_on(axes, &[a, b, c], q);
                    assert_eq!(lifted, exact.lifted_on(axes, &[a, b, c], q));
                    ties += u32::from(sign != Sign::Zero && lifted == Sign::Zero);
                }
                assert_eq!(kernel.orient_on(&[1], &[a, b]), exact.orient_on(&[1], &[a, b]));
            }
        }
    }
    assert!(ties > 500, "{ties} ties");
}
