use super::*;
use crate::testing::of;

fn triangle() -> AlphaFiltration<2> {
    of(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]]) // squared values 0, 2.25, 4, 6.25
}

fn ranks(param: AlphaParam) -> u32 {
    triangle().cut(param).unwrap().ranks()
}

#[test]
fn queries_are_closed_and_exact() {
    for (value, at) in [(0.0f64, 1), (2.25, 2), (4.0, 3), (6.25, 4)] {
        assert_eq!(ranks(AlphaParam::Squared(value)), at);
        assert_eq!(ranks(AlphaParam::Squared(value.next_down())), at - 1);
        assert_eq!(ranks(AlphaParam::Radius(value.sqrt())), at);
        assert_eq!(ranks(AlphaParam::Radius(value.sqrt().next_up())), at);
        assert_eq!(ranks(AlphaParam::Radius(value.sqrt().next_down())), at - 1);
        assert_eq!(ranks(AlphaParam::Unit(value.sqrt() / 4.0)), at);
    }
    // 1/q is 2 exactly; a little more of q is a little less than 2.
    assert_eq!(ranks(AlphaParam::Inverse(0.5)), 3);
    assert_eq!(ranks(AlphaParam::Inverse(0.5f64.next_up())), 2);
    assert_eq!(ranks(AlphaParam::Inverse(0.0)), 4);
    assert_eq!(ranks(AlphaParam::Squared(-1.0)), 0);
    assert_eq!(ranks(AlphaParam::Radius(1e308)), 4);
    assert_eq!(ranks(AlphaParam::Radius(5e-324)), 1);
}

#[test]
fn every_convention_names_the_same_complexes() {
    let filtration = triangle();
    for index in 0..4 {
        let cut = filtration.cut(AlphaParam::Index(index)).unwrap();
        let t = f64::from(narrow(index)) / 3.0;
        assert_eq!(filtration.cut(AlphaParam::Rank(t)).unwrap(), cut);
        let value = filtration.value_of_rank(narrow(index));
        assert_eq!(filtration.up_to(&value), cut);
    }
    assert_eq!(ranks(AlphaParam::Rank(0.34)), 2);
    assert_eq!(ranks(AlphaParam::Rank(1.0f64.next_down())), 3);
}

#[test]
fn few_values_have_a_slider() {
    let one = of(&[[3.0, 4.0]]);
    assert_eq!(one.cut(AlphaParam::Rank(0.0)).unwrap(), one.whole());
    assert_eq!(one.cut(AlphaParam::Rank(1.0)).unwrap(), one.whole());
    let none = of::<2>(&[]);
    assert_eq!(none.cut(AlphaParam::Rank(0.5)).unwrap(), Cut::new(0));
    assert_eq!(none.cut(AlphaParam::Unit(0.5)).unwrap(), Cut::new(0));
}

#[test]
fn what_is_no_parameter_is_refused() {
    for param in [
        AlphaParam::Radius(f64::NAN),
        AlphaParam::Squared(f64::INFINITY),
        AlphaParam::Inverse(-1.0),
        AlphaParam::Unit(-0.5),
        AlphaParam::Rank(1.5),
        AlphaParam::Rank(f64::NAN),
        AlphaParam::Index(4),
    ] {
        let error = triangle().cut(param).unwrap_err();
        assert!(matches!(error, ParamError::OutOfRange(_)), "{param:?}");
    }
}

#[test]
fn critical_complexes_have_their_property() {
    // A triangle, and a square away from it by 6.
    let filtration =
        of(&[[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [8.0, 0.0], [10.0, 0.0], [8.0, 2.0], [10.0, 2.0]]);
    let value = |critical| {
        let cut = filtration.cut(AlphaParam::Critical(critical)).unwrap();
        filtration.value_of_rank(cut.ranks() - 1).to_f64()
    };
    assert_eq!(value(Critical::AllPoints), 2.0); // the square's
    assert_eq!(value(Critical::Components(7)), 0.0);
    assert_eq!(value(Critical::Components(2)), 1.0); // half of 2, squared
    assert_eq!(value(Critical::Components(1)), 9.0); // half of 6, squared
    assert_eq!(value(Critical::Betti(2, 1)), 1.0); // the square's ring, the triangle's edge being attached
    // Between the two there are slabs of triangles, the last of which fills the shape.
    assert!(value(Critical::OneRegion) >= 9.0);
    let none = filtration.cut(AlphaParam::Critical(Critical::Betti(1, 5)));
    assert_eq!(none, Err(ParamError::NoSuchComplex(Critical::Betti(1, 5))));
}
