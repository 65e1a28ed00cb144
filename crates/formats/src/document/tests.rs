use super::*;

#[test]
fn projecting_undoes_raising() {
    let plane = Document { holes: vec![0.5, 0.25], ..Document::new(2) };
    assert_eq!(plane.clone().raised().projected(2), plane);
}

#[test]
fn the_wrong_dimension_is_an_error_and_not_a_guess() {
    let space = Document { points: vec![1.0, 2.0, 3.0], ..Document::new(3) };
    assert!(matches!(space.points_2d(), Err(ReadError::Dimension { expected: 2, found: 3, .. })));
    assert_eq!(space.points_3d().unwrap(), [[1.0, 2.0, 3.0]]);
    assert_eq!(space.projected(0).points_2d().unwrap(), [[2.0, 3.0]]);
}
