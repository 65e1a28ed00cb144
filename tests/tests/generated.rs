//! All laws on generated inputs. The strategies make *values*, coordinates chosen one by one, so that what fails shrinks:
//! towards fewer points, smaller integers, no nudge.

use delone::cdt::algorithms;
use delone::delaunay::Options;
use delone_tests::case::Case;
use delone_tests::generated::{coordinate, run};
use delone_tests::laws::{constrained_laws, delaunay_laws, obey};
use proptest::prelude::{Strategy, any, prop_oneof};

/// A point: free, on a circle of integers, or a copy of an earlier one's coordinates.
#[derive(Clone, Debug)]
enum Atom<const D: usize> {
    Free([f64; D]),
    /// Which of the points with these coordinates, up to order and sign; their squares sum to one number.
    Round(usize, [bool; D]),
    /// Coordinate `axis` of point `of`, the rest free.
    Shares {
        of: usize,
        axis: usize,
        rest: [f64; D],
    },
    /// The middle of two points, rounded.
    Middle(usize, usize),
}

const TRIPLES: [[f64; 3]; 6] = [
    [7.0, 4.0, 4.0],
    [4.0, 7.0, 4.0],
    [1.0, 4.0, 8.0],
    [8.0, 1.0, 4.0],
    [9.0, 0.0, 0.0],
    [3.0, 6.0, 6.0],
];
const PAIRS: [[f64; 2]; 6] =
    [[33.0, 4.0], [32.0, 9.0], [31.0, 12.0], [24.0, 23.0], [4.0, 33.0], [23.0, 24.0]];

fn resolved<const D: usize>(atoms: &[Atom<D>], table: &[[f64; D]]) -> Vec<[f64; D]> {
    let mut points: Vec<[f64; D]> = Vec::new();
    for atom in atoms {
        let earlier = |i: usize| points.get(i % points.len().max(1)).copied().unwrap_or([0.0; D]);
        points.push(match *atom {
            Atom::Free(point) => point,
            Atom::Round(which, signs) => {
                let p = table[which % table.len()];
                std::array::from_fn(|axis| if signs[axis] { -p[axis] } else { p[axis] })
            }
            Atom::Shares { of, axis, mut rest } => {
                rest[axis] = earlier(of)[axis];
                rest
            }
            Atom::Middle(i, j) => {
                let (p, q) = (earlier(i), earlier(j));
                std::array::from_fn(|axis| p[axis] / 2.0 + q[axis] / 2.0)
            }
        });
    }
    points
}

fn atoms<const D: usize>(max: usize) -> impl Strategy<Value = Vec<Atom<D>>> {
    let free = || proptest::array::uniform::<_, D>(coordinate());
    let atom = prop_oneof![
        8 => free().prop_map(Atom::Free),
        3 => (0..6usize, proptest::array::uniform::<_, D>(any::<bool>()))
            .prop_map(|(which, signs)| Atom::Round(which, signs)),
        3 => (0..max, 0..D, free()).prop_map(|(of, axis, rest)| Atom::Shares { of, axis, rest }),
        1 => (0..max, 0..max).prop_map(|(i, j)| Atom::Middle(i, j)),
    ];
    proptest::collection::vec(atom, 0..=max)
}

/// Candidates for segments; those that cross an earlier one are left out.
fn graph(points: Vec<[f64; 2]>, candidates: &[[usize; 2]]) -> Case<2> {
    let mut case = Case::new("generated", points, Vec::new());
    let count = case.points.len().max(1);
    for ends in candidates.iter().filter(|_| !case.points.is_empty()) {
        case.segments.push(ends.map(|v| delone_tests::id(v % count)));
        if case.try_pslg().is_none() {
            case.segments.pop();
        }
    }
    case
}

#[test]
fn point_sets_of_the_plane() {
    let laws = delaunay_laws::<2>();
    run(400, &atoms::<2>(14).prop_map(|atoms| resolved(&atoms, &PAIRS)), |points| {
        let case = Case::of_points("generated", points);
        obey(&laws, &case);
    });
}

#[test]
fn point_sets_of_space() {
    let laws = delaunay_laws::<3>();
    run(250, &atoms::<3>(11).prop_map(|atoms| resolved(&atoms, &TRIPLES)), |points| {
        let case = Case::of_points("generated", points);
        obey(&laws, &case);
    });
}

/// Graphs, as [`graph`] makes them.
fn graphs() -> impl Strategy<Value = Case<2>> {
    let segments = proptest::collection::vec(proptest::array::uniform2(0..12usize), 0..16);
    (atoms::<2>(12), segments)
        .prop_map(|(atoms, candidates)| graph(resolved(&atoms, &PAIRS), &candidates))
}

#[test]
fn laws_of_graphs() {
    let laws = constrained_laws();
    run(400, &graphs(), |case| obey(&laws, &case));
}

/// The law that matters most, alone, so that a million graphs take minutes.
#[test]
fn algorithms_agree_on_graphs() {
    let algorithms = algorithms();
    run(1000, &graphs(), |case| {
        let pslg = case.pslg();
        let mut results =
            algorithms.iter().map(|algorithm| (algorithm.run)(&pslg, &Options::default()));
        let first = results.next().expect("there is an algorithm");
        for (other, algorithm) in results.zip(&algorithms[1..]) {
            assert_eq!(other.canonical(), first.canonical(), "{}", algorithm.name);
            assert_eq!(other.constrained_edges(), first.constrained_edges(), "{}", algorithm.name);
        }
    });
}
