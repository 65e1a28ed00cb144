use std::cmp::Ordering;

use super::*;
use crate::metric::Radii;
use crate::{Constructed, Construction, Metric};

fn coordinate(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    f64::from_bits(1023 << 52 | *seed >> 12) - 1.0
}

fn call<const D: usize>(kernel: &Constructed<D>, ids: &[usize]) -> Call<Dyadic, D> {
    let points = ids.iter().map(|&id| kernel.exact_point(id)).collect();
    Call { points, squares: SmallVec::new() }
}

/// Random points and degenerate questions: what the widths of `narrow.rs` are for.
#[test]
fn ordinary_degenerate_calls_are_decided_in_short_integers() {
    let mut seed = 1;
    for _ in 0..50 {
        let points = (0..6).map(|_| [0; 3].map(|_| coordinate(&mut seed))).collect();
        let mut kernel = Constructed::<3>::new(points);
        let planes = [[0, 1, 2], [0, 3, 4], [1, 2, 4]];
        let sides = [
            Construction::ThreePlanes { planes },
            Construction::LinePlane { a: 3, b: 5, plane: [0, 1, 2] },
            Construction::SegmentPoint { a: 0, b: 1, t: (1.0 / 3.0).into() },
        ];
        for side in &sides {
            let id = kernel.push(side).unwrap() as usize;
            let call = call(&kernel, &[0, 1, 2, id]);
            assert_eq!(in_limbs::<8, 3, _>(&Orient(&[0, 1, 2]), &call), Some(Sign::Zero));
            assert_eq!(in_limbs::<2, 3, _>(&Orient(&[0, 1, 2]), &call), None, "too few");
        }
        let radii = call(&kernel, &[0, 1, 2, 3, 3, 0, 1, 2]);
        assert_eq!(in_limbs::<16, 3, _>(&Radii(4), &radii), Some(Ordering::Equal));
    }
}
