//! The collected files: valid, independent of order, and CGAL's. Skipped, said aloud, where there are none.
//!
//! No input of more than 200,000 points is taken; without `DELONE_LONG=1`, none in space of more than 12,000.

use std::collections::BTreeMap;
use std::time::Instant;

use delone::cdt::cavity;
use delone::delaunay::{Options, delaunay};
use delone_tests::case::Case;
use delone_tests::cgal::Cgal;
use delone_tests::data::{documents, files, points_of, pslg_of};
use delone_tests::judge::{Rigour, accept_constrained, accept_delaunay};
use delone_tests::{long, say};

use crate::equals_cgal;
use crate::workloads::constrained_equals_cgal;

/// What became of the inputs.
#[derive(Default)]
struct Tally(BTreeMap<&'static str, usize>);

impl Tally {
    fn count(&mut self, what: &'static str) {
        *self.0.entry(what).or_default() += 1;
    }
}

/// The most points taken.
fn points_max(dimension: usize) -> usize {
    match (long(), dimension) {
        (false, 3) => 12_000,
        _ => 200_000,
    }
}

fn check_points<const D: usize>(case: &Case<D>, cgal: Option<&mut Cgal>, tally: &mut Tally) {
    let start = Instant::now();
    let sites = case.sites();
    let ours = delaunay(&sites, &Options::default(), &mut ());
    accept_delaunay(case, &sites, &ours, Rigour::Once);
    let print = ours.fingerprint(&sites);
    for seed in 1..=3 {
        let shuffled = case.shuffled(seed);
        let sites = shuffled.sites();
        let other = delaunay(&sites, &Options::default(), &mut ());
        assert_eq!(other.fingerprint(&sites), print, "{}", shuffled.name);
    }
    tally.count("valid in four orders");
    if let Some(cgal) = cgal {
        let answered = equals_cgal(&case.name, sites.points(), &ours, cgal);
        tally.count(if answered { "equal to CGAL's" } else { "refused by CGAL" });
    }
    slow(&case.name, case.points.len(), start);
}

fn slow(name: &str, points: usize, start: Instant) {
    let seconds = start.elapsed().as_secs_f64();
    if seconds > 5.0 {
        say(format!("{seconds:.0} s: {name}, {points} points"));
    }
}

fn check_folder<const D: usize>(folder: &str) {
    let (mut cgal, mut tally) = (Cgal::start(), Tally::default());
    for path in files(folder) {
        for document in documents(&path) {
            match points_of::<D>(&document) {
                Some(case) if case.points.len() <= points_max(D) => {
                    check_points(&case, cgal.as_mut(), &mut tally);
                }
                Some(_) => tally.count("too large for the short test"),
                None => tally.count("of another dimension, or not finite"),
            }
        }
    }
    say(format!("{folder}: {:?}", tally.0));
}

#[test]
fn points_of_the_plane() {
    check_folder::<2>("points2d");
}

#[test]
fn points_of_space() {
    check_folder::<3>("points3d");
}

#[test]
fn graphs() {
    let (mut cgal, mut tally) = (Cgal::start(), Tally::default());
    for path in files("pslg") {
        for document in documents(&path) {
            match pslg_of(&document) {
                Some(case) if case.points.len() <= points_max(2) => {
                    check_graph(&case, cgal.as_mut(), &mut tally);
                }
                Some(_) => tally.count("too large for the short test"),
                None => tally.count("of another dimension, or not finite"),
            }
        }
    }
    say(format!("pslg: {:?}", tally.0));
}

fn check_graph(case: &Case<2>, cgal: Option<&mut Cgal>, tally: &mut Tally) {
    let start = Instant::now();
    let Some(pslg) = case.try_pslg() else {
        return tally.count("refused: segments cross");
    };
    let ours = cavity(&pslg, &Options::default(), &mut ());
    accept_constrained(case, &pslg, &ours, Rigour::Once);
    tally.count("valid");
    if let Some(cgal) = cgal {
        let answered = constrained_equals_cgal(case, cgal);
        tally.count(if answered { "equal to CGAL's" } else { "refused by CGAL" });
    }
    slow(&case.name, case.points.len(), start);
}
