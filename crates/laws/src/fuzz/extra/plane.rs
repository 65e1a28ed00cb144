//! Laws of graphs in the plane: one answer by every way, crossings, files.

use delone::cdt::{algorithms, cavity, chew_from_points, from_points};
use delone::formats::{Document, Format, Source, one, read_bytes, write};

use crate::case::Case;
use crate::judge::{Rigour, accept_constrained};
use crate::laws::{Law, crossings};

/// Segments that do not cross: every algorithm and door gives one triangulation, and the judge accepts it.
pub(in crate::fuzz) fn of_agreement() -> Vec<Law<2>> {
    vec![Law { name: "one answer", hold: one_answer }]
}

/// The definition is tried on so many sites: it takes their cube in time.
const NAIVE_MAX: usize = 9;

fn one_answer(case: &Case<2>) -> usize {
    let segments: Vec<[usize; 2]> =
        case.segments.iter().map(|ends| ends.map(|v| v as usize)).collect();
    let pslg = case.pslg();
    let options = delone::delaunay::Options::default();
    let first = cavity(&pslg, &options, &mut ());
    accept_constrained(case, &pslg, &first, Rigour::Once);
    let is_quick = |name: &str| name != "naive" || pslg.sites().len() <= NAIVE_MAX;
    for algorithm in algorithms().iter().filter(|algorithm| is_quick(algorithm.name)) {
        let other = (algorithm.run)(&pslg, &options);
        assert_eq!(other.canonical(), first.canonical(), "{}: {}", case.name, algorithm.name);
        assert_eq!(other.constrained_edges(), pslg.subsegments(), "{}", algorithm.name);
    }
    for way in [from_points, chew_from_points] {
        let (noded, other) = way(&case.points, &segments, &mut ()).expect("no crossings");
        assert_eq!(noded, pslg, "{}", case.name);
        assert_eq!(other.canonical(), first.canonical(), "{}", case.name);
    }
    1
}

/// Segments that cross.
pub(in crate::fuzz) fn of_crossings() -> Vec<Law<2>> {
    vec![Law { name: "crossings", hold: crossings }]
}

/// What is written is read again, bit for bit.
pub(in crate::fuzz) fn of_files() -> Vec<Law<2>> {
    vec![Law { name: "round-trip", hold: round_trip }]
}

fn round_trip(case: &Case<2>) -> usize {
    if case.points.is_empty() {
        return 0; // a .poly file without points says that they are in another file
    }
    let document = document(case);
    let formats = [Format::Poly, Format::Lar, Format::Off];
    for format in formats {
        let mut bytes = Vec::new();
        write(&document, format, &mut bytes).unwrap_or_else(|error| panic!("{format:?}: {error}"));
        let source = Source { name: "", bytes: &bytes, format: Some(format), nodes: None };
        let again = read_bytes(&source).and_then(|documents| one(documents, ""));
        let again = again.unwrap_or_else(|error| panic!("{format:?}: {error}"));
        let bits = |document: &Document| -> Vec<u64> {
            document.points.iter().map(|x| x.to_bits()).collect()
        };
        if document.dimension == again.dimension {
            assert_eq!(bits(&again), bits(&document), "{}: {format:?}", case.name);
        }
        if format != Format::Off {
            assert_eq!(again.segments, document.segments, "{}: {format:?}", case.name);
        }
    }
    formats.len()
}

/// A case as a document.
pub(super) fn document(case: &Case<2>) -> Document {
    Document {
        points: case.points.as_flattened().to_vec(),
        segments: case.segments.clone(),
        ..Document::new(2)
    }
}
