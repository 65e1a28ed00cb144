use super::*;

#[test]
fn rings_close_whether_or_not_they_repeat_their_first_point() {
    for ring in [
        &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]][..],
        &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]],
    ] {
        let mut shapes = Shapes::new(2);
        shapes.ring(ring).unwrap();
        let document = shapes.finish();
        assert_eq!(document.segments, [[0, 1], [1, 2], [2, 0]]);
        assert_eq!(document.points_listed, 3);
    }
}

#[test]
fn zero_length_edges_are_dropped_and_counted() {
    let mut shapes = Shapes::new(2);
    shapes.ring(&[[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
    let document = shapes.finish();
    assert_eq!(document.zero_length_dropped, 1);
    assert_eq!(document.segments.len(), 3);
    assert_eq!(document.notes, ["1 zero-length edges dropped", "4 listed points merged to 3"]);
}

#[test]
fn shared_borders_keep_their_multiplicity() {
    let mut shapes = Shapes::new(2);
    shapes.line(&[[0.0, 0.0], [1.0, 0.0]]).unwrap();
    shapes.line(&[[1.0, 0.0], [0.0, 0.0]]).unwrap();
    assert_eq!(shapes.finish().segments, [[0, 1], [1, 0]]);
}

#[test]
fn the_two_zeros_are_two_vertices() {
    let mut shapes = Shapes::new(2);
    shapes.point(&[0.0, 0.0]).unwrap();
    shapes.point(&[-0.0, 0.0]).unwrap();
    assert_eq!(shapes.finish().point_count(), 2);
}

#[test]
fn a_ring_of_one_point_is_a_free_point() {
    let mut shapes = Shapes::new(2);
    shapes.ring(&[[3.0, 4.0]]).unwrap();
    let document = shapes.finish();
    assert_eq!((document.point_count(), document.segments.len()), (1, 0));
}
