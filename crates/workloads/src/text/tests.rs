use std::collections::BTreeSet;

use super::*;

type Line = [[u32; 2]; 2];

fn lines(character: char) -> Vec<Line> {
    let chains = strokes::chains(character).unwrap();
    chains.flat_map(|chain| chain.windows(2).map(|w| [w[0], w[1]]).collect::<Vec<_>>()).collect()
}

fn turn([a, b]: Line, c: [u32; 2]) -> i64 {
    let d = |p: [u32; 2], axis: usize| i64::from(p[axis]) - i64::from(a[axis]);
    (d(b, 0) * d(c, 1) - d(b, 1) * d(c, 0)).signum()
}

fn is_inside([a, b]: Line, p: [u32; 2]) -> bool {
    let between = |axis: usize| (a[axis].min(b[axis])..=a[axis].max(b[axis])).contains(&p[axis]);
    turn([a, b], p) == 0 && p != a && p != b && between(0) && between(1)
}

/// A planar straight-line graph each: no crossing, no end inside a line, no line twice.
#[test]
fn glyphs_are_planar_and_in_their_frame() {
    for character in '!'..='~' {
        let all = lines(character);
        assert!(!all.is_empty(), "{character}");
        for (i, &[a, b]) in all.iter().enumerate() {
            assert!(a != b && a[0].max(b[0]) <= 4 && a[1].max(b[1]) <= 9, "{character}");
            for &[c, d] in &all[..i] {
                assert!([a, b] != [c, d] && [a, b] != [d, c], "{character}");
                let ends = [is_inside([a, b], c), is_inside([a, b], d)];
                let ends = ends.into_iter().chain([is_inside([c, d], a), is_inside([c, d], b)]);
                assert!(ends.into_iter().all(|inside| !inside), "{character}");
                let crosses =
                    turn([a, b], c) * turn([a, b], d) < 0 && turn([c, d], a) * turn([c, d], b) < 0;
                assert!(!crosses, "{character}");
            }
        }
    }
}

#[test]
fn no_two_glyphs_are_alike() {
    let sorted = |character| {
        let mut all: Vec<Line> = lines(character);
        all.iter_mut().for_each(|line| line.sort_unstable());
        all.sort_unstable();
        all
    };
    assert_eq!((' '..='~').map(sorted).collect::<BTreeSet<_>>().len(), 95);
}

#[test]
fn lines_are_aligned_and_turned() {
    let x = |align, text| {
        let layout = Layout { align, ..Layout::default() };
        let svg = strokes(text, &layout).unwrap();
        let last = svg.rfind("translate(").unwrap();
        svg[last + 10..].split(')').next().unwrap().to_owned()
    };
    let found = [Align::Left, Align::Centre, Align::Right].map(|align| x(align, "abc\nd"));
    assert_eq!(found, ["0 1000", "600 1000", "1200 1000"]);
    let spaced = strokes("ab", &Layout { spacing: 50, ..Layout::default() }).unwrap();
    assert!(spaced.contains("translate(650 0)") && spaced.contains("viewBox=\"0 0 1250 1000\""));
    let turned = strokes("ab", &Layout { angle: 90.0, ..Layout::default() }).unwrap();
    assert!(turned.contains("rotate(-90)"));
    let frame = turned.split("viewBox=\"").nth(1).unwrap().split('"').next().unwrap();
    let frame: Vec<f64> = frame.split(' ').map(|number| number.parse().unwrap()).collect();
    for (found, expected) in frame.iter().zip([0.0, -1200.0, 1000.0, 1200.0]) {
        assert!((found - expected).abs() < 1e-9, "{frame:?}");
    }
}

#[test]
fn what_is_not_drawn_is_named() {
    let layout = Layout::default();
    let error = strokes("a\u{e9}", &layout).unwrap_err();
    assert_eq!(error.character, '\u{e9}');
    assert!(strokes("\t", &layout).is_err() && outlines("Lx", &layout).is_err());
    assert!(error.to_string().contains("printable"));
}
