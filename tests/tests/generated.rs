//! All laws on generated inputs: the fuzzer's own targets and cases, so that what fails here fails there by the same number.
//! What fails is told with the smallest input that still does.
//!
//! `DELONE_CASES` says how many of each, `DELONE_SEED` which.

use delone::cdt::algorithms;
use delone::delaunay::Options;
use delone::workloads::Rng;
use delone_laws::fuzz::{Broken, Input, Subject, target};
use delone_laws::{Effort, generate};
use delone_tests::number;

fn seed() -> u64 {
    number("DELONE_SEED").unwrap_or(1)
}

fn count(cases: u64) -> u64 {
    number("DELONE_CASES").unwrap_or(cases)
}

/// Demands the laws of a target of this many cases.
fn hold(name: &str, cases: u64) {
    let target = target(name).expect("there is such a target");
    for k in 0..count(cases) {
        let input = target.case(seed(), k);
        let Err(broken) = (&target).try_on(&input) else { continue };
        let same = |other: &Broken| (&other.law, &other.place) == (&broken.law, &broken.place);
        let small = input.shrunk(&mut Effort::default(), |input: &Input| {
            (&target).try_on(input).is_err_and(|other| same(&other))
        });
        let again = format!("delone fuzz {name} --seed {} --case {k}", seed());
        panic!("{broken}\nagain: {again}\nsmallest: {small:?}");
    }
}

#[test]
fn point_sets_of_the_plane() {
    hold("delaunay-2d", 400);
}

#[test]
fn point_sets_of_space() {
    hold("delaunay-3d", 250);
}

#[test]
fn laws_of_graphs() {
    hold("cdt", 400);
}

#[test]
fn crossing_segments() {
    hold("crossings", 200);
}

#[test]
fn domain_trees() {
    hold("trees-2d", 200);
    hold("trees-3d", 200);
}

#[test]
fn predicates() {
    hold("predicates-2d", 400);
    hold("predicates-3d", 400);
}

/// The law that matters most, alone, so that a million graphs take minutes.
#[test]
fn algorithms_agree_on_graphs() {
    let algorithms = algorithms();
    for k in 0..count(1000) {
        let case = generate::graph(&mut Rng::named("agree", seed() ^ k << 20));
        let pslg = case.pslg();
        let mut results =
            algorithms.iter().map(|algorithm| (algorithm.run)(&pslg, &Options::default()));
        let first = results.next().expect("there is an algorithm");
        for (other, algorithm) in results.zip(&algorithms[1..]) {
            let which = format!("{} {k}: {case:?}", algorithm.name);
            assert_eq!(other.canonical(), first.canonical(), "{which}");
            assert_eq!(other.constrained_edges(), first.constrained_edges(), "{which}");
        }
    }
}
