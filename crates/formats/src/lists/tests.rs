use crate::format::Format;
use crate::testing::{all, read_named, refusal};

#[test]
fn boost_lists_points_then_segments() {
    let document = read_named("a.txt", "1\n5 5\n1\n0 0 1 0\n");
    assert_eq!(document.points, [5.0, 5.0, 0.0, 0.0, 1.0, 0.0]);
    assert_eq!(document.segments, [[1, 2]]);
    assert_eq!(read_named("a.txt", "0 1\n0 0 1 0\n").segments, [[0, 1]]);
}

#[test]
fn vertex_edge_keeps_points_as_listed() {
    let document = read_named("a.txt", "3 2\n0 0\n0 0\n1 1\n0 2\n1 1\n");
    assert_eq!((document.point_count(), document.segments.len()), (3, 1));
    assert_eq!(document.zero_length_dropped, 1);
    let message = "t:5: index 3 names no point: 3 points are numbered from 0";
    assert_eq!(refusal(Format::VertexEdge, "3 1\n0 0\n1 0\n0 1\n0 3\n"), message);
}

#[test]
fn detria_closes_its_polylines() {
    let document = read_named("a.txt", "3 1 1\n3\n0\n0 0\n1 0\n0 1\n0\n1\n2\n0 1\n");
    assert_eq!(document.segments, [[0, 1], [1, 2], [2, 0], [0, 1]]);
}

#[test]
fn segment_soups_merge_ends_and_round_quotients() {
    let document = read_named("a.edg", "2\n0/1 1/3 1 1\n1 1 2/2 0\n");
    assert_eq!(document.points, [0.0, 1.0 / 3.0, 1.0, 1.0, 1.0, 0.0]);
    assert_eq!(document.segments, [[0, 1], [1, 2]]);
    assert_eq!(document.notes[0], "1 rational coordinates rounded to the nearest double");
    assert!(refusal(Format::SegmentList, "2\n0 0 1 1\n").contains("ends before"));
}

#[test]
fn dat_files_are_rings_with_holes_and_steiner_points() {
    let document = read_named("a.dat", "0 0\n9 0\n0 9\nHOLE\n1 1\n2 1\n1 2\nSTEINER\n3 3\n");
    assert_eq!((document.point_count(), document.segments.len()), (7, 6));
}

#[test]
fn counted_runs_have_three_grammars() {
    let ring = "3\n0 0\n1 0\n0 1\n";
    let two = format!("2\n{ring}{ring}");
    let holes = "3 0 0 9 0 0 9\n1\n3 1 1 2 1 1 2\n3 0 0 9 0 0 9\n";
    assert_eq!(read_named("a.dat", ring).segments, [[0, 1], [1, 2], [2, 0]]);
    assert_eq!(read_named("a.dat", &two).segments.len(), 6);
    assert_eq!(read_named("a.dat", holes).segments.len(), 9);
    assert_eq!(read_named("a.poly", ring).segments.len(), 3);
    assert_eq!(read_named("polyline/a.dat", &two).segments.len(), 4);
    assert_eq!(read_named("points.dat", ring).segments.len(), 0);
}

#[test]
fn sites_of_both_kinds() {
    let document = read_named("a.cin", "s 0 0 1 0 r\np 0 0\np 5 5\n");
    assert_eq!((document.point_count(), document.points_listed), (3, 4));
    assert_eq!(document.segments, [[0, 1]]);
    assert_eq!(refusal(Format::Cin, "s 0 0 1\n"), "t:1: expected 4 coordinates, found `s 0 0 1`");
}

#[test]
fn clipper_has_a_document_per_caption() {
    let text = "CAPTION: 1.\nSUBJECTS\n0,0, 9,0, 0,9\nSUBJECTS_OPEN\n1,1 2,2\nCLIPS\n5,5 6,5 5,6\n\nCAPTION: 2.\n";
    let documents = all("a.txt", text);
    assert_eq!(documents.len(), 2);
    assert_eq!(documents[0].name, "a.txt#1");
    assert_eq!(documents[0].segments.len(), 3 + 1 + 3);
    assert!(documents[1].points.is_empty());
}

#[test]
fn manifold_names_its_cases() {
    let documents = all("a.txt", "One 1 -1.0 1\n3\n0 0\n1 0\n0 1\nTwo 1 5e-6 0\n");
    assert_eq!(documents[0].name, "a.txt#One");
    assert_eq!(documents[0].segments.len(), 3);
    assert_eq!(documents.len(), 2);
}

#[test]
fn shorelines_hold_as_many_points_as_they_say() {
    let text = "# note\n> 1 1 0.5 4\n0 0\n1 0\n0 1\n0 0\n";
    assert_eq!(read_named("a.xy", text).segments.len(), 3);
    let message = "t:1: header announces 5 ring points, 1 follow";
    assert_eq!(refusal(Format::Gshhg, "> 1 1 0.5 5\n0 0\n"), message);
}
