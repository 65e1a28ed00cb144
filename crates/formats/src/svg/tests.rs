use crate::format::Format;
use crate::testing::{read_named, refusal};

fn svg(body: &str) -> crate::Document {
    read_named("a.svg", &format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{body}</svg>"))
}

#[test]
fn subpaths_are_rings_or_lines() {
    let document = svg("<path d='M 0 0 L 4 0 0 4 Z M 9 9 l 1 0'/>");
    assert_eq!(document.segments, [[0, 1], [1, 2], [2, 0], [3, 4]]);
    assert_eq!(document.points, [0.0, 0.0, 4.0, 0.0, 0.0, 4.0, 9.0, 9.0, 10.0, 9.0]);
}

#[test]
fn shapes_and_transforms() {
    let document =
        svg("<g transform='translate(10)'><rect width='1' height='2' transform='scale(2)'/></g>");
    assert_eq!(document.points, [10.0, 0.0, 12.0, 0.0, 12.0, 4.0, 10.0, 4.0]);
    assert_eq!(svg("<polygon points='0,0 1,0 0,1'/>").segments.len(), 3);
    assert_eq!(svg("<polyline points='0,0 1,0 0,1'/>").segments.len(), 2);
    assert_eq!(svg("<line x2='1' y2='1'/>").segments.len(), 1);
    assert_eq!(svg("<circle r='1'/>").notes.len(), 1);
}

#[test]
fn curves_take_eight_steps() {
    assert_eq!(svg("<path d='M0 0 Q 1 2 2 0 C 3 1 4 1 5 0'/>").segments.len(), 16);
}

#[test]
fn damaged_paths_are_refused() {
    assert!(
        refusal(Format::Svg, "<svg>\n<path d='M 0 0 L x'/></svg>")
            .starts_with("t:2: expected SVG path data")
    );
}
