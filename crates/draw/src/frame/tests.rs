use super::Frame;

const TINY: f64 = 5e-324;

/// Corners of boxes at every scale land on the corners of the unit square.
#[test]
fn every_scale_fills_the_unit_square() {
    for size in [TINY, 1e-310, 1e-300, 1e-160, 1.0, 1e160, 1e300, f64::MAX] {
        let frame = Frame::around(&[[-size, size], [size, -size]]);
        assert_eq!(frame.proportions, [1.0, 1.0], "{size:e}");
        assert_eq!(frame.unit([-size, -size]), Some([0.0, 0.0]), "{size:e}");
        assert_eq!(frame.unit([size, 0.0]), Some([1.0, 0.5]), "{size:e}");
    }
}

#[test]
fn axes_of_any_two_scales_are_kept_apart() {
    for (wide, high) in [(f64::MAX, TINY), (1.0, 1e-300), (1e300, 1e-300)] {
        let frame = Frame::around(&[[0.0, 0.0], [wide, high]]);
        assert_eq!(frame.proportions[0], 1.0);
        assert!(frame.proportions[1] < 1e-290 && frame.is_spread(1));
        assert_eq!(frame.unit([wide, high]), Some([1.0, 1.0]));
    }
}

#[test]
fn nothing_and_one_point_and_no_point_at_all() {
    let empty = Frame::<2>::around(&[]);
    assert_eq!((empty.proportions, empty.unit([3.0, 4.0])), ([0.0, 0.0], Some([0.5, 0.5])));
    let one = Frame::around(&[[7.0, f64::MAX, TINY]]);
    assert_eq!((one.proportions, one.unit([7.0, f64::MAX, TINY])), ([0.0; 3], Some([0.5; 3])));
    let odd = Frame::around(&[[f64::NAN, 0.0], [f64::INFINITY, 1.0], [1.0, 1.0], [2.0, 3.0]]);
    assert_eq!(odd.unit([2.0, 3.0]), Some([1.0, 1.0]));
    assert_eq!(odd.unit([f64::NAN, 3.0]), None);
}
