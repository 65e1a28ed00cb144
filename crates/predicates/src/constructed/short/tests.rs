//! Fixed widths against numbers of any length, by the bits of coordinates.

use crate::formula::{Call, Lifted, Orient, exactly};
use crate::{Construction, Metric};

use super::*;

/// Numbers below `count`.
fn below(seed: &mut u64, count: usize) -> usize {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    usize::try_from(*seed >> 33).expect("31 bits") % count
}

/// A coordinate of so many bits, the last 53 or any in a row.
fn coordinate(seed: &mut u64, bits: u32) -> f64 {
    if bits > 53 {
        let shift = below(seed, usize::try_from(bits).expect("few") - 52);
        return coordinate(seed, 53) * 2f64.powi(i32::try_from(shift).expect("few"));
    }
    let mut value = 0.0;
    for bit in 0..bits {
        value += f64::from(u8::from(below(seed, 2) == 1)) * 2f64.powi(bit.cast_signed());
    }
    if below(seed, 2) == 0 { value } else { -value }
}

/// Some construction from the first nine points.
fn construction<const D: usize>(seed: &mut u64) -> Construction {
    let mut id = || u32::try_from(below(seed, 9)).expect("few points");
    let (a, b, c, d) = (id(), id(), id(), id());
    let plane = [id(), id(), id()];
    match (D, below(seed, 4)) {
        (2, 1..) => Construction::Crossing { a, b, c, d },
        (3, 1 | 2) => Construction::LinePlane { a, b, plane },
        (3, 3) => Construction::ThreePlanes { planes: [plane, [a, b, c], [d, b, plane[0]]] },
        _ => Construction::SegmentPoint { a, b, t: (1.0 / 3.0).into() },
    }
}

/// Nine plain points and as many constructed ones.
fn world<const D: usize>(seed: &mut u64, bits: u32, unit: f64) -> Constructed<D> {
    let point = |_| [0; D].map(|_| coordinate(seed, bits) * unit);
    let mut kernel = Constructed::<D>::new((0..9).map(point).collect());
    for _ in 0..9 {
        // Refused if it makes no point: any other one will do.
        let _ = kernel.push(&construction::<D>(seed));
    }
    kernel
}

/// The same in a plane of space that slants.
fn flat(seed: &mut u64, bits: u32) -> Constructed<3> {
    let point = |_| {
        let [x, y] = [0; 2].map(|_| coordinate(seed, bits));
        [x, y, x + 2.0 * y]
    };
    let mut kernel = Constructed::new((0..9).map(point).collect());
    for a in 0..9 {
        let third = Construction::SegmentPoint { a, b: (a + 4) % 9, t: (1.0 / 3.0).into() };
        kernel.push(&third).expect("a point of any segment");
    }
    kernel
}

/// Of calls on some axes: those decided, and the zeros among them.
fn decided<const D: usize>(
    bits: u32,
    axes: &[usize],
    world: impl Fn(&mut u64) -> Constructed<D>,
) -> [usize; 2] {
    let mut seed = u64::from(bits) + 1;
    let mut counts = [0; 2];
    let mut compare = |short: Option<Sign>, exact: &dyn Fn() -> Sign| {
        if let Some(sign) = short {
            assert_eq!(sign, exact(), "{bits} bits, on {axes:?}");
            counts[0] += 1;
            counts[1] += usize::from(sign == Sign::Zero);
        }
    };
    for round in 0..100 {
        let kernel = world(&mut seed);
        let plain = round % 3 * 4; // one in three mostly on plain points, one in three mostly on others
        let mut any = |count: usize| -> Vec<usize> {
            (0..count)
                .map(|_| (below(&mut seed, 14) + plain) % 18)
                .map(|v| v.min(kernel.len() - 1))
                .collect()
        };
        let call = |vertices: &[usize]| Call {
            points: vertices.iter().map(|&v| kernel.exact_point(v)).collect(),
            squares: SmallVec::new(),
        };
        let vertices = any(axes.len() + 1);
        let short = Short::new(&kernel, vertices.iter().copied()).orient(axes);
        compare(short, &|| exactly(&Orient(axes), &call(&vertices)));
        let vertices = any(axes.len() + 2);
        let short = Short::new(&kernel, vertices.iter().copied()).lifted(axes);
        compare(short, &|| exactly(&Lifted(axes), &call(&vertices)));
    }
    counts
}

#[test]
fn fixed_widths_answer_as_numbers_of_any_length() {
    for bits in [1, 2, 3, 10, 26, 40, 53] {
        for unit in [1.0, 2f64.powi(-1000)] {
            let plane = decided::<2>(bits, &[0, 1], |seed| world(seed, bits, unit));
            let space = decided::<3>(bits, &[0, 1, 2], |seed| world(seed, bits, unit));
            // All but lifted determinants of many constructed points.
            assert!(plane[0] > 100 && space[0] > 100, "{plane:?} {space:?}");
            assert!(bits > 3 || plane[1] > 20 && space[1] > 20, "{plane:?} {space:?} zeros");
        }
        let bits = bits.min(50);
        for axes in [[0, 1], [2, 0]] {
            assert!(decided::<3>(bits, &axes, |seed| flat(seed, bits))[0] > 150, "{bits} bits");
        }
    }
}

#[test]
fn fixed_widths_know_what_is_too_wide() {
    // Coordinates of up to 512 bits: the widths run through all limits, and most calls are left to others.
    let mut counts = Vec::new();
    for bits in (54..512).step_by(13) {
        let [plane, _] = decided::<2>(bits, &[0, 1], |seed| world(seed, bits, 1.0));
        let [space, _] = decided::<3>(bits, &[0, 1, 2], |seed| world(seed, bits, 1.0));
        counts.push(plane + space);
    }
    assert!(counts[0] > 200 && counts[counts.len() - 1] < counts[0] / 2, "{counts:?}");
}

/// Points on segments are whole: none of a call needs to be plain.
#[test]
fn calls_on_points_of_segments_alone_are_decided() {
    let mut seed = 7;
    for round in 0..200 {
        let bits = [3, 26, 53][round % 3];
        let point = |_| [0; 2].map(|_| coordinate(&mut seed, bits));
        let mut kernel = Constructed::new((0..9).map(point).collect::<Vec<_>>());
        let on: Vec<usize> = (0..4)
            .map(|a| {
                let t = coordinate(&mut seed, 20) / 3e6;
                kernel.push_between([a, 8 - a], t).expect("a point of any segment") as usize
            })
            .collect();
        let call = |vertices: &[usize]| Call {
            points: vertices.iter().map(|&v| kernel.exact_point(v)).collect(),
            squares: SmallVec::new(),
        };
        let axes = [0, 1];
        let orient = Short::new(&kernel, on[..3].iter().copied()).orient(&axes);
        assert_eq!(orient, Some(exactly(&Orient(&axes), &call(&on[..3]))));
        let lifted = Short::new(&kernel, on.iter().copied()).lifted(&axes);
        assert_eq!(lifted, Some(exactly(&Lifted(&axes), &call(&on))));
    }
}
