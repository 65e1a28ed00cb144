//! The collected files: every closed drawing a quadtree, every closed surface an octree. Skipped, said aloud, where there are
//! none.
//!
//! Without `DELONE_LONG=1` no drawing of more than 2,000 segments is taken, no surface of more than 2,000 faces.

use std::collections::BTreeMap;

use delone::formats::Document;
use delone::predicates::Dyadic;
use delone::trees::{Joined, OrthTree, Rule, Solid};
use delone_tests::data::{documents, files};
use delone_tests::laws::trees::{Drawn, obey_in_space, obeyed};
use delone_tests::scipy::Labels;
use delone_tests::{long, say};

use crate::{is_closed, solid_trees};

fn pieces_max() -> usize {
    if long() { usize::MAX } else { 2_000 }
}

/// The levels of trees of files.
const PLANE: u8 = 7;
const SPACE: u8 = 4;

fn drawing(document: &Document, labels: &mut Labels) -> &'static str {
    let Ok(points) = document.points_2d() else { return "in space" };
    let segments: Vec<[usize; 2]> =
        document.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
    if segments.is_empty() {
        return "without segments";
    }
    if segments.len() > pieces_max() {
        return "too long";
    }
    let drawn = Drawn { points, segments: &segments, rule: Rule::EvenOdd, depth: PLANE };
    if !is_closed(&drawn) {
        return "open";
    }
    let Some(trees) = obeyed(&drawn) else { return "too fine for doubles" };
    labels.add(&document.name, &trees[1], Joined::ByFacets);
    labels.add(&document.name, &trees[1], Joined::AtCorners);
    "closed: every law held"
}

fn surface(document: &Document, labels: &mut Labels) -> &'static str {
    let Ok(points) = document.points_3d() else { return "in the plane" };
    if document.triangles.is_empty() || !document.polygons.is_empty() {
        return "not of triangles";
    }
    if document.triangles.len() > pieces_max() {
        return "too long";
    }
    let faces: Vec<[usize; 3]> =
        document.triangles.iter().map(|face| face.map(|v| v as usize)).collect();
    let Ok(solid) = Solid::new(points, &faces, Rule::EvenOdd) else { return "open" };
    let Some(trees) = solid_trees(&solid, SPACE) else { return "too fine for doubles" };
    obey_in_space(&trees);
    labels.add(&document.name, &trees[1], Joined::ByFacets);
    labels.add(&document.name, &trees[1], Joined::AtCorners);
    // Where the surface does not meet itself, both rules agree, and the volume is the sum of signed tetrahedra.
    let Ok(winding) = Solid::new(points, &faces, Rule::NonZero) else {
        return "closed, but not oriented: every law held";
    };
    if solid_trees(&winding, SPACE).as_ref() != Some(&trees) {
        return "closed, meets itself: every law held";
    }
    let frame = solid.frame(SPACE).expect("as before");
    let r = Dyadic::from(frame.resolution());
    let unit = &(&(&r * &r) * &r) * &Dyadic::from(6);
    let volume = |tree: &OrthTree<3>| {
        let cells = tree.volume(SPACE).expect("no leaf is smaller");
        &unit * &Dyadic::from(i64::try_from(cells).expect("trees are small"))
    };
    let mut exact = Dyadic::from(0);
    for [a, b, c] in faces.iter().map(|face| face.map(|v| points[v].map(Dyadic::from))) {
        for (i, j, k) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
            exact += &(&a[i] * &(&b[j] * &c[k] - &b[k] * &c[j]));
        }
    }
    if exact < Dyadic::from(0) {
        exact = -exact;
    }
    let brackets = volume(&trees[0]) <= exact && exact <= volume(&trees[2]);
    assert!(brackets, "{}: the volume is between", document.name);
    "closed and oriented: every law held, volume between"
}

fn all(part: &str, each: fn(&Document, &mut Labels) -> &'static str) {
    let mut tally: BTreeMap<&str, usize> = BTreeMap::new();
    let mut labels = Labels::default();
    for document in files(part).iter().flat_map(|path| documents(path)) {
        *tally.entry(each(&document, &mut labels)).or_default() += 1;
    }
    let compared = labels.compare().unwrap_or(0);
    say(format!("{part}: {tally:?}, {compared} labellings are scipy's"));
}

#[test]
fn quadtrees_of_drawings() {
    all("pslg", drawing);
}

#[test]
fn octrees_of_surfaces() {
    all("plc", surface);
}
