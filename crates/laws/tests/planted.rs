//! A test of the fuzzer itself: faults planted in a small triangulator, each found within a stated number of cases, under each
//! of several seeds; and without a fault, nothing is found.

#[path = "planted/small.rs"]
mod small;

use delone::check::Options;
use delone_laws::case::Case;
use delone_laws::foreign::{is_solid, judged};
use delone_laws::fuzz::{Broken, Input, Target, attempt, target};
use delone_laws::{Effort, id};

use small::{Fault, triangulate};

/// Each fault, the target whose cases find it, and within how many.
const PLANTED: [(Fault, &str, u64); 18] = [
    (Fault::RoundedOrient, "delaunay-2d", 400),
    (Fault::RoundedInCircle, "delaunay-2d", 400),
    (Fault::ShortFilter, "delaunay-2d", 1000),
    (Fault::HullEdgeIgnored, "delaunay-2d", 200),
    (Fault::GhostsClosed, "delaunay-2d", 200),
    (Fault::FirstThree, "delaunay-2d", 200),
    (Fault::MergesNear, "delaunay-2d", 400),
    (Fault::Overflows, "delaunay-2d", 400),
    (Fault::FlushesDenormals, "delaunay-2d", 400),
    (Fault::SinglePrecision, "delaunay-2d", 400),
    (Fault::ZerosDiffer, "delaunay-2d", 2000),
    (Fault::TiesByIndex, "delaunay-2d", 200),
    (Fault::TiesInside, "delaunay-2d", 200),
    (Fault::LastOfSeven, "delaunay-2d", 200),
    (Fault::ThroughVertexLost, "cdt", 800),
    (Fault::FlipsConstraints, "cdt", 200),
    (Fault::NeverRestores, "cdt", 400),
    (Fault::SixSegments, "cdt", 400),
];

/// What a fault does to a case; nothing where there are no triangles to ask for.
fn failure(fault: Fault, input: &Input) -> Option<Broken> {
    let Input::Plane(case) = input else { panic!("these targets are in the plane") };
    if !is_solid(case) {
        return None;
    }
    let mut cells = Vec::new();
    let run = attempt("run", || {
        cells = cells_of(fault, case);
        1
    });
    run.and_then(|_| judged(case, &cells, &Options::default()).map(|()| 1)).err()
}

fn cells_of(fault: Fault, case: &Case<2>) -> Vec<u32> {
    triangulate(&case.points, &case.segments, fault).into_iter().flatten().map(id).collect()
}

/// The first case that shows a fault.
fn found(fault: Fault, target: &Target, seed: u64, cases: u64) -> Option<u64> {
    (0..cases).find(|&k| failure(fault, &target.case(seed, k)).is_some())
}

#[test]
fn every_planted_fault_is_found() {
    let mut missed = Vec::new();
    for (fault, name, cases) in PLANTED {
        let target = target(name).expect("a target");
        for seed in 1..=3 {
            if found(fault, &target, seed, cases).is_none() {
                missed.push((fault, name, seed));
            }
        }
    }
    assert!(missed.is_empty(), "not found: {missed:?}");
}

#[test]
fn without_a_fault_nothing_is_found() {
    for name in ["delaunay-2d", "cdt"] {
        let target = target(name).expect("a target");
        for k in 0..1000 {
            let broken = failure(Fault::None, &target.case(1, k));
            assert_eq!(broken, None, "{name} {k}: {:?}", target.case(1, k));
        }
    }
}

/// What is found shrinks to few points, and still fails in the same way.
#[test]
fn every_failure_shrinks() {
    for (fault, name, cases) in PLANTED {
        let target = target(name).expect("a target");
        let k = found(fault, &target, 1, cases).expect("every fault is found");
        let input = target.case(1, k);
        let place = failure(fault, &input).expect("it fails").place;
        let fails = |other: &Input| failure(fault, other).is_some_and(|b| b.place == place);
        let shrunk = input.shrunk(&mut Effort { tests: 1500 }, fails);
        assert!(fails(&shrunk), "{fault:?}");
        assert!(shrunk.points() <= 8, "{fault:?}: {shrunk:?}");
    }
}
