use crate::format::Format;
use crate::testing::{read_named, refusal, written};

const TEXT: &str = "{\"V\": [[0,0],[1,-0],[0.1,1e300]],\n\"EV\": [[0,1]],\n\"FV\": [[0,1,2]]}\n";

#[test]
fn vertices_edges_faces() {
    let document = read_named("a.lar.json", TEXT);
    assert_eq!(document.segments, [[0, 1]]);
    assert_eq!(document.triangles, [[0, 1, 2]]);
    assert_eq!(document.points[3].to_bits(), (-0.0_f64).to_bits());
    assert_eq!(written(&document, Format::Lar), TEXT);
    assert_eq!(read_named("b.json", TEXT).points, document.points);
}

#[test]
fn cells_in_space() {
    let text = "{\"V\": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]],\n\"CV\": [[0,1,2,3]]}\n";
    let document = read_named("a.lar.json", text);
    assert_eq!(document.tets, [[0, 1, 2, 3]]);
    assert_eq!(written(&document, Format::Lar), text);
}

#[test]
fn nonsense_is_refused() {
    let out = "t: index 1 names no point: 1 points are numbered from 0";
    assert_eq!(refusal(Format::Lar, "{\"V\":[[0,0]],\"EV\":[[0,1]]}"), out);
    for bad in [
        "{}",
        "[]",
        "{\"V\":[[0]]}",
        "{\"V\":[[0,0],[1]]}",
        "{\"V\":[[0,0]],\"EV\":[[0]]}",
        "{\"V\":[[0,\"a\"]]}",
    ] {
        assert!(refusal(Format::Lar, bad).starts_with("t: expected"), "{bad}");
    }
}
