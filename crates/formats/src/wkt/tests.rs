use crate::format::Format;
use crate::testing::{all, read_as, read_named, refusal, written};

#[test]
fn every_kind_of_geometry() {
    let cases = [
        ("POINT (1 2)", 1, 0),
        ("point empty", 0, 0),
        ("LINESTRING(0 0,1 0,1 1)", 3, 2),
        ("LINEARRING(0 0,1 0,1 1)", 3, 3),
        ("POLYGON((0 0,9 0,0 9,0 0),(1 1,2 1,1 2))", 6, 6),
        ("TRIANGLE((0 0,9 0,0 9,0 0))", 3, 3),
        ("MULTIPOINT((1 2),(3 4))", 2, 0),
        ("MULTIPOINT(1 2,3 4, EMPTY)", 2, 0),
        ("MULTILINESTRING((0 0,1 0),EMPTY,(5 5,6 5))", 4, 2),
        ("MULTIPOLYGON(((0 0,9 0,0 9)),((20 0,21 0,20 1)))", 6, 6),
        ("TIN Z (((0 0 1,9 0 1,0 9 1,0 0 1)))", 3, 3),
        ("GEOMETRYCOLLECTION (POINT(7 7), GEOMETRYCOLLECTION(LINESTRING(0 0,1 1)))", 3, 1),
        ("SRID=4326;POINT Z (1 2 3)", 1, 0),
    ];
    for (text, points, segments) in cases {
        let document = read_as(Format::Wkt, text).unwrap();
        assert_eq!((document.point_count(), document.segments.len()), (points, segments), "{text}");
    }
}

#[test]
fn a_file_of_geometries() {
    let documents = all(
        "a.wkt",
        "# note\nPOINT(1 2)\nMULTIPOLYGON(((0 0,1 0,0 1))), ((5 3, 5 1)))\n\nLINESTRING(1/3 0,\n 1 0)\n",
    );
    assert_eq!(documents.len(), 3);
    assert_eq!(documents[0].name, "a.wkt#1");
    assert_eq!(documents[1].notes, ["text after the geometry left out, line 3"]);
    assert_eq!(documents[2].points[0], 1.0 / 3.0);
}

#[test]
fn tables_hold_geometries_in_fields() {
    let documents =
        all("a.txt", "#c\n2|POINT(0 0)|@A|LINESTRING(0 0,1 0)\n0 POLYGON((0 0,1 0,0 1))\n");
    assert_eq!(documents.len(), 3);
    assert_eq!(read_named("b.txt", "1 POINT(3 4)\n").points, [3.0, 4.0]);
}

#[test]
fn faults_have_their_line() {
    assert_eq!(
        refusal(Format::Wkt, "POINT(1 2)\nPOINT(1)\n"),
        "t:2: expected a coordinate, found `)`"
    );
    assert_eq!(refusal(Format::Wkt, "POLYGON((0 0, 1"), "t:1: file ends before a coordinate");
    assert_eq!(refusal(Format::Wkt, "CIRCLE(0 0)"), "t:1: expected a WKT geometry, found `CIRCLE`");
    let deep = "GEOMETRYCOLLECTION(".repeat(100_000);
    assert!(refusal(Format::Wkt, &deep).contains("nested at most 64 deep"));
}

#[test]
fn written_text_reads_back() {
    let document = read_named("a.wkt", "GEOMETRYCOLLECTION(POINT(0.1 1e300),LINESTRING(0 -0,1 0))");
    let text = written(&document, Format::Wkt);
    assert_eq!(
        text,
        "GEOMETRYCOLLECTION (MULTIPOINT ((0.1 1e300), (0 -0), (1 0)), MULTILINESTRING ((0 -0, 1 0)))\n"
    );
    assert_eq!(read_named("a.wkt", &text).points, document.points);
}
