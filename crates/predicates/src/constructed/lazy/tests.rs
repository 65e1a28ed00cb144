use super::*;
use crate::dyadic::nearest_ratio;

/// Against long numbers.
fn check(a: f64, b: f64, t: f64) -> bool {
    let exact = (Dyadic::from(b) - Dyadic::from(a)) * Dyadic::from(t) + Dyadic::from(a);
    let Some((position, is_exact)) = nearest(a, b, t) else { return false };
    assert_eq!(position.to_bits() << 1, (nearest_ratio(&exact, &Dyadic::from(1))).to_bits() << 1);
    assert_eq!(is_exact, Dyadic::from(position) == exact, "{a} {b} {t}");
    true
}

/// Sums of few bits far apart: ties between doubles, powers of two, sums that cancel.
#[test]
fn nearest_doubles_are_those_of_long_numbers() {
    let short = [1.0, 3.0, 5.0, 0.75, 1.0 + f64::EPSILON, 2.0 - f64::EPSILON, 1.0 / 3.0];
    let mut certain = 0;
    for a in short {
        for b in short {
            for far in [-60, -53, -52, -27, -1, 0, 1, 26, 52, 53, 54, 80] {
                for t in [0.5, 0.25, 0.75, 1.0 / 3.0, 2.0f64.powi(-40), 1.0 - f64::EPSILON / 2.0] {
                    let far = 2.0f64.powi(far);
                    certain += usize::from(check(a, b * far, t));
                    certain += usize::from(check(a * far, -b, t));
                }
            }
        }
    }
    assert!(certain > 13 * short.len() * short.len() * 12 * 6 / 8, "{certain}");
}

#[test]
fn what_may_underflow_is_left_to_long_numbers() {
    assert!(nearest(0.0, 1e-200, 1e-100).is_none());
    assert!(nearest(1e300, -1e300, 0.5).is_none());
    assert!(check(2.0, 2.0, 0.3) && check(0.0, 0.0, 0.3));
}

#[test]
fn a_value_is_computed_once_asked_for() {
    let (value, position, is_exact) =
        Value::between([[0.0, 1.0], [1.0, 1.0 / 3.0]], 0.1).expect("it is far from any limit");
    assert!(value.exact.get().is_none() && !is_exact);
    let exact = value.get();
    let near = exact.x.each_ref().map(|x| nearest_ratio(x, &exact.w));
    assert_eq!(near, position);
    assert!(value.exact.get().is_some());
}
