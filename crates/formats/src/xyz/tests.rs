use crate::format::Format;
use crate::testing::{read_as, read_named, refusal, written};

#[test]
fn two_columns_are_the_plane_three_are_space() {
    assert_eq!(read_named("a.xyz", "0 -0\r\n1.5\t2\r\n").points, [0.0, -0.0, 1.5, 2.0]);
    let space = read_named("a.pts", "2\n1 2 3\n4 5 6\n");
    assert_eq!(
        (space.dimension, space.points.as_slice()),
        (3, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0][..])
    );
    assert!(space.notes.is_empty());
}

#[test]
fn what_is_no_coordinate_is_said() {
    let normals = read_named("a.pwn", "1 2 3 0 0 1\n");
    assert_eq!(normals.attributes, [0.0, 0.0, 1.0]);
    assert_eq!(normals.notes, ["6 columns: those after the third kept as attributes"]);
    let bounded = read_named("a.txt", "0 0 9 9\n1 2\n");
    assert_eq!(bounded.points, [1.0, 2.0]);
    assert_eq!(bounded.notes, ["first line is a bounding box: dropped"]);
    let short = read_named("a.pts", "5\n1 2 3\n");
    assert_eq!(short.notes, ["header announces 5 points, 1 follow"]);
    let contours = read_named("a.pts", "1 2 3\n{ -30.0\n//v 7 z 1 2\n4 5 6\n}\n -64.0\n");
    assert_eq!((contours.point_count(), contours.notes.len()), (2, 1));
}

#[test]
fn not_a_number_is_passed_on() {
    let document = read_named("a.xy", "0 0\n\nnan inf\n-inf 1\n");
    assert!(document.points[2].is_nan());
    assert_eq!(document.notes, ["point 1, line 3, is the first that is not finite"]);
}

#[test]
fn tables_name_their_columns() {
    let table = read_named("a.csv", "id,x,y,w\n7,0.5,1,2\n8,3,4,5\n");
    assert_eq!(table.points, [0.5, 1.0, 3.0, 4.0]);
    assert_eq!(table.weights, Some(vec![2.0, 5.0]));
    assert_eq!(table.attributes, [7.0, 8.0]);
    assert_eq!(written(&table, Format::Csv), "x,y,w,a0\n0.5,1,2,7\n3,4,5,8\n");
}

#[test]
fn ragged_lines_and_words_are_refused() {
    assert_eq!(refusal(Format::Xyz, "1 2\n3\n"), "t:2: expected 2 numbers, found `3`");
    assert_eq!(refusal(Format::Xyz, "1 2\n3 x\n"), "t:2: expected a coordinate, found `x`");
    assert!(read_as(Format::Csv, "x\n1\n").is_err());
}
