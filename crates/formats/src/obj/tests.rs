use crate::format::Format;
use crate::testing::{read_named, refusal, written};

#[test]
fn lines_faces_and_relative_indices() {
    let text = "mtllib a\nv 0 0 1\nv 1 0 0\nv 0 1 0\nl 1 2 3\nf 1/1/1 -2//7 -1\nf 1 2 3 1\n";
    let document = read_named("a.obj", text);
    assert_eq!(document.segments, [[0, 1], [1, 2]]);
    assert_eq!(document.triangles, [[0, 1, 2]]);
    assert_eq!(document.polygons, [[0, 1, 2, 0]]);
    let text = "v 0 0 1\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\nf 1 2 3\nf 1 2 3 1\n";
    assert_eq!(written(&document, Format::Obj), text);
}

#[test]
fn nonsense_is_refused() {
    assert_eq!(refusal(Format::Obj, "v 1 2\n"), "t:1: expected `v x y z`, found `v 1 2`");
    for bad in ["l 1 2", "l 0 1", "f -1 -2 -3", "l 1 99999999999999999999", "l 1 x", "f 1 1"] {
        assert!(refusal(Format::Obj, &format!("v 0 0 0\n{bad}\n")).starts_with("t:2"), "{bad}");
    }
}
