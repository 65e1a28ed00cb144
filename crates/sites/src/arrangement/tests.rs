use delone_predicates::Sign;

use super::*;
use crate::{Noded, scatter};

/// Walks each chain: consecutive pieces share a vertex, all vertices are on the segment's line, in order.
fn check(arrangement: &Arrangement) {
    let kernel = arrangement.kernel();
    for (chain, &[a, b]) in arrangement.chains().iter().zip(arrangement.segments()) {
        let mut at = a;
        let forwards = kernel.compare_lexicographic(a as usize, b as usize);
        for &piece in chain {
            let [low, high] = arrangement.subsegments()[piece as usize];
            assert!(at == low || at == high);
            let next = if at == low { high } else { low };
            assert_eq!(kernel.compare_lexicographic(at as usize, next as usize), forwards);
            assert!(
                next == b || kernel.orient(&[a as usize, b as usize, next as usize]) == Sign::Zero
            );
            at = next;
        }
        assert_eq!(at, b);
    }
    assert!(arrangement.subsegments().is_sorted());
    assert!(arrangement.subsegments().windows(2).all(|pair| pair[0] != pair[1]));
}

/// No two pieces cross, and no vertex lies inside one: all pairs, exactly.
fn is_noded(arrangement: &Arrangement) -> bool {
    let kernel = arrangement.kernel();
    let turn = |u: u32, v: u32, w: u32| {
        if w == u || w == v { Sign::Zero } else { kernel.orient(&[u, v, w].map(|v| v as usize)) }
    };
    let pieces = arrangement.subsegments();
    let crosses = |[a, b]: [u32; 2], [c, d]: [u32; 2]| {
        turn(a, b, c) * turn(a, b, d) == Sign::Negative
            && turn(c, d, a) * turn(c, d, b) == Sign::Negative
    };
    let inside = |[a, b]: [u32; 2], v: usize| {
        let [a, b] = [a, b].map(|v| v as usize);
        let (low, high) = if kernel.compare_lexicographic(a, b).is_lt() { (a, b) } else { (b, a) };
        v != a
            && v != b
            && kernel.orient(&[a, b, v]) == Sign::Zero
            && kernel.compare_lexicographic(low, v).is_lt()
            && kernel.compare_lexicographic(v, high).is_lt()
    };
    pieces.iter().enumerate().all(|(i, &s)| {
        pieces[..i].iter().all(|&t| !crosses(s, t)) && (0..kernel.len()).all(|v| !inside(s, v))
    })
}

#[test]
fn segments_through_one_point_have_one_vertex() {
    // Four lines through (1/3, 1/3) times 6, three of them not through a site there; and two through the site (9, 9).
    let points = [
        [0.0, 0.0],
        [3.0, 3.0],
        [0.0, 1.0],
        [2.0, 0.0],
        [0.0, 2.0],
        [1.0, 0.0],
        [9.0, 9.0],
        [8.0, 8.0],
        [10.0, 10.0],
        [8.0, 10.0],
        [10.0, 8.0],
    ];
    let arrangement =
        Arrangement::new(&points, &[[0, 1], [2, 3], [4, 5], [7, 8], [9, 10]]).unwrap();
    check(&arrangement);
    assert_eq!(arrangement.kernel().len(), 12);
    assert_eq!(arrangement.crossing_count(), 3); // three pairs in one vertex
    assert_eq!(arrangement.kernel().position(11), [2.0 / 3.0, 2.0 / 3.0]);
    assert!(!arrangement.kernel().is_exact_position(11));
    assert_eq!(arrangement.subsegments().len(), 10);
}

#[test]
fn chains_lead_from_end_to_end() {
    let points =
        [[0.0, 0.0], [4.0, 0.0], [2.0, 0.0], [3.0, 0.0], [1.0, -1.0], [1.0, 1.0], [3.0, 5.0]];
    // A whole, an overlap that runs back, a crossing, a T-junction, a repeat.
    let segments = [[0, 1], [3, 2], [4, 5], [6, 3], [1, 0], [2, 2]];
    let arrangement = Arrangement::new(&points, &segments).unwrap();
    check(&arrangement);
    assert!(is_noded(&arrangement));
    assert_eq!(
        arrangement.chains().iter().map(<[u32]>::len).collect::<Vec<_>>(),
        [4, 1, 2, 1, 4, 0]
    );
    let twice = arrangement.coverage().iter().filter(|c| c.times == 3).count();
    assert_eq!((twice, arrangement.dropped()), (1, &[5][..])); // from (2, 0) to (3, 0)
}

#[test]
fn crossings_closer_than_doubles_are_two() {
    // Two lines cross a third, one ulp of 1 apart at x = 0 and converging from there: their crossings with a steep line round alike.
    let e = f64::EPSILON;
    let points = [[0.0, 1.0], [3.0, 2.0], [0.0, 1.0 + e], [3.0, 2.0], [1.0, 0.0], [1.5, 9.0]];
    let arrangement = Arrangement::new(&points, &[[0, 1], [2, 3], [4, 5]]).unwrap();
    check(&arrangement);
    assert!(is_noded(&arrangement));
    let kernel = arrangement.kernel();
    assert_eq!(kernel.len(), 7);
    assert_eq!(kernel.compare_lexicographic(5usize, 6usize), std::cmp::Ordering::Less);
    assert_eq!(arrangement.crossing_count(), 2);
}

#[test]
fn random_segments_are_noded() {
    let mut state = 3u64;
    let mut next = |below: u64| {
        state = scatter(state);
        u32::try_from(state % below).unwrap()
    };
    let mut crossings = 0;
    for round in 0..200 {
        let side = 3 + round % 20;
        let points: Vec<[f64; 2]> =
            (0..6 + next(10)).map(|_| [f64::from(next(side)), f64::from(next(side))]).collect();
        let count = points.len() as u64;
        let segments: Vec<[usize; 2]> =
            (0..4 + next(9)).map(|_| [next(count) as usize, next(count) as usize]).collect();
        let arrangement = Arrangement::new(&points, &segments).unwrap();
        check(&arrangement);
        assert!(is_noded(&arrangement), "{points:?} {segments:?}");
        crossings += arrangement.kernel().len() - arrangement.sites().len();
        // A new vertex is on two segments, and is no site.
        let sites = arrangement.sites().points();
        for v in sites.len()..arrangement.kernel().len() {
            let exact = (0..sites.len())
                .all(|site| arrangement.kernel().compare_lexicographic(site, v).is_ne());
            assert!(exact);
        }
    }
    assert!(crossings > 300, "{crossings}");
}
