//! Laws x corpus: every law of `delone_tests::laws` on every input. The laws walk the registries of algorithms.
//!
//! Each test tells how often each law was tried: a law that skips everything (scaling that is never exact) proves nothing,
//! and fails here.

use std::collections::BTreeMap;

use delone_tests::case::Case;
use delone_tests::corpus::{Size, graphs, plane, pslgs, space};
use delone_tests::laws::{Law, constrained_laws, delaunay_laws};
use delone_tests::say;

fn hold_all<const D: usize>(laws: &[Law<D>], cases: &[Case<D>]) {
    assert!(!cases.is_empty(), "the corpus is there");
    let mut tried: BTreeMap<&str, usize> = BTreeMap::new();
    for law in laws {
        let count: usize = cases.iter().map(|case| (law.hold)(case)).sum();
        tried.insert(law.name, count);
    }
    say(format!("{} inputs: {tried:?}", cases.len()));
}

fn never_idle<const D: usize>(laws: &[Law<D>], cases: &[Case<D>]) {
    for law in laws {
        let count: usize = cases.iter().map(|case| (law.hold)(case)).sum();
        assert!(count > 0, "no input of {} tries `{}`", cases.len(), law.name);
    }
}

#[test]
fn small_point_sets_of_the_plane() {
    hold_all(&delaunay_laws::<2>(), &plane(Size::Small));
}

#[test]
fn middle_point_sets_of_the_plane() {
    hold_all(&delaunay_laws::<2>(), &plane(Size::Middle));
}

#[test]
fn small_point_sets_of_space() {
    hold_all(&delaunay_laws::<3>(), &space(Size::Small));
}

#[test]
fn middle_point_sets_of_space() {
    hold_all(&delaunay_laws::<3>(), &space(Size::Middle));
}

#[test]
fn small_graphs() {
    hold_all(&constrained_laws(), &pslgs(Size::Small));
}

#[test]
fn middle_graphs() {
    hold_all(&constrained_laws(), &pslgs(Size::Middle));
}

#[test]
fn every_law_has_an_input_that_tries_it() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 2.0]];
    let cube: Vec<[f64; 3]> = (0..8u8).map(|i| [i / 4, i / 2 % 2, i % 2].map(f64::from)).collect();
    never_idle(&delaunay_laws::<2>(), &[Case::of_points("square", square.to_vec())]);
    never_idle(&delaunay_laws::<3>(), &[Case::of_points("cube", cube)]);
    never_idle(&constrained_laws(), &[Case::new("square", square.to_vec(), vec![[0, 2]])]);
}

/// What is refused is refused for crossings, in every order of the input, and the rest passes.
#[test]
fn crossings_are_refused_in_every_order() {
    let (mut refused, mut taken) = (0, 0);
    for case in graphs(Size::Small).into_iter().chain(graphs(Size::Middle)) {
        let passes = case.try_pslg().is_some();
        for seed in 1..=3 {
            assert_eq!(case.shuffled(seed).try_pslg().is_some(), passes, "{}", case.name);
        }
        *(if passes { &mut taken } else { &mut refused }) += 1;
    }
    assert!(refused > 5 && taken > 50, "{refused} refused, {taken} taken");
}
