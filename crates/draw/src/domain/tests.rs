use super::{Block, Cube, DomainSheet, Panel, Shade};

fn sheet(panel: Panel) -> String {
    DomainSheet { title: "<1>".into(), rows: vec![vec![("a & b".into(), panel)]] }.svg()
}

#[test]
fn every_node_is_drawn_once_and_fathers_are_above_the_middle_of_their_sons() {
    use Shade::{Black, Gray, White};
    let nodes = vec![Gray, Black, Gray, White, Black, White, White, White, Black];
    let svg = sheet(Panel::Hierarchy { arity: 4, nodes });
    assert_eq!(svg.matches("<circle").count(), 2);
    assert_eq!(svg.matches("fill=\"#26303a\" stroke").count(), 3, "black leaves");
    assert_eq!(svg.matches('L').count(), 8, "edges");
    // Leaves are at 6 + 16 (k + 1/2): the inner node's sons are 1 to 4, the root's 0, 2.5, 5, 6.
    assert!(svg.contains("<circle cx=\"54\" cy=\"62\""), "{svg}");
    assert!(svg.contains("<circle cx=\"62\" cy=\"6\""), "{svg}");
}

#[test]
fn nodes_that_end_early_or_go_on_are_drawn_as_far_as_they_are_a_tree() {
    let cut = sheet(Panel::Hierarchy { arity: 4, nodes: vec![Shade::Gray, Shade::Black] });
    assert_eq!((cut.matches("<circle").count(), cut.matches('L').count()), (1, 1));
    let long = sheet(Panel::Hierarchy { arity: 2, nodes: vec![Shade::Black, Shade::White] });
    assert_eq!(long.matches("stroke-width=\"0.6\"").count(), 1);
}

#[test]
fn blocks_have_y_upwards_and_labels() {
    let block =
        Block { lower: [0.0, 0.5], upper: [0.5, 1.0], shade: Shade::Black, label: "1".into() };
    let svg = sheet(Panel::Blocks { blocks: vec![block], outline: vec![[[0.0, 0.0], [1.0, 1.0]]] });
    assert!(svg.contains("<rect x=\"0\" y=\"0\" width=\"192\" height=\"192\" fill=\"#26303a\""));
    assert!(svg.contains("d=\"M0 384L384 0\""));
    assert!(svg.contains(">1</text>") && svg.contains("a &amp; b"));
}

#[test]
fn a_cube_shows_three_faces() {
    let svg = sheet(Panel::Cubes(vec![Cube { lower: [0.0; 3], side: 1.0 }]));
    assert_eq!(svg.matches("<path fill=\"#").count(), 3);
    // The face towards small y is right of the face towards large x's left edge: both share the edge above (1, 0).
    assert!(!svg.contains("NaN"));
}

#[test]
fn long_text_says_how_much_is_left_out() {
    let svg = sheet(Panel::Text("(".repeat(128 * 16 + 7)));
    assert!(svg.contains(".. and 7 more"));
}
