//! Points of the plane.

use super::{HUGE, TINY, real};
use crate::case::Case;

/// All of them.
#[must_use]
pub fn plane() -> Vec<Case<2>> {
    let mut cases = few();
    cases.extend(in_line());
    cases.extend(cocircular());
    cases.extend(at_the_ends_of_the_range());
    cases
        .into_iter()
        .map(|(name, points)| Case::of_points(format!("hand {name}"), points))
        .collect()
}

type Named = (&'static str, Vec<[f64; 2]>);

fn few() -> Vec<Named> {
    vec![
        ("no point", vec![]),
        ("one point", vec![[1.0, 2.0]]),
        ("one point thrice", vec![[1.0, 2.0]; 3]),
        ("zeros of both signs", vec![[0.0, -0.0], [-0.0, 0.0], [1.0, 0.0], [-0.0, 1.0]]),
        ("two points", vec![[1.0, 2.0], [1.0, 1.0]]),
        ("a triangle", vec![[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]]),
        ("a triangle twice", [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]].repeat(2)),
        ("a site on a hull edge", vec![[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 0.0], [2.0, 2.0]]),
        ("beyond a hull edge, in line", vec![[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [5.0, 0.0]]),
    ]
}

fn in_line() -> Vec<Named> {
    let on = |f: fn(i32) -> [f64; 2]| [3, 0, 4, 1, 7, 2].map(f).to_vec();
    let mut late = on(|i| [real(i), real(2 * i)]);
    late.push([1.0, 0.0]);
    let mut early = vec![[-5.0, 100.0]];
    early.extend(on(|i| [real(i), 0.0]));
    vec![
        ("horizontal", on(|i| [real(i), 1.0])),
        ("vertical", on(|i| [1.0, real(i)])),
        ("slanted", on(|i| [real(i), real(3 * i)])),
        ("in line but the last", late),
        ("in line but the first", early),
        ("in line over the whole range", vec![[-HUGE, 0.0], [TINY, 0.0], [0.0, 0.0], [HUGE, 0.0]]),
        ("two lines", (0..10).map(|i| [real(i / 2), real(i % 2 * 3)]).collect()),
        ("a cross", (-4..=4).flat_map(|i| [[real(i), 0.0], [0.0, real(i)]]).collect()),
        ("nearly in line", (0..9).map(|i| [real(i) * 0.1, real(i) * 0.3]).collect()),
    ]
}

/// The integer points at this squared distance from the origin.
fn on_circle(square: i32) -> Vec<[f64; 2]> {
    let range = || -40..=40i32;
    let all = range().flat_map(|x| range().map(move |y| (x, y)));
    all.filter(|(x, y)| x * x + y * y == square).map(|(x, y)| [real(x), real(y)]).collect()
}

fn cocircular() -> Vec<Named> {
    let mut centred = on_circle(325);
    centred.push([0.0, 0.0]);
    let rings = [25, 65, 325, 1105].map(on_circle).concat();
    let grid =
        |n: i32| -> Vec<[f64; 2]> { (0..n * n).map(|i| [real(i / n), real(i % n)]).collect() };
    vec![
        ("a square", grid(2)),
        ("a grid", grid(5)),
        ("twelve cocircular points", on_circle(25)),
        ("32 cocircular points", on_circle(1105)),
        ("cocircular points and their centre", centred),
        ("four rings", rings),
        ("a rhombus of equal triangles", vec![[0.0, 0.0], [2.0, 1.0], [4.0, 0.0], [2.0, -1.0]]),
    ]
}

fn at_the_ends_of_the_range() -> Vec<Named> {
    let square = |s: f64| vec![[s, s], [-s, s], [s, -s], [-s, -s], [0.0, 0.0]];
    let scale = |i: i32| crate::exact::power_of_two(-1074 + 139 * i);
    vec![
        ("the largest square", square(HUGE)),
        ("the smallest square", square(TINY)),
        ("a triangle of denormals", vec![[0.0, 0.0], [TINY, 0.0], [0.0, TINY]]),
        ("both ends", [square(HUGE), square(TINY)].concat()),
        ("every scale", (0..15).map(|i| [scale(i), real(i % 3) * scale(i)]).collect()),
        ("a needle", vec![[-HUGE, -HUGE], [HUGE, HUGE], [0.0, TINY], [TINY, 0.0]]),
        (
            "one ulp inside a circle",
            vec![[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, (-1f64).next_up()], [0.0, -1.0]],
        ),
    ]
}
