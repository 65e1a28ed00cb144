use crate::format::Format;
use crate::testing::{read_as, read_named, refusal, written};

#[test]
fn faces_and_their_colours() {
    let text =
        "OFF # note\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1 255 0 0\n3 0 1 2\n4 0 1 2 3 0.1 0.2 0.3\n";
    let document = read_named("a.off", text);
    assert_eq!(document.triangles, [[0, 1, 2]]);
    assert_eq!(document.polygons, [[0, 1, 2, 3]]);
    let text = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1\n3 0 1 2\n4 0 1 2 3\n";
    assert_eq!(written(&document, Format::Off), text);
}

#[test]
fn plane_files_are_two_dimensional() {
    let flat = read_as(Format::Off, "OFF 1 0\n1 2 0\n").unwrap();
    assert_eq!((flat.dimension, flat.points.as_slice()), (2, &[1.0, 2.0][..]));
    let two = read_as(Format::Off, "nOFF\n2\n1 0 0\n1 2\n").unwrap();
    assert_eq!(two.points, [1.0, 2.0]);
    assert_eq!(written(&two, Format::Off), "nOFF\n2\n1 0 0\n1 2\n");
    assert_eq!(read_as(Format::Off, "nOFF 2 1 0 0\n1 2\n").unwrap().points, [1.0, 2.0]);
}

#[test]
fn counts_and_indices_are_checked() {
    assert!(refusal(Format::Off, "OFF\n2 0 0\n0 0 0\n").contains("ends before the next vertex"));
    assert!(
        refusal(Format::Off, "OFF\n1 0 0\n0 0 0\n1 1 1\n")
            .starts_with("t:4: expected the end of the file")
    );
    assert!(
        refusal(Format::Off, "OFF\n1 1 0\n0 0 0\n3 0 0 1\n").contains("index 1 names no point")
    );
    assert!(refusal(Format::Off, "OFF\n1 1 0\n0 0 0\n3 0 0\n").contains("3 corners"));
    assert!(refusal(Format::Off, "FOO\n").contains("OFF or nOFF"));
    // A line of separators only has no fields.
    assert!(refusal(Format::Off, "nOFF\n,\n1 0 0\n1 2\n").contains("a dimension"));
}
