use super::*;

#[test]
fn small_quotients_agree_with_division_of_doubles() {
    for p in -50..50 {
        for q in 1..50 {
            let got = parse_coordinate(&format!("{p}/{q}")).unwrap().value;
            assert_eq!(got, f64::from(p) / f64::from(q), "{p}/{q}");
        }
    }
}

#[test]
fn exact_quotients_say_so() {
    assert_eq!(parse_coordinate("3/4"), Some(Rounded { value: 0.75, inexact: false }));
    assert_eq!(parse_coordinate("-1/3"), Some(Rounded { value: -1.0 / 3.0, inexact: true }));
    assert_eq!(parse_coordinate("9007199254740993/1").map(|r| r.inexact), Some(true));
}

#[test]
fn long_integers_are_rounded_once() {
    let third = parse_coordinate(
        "10000000000000000000000000000000000000/30000000000000000000000000000000000000",
    );
    assert_eq!(third.map(|r| r.value), Some(1.0 / 3.0));
    // 2^53 + 1 over 1 is a tie: to even.
    assert_eq!(
        parse_coordinate("9007199254740993/1").map(|r| r.value),
        Some(9_007_199_254_740_992.0)
    );
}

#[test]
fn nonsense_is_no_number() {
    for bad in ["1/0", "1/", "/2", "1/-2", "a/b", "1.5/2", "", "1/2/3"] {
        assert_eq!(parse_coordinate(bad), None, "{bad}");
    }
}
