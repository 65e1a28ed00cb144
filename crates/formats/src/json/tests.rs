use crate::format::Format;
use crate::testing::{all, read_named, refusal};

#[test]
fn bare_arrays_by_depth() {
    assert_eq!(read_named("a.json", "[[[0,0],[1,0],[0,1]],[[5,5]]]").segments.len(), 3);
    assert_eq!(read_named("a.json", "[[0,0],[1,0]]").points, [0.0, 0.0, 1.0, 0.0]);
    assert_eq!(read_named("a.json", "[0,0,1,0]").points, [0.0, 0.0, 1.0, 0.0]);
    assert_eq!(read_named("a.json", "[[0,0,1]]").dimension, 3);
    assert!(refusal(Format::Json, "[0,1,2]").contains("x and y in turn"));
}

#[test]
fn numbers_are_the_nearest_doubles() {
    let text = "[[122.416294033786585, 0.000000000000000000000000000000000000000000000000000000000000000000000000000001]]";
    assert_eq!(read_named("a.json", text).points, ["122.416294033786585".parse().unwrap(), 1e-78]);
}

#[test]
fn bug_reports_with_decimal_strings() {
    let text = r#"{"note":"n","points":[["0","0"],["1.5","0"]],"edges":[[0,1]],"segments":[["1.5","0","2","2"]],"hole_points":[["9","9"]]}"#;
    let document = read_named("a.json", text);
    assert_eq!(document.points, [0.0, 0.0, 1.5, 0.0, 2.0, 2.0]);
    assert_eq!(document.segments, [[0, 1], [1, 2]]);
    assert_eq!(document.holes, [9.0, 9.0]);
    let grids = all("a.json", r#"{"grids":[{"p":["0.5","0.5"],"q":["12","12"],"r":["24","24"]}]}"#);
    assert_eq!(grids[0].point_count(), 3);
}

#[test]
fn challenge_instances() {
    let text = r#"{"num_points":4,"points_x":[0,9,0,1],"points_y":[0,0,9,1],"region_boundary":[0,1,2],"num_constraints":1,"additional_constraints":[[0,3]]}"#;
    assert_eq!(read_named("a.json", text).segments, [[0, 1], [1, 2], [2, 0], [0, 3]]);
    assert!(refusal(Format::Json, r#"{"points_x":[0],"points_y":[]}"#).contains("1 y coordinates"));
}

#[test]
fn topologies_are_summed_and_scaled() {
    let text = r#"{"type":"Topology","transform":{"scale":[2,1],"translate":[10,0]},"objects":{},"arcs":[[[0,0],[1,1],[1,0]]]}"#;
    let document = read_named("a.json", text);
    assert_eq!(document.points, [10.0, 0.0, 12.0, 1.0, 14.0, 1.0]);
    assert_eq!(document.segments, [[0, 1], [1, 2]]);
}

#[test]
fn glyphs_flatten_by_the_fixed_rule() {
    let text = r#"{"glyphs":{"o":{"path":[["moveTo",[[0,0]]],["qCurveTo",[[2,0],[2,2],[0,2]]],["lineTo",[[0,1]]],["closePath",[]]]}}}"#;
    let documents = all("f.json", text);
    assert_eq!(documents[0].name, "f.json#o");
    // Two pieces of eight steps, one line, one closing edge; the implied point is half way.
    assert_eq!(documents[0].segments.len(), 18);
    assert_eq!(documents[0].point(8), Some(&[2.0, 1.0][..]));
}

#[test]
fn curves_are_their_control_points() {
    assert_eq!(read_named("a.json", r#"[{"poles":[[0,0],[1,1],[2,0]]}]"#).segments.len(), 2);
}

#[test]
fn nesting_is_bounded() {
    assert!(refusal(Format::Json, &"[".repeat(100_000)).contains("recursion limit"));
}
