use super::*;

#[test]
fn a_quadratic_takes_eight_steps_and_ends_where_it_says() {
    let mut out = vec![[0.0, 0.0]];
    flatten([0.0, 0.0], &[[1.0, 2.0], [2.0, 0.0]], &mut out);
    assert_eq!(out.len(), 9);
    assert_eq!(out[4], [1.0, 1.0]);
    assert_eq!(out[8], [2.0, 0.0]);
}
