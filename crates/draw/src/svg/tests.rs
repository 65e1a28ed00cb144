use super::{Aspect, Dots, Picture, Style};
use roxmltree::Document;

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
const HALVES: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

fn square() -> Picture<'static> {
    Picture { points: &SQUARE, triangles: &HALVES, segments: &[[0, 2]], ..Picture::default() }
}

fn numbered() -> Style {
    Style {
        numbered: true,
        circumcircles: true,
        title: "a <b> & \"c\"".to_owned(),
        ..Style::default()
    }
}

/// Every number of every path and attribute lies in a picture's neighbourhood: no NaN, no infinity, no overflow.
fn assert_sane(svg: &str) {
    let document = Document::parse(svg).unwrap();
    for node in document.descendants().filter(|node| node.is_element()) {
        for attribute in node.attributes() {
            let value = attribute.value();
            assert!(!value.contains("NaN") && !value.contains("inf"), "{value}");
            if attribute.name() == "d" {
                let numbers =
                    value.split(['M', 'L', 'Z', 'h', ' ']).filter(|text| !text.is_empty());
                numbers.for_each(|text| {
                    let x: f64 = text.parse().unwrap();
                    assert!((0.0..=20_000.0).contains(&x), "{x}");
                });
            }
        }
    }
}

fn path<'d>(document: &'d Document<'_>, class: &str) -> Option<&'d str> {
    let node = document.descendants().find(|node| node.attribute("class") == Some(class))?;
    node.attribute("d")
}

#[test]
fn a_square_has_five_edges_and_y_points_up() {
    let svg = square().svg(&Style { size: 128.0, ..Style::default() });
    assert_sane(&svg);
    let document = Document::parse(&svg).unwrap();
    let edges = path(&document, "edge").unwrap();
    assert_eq!(edges.matches('M').count(), 5);
    assert!(edges.starts_with("M14 114L114 114"), "bottom edge at the bottom: {edges}");
    assert_eq!(path(&document, "segment"), Some("M14 114L114 14"));
    assert_eq!(path(&document, "site").unwrap().matches('M').count(), 4);
}

#[test]
fn the_title_is_escaped_and_numbers_are_there() {
    let svg = square().svg(&numbered());
    assert_sane(&svg);
    let document = Document::parse(&svg).unwrap();
    let title = document.descendants().find(|node| node.has_tag_name("title")).unwrap();
    assert_eq!(title.text(), Some("a <b> & \"c\""));
    let numbers: Vec<_> = document.descendants().filter(|n| n.has_tag_name("text")).collect();
    assert_eq!(numbers.len(), 6);
}

#[test]
fn fills_highlights_and_marks_have_their_layers() {
    let picture = Picture { classes: &[0, 9], highlights: &[[1, 3]], marked: &[2], ..square() };
    let svg = picture.svg(&Style { dots: Dots::None, ..Style::default() });
    let document = Document::parse(&svg).unwrap();
    assert!(path(&document, "fill fill0").is_some(), "class 9 takes the first turn again");
    assert_eq!(svg.matches("class=\"fill ").count(), 1, "class 0 is empty");
    assert!(path(&document, "highlight").is_some() && path(&document, "marked").is_some());
    assert!(path(&document, "site").is_none());
}

#[test]
fn extreme_coordinates_make_ordinary_pictures() {
    let sizes = [5e-324, 1e-310, 1e-300, 1.0, 1e300, f64::MAX];
    for wide in sizes {
        for high in sizes {
            for aspect in [Aspect::Auto, Aspect::Equal, Aspect::Stretched] {
                let points = SQUARE.map(|[x, y]| [wide * (x - 0.5) * 2.0, high * (0.5 - y) * 2.0]);
                let picture = Picture { points: &points, ..square() };
                assert_sane(&picture.svg(&Style { aspect, ..numbered() }));
            }
        }
    }
}

#[test]
fn a_thin_strip_is_stretched_and_says_so() {
    let points = SQUARE.map(|[x, y]| [x, y * 1e-300]);
    let picture = Picture { points: &points, ..square() };
    assert!(picture.svg(&Style::default()).contains("stretched"));
    assert!(
        !picture.svg(&Style { aspect: Aspect::Equal, ..Style::default() }).contains("stretched")
    );
    assert!(!square().svg(&Style::default()).contains("stretched"));
}

#[test]
fn nothing_one_site_and_equal_sites() {
    for points in [&[][..], &[[3.0, 4.0]], &[[0.1, 0.2]; 5], &[[0.0, 1.0], [5.0, 1.0]]] {
        let picture = Picture { points, ..Picture::default() };
        assert_sane(&picture.svg(&numbered()));
        assert_sane(&picture.svg(&Style { size: f64::NAN, ..Style::default() }));
    }
}

#[test]
fn what_cannot_be_drawn_is_left_out_and_counted() {
    let points = [[0.0, 0.0], [f64::NAN, 1.0], [1.0, f64::INFINITY], [1.0, 1.0]];
    let picture = Picture {
        points: &points,
        triangles: &[[0, 1, 3], [0, 3, 9]],
        segments: &[[0, 3], [0, 4_000_000_000]],
        marked: &[77],
        ..Picture::default()
    };
    let svg = picture.svg(&numbered());
    assert_sane(&svg);
    assert!(svg.contains("6 elements left out"), "{svg}");
}

#[test]
fn the_same_picture_is_the_same_bytes() {
    let mut out = Vec::new();
    square().write_svg(&numbered(), &mut out).unwrap();
    assert_eq!(out, square().svg(&numbered()).into_bytes());
}

#[test]
fn edges_are_numbered_in_order() {
    let svg = square().svg(&Style { edges_numbered: true, ..Style::default() });
    assert_sane(&svg);
    let document = Document::parse(&svg).unwrap();
    let group = document.descendants().find(|n| n.attribute("class") == Some("edgenumber"));
    let numbers: Vec<&str> = group.unwrap().children().filter_map(|n| n.text()).collect();
    assert_eq!(numbers, ["0", "1", "2", "3", "4"]);
}

#[test]
fn exploded_triangles_share_nothing() {
    let exploded = super::Exploded::new(&square(), 1.5);
    let picture = exploded.picture();
    assert_eq!(
        (picture.points.len(), picture.triangles, picture.segments.len()),
        (6, &[[0, 1, 2], [3, 4, 5]][..], 2)
    );
    // The diagonal is there twice, apart by half of the distance of the centroids, which is (1/3, -1/3).
    let [p, q] = [picture.segments[0], picture.segments[1]].map(|ends| {
        let [p, q] = ends.map(|v| picture.points[v as usize]);
        [p[0] + q[0], p[1] + q[1]].map(|x| x / 2.0)
    });
    let gap = [p[0] - q[0], p[1] - q[1]];
    assert!(gap.iter().zip([1.0 / 6.0, -1.0 / 6.0]).all(|(x, y)| (x - y).abs() < 1e-12), "{gap:?}");
    assert_sane(&picture.svg(&Style::default()));
    let huge = SQUARE.map(|p| p.map(|x| if x > 0.0 { f64::MAX } else { -f64::MAX }));
    let exploded = super::Exploded::new(&Picture { points: &huge, ..square() }, 2.0);
    assert!(exploded.picture().points.as_flattened().iter().all(|x| x.is_finite()));
}

#[test]
fn panels_stand_in_rows_of_two() {
    let style = |title: &str| Style { title: title.to_owned(), size: 200.0, ..Style::default() };
    let three = ["a < b", "c", "d"].map(|title| (square(), style(title)));
    let sheet = super::panels(&three);
    let document = Document::parse(&sheet).unwrap();
    let places: Vec<[f64; 2]> = document
        .root_element()
        .children()
        .filter(|n| n.has_tag_name("svg"))
        .map(|n| ["x", "y"].map(|name| n.attribute(name).unwrap().parse().unwrap()))
        .collect();
    assert_eq!(places, [[0.0, 26.0], [200.0, 26.0], [0.0, 252.0]]);
}

#[test]
fn regions_are_outlines_and_the_picture_is_as_large_as_they_ask() {
    let regions = [
        vec![[-1.0, -1.0], [2.0, -1.0], [2.0, 2.0], [-1.0, 2.0]],
        vec![[0.0, 0.0], [f64::NAN, 0.0], [1.0, 1.0]],
    ];
    let text = Picture { regions: &regions, ..square() }.svg(&Style::default());
    let document = Document::parse(&text).unwrap();
    let d = path(&document, "region").unwrap();
    assert_eq!(d.matches('M').count(), 1);
    assert!(d.starts_with("M14 786L786 786L786 14"), "from edge to edge of the picture: {d}");
    assert!(text.contains("1 elements left out"), "{text}");
}
