//! Some tens of thousands of cells: sizes at which a quadratic check would be felt.

use super::*;
use crate::testing::kuhn_grid;

fn many(input: &Owned<2>, filtered: bool) {
    let options = Options { filtered, ..Options::default() };
    let verdict = judge_delaunay(&input.complex(), &options);
    assert!(verdict.ok && verdict.level == Level::Delaunay, "{verdict}");
}

#[test]
fn many_on_a_grid() {
    many(&square_grid(100), true);
}

#[test]
fn many_on_a_grid_unfiltered() {
    many(&square_grid(100), false);
}

#[test]
fn many_jittered() {
    many(&jittered(100, 38), true);
}

#[test]
fn many_jittered_unfiltered() {
    many(&jittered(100, 38), false);
}

#[test]
fn many_in_space() {
    let verdict = judge_delaunay(&kuhn_grid(12).complex(), &Options::foreign());
    assert!(verdict.ok && verdict.level == Level::WeaklyDelaunay, "{verdict}");
}
