use super::*;

fn dyadic(numerator: i64, exponent: i32) -> Area {
    Area::new(IBig::from(numerator), exponent)
}

#[test]
fn dyadics_are_told_in_lowest_terms() {
    let texts = [(0, 7), (12, -2), (12, 3), (-3, -1), (191, -1), (6, -1)];
    let texts = texts.map(|(numerator, exponent)| dyadic(numerator, exponent).to_string());
    assert_eq!(texts, ["0", "3", "96", "-3/2", "191/2", "3"]);
    assert_eq!(dyadic(12, -2), dyadic(3, 0));
    let mut sum = dyadic(1, -1);
    sum += &dyadic(3, -2);
    sum += &dyadic(-5, -2);
    assert_eq!(sum, Area::default());
}

#[test]
fn the_nearest_double_is_nearest() {
    let two_53 = 1i64 << 53;
    assert_eq!(dyadic(two_53 + 1, 0).to_f64(), 9_007_199_254_740_992.0); // a tie, to even
    assert_eq!(dyadic(two_53 + 3, 0).to_f64(), 9_007_199_254_740_996.0);
    assert_eq!(dyadic(-two_53 - 3, 0).to_f64(), -9_007_199_254_740_996.0);
    assert_eq!(dyadic(2 * two_53 + 3, -1).to_f64(), 9_007_199_254_740_994.0); // past the tie
    assert_eq!(dyadic(1, -1074).to_f64(), 5e-324);
    assert_eq!(dyadic(1, -1075).to_f64(), 0.0); // half of the least double: to even
    assert_eq!(dyadic(3, -1076).to_f64(), 5e-324);
    assert_eq!(dyadic(3, -1075).to_f64(), 1e-323); // one and a half: to even
    assert_eq!(dyadic(1, -2149).to_f64(), 0.0);
    assert_eq!(dyadic((1 << 53) - 1, 971).to_f64(), f64::MAX);
    assert_eq!(dyadic((1 << 54) - 1, 970).to_f64(), f64::INFINITY);
    assert_eq!(dyadic(-1, 1024).to_f64(), f64::NEG_INFINITY);
}

/// Every double, times a power of two and back, is itself.
#[test]
fn doubles_pass_through() {
    for x in [1.0, -0.1, 1e300, 5e-324, f64::MAX, 2.2e-308, 1.0 / 3.0] {
        let (mantissa, exponent) = decode(x);
        assert_eq!(dyadic(mantissa, exponent).to_f64(), x);
        assert_eq!(mantissa % 2 != 0, x != 0.0);
    }
}

#[test]
fn areas_hold_over_the_whole_range() {
    for (side, text_is_integer) in [(5e-324, false), (1.0, true), (f64::MAX, true)] {
        let triangle = [[-side, -side], [side, -side], [-side, side]];
        let lattice = Lattice::of(&triangle);
        let area = lattice.area(lattice.twice_area(triangle)); // twice the square of the side
        let (mantissa, exponent) = decode(side);
        let expected = Area::new(IBig::from(mantissa) * IBig::from(mantissa), 2 * exponent + 1);
        assert_eq!(area, expected);
        assert_eq!(!area.to_string().contains('/'), text_is_integer, "{side:e}");
    }
}
