use super::*;

#[test]
fn a_page_is_well_formed_and_holds_every_simplex() {
    let page = Slider {
        title: "a <b> & \"c\"",
        points: &[[0.0, 0.0], [1.0, 0.0], [f64::NAN, 1.0]],
        edges: &[[0, 1], [0, 2]],
        edge_ranks: &[1, 2],
        triangles: &[[0, 1, 2]],
        triangle_ranks: &[2],
        values: &["0".to_owned(), "0.5".to_owned(), "]]></script>".to_owned()],
        numbers: &["0".to_owned()],
        figures: &["<svg/>".to_owned()],
        start: 9,
    }
    .html();
    let body = page.split_once('\n').unwrap().1; // after the document type
    let tree = roxmltree::Document::parse(body).unwrap();
    let script = tree.descendants().find(|node| node.has_tag_name("script")).unwrap();
    let script: String = script.children().filter_map(|node| node.text()).collect();
    assert!(script.contains("const edges = [[0,1,1],[0,2,2]];"));
    assert!(script.contains("const triangles = [[0,1,2,2]];"));
    assert!(script.contains(",null];"), "a point without a place");
    assert!(page.contains("max=\"3\" value=\"3\""));
}
