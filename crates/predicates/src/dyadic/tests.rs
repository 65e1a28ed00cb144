use super::nearest::nearest_ratio;
use super::*;

#[test]
fn sums_and_products_are_those_of_integers() {
    let values: Vec<i64> =
        vec![0, 1, -1, 2, 3, -7, 1 << 40, -(1 << 62), i64::MAX, i64::MIN, 12_345_678_901];
    for &a in &values {
        for &b in &values {
            let (x, y) = (Dyadic::from(a), Dyadic::from(b));
            let (wide_a, wide_b) = (i128::from(a), i128::from(b));
            assert_eq!(x.clone() + &y, Dyadic::short(wide_a + wide_b, 0), "{a} + {b}");
            assert_eq!(x.clone() - &y, Dyadic::short(wide_a - wide_b, 0), "{a} - {b}");
            assert_eq!(x.clone() * &y, Dyadic::short(wide_a * wide_b, 0), "{a} * {b}");
            assert_eq!(x.cmp(&y), a.cmp(&b));
        }
    }
}

#[test]
fn terms_far_apart_are_both_kept() {
    let (tiny, huge) = (Dyadic::from(5e-324), Dyadic::from(f64::MAX));
    let sum = huge.clone() + &tiny;
    assert_eq!(sum.mantissa().len(), 33, "2,098 bits");
    assert_eq!(sum.clone() - &huge, tiny);
    assert!(sum > huge && sum.clone() - &tiny == huge);
    assert_eq!((sum.clone() - &sum).sign(), Sign::Zero);
    let square = &sum * &sum;
    assert_eq!(square, &huge * &huge + &tiny * &tiny + ((&huge * &tiny) * Dyadic::from(2)));
    assert_eq!(-Dyadic::ZERO, Dyadic::ZERO);
    assert_eq!(Dyadic::from(-0.0), Dyadic::ZERO);
}

#[test]
fn doubles_come_back() {
    for x in [0.0, 1.0, -0.1, 5e-324, -f64::MAX, f64::MIN_POSITIVE, f64::MIN_POSITIVE.next_down()] {
        assert_eq!(Dyadic::from(x).to_f64(), x);
    }
}

#[test]
fn halves_round_to_even_and_all_above_to_the_next() {
    let above = |x: f64, least: f64| Dyadic::from(x) + Dyadic::from(least);
    for (x, half) in [(1.0, f64::EPSILON / 2.0), (1f64.next_up(), f64::EPSILON / 2.0)] {
        let even = if x == 1.0 { x } else { x.next_up() };
        assert_eq!(above(x, half).to_f64(), even);
        assert_eq!((above(x, half) + Dyadic::from(5e-324)).to_f64(), x.next_up());
        assert_eq!((above(x, half) - Dyadic::from(5e-324)).to_f64(), x);
    }
    let half = Dyadic::from(5e-324).half();
    assert_eq!(half.to_f64(), 0.0);
    assert_eq!((half.clone() + half.clone().half()).to_f64(), 5e-324);
    assert_eq!((Dyadic::from(5e-324) + &half).to_f64(), 1e-323, "to even");
    let ulp = f64::MAX - f64::MAX.next_down();
    assert_eq!(above(f64::MAX, ulp / 4.0).to_f64(), f64::MAX);
    assert_eq!(above(f64::MAX, ulp / 2.0).to_f64(), f64::INFINITY);
    assert_eq!((-above(f64::MAX, ulp)).to_f64(), f64::NEG_INFINITY);
}

/// Against division in doubles, which is rounded to nearest.
#[test]
fn quotients_are_those_of_doubles() {
    let values =
        [1.0, 3.0, 7.0, 0.1, 1e300, 5e-324, 1e-310, f64::MAX, 123_456_789.0, 2f64.powi(-600)];
    for a in values {
        for b in values {
            assert_eq!(nearest_ratio(&a.into(), &b.into()), a / b, "{a:e} / {b:e}");
            assert_eq!(nearest_ratio(&(-a).into(), &b.into()), -a / b, "-{a:e} / {b:e}");
        }
    }
}

#[test]
fn powers_of_two_move_the_exponent() {
    for x in [1.0, -0.75, 5e-324, f64::MAX, 0.1] {
        let number = Dyadic::from(x);
        assert_eq!(number.clone().scaled(7).scaled(-8), number.clone().half());
        let top = number.magnitude().unwrap();
        let one = Dyadic::from(1);
        let size = if x < 0.0 { -number } else { number };
        assert!(one.clone().scaled(top) <= size && size < one.scaled(top + 1), "{x}");
    }
    assert_eq!(Dyadic::ZERO.scaled(9), Dyadic::ZERO);
    assert_eq!(Dyadic::ZERO.magnitude(), None);
}

/// By long division of three times as much by three.
#[test]
fn a_power_of_two_below_needs_no_division() {
    let three = Dyadic::from(3);
    let mut number = Dyadic::from(0.1);
    let mut lengths = std::collections::BTreeSet::new();
    for step in 0..300 {
        for shift in [0, -1100, -1074, 900] {
            let x = number.clone().scaled(shift);
            let halves = Dyadic::from(1).scaled(step - 150);
            let (direct, divided) =
                (nearest_ratio(&x, &halves), nearest_ratio(&(&x * &three), &(&halves * &three)));
            assert_eq!(direct.to_bits(), divided.to_bits(), "{x:?}");
        }
        lengths.insert(number.mantissa().len());
        let factor = Dyadic::from(if step % 7 == 6 { 1e-3 } else { 3.0 });
        number = -(&number * &factor) + Dyadic::from(step).scaled(-60);
        if step % 50 == 49 {
            number = Dyadic::from(1.0 / (f64::from(u32::try_from(step).unwrap()) + 1.0));
        }
    }
    assert!(lengths.len() > 3, "{lengths:?}");
}
