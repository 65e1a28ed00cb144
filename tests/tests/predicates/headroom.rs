//! Head-room of the exact integers: determinants about as large as the width `w` of the coordinates allows, for each `w`, so
//! that every tier of the integers is filled to its brim. A tier chosen a few bits too small wraps into a wrong sign.

use delone::predicates::{Exact, Kernel, PlaneKernel};
use delone::workloads::Rng;
use delone_tests::exact::power_of_two;

use crate::oracle;

/// Corners of the box of `w`-bit integers, one coordinate in a few being 1 or -1, on which the lowest bit stands.
fn corners<const D: usize>(n: usize, w: i32, rng: &mut Rng) -> Vec<[f64; D]> {
    let largest = power_of_two(w) - power_of_two((w - 53).max(0));
    let unit = rng.index(n);
    (0..n)
        .map(|i| {
            let size = if i == unit { 1.0 } else { largest };
            std::array::from_fn(|_| if rng.coin() { size } else { -size })
        })
        .collect()
}

fn fill_every_tier<const D: usize>(w_max: i32) {
    let mut rng = Rng::named("headroom", 1);
    let ids: Vec<usize> = (0..=D).collect();
    for w in 2..=w_max {
        for _ in 0..24 {
            let points = corners::<D>(D + 2, w, &mut rng);
            let slices: Vec<&[f64]> = points.iter().map(<[f64; D]>::as_slice).collect();
            let kernel = Exact::new(&points[..]);
            let turn = oracle::orient(&slices[..=D]);
            assert_eq!(kernel.orient(&ids), turn, "{w} bits: {points:?}");
            let side = oracle::lifted(&slices);
            assert_eq!(kernel.lifted(&ids, D + 1), side, "{w} bits: {points:?}");
        }
    }
}

#[test]
fn every_tier_in_the_plane() {
    fill_every_tier::<2>(300);
}

#[test]
fn every_tier_in_space() {
    fill_every_tier::<3>(260);
}

#[test]
fn every_tier_of_cross() {
    let mut rng = Rng::named("headroom", 2);
    for w in 2..=600 {
        for _ in 0..12 {
            let points = corners::<2>(4, w, &mut rng);
            let exact = oracle::cross([points[0], points[1], points[2], points[3]]);
            assert_eq!(Exact::new(&points[..]).cross([0usize, 1, 2, 3]), exact, "{w} bits");
        }
    }
}
