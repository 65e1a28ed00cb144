use crate::document::Region;
use crate::format::Format;
use crate::read::{Source, read_bytes};
use crate::testing::{read_as, refusal, written};

const NODES: &str = "# four\n4 2 1 1\n1 0 0 0.5 1\n\n2 1 0 -1 1 # two\r\n3 1 1 2 0\n4 0 1e-3 0 0\n";

fn beside(format: Format, text: &str, nodes: &str) -> Result<crate::Document, crate::ReadError> {
    let source = Source {
        name: "t",
        bytes: text.as_bytes(),
        format: Some(format),
        nodes: Some(nodes.as_bytes()),
    };
    read_bytes(&source).map(|mut documents| documents.remove(0))
}

#[test]
fn nodes_with_attributes_and_markers() {
    let document = read_as(Format::Node, NODES).unwrap();
    assert_eq!(document.points, [0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1e-3]);
    assert_eq!(document.attributes, [0.5, -1.0, 2.0, 0.0]);
    assert_eq!(document.point_markers, [1, 1, 0, 0]);
    assert_eq!(document.first_index, 1);
    let text = "4 2 1 1\n1 0 0 0.5 1\n2 1 0 -1 1\n3 1 1 2 0\n4 0 0.001 0 0\n";
    assert_eq!(written(&document, Format::Node), text);
}

#[test]
fn broken_numbering_is_refused() {
    assert_eq!(
        refusal(Format::Node, "2 2 0 0\n0 1 2\n2 3 4\n"),
        "t:3: point number 1 is due, found `2`"
    );
    assert_eq!(
        refusal(Format::Node, "2 2 0 0\n1 1 2\n1 3 4\n"),
        "t:3: point number 2 is due, found `1`"
    );
    assert_eq!(refusal(Format::Node, "1 2 0 0\n5 1 2\n"), "t:2: point number 1 is due, found `5`");
}

#[test]
fn counts_and_fields_must_agree() {
    assert_eq!(refusal(Format::Node, "3 2 0 0\n1 0 0\n"), "t:2: file ends before the next point");
    let more = "t:3: expected the end of the file, or a larger count in the header, found `2 0 1`";
    assert_eq!(refusal(Format::Node, "1 2 0 0\n1 0 0\n2 0 1\n"), more);
    assert!(refusal(Format::Node, "1 2 0 1\n1 0 0\n").contains("a number and 3 fields"));
    assert!(refusal(Format::Node, "1 4 0 0\n1 0 0 0 0\n").contains("dimension 2 or 3"));
    assert!(
        refusal(Format::Node, "18446744073709551615 2 18446744073709551615 1\n1 0 0\n")
            .starts_with("t:2")
    );
}

#[test]
fn poly_with_holes_and_regions() {
    let text = "3 2 0 0\n0 0 0\n1 4 0\n2 0 4\n3 1\n0 0 1 5\n1 1 2 -6\n2 2 0 7\n1\n0 1 1\n2\n0 1 2 3 0.5\n1 2 1 4\n";
    let document = read_as(Format::Poly, text).unwrap();
    assert_eq!(document.segments, [[0, 1], [1, 2], [2, 0]]);
    assert_eq!(document.segment_markers, [5, -6, 7]);
    assert_eq!(document.holes, [1.0, 1.0]);
    assert_eq!(
        document.regions[0],
        Region { seed: vec![1.0, 2.0], attribute: 3.0, size_max: Some(0.5) }
    );
    assert_eq!(written(&document, Format::Poly), text);
}

#[test]
fn poly_without_points_takes_those_of_the_node_file() {
    let text = "0 2 0 0\n1 0\n1 1 4\n0\n";
    assert_eq!(beside(Format::Poly, text, NODES).unwrap().segments, [[0, 3]]);
    assert!(refusal(Format::Poly, text).contains(".node file of the same name"));
    let out = beside(Format::Poly, "0 2 0 0\n1 0\n1 1 5\n0\n", NODES).unwrap_err();
    assert_eq!(out.to_string(), "t:3: index 5 names no point: 4 points are numbered from 1");
}

#[test]
fn poly_in_space_has_facets() {
    let text = "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n3 0\n1\n3 1 2 3\n2 0\n4 1 2\n 3 4\n2 1 4\n1 1\n3 2 3 4\n1 0.5 0.5 0.5\n0\n";
    let document = read_as(Format::Poly, text).unwrap();
    assert_eq!(document.triangles, [[0, 1, 2], [1, 2, 3]]);
    assert_eq!(document.polygons, [[0, 1, 2, 3]]);
    assert_eq!(document.segments, [[0, 3]]);
    assert_eq!(document.notes, ["1 facets of several polygons taken apart, 1 facet holes dropped"]);
    let again = read_as(Format::Poly, &written(&document, Format::Poly)).unwrap();
    assert_eq!(
        (again.triangles, again.polygons, again.segments),
        (document.triangles, document.polygons, document.segments)
    );
}

#[test]
fn smesh_has_a_facet_a_line() {
    let text = "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n2 1\n3 1 2 3 -7\n4 1 2 3 4 5\n0\n";
    let document = read_as(Format::Smesh, text).unwrap();
    assert_eq!((document.triangles.as_slice(), document.polygons.len()), (&[[0, 1, 2]][..], 1));
    assert_eq!(document.notes, ["facet markers dropped"]);
}

#[test]
fn elements_of_first_and_second_order() {
    let document = beside(Format::Ele, "2 3 1\n1 1 2 3 9\n2 1 3 4 8\n", NODES).unwrap();
    assert_eq!(document.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(document.cell_attributes, [9.0, 8.0]);
    assert_eq!(written(&document, Format::Ele), "2 3 1\n1 1 2 3 9\n2 1 3 4 8\n");
    assert_eq!(written(&document, Format::Neigh), "2 3\n1 -1 2 -1\n2 -1 -1 1\n");
    let second = beside(Format::Ele, "1 6 0\n0 1 2 3 4 4 4\n", NODES).unwrap();
    assert_eq!(second.notes, ["elements of 6 corners: only the first 3 kept"]);
    assert!(beside(Format::Ele, "1 4 0\n1 1 2 3 4\n", NODES).is_err());
    assert!(matches!(read_as(Format::Ele, "0 3 0\n"), Err(crate::ReadError::NodesMissing { .. })));
}

#[test]
fn edges_are_segments() {
    let document = beside(Format::Edge, "1 1\n1 2 3 -4\n", NODES).unwrap();
    assert_eq!(
        (document.segments.as_slice(), document.segment_markers.as_slice()),
        (&[[1, 2]][..], &[-4][..])
    );
    assert_eq!(written(&document, Format::Edge), "1 1\n1 2 3 -4\n");
}
