use super::*;

fn plot(points: Vec<[f64; 2]>) -> String {
    let series = vec![Series { name: "a < b".into(), points }];
    Plot { title: "growth".into(), across: "sites".into(), up: "ns".into(), series }.svg()
}

#[test]
fn what_a_logarithm_has_no_place_for_is_left_out() {
    let svg = plot(vec![[0.0, 1.0], [1.0, -1.0], [10.0, 2.0], [f64::NAN, 1.0], [100.0, 20.0]]);
    assert_eq!(svg.matches("<circle").count(), 2 + 1);
    assert!(svg.contains("a &lt; b, n^1.00"), "{svg}");
    assert!(roxmltree::Document::parse(&svg).is_ok());
}

#[test]
fn no_points_and_one_point_are_drawn() {
    for points in [vec![], vec![[5.0, 5.0]]] {
        let svg = plot(points);
        assert!(roxmltree::Document::parse(&svg).is_ok());
        assert!(!svg.contains("NaN") && !svg.contains("inf") && !svg.contains("n^"), "{svg}");
    }
}
