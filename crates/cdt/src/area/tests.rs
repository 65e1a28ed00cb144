use delone_predicates::Constructed;

use super::*;

fn dyadic(numerator: i64, exponent: i64) -> Area {
    Area::dyadic(IBig::from(numerator), exponent)
}

fn ratio(numerator: i64, denominator: u64) -> Area {
    Area::ratio(IBig::from(numerator), UBig::from(denominator))
}

#[test]
fn areas_are_told_in_lowest_terms() {
    let texts = [(0, 7), (0, -7), (12, -2), (12, 3), (-3, -1), (191, -1), (6, -1)];
    let texts = texts.map(|(numerator, exponent)| dyadic(numerator, exponent).to_string());
    assert_eq!(texts, ["0", "0", "3", "96", "-3/2", "191/2", "3"]);
    assert_eq!(ratio(-6, 9).to_string(), "-2/3");
    assert_eq!(ratio(0, 9), Area::default());
    assert_eq!(dyadic(12, -2), dyadic(3, 0));
    let mut sum = dyadic(1, -1);
    sum += &ratio(1, 3);
    assert_eq!(sum.to_string(), "5/6");
    sum += &ratio(-5, 6);
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

/// Division of doubles is rounded to nearest: of integers below 2^53, the quotient is that of the fraction.
#[test]
fn fractions_round_as_division_does() {
    let mut state = 1u64;
    for _ in 0..20_000 {
        state = delone_sites::scatter(state);
        let (p, q) = (state >> (11 + state % 40), (state.rotate_left(23) >> (11 + state % 37)) | 1);
        let signed = i64::try_from(p).unwrap();
        assert_eq!(ratio(signed, q).to_f64(), p as f64 / q as f64, "{p} / {q}");
    }
    for x in [1.0f64, 0.1, 1e300, 5e-324, f64::MAX, 2.2e-308, 1.0 / 3.0] {
        let exact = delone_predicates::Dyadic::from(x);
        let mantissa = i64::try_from(exact.mantissa()[0]).unwrap();
        assert_eq!(dyadic(mantissa, exact.exponent()).to_f64(), x);
    }
}

#[test]
fn areas_hold_over_the_whole_range() {
    for (side, text_is_integer) in [(5e-324, false), (1.0, true), (f64::MAX, true)] {
        let kernel = Constructed::new(vec![[-side, -side], [side, -side], [-side, side]]);
        let area = Areas::new(&kernel).sum(&[[0, 1, 2]]); // twice the square of the side
        let exact = delone_predicates::Dyadic::from(side);
        let mantissa = IBig::from(exact.mantissa()[0]);
        assert_eq!(area, Area::dyadic(&mantissa * &mantissa, 2 * exact.exponent() + 1));
        assert_eq!(!area.to_string().contains('/'), text_is_integer, "{side:e}");
    }
}
