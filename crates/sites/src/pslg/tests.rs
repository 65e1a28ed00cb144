use super::{by_strips, by_sweep};
use crate::{NotFinite, Pslg, PslgError, PslgFault, Sites, scatter};

#[test]
fn strict_lists_everything_that_is_repaired() {
    let points =
        [[0.0, 0.0], [4.0, 0.0], [4.0, 0.0], [1.0, 0.0], [3.0, 0.0], [2.0, 1.0], [2.0, -1.0]];
    let segments = [[0, 1], [2, 0], [3, 4], [1, 2], [5, 6], [3, 5]];
    let PslgError(faults) = Pslg::strict(&points, &segments).unwrap_err();
    let lines: Vec<String> = faults.iter().map(ToString::to_string).collect();
    assert_eq!(
        lines,
        [
            "point 2 at (4, 0) equals point 1: list it once",
            "segment 3 has no length, at (4, 0): leave it out",
            "point 3 at (1, 0) lies inside segment 0: split the segment there",
            "point 4 at (3, 0) lies inside segment 0: split the segment there",
            "point 4 at (3, 0) lies inside segment 1: split the segment there",
            "point 3 at (1, 0) lies inside segment 1: split the segment there",
            "segments 0 and 1 are the same, from (0, 0) to (4, 0): list it once",
            "segments 1 and 2 overlap, from (1, 0) to (3, 0): split them there",
            "segments 0 and 4 cross near (2, 0): split them at a common vertex",
            "segments 1 and 4 cross near (2, 0): split them at a common vertex",
            "segments 2 and 4 cross near (2, 0): split them at a common vertex",
        ]
    );
    assert!(Pslg::strict(&points[..2], &[[0, 1]]).is_ok());
}

#[test]
fn what_cannot_be_used_hides_nothing_of_the_rest() {
    let points =
        [[f64::NAN, 0.0], [0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0], [0.0, f64::INFINITY]];
    let segments = [[0, 1], [1, 2], [5, 9], [3, 4], [1, 8]];
    let PslgError(faults) = Pslg::new(&points, &segments).unwrap_err();
    assert!(matches!(faults[0], PslgFault::NotFinite(NotFinite { point: 0, axis: 0, .. })));
    assert!(matches!(faults[1], PslgFault::NotFinite(NotFinite { point: 5, axis: 1, .. })));
    assert_eq!(faults[2], PslgFault::NoSuchPoint { segment: 2, point: 9, count: 6 });
    assert_eq!(faults[3], PslgFault::NoSuchPoint { segment: 4, point: 8, count: 6 });
    let PslgFault::Crossing(crossing) = faults[4] else { panic!("{}", faults[4]) };
    assert_eq!((crossing.segments, faults.len()), ([1, 3], 5));
}

/// Integers decide each violation from its definition, pair by pair.
#[test]
fn strict_agrees_with_all_pairs() {
    let mut state = 5u64;
    let mut next = |below: usize| {
        state = scatter(state);
        (state % below as u64) as usize
    };
    let mut seen = [0; 6];
    for _ in 0..3000 {
        let side = 2 + next(4);
        let grid: Vec<[i64; 2]> = (0..2 + next(7))
            .map(|_| [(); 2].map(|()| i64::try_from(next(side)).unwrap()))
            .collect();
        let segments: Vec<[usize; 2]> =
            (0..next(6)).map(|_| [next(grid.len()), next(grid.len())]).collect();
        let points: Vec<[f64; 2]> = grid.iter().map(|p| p.map(|x| x as f64)).collect();
        let faults = match Pslg::strict(&points, &segments) {
            Ok(_) => Vec::new(),
            Err(PslgError(faults)) => faults,
        };
        let count = |kind: fn(&PslgFault) -> bool| faults.iter().filter(|f| kind(f)).count();
        let found = [
            count(|f| matches!(f, PslgFault::DuplicatePoint { .. })),
            count(|f| matches!(f, PslgFault::ZeroLength { .. })),
            count(|f| matches!(f, PslgFault::Junction { .. })),
            count(|f| matches!(f, PslgFault::Overlap { .. })),
            count(|f| matches!(f, PslgFault::Crossing(_))),
        ];
        let expected = Expected::of(&grid, &segments);
        assert_eq!(found[..3], expected.exact[..3], "{grid:?} {segments:?}");
        // Of overlapping segments a chain of pairs is listed, not all: there is one if there is any.
        assert_eq!(found[3] > 0, expected.exact[3] > 0, "{grid:?} {segments:?}");
        assert_eq!(found[4], expected.exact[4], "{grid:?} {segments:?}");
        assert_eq!(faults.len(), found.iter().sum::<usize>());
        found.iter().zip(&mut seen).for_each(|(&n, seen)| *seen += usize::from(n > 0));
        seen[5] += usize::from(faults.is_empty());
    }
    assert!(seen.iter().all(|&times| times > 100), "{seen:?}");
}

struct Expected {
    exact: [usize; 5],
}

impl Expected {
    fn of(grid: &[[i64; 2]], segments: &[[usize; 2]]) -> Self {
        let mut exact = [0; 5];
        let distinct: Vec<usize> =
            (0..grid.len()).filter(|&i| !grid[..i].contains(&grid[i])).collect();
        exact[0] = grid.len() - distinct.len();
        for (i, &[a, b]) in segments.iter().enumerate() {
            let s = [grid[a], grid[b]];
            exact[1] += usize::from(s[0] == s[1]);
            exact[2] += distinct.iter().filter(|&&v| inside(s, grid[v])).count();
            for &[c, d] in &segments[..i] {
                let t = [grid[c], grid[d]];
                exact[3] += usize::from(overlap(s, t));
                let meets = cross(s, t);
                exact[4] +=
                    usize::from(meets && !grid.iter().any(|&v| inside(s, v) && inside(t, v)));
            }
        }
        Self { exact }
    }
}

fn turn(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i64 {
    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).signum()
}

fn inside([a, b]: [[i64; 2]; 2], v: [i64; 2]) -> bool {
    let between = (0..2).all(|x| a[x].min(b[x]) <= v[x] && v[x] <= a[x].max(b[x]));
    turn(a, b, v) == 0 && between && v != a && v != b
}

fn overlap([a, b]: [[i64; 2]; 2], [c, d]: [[i64; 2]; 2]) -> bool {
    let in_line = a != b && c != d && turn(a, b, c) == 0 && turn(a, b, d) == 0;
    // In line, the order along the line is that of the coordinates.
    in_line && a.min(b).max(c.min(d)) < a.max(b).min(c.max(d))
}

fn cross([a, b]: [[i64; 2]; 2], [c, d]: [[i64; 2]; 2]) -> bool {
    turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0
}

#[test]
fn the_sweep_nodes_as_strips_do() {
    let mut state = 5u64;
    let mut next = |below: usize| {
        state = scatter(state);
        usize::try_from(state % below as u64).unwrap()
    };
    let (mut noded, mut cut, mut crossed) = (0, 0, 0);
    for _ in 0..6000 {
        let side = 2 + next(5);
        let points: Vec<[f64; 2]> =
            (0..2 + next(16)).map(|_| [next(side) as f64, next(side) as f64]).collect();
        let sites = Sites::new(&points).unwrap();
        let end = |point: usize| sites.site_of()[point];
        let segments: Vec<[u32; 2]> =
            (0..next(7)).map(|_| [end(next(points.len())), end(next(points.len()))]).collect();
        let mut expected = by_strips(&sites, &segments);
        expected.sort_unstable();
        let at = |site: u32| points[sites.input_of()[site as usize] as usize];
        match by_sweep(&sites, &segments) {
            Some(mut pieces) => {
                pieces.sort_unstable();
                assert_eq!(pieces, expected, "{points:?} {segments:?}");
                noded += 1;
                cut += usize::from(pieces.iter().any(|piece| piece.place > 0));
            }
            // Some pair crosses, be it at a site.
            None => {
                let any = segments.iter().enumerate().any(|(i, &[a, b])| {
                    segments[..i]
                        .iter()
                        .any(|&[c, d]| super::crossings::cross(at(a), at(b), at(c), at(d)))
                });
                assert!(any, "{points:?} {segments:?}");
                crossed += 1;
            }
        }
    }
    assert!(noded > 1000 && cut > 500 && crossed > 500, "{noded} {cut} {crossed}");
}
