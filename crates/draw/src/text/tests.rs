use super::{Escaped, Short, grouped};

#[test]
fn escapes_markup_quotes_and_forbidden_characters() {
    let text = Escaped("<a href=\"x\">'&'</a>\u{0}\u{1b}\u{fffe}\n\u{e9}").to_string();
    assert_eq!(
        text,
        "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;\u{fffd}\u{fffd}\u{fffd}\n\u{e9}"
    );
}

#[test]
fn short_numbers_are_short_and_always_numbers() {
    let cases =
        [(1.0, "1"), (0.0, "0"), (-0.0, "0"), (-0.001, "0"), (1.256, "1.26"), (-12.5, "-12.5")];
    for (x, text) in cases {
        assert_eq!(Short(x).to_string(), text);
    }
    assert_eq!(Short(f64::NAN).to_string(), "0");
    assert_eq!(Short(f64::INFINITY).to_string(), "0");
    assert_eq!(Short(100.0).to_string(), "100");
}

#[test]
fn digits_are_grouped_by_three() {
    let cases = ["", "1", "123", "1\u{202f}234", "12\u{202f}345\u{202f}678"];
    for text in cases {
        assert_eq!(grouped(&text.replace('\u{202f}', "")), text);
    }
}
