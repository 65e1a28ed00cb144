use super::*;

#[test]
fn marks_blank_lines_comments_and_line_ends_do_not_matter() {
    let text = decode(b"\xEF\xBB\xBF1 2\r\n\r\n# no\n 3,4;5 # tail\n");
    let fields: Vec<(usize, Vec<&str>)> =
        lines(&text, Some('#')).map(|line| (line.number, line.fields().collect())).collect();
    assert_eq!(fields, [(1, vec!["1", "2"]), (4, vec!["3", "4", "5"])]);
}

#[test]
fn numbers_are_the_nearest_doubles() {
    assert_eq!(parse_number("0.1"), Some(0.1));
    assert_eq!(parse_number("-0").map(f64::to_bits), Some((-0.0_f64).to_bits()));
    assert_eq!(parse_number("5e-324"), Some(f64::from_bits(1)));
    assert_eq!(parse_number("1.5D+3"), Some(1500.0));
    assert_eq!(parse_number("-.5d0"), Some(-0.5));
    assert!(parse_number("nan").is_some_and(f64::is_nan));
    for bad in ["", "x", "1,2", "0x10", "d", "D5", "1D", "1e", "--1"] {
        assert_eq!(parse_number(bad), None, "{bad}");
    }
}

#[test]
fn indices_are_checked_against_first_and_count() {
    assert_eq!(index("1", 7, 1, 3).unwrap(), 0);
    assert_eq!(index("3", 7, 1, 3).unwrap(), 2);
    for bad in ["0", "4", "-1", "99999999999999999999"] {
        assert!(matches!(index(bad, 7, 1, 3), Err(ReadError::IndexOutOfRange { .. })), "{bad}");
    }
    assert!(matches!(index("1.5", 7, 1, 3), Err(ReadError::Malformed { .. })));
}
