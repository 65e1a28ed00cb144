//! A million cells. Run in release, timed from outside.

use super::*;
use crate::testing::kuhn_grid;

fn million(input: &Owned<2>, filtered: bool) {
    let options = Options { filtered, ..Options::default() };
    let verdict = judge_delaunay(&input.complex(), &options);
    assert!(verdict.ok && verdict.level == Level::Delaunay, "{verdict}");
}

#[test]
#[ignore = "a million triangles: run it in release"]
fn million_on_a_grid() {
    million(&square_grid(707), true);
}

#[test]
#[ignore = "a million triangles: run it in release"]
fn million_on_a_grid_unfiltered() {
    million(&square_grid(707), false);
}

#[test]
#[ignore = "a million triangles: run it in release"]
fn million_jittered() {
    million(&jittered(707, 38), true);
}

#[test]
#[ignore = "a million triangles: run it in release"]
fn million_jittered_unfiltered() {
    million(&jittered(707, 38), false);
}

#[test]
#[ignore = "a million tetrahedra: run it in release"]
fn million_in_space() {
    let verdict = judge_delaunay(&kuhn_grid(55).complex(), &Options::foreign());
    assert!(verdict.ok && verdict.level == Level::WeaklyDelaunay, "{verdict}");
}
