use super::*;

fn class(dimension: usize, birth: f64, death: Option<f64>) -> Class {
    Class { dimension, birth, death }
}

/// The numbers of an attribute, element by element.
fn attributes(svg: &str, element: &str, name: &str) -> Vec<f64> {
    let parts = svg.split(element).skip(1);
    let number = |part: &str| {
        let rest = part.split_once(&format!(" {name}=\"")).unwrap().1;
        rest.split_once('"').unwrap().0.parse().unwrap()
    };
    parts.map(number).collect()
}

#[test]
fn points_are_above_the_diagonal_and_what_never_dies_is_at_the_top() {
    let classes = [class(0, 0.0, None), class(1, 1.0, Some(10.0)), class(1, -3.0, Some(1e300))];
    let svg = barcode("three", &classes);
    let across = attributes(&svg, "class=\"point\"", "cx");
    let down = attributes(&svg, "class=\"point\"", "cy");
    assert_eq!(across.len(), 3);
    let left = LEFT + SIDE + 72.0;
    for (x, y) in across.iter().zip(&down) {
        assert!(x - left < TOP + SIDE - y, "{x} {y}");
    }
    assert!((down.iter().copied().fold(f64::INFINITY, f64::min) - TOP).abs() < 0.01);
    assert!(!svg.contains("NaN") && !svg.contains("inf\""));
}

#[test]
fn the_longest_bars_are_kept() {
    let mut classes: Vec<Class> = (1..=1000).map(|i| class(1, 1.0, Some(1.0 + real(i)))).collect();
    classes.push(class(0, 0.0, None));
    let svg = barcode("many", &classes);
    assert_eq!(svg.matches("class=\"bar\"").count(), BARS_MAX / 2 + 1, "half for each dimension");
    assert!(svg.contains("the 101 longest of 1001 bars"));
    assert!(svg.contains(&format!("M{LEFT} ")), "the one that never dies begins at the edge");
}

#[test]
fn betti_numbers_step_at_their_radii() {
    let svg = betti_curves("steps", &[0.0, 1.0, 2.0], &[vec![9, 0], vec![1, 1], vec![1, 0]]);
    assert_eq!(svg.matches("class=\"betti\"").count(), 2);
    let up = |count: f64| Short(TOP + SIDE * (1.0 - (count + 1.0).log10())).to_string();
    let first = svg.split("class=\"betti\"").nth(1).unwrap();
    assert!(first.contains(&format!("V{}", up(9.0))) && first.contains(&format!("V{}", up(1.0))));
    let second = svg.split("class=\"betti\"").nth(2).unwrap();
    assert_eq!(second.matches(&format!("V{}", up(1.0))).count(), 1);
    for empty in [betti_curves("", &[], &[]), barcode("", &[])] {
        assert!(empty.ends_with("</svg>\n") && !empty.contains("NaN"));
    }
}
