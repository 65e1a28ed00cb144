use super::*;

#[test]
fn names_are_unique_and_lead_back() {
    for (format, name) in Format::NAMES {
        assert_eq!(Format::from_name(name), Some(format));
        assert_eq!(format.to_string(), name);
    }
}

#[test]
fn endings_decide_in_any_case_and_under_compression() {
    assert_eq!(Format::from_path("a/B.NODE"), Some(Format::Node));
    assert_eq!(Format::from_path("a.lar.json"), Some(Format::Lar));
    assert_eq!(Format::from_path("a.off.xz"), Some(Format::Off));
    assert_eq!(Format::from_path("a.json"), None);
    assert_eq!(Format::from_path("node"), None);
}

#[test]
fn content_decides_where_endings_do_not() {
    let cases = [
        ("a.txt", "0 0\n1 1\n", Format::Xyz),
        ("a.dat", "0 0\n1 1\n", Format::P2t),
        ("a.txt", "1 0\n1 1\n", Format::VertexEdge),
        ("a.txt", "2\n0 0 1 1\n1 1 2 2\n", Format::SegmentList),
        ("a.txt", "1\n0 0 0\n", Format::Xyz),
        ("a.cin", "3 4\n", Format::Xyz),
        ("-", "OFF\n0 0 0\n", Format::Off),
        ("-", "v 0 0 0\n", Format::Obj),
        ("-", "x,y\n0,0\n", Format::Csv),
        ("-", "<svg/>", Format::Svg),
        ("a.poly", "3\n0 0\n1 0\n0 1\n", Format::RingList),
        ("a.poly", "0 2 0 0\n", Format::Poly),
    ];
    for (name, text, format) in cases {
        assert_eq!(Format::detect(name, text.as_bytes()), Some(format), "{name}: {text}");
    }
    assert_eq!(Format::detect("-", b""), None);
    assert_eq!(Format::detect("-", b"hello"), None);
}

#[test]
fn nodes_and_graphs_are_known_without_a_name() {
    let node = b"2 2 0 0\n0 0 1\n1 1 1\n";
    assert_eq!(Format::detect("-", node), Some(Format::Node));
    let poly = b"2 2 0 1\n1 0 1 0\n2 1 1 0\n1 0\n1 1 2\n0\n";
    assert_eq!(Format::detect("-", poly), Some(Format::Poly));
    assert_eq!(Format::detect("-", b"1 3 0 0\n1 0 0 0\n"), Some(Format::Node));
    // Four coordinates in a row are not a header.
    assert_eq!(Format::detect("-", b"2 2 0 0\n5 5 1 1\n"), Some(Format::Xyz));
}
