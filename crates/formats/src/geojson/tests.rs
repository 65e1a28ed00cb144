use crate::format::Format;
use crate::testing::{read_named, refusal, written};

#[test]
fn all_features_are_one_document() {
    let text = r#"{"type":"FeatureCollection","features":[
        {"type":"Feature","properties":null,"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}},
        {"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[5,6,7]}},
        {"type":"Feature","properties":{},"geometry":null}]}"#;
    for name in ["a.geojson", "a.json"] {
        let document = read_named(name, text);
        assert_eq!(document.segments, [[0, 1], [1, 2], [2, 0]]);
        assert_eq!(document.points[6..], [5.0, 6.0]);
        assert_eq!(document.notes, ["altitude dropped of 1 positions"]);
    }
}

#[test]
fn written_json_reads_back() {
    let document = read_named(
        "a.geojson",
        r#"{"type":"LineString","coordinates":[[0.1,1e300],[-0.0,5e-324]]}"#,
    );
    let again = read_named("a.geojson", &written(&document, Format::GeoJson));
    assert_eq!((again.points, again.segments), (document.points, document.segments));
}

#[test]
fn short_positions_are_refused() {
    assert!(refusal(Format::GeoJson, r#"{"type":"Point","coordinates":[1]}"#).starts_with("t: "));
    assert!(refusal(Format::GeoJson, "{\n").contains("ends before"));
}
