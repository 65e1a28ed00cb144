use std::collections::BTreeSet;

use proptest::prelude::*;

use super::{all_steps, facet_steps};
use crate::testing::raster;
use crate::{Colour, Joined, OrthTree, Raster};

type Place<const N: usize> = [i64; N];

fn step<const N: usize>(place: Place<N>, steps: [i8; N]) -> Place<N> {
    std::array::from_fn(|axis| place[axis] + i64::from(steps[axis]))
}

/// Flood fill.
fn pieces<const N: usize>(cells: &[Place<N>], steps: &[[i8; N]]) -> usize {
    let mut left: BTreeSet<Place<N>> = cells.iter().copied().collect();
    let mut count = 0;
    while let Some(seed) = left.pop_first() {
        count += 1;
        let mut pending = vec![seed];
        while let Some(place) = pending.pop() {
            pending.extend(steps.iter().map(|&s| step(place, s)).filter(|next| left.remove(next)));
        }
    }
    count
}

/// The faces of cells, at doubled coordinates: odd where the face spans the axis.
fn faces<const N: usize>(cells: &[Place<N>]) -> BTreeSet<Place<N>> {
    let around = |&cell: &Place<N>| {
        let centre = cell.map(|c| 2 * c + 1);
        all_steps::<N>().map(move |s| step(centre, s)).chain([centre])
    };
    cells.iter().flat_map(around).collect()
}

fn dimension<const N: usize>(face: &Place<N>) -> usize {
    face.iter().filter(|c| c.rem_euclid(2) == 1).count()
}

/// Faces counted one by one.
fn euler<const N: usize>(cells: &[Place<N>], joined: Joined) -> i64 {
    let set: BTreeSet<Place<N>> = cells.iter().copied().collect();
    let whole = |face: &Place<N>| {
        let mut cells_around = all_steps::<N>().chain([[0; N]]).map(|s| step(*face, s));
        cells_around.all(|at| dimension(&at) < N || set.contains(&at.map(|c| c.div_euclid(2))))
    };
    let sign = |k: usize| if k.is_multiple_of(2) { 1 } else { -1 };
    match joined {
        Joined::AtCorners => faces(cells).iter().map(|f| sign(dimension(f))).sum(),
        Joined::ByFacets => {
            faces(cells).iter().filter(|f| whole(f)).map(|f| sign(N - dimension(f))).sum()
        }
    }
}

fn measures_are_those_of_the_raster<const N: usize>(raster: &Raster<N>) {
    let tree = OrthTree::from_raster(raster);
    let cells: Vec<Place<N>> = raster.black().map(|place| place.map(i64::from)).collect();
    let set: BTreeSet<Place<N>> = cells.iter().copied().collect();
    let white =
        |cell: &Place<N>| facet_steps::<N>().filter(|&s| !set.contains(&step(*cell, s))).count();
    let surface: usize = cells.iter().map(white).sum();
    assert_eq!(tree.surface(raster.depth()), Some(surface as u128));
    let facets: Vec<_> = facet_steps::<N>().collect();
    let all: Vec<_> = all_steps::<N>().collect();
    assert_eq!(tree.components(Joined::ByFacets).count, pieces(&cells, &facets));
    assert_eq!(tree.components(Joined::AtCorners).count, pieces(&cells, &all));
    for joined in [Joined::ByFacets, Joined::AtCorners] {
        assert_eq!(tree.euler(joined), euler(&cells, joined));
    }
}

proptest! {
    #[test]
    fn measures_agree_with_the_raster(
        line in raster::<1>(6), plane in raster::<2>(4), space in raster::<3>(3), four in raster::<4>(1),
    ) {
        measures_are_those_of_the_raster(&line);
        measures_are_those_of_the_raster(&plane);
        measures_are_those_of_the_raster(&space);
        measures_are_those_of_the_raster(&four);
    }
}

#[test]
fn cells_at_a_corner_are_joined_as_asked() {
    let tree = OrthTree::<2>::from_text("(BWWB").unwrap();
    let counts = |joined| (tree.components(joined).count, tree.euler(joined));
    assert_eq!(counts(Joined::ByFacets), (2, 2));
    assert_eq!(counts(Joined::AtCorners), (1, 1));
}

#[test]
fn all_black_is_a_ball() {
    let ball = OrthTree::<3>::of(Colour::Black);
    assert_eq!((ball.euler(Joined::ByFacets), ball.euler(Joined::AtCorners)), (1, 1));
    assert_eq!((ball.surface(2), ball.volume(2)), (Some(6 * 16), Some(64)));
    let nothing = OrthTree::<3>::of(Colour::White);
    assert_eq!((nothing.euler(Joined::AtCorners), nothing.surface(2)), (0, Some(0)));
    assert_eq!(nothing.components(Joined::AtCorners).count, 0);
}

#[test]
fn a_level_above_a_black_leaf_has_no_measure() {
    let tree = OrthTree::<2>::from_text("(WWW(WBBW").unwrap();
    assert_eq!((tree.volume(1), tree.surface(1)), (None, None));
    assert_eq!((tree.volume(2), tree.surface(2)), (Some(2), Some(8)));
}
