use proptest::prelude::*;

use crate::{Cell, DEPTH_MAX, Frame, FrameFault};

proptest! {
    #[test]
    fn frames_hold_their_points_and_cells_meet_exactly(
        bits in prop::collection::vec(any::<[f64; 2]>(), 1..5), depth in 0u8..20, x in any::<u32>(),
    ) {
        let points: Vec<[f64; 2]> = bits.into_iter().filter(|p| p.iter().all(|c| c.is_finite())).collect();
        let Ok(frame) = Frame::around(&points, depth) else { return Ok(()) };
        let [lower, upper] = frame.corners(Cell::ROOT);
        for point in &points {
            prop_assert!((0..2).all(|axis| lower[axis] <= point[axis] && point[axis] <= upper[axis]));
        }
        // Sides subtract exactly only if the corners are doubles exactly.
        let cell = Cell::new([x & ((1 << depth) - 1), 0], depth).unwrap();
        let ([lower, upper], centre) = (frame.corners(cell), frame.centre(cell));
        for axis in 0..2 {
            prop_assert_eq!(upper[axis] - lower[axis], frame.resolution());
            prop_assert_eq!(centre[axis] - lower[axis], frame.resolution() / 2.0);
        }
    }

    #[test]
    fn moderate_points_have_frames_of_twenty_levels(
        points in prop::collection::vec([-1e3..1e3, 1e-3..1e3, -5.0..5.0], 2..5),
    ) {
        let frame = Frame::<3>::around(&points, 20);
        prop_assert!(frame.is_ok());
        prop_assert_eq!(frame.unwrap().resolution() * f64::from(1 << 20), frame.unwrap().side());
    }
}

#[test]
fn points_without_extent_have_a_frame() {
    let nothing = Frame::<2>::around(&[], 3).unwrap();
    assert_eq!((nothing.corner(), nothing.side(), nothing.resolution()), ([0.0; 2], 1.0, 0.125));
    let one = Frame::around(&[[3.0, -7.0]], 3).unwrap();
    assert_eq!((one.corner(), one.side()), ([3.0, -7.0], 4.0));
    assert_eq!(Frame::around(&[[-1.0], [1.0]], 0).unwrap().corner(), [-1.0]);
}

#[test]
fn a_corner_just_below_a_multiple_goes_down() {
    let frame = Frame::around(&[[-5e-324, 0.0], [1e10, 0.0]], 4).unwrap();
    assert_eq!(frame.corner()[0], -frame.side() / 1024.0);
}

#[test]
fn frames_finer_than_doubles_are_refused() {
    let near = [[1.0, 1.0], [1.0 + f64::EPSILON, 1.0]];
    assert_eq!(Frame::around(&near, 4), Err(FrameFault::TooFine { depth: 4 }));
    assert_eq!(Frame::around(&[[0.0; 2], [5e-324; 2]], 1), Err(FrameFault::TooFine { depth: 1 }));
    let depth = DEPTH_MAX + 1;
    assert_eq!(Frame::around(&[[0.0]], depth), Err(FrameFault::TooFine { depth }));
}

#[test]
fn frames_larger_than_doubles_are_refused() {
    assert_eq!(Frame::around(&[[f64::MAX], [-f64::MAX]], 1), Err(FrameFault::TooLarge));
    assert_eq!(Frame::around(&[[0.0], [f64::NAN]], 1), Err(FrameFault::NotFinite { point: 1 }));
}
