//! Every tier alone, also on input that a narrower one would take: all answer alike.

use super::*;

/// A small deterministic stream.
fn stream(seed: &mut u64, modulus: u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    f64::from(u32::try_from((*seed >> 33) % modulus).expect("small"))
        - f64::from(u32::try_from(modulus / 2).expect("small"))
}

/// Points on a small grid, so that a third of the determinants vanish.
fn points<const D: usize, const N: usize>(seed: &mut u64) -> [[f64; D]; N] {
    std::array::from_fn(|_| std::array::from_fn(|_| stream(seed, 5)))
}

/// A term of no influence on signs that forces a width: the same translation of all points, by a power of two.
fn translated<const D: usize, const N: usize>(points: [[f64; D]; N], by: f64) -> [[f64; D]; N] {
    points.map(|p| p.map(|x| (x + by) * 0.5f64.powi(20)))
}

#[test]
fn all_tiers_agree_in_space() {
    let mut seed = 1;
    let mut zeros = 0;
    for _ in 0..2000 {
        let narrow: [[f64; 3]; 5] = points(&mut seed);
        let [a, b, c, d, e] = &narrow;
        let slices = narrow.each_ref().map(<[f64; 3]>::as_slice);
        let (orientation, stage) = orient3d(a, b, c, d);
        assert_eq!(stage, Stage::MachineWords);
        let (sphere, stage) = in_sphere(a, b, c, d, e);
        assert_eq!(stage, Stage::MachineWords);
        zeros += usize::from(sphere == Sign::Zero);
        assert_eq!(general::orient_in_all_tiers(&slices[..4], &[0, 1, 2]), [orientation; 4]);
        assert_eq!(general::lifted_in_all_tiers(&slices, &[0, 1, 2], None), [sphere; 4]);
        let weights: [f64; 5] = std::array::from_fn(|_| stream(&mut seed, 9) * 0.125);
        let [first, rest @ ..] = general::lifted_in_all_tiers(&slices, &[0, 1, 2], Some(&weights));
        assert_eq!(rest, [first; 3]);
        let far = translated(narrow, 1024.0);
        let [a, b, c, d, e] = &far;
        assert_eq!(orient3d(a, b, c, d).0, orientation);
        assert_eq!(in_sphere(a, b, c, d, e).0, sphere);
    }
    assert!(zeros > 100);
}

#[test]
fn all_tiers_agree_in_the_plane_and_in_flats() {
    let mut seed = 2;
    for _ in 0..2000 {
        let narrow: [[f64; 2]; 4] = points(&mut seed);
        let [a, b, c, d] = &narrow;
        let slices = narrow.each_ref().map(<[f64; 2]>::as_slice);
        let (orientation, circle) = (orient2d(a, b, c).0, in_circle(a, b, c, d).0);
        assert_eq!(general::orient_in_all_tiers(&slices[..3], &[0, 1]), [orientation; 4]);
        assert_eq!(general::lifted_in_all_tiers(&slices, &[0, 1], None), [circle; 4]);
        assert_eq!(long::cross([*c, *a, *c, *b]), orientation);
        assert_eq!(general::cross(&[*c, *a, *c, *b]).0, orientation);
        // On some axes the points must lie in a flat: a translation shears the heights of others.
        let flat = narrow.map(|[x, y]| [x, y, x + 2.0 * y]);
        let slices = flat.each_ref().map(<[f64; 3]>::as_slice);
        for axes in [[0, 1], [0, 2], [1, 2]] {
            let [first, rest @ ..] = general::lifted_in_all_tiers(&slices, &axes, None);
            assert_eq!(rest, [first; 3]);
        }
        let line = narrow.map(|[x, _]| [x, 3.0 - x, 2.0 * x]);
        let slices = line.each_ref().map(<[f64; 3]>::as_slice);
        let [first, rest @ ..] = general::lifted_in_all_tiers(&slices[..3], &[0], None);
        assert_eq!(rest, [first; 3]);
    }
}

#[test]
fn all_tiers_agree_in_five_axes() {
    let mut seed = 3;
    for _ in 0..50 {
        let narrow: [[f64; 5]; 7] = points(&mut seed);
        let slices = narrow.each_ref().map(<[f64; 5]>::as_slice);
        let axes = [0, 1, 2, 3, 4];
        let [first, rest @ ..] = general::orient_in_all_tiers(&slices[..6], &axes);
        assert_eq!(rest, [first; 3]);
        let [first, rest @ ..] = general::lifted_in_all_tiers(&slices, &axes, None);
        assert_eq!(rest, [first; 3]);
    }
}

#[test]
fn the_head_room_holds_at_the_largest_differences() {
    // Differences of 2^61 and -2^61 + 1 at once, in the tier of one limb: the corners of a cube, and next to them.
    let big = 2f64.powi(60);
    for far in [big, -big, big - 256.0, -big + 256.0] {
        for near in [big, -big, big - 256.0] {
            let p = [
                [far, near, far],
                [near, far, near],
                [-far, near, -near],
                [near, -near, far],
                [-near, -far, -far],
            ];
            let [a, b, c, d, e] = &p;
            let slices = p.each_ref().map(<[f64; 3]>::as_slice);
            let [sum, rest @ ..] = general::lifted_in_all_tiers(&slices, &[0, 1, 2], None);
            assert_eq!(rest, [sum; 3]);
            assert_eq!(in_sphere(a, b, c, d, e).0, sum);
            let [sum, rest @ ..] = general::orient_in_all_tiers(&slices[..4], &[0, 1, 2]);
            assert_eq!(rest, [sum; 3]);
            assert_eq!(orient3d(a, b, c, d).0, sum);
        }
    }
}

#[test]
fn the_head_room_of_machine_words_holds_up_to_each_limit() {
    // Odd coordinates, so that no common power of two can be taken out, with differences around every width that is a
    // limit of machine words. An integer that is too narrow overflows, which is a panic here.
    let mut seed = 4;
    for bits in 15..34 {
        let far = 2f64.powi(bits - 1) + 1.0;
        for _ in 0..200 {
            let mut corner = || {
                let side = if stream(&mut seed, 2) < 0.0 { far } else { -far };
                if stream(&mut seed, 2) < 0.0 { side } else { 2.0 - side }
            };
            let p: [[f64; 3]; 5] = std::array::from_fn(|_| std::array::from_fn(|_| corner()));
            let [a, b, c, d, e] = &p;
            let slices = p.each_ref().map(<[f64; 3]>::as_slice);
            let [sum, ..] = general::lifted_in_all_tiers(&slices, &[0, 1, 2], None);
            assert_eq!(in_sphere(a, b, c, d, e).0, sum, "{p:?}");
            let [sum, ..] = general::orient_in_all_tiers(&slices[..4], &[0, 1, 2]);
            assert_eq!(orient3d(a, b, c, d).0, sum, "{p:?}");
            let plane = p.map(|[x, y, _]| [x, y]);
            let [a, b, c, d, _] = &plane;
            let slices = plane.each_ref().map(<[f64; 2]>::as_slice);
            let [sum, ..] = general::lifted_in_all_tiers(&slices[..4], &[0, 1], None);
            assert_eq!(in_circle(a, b, c, d).0, sum, "{plane:?}");
            let [sum, ..] = general::orient_in_all_tiers(&slices[..3], &[0, 1]);
            assert_eq!(orient2d(a, b, c).0, sum, "{plane:?}");
        }
    }
}
