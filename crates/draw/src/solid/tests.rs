use super::Solid;
use roxmltree::Document;

const CORNERS: [[f64; 3]; 5] =
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0]];

fn facets(svg: &str) -> usize {
    let document = Document::parse(svg).unwrap();
    let group =
        document.descendants().find(|node| node.attribute("class") == Some("facet")).unwrap();
    group.children().count()
}

#[test]
fn two_tets_have_six_boundary_facets_and_nine_wires() {
    let solid = Solid { points: &CORNERS, tets: &[[0, 1, 2, 3], [4, 3, 2, 1]], ..Solid::default() };
    let svg = solid.svg();
    assert_eq!(facets(&svg), 6);
    let document = Document::parse(&svg).unwrap();
    let wires =
        document.descendants().find(|node| node.attribute("class") == Some("wire")).unwrap();
    assert_eq!(wires.attribute("d").unwrap().matches('M').count(), 9);
    assert_eq!(svg, solid.svg());
}

#[test]
fn extremes_empties_and_bad_indices_stay_well_formed() {
    for size in [0.0, 5e-324, 1e-300, 1e300, f64::MAX] {
        let points = CORNERS.map(|p| p.map(|x| (x - 0.5) * size * 2.0));
        let svg = Solid {
            points: &points,
            tets: &[[0, 1, 2, 3], [1, 2, 3, 99]],
            title: "<&>",
            ..Solid::default()
        }
        .svg();
        assert!(Document::parse(&svg).is_ok() && !svg.contains("NaN") && !svg.contains("inf"));
    }
    assert_eq!(facets(&Solid::default().svg()), 0);
    let cloud = Solid { points: &[[f64::NAN; 3], [1.0; 3]], ..Solid::default() }.svg();
    assert!(cloud.contains("class=\"site\"") && !cloud.contains("NaN"));
}
