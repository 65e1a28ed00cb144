use super::*;
use crate::naive;
use crate::testing::{Owned, Random, square_grid};

#[derive(Clone)]
struct Case {
    complex: Owned<2>,
    segments: Vec<[u32; 2]>,
    flags: Vec<[u32; 2]>,
}

impl Case {
    fn judged_with(&self, options: Options) -> Verdict {
        let one = |options: &Options| {
            judge_constrained(&self.complex.complex(), &self.segments, &self.flags, options)
        };
        let verdict = one(&options);
        for filtered in [true, false] {
            for &backend in Backend::all() {
                assert_eq!(one(&Options { filtered, backend, ..options }), verdict);
            }
        }
        verdict
    }

    fn judged(&self) -> Verdict {
        self.judged_with(Options::default())
    }

    fn accepted(&self) {
        let verdict = self.judged();
        assert!(verdict.ok && verdict.level == Level::Constrained, "{verdict}");
    }

    fn rejected(&self, kind: &str) -> Verdict {
        let verdict = self.judged();
        assert!(!verdict.ok && verdict.has(kind), "expected {kind} in\n{verdict}");
        verdict
    }
}

/// The right answer, by definition: a diagonal in overlapping pieces with a vertex inside, and two
/// more segments.
fn noded() -> Case {
    let points = [
        [0.0, 0.0],
        [10.0, 0.0],
        [0.0, 7.0],
        [10.0, 9.0],
        [2.0, 2.0],
        [5.0, 5.0],
        [7.0, 7.0],
        [6.0, 1.0],
        [3.0, 6.0],
    ];
    let segments = vec![[4, 6], [6, 5], [7, 3], [0, 4]];
    let complex = Owned::of_cells(&points, &naive::constrained(&points, &segments));
    Case { complex, segments, flags: vec![[4, 5], [6, 5], [3, 7], [0, 4]] }
}

#[test]
fn right_answer_with_vertices_inside_segments_and_overlaps() {
    noded().accepted();
    let mut case = noded();
    case.segments.extend([[0, 6], [5, 0], [3, 3]]); // all along the diagonal, and a point
    case.accepted();
    case.flags.reverse();
    case.flags.push([5, 4]); // a set: order and repetition do not matter
    case.accepted();
}

#[test]
fn dropped_flag() {
    let mut case = noded();
    case.flags.remove(0);
    let verdict = case.rejected("missing-flag");
    assert_eq!(verdict.counts.len(), 1);
    assert_eq!(verdict.level, Level::Triangulation);
}

#[test]
fn extra_flag() {
    let mut case = noded();
    case.flags.push([0, 1]);
    assert_eq!(case.rejected("extra-flag").counts.len(), 1);
}

#[test]
fn flag_that_is_no_edge() {
    for ends in [[4, 6], [2, 7], [3, 3], [0, 99]] {
        let mut case = noded();
        case.flags.push(ends);
        assert_eq!(case.rejected("flag-not-edge").counts.len(), 1);
    }
}

#[test]
fn segment_that_is_no_edge() {
    let mut case = noded();
    case.complex = Owned::delaunay(&case.complex.points);
    assert!(case.judged().ok || case.judged().has("broken-segment"));
    let points = [[0.0, 0.0], [10.0, 0.0], [5.0, 2.0], [5.0, -1.0]];
    let case =
        Case { complex: Owned::delaunay(&points), segments: vec![[0, 1]], flags: vec![[0, 1]] };
    assert!(case.rejected("broken-segment").has("flag-not-edge"));
}

/// A chain that is off by one ulp is not on the segment.
#[test]
fn chain_bent_by_one_ulp() {
    let with = |x: f64| {
        let points = [[0.0, 0.0], [2.0, 2.0], [x, 1.0], [2.0, 0.0], [0.0, 2.0]];
        let complex = Owned::new(&points, 2, &[0, 3, 2, 3, 1, 2, 1, 4, 2, 4, 0, 2]);
        Case { complex, segments: vec![[1, 0]], flags: vec![[0, 2], [1, 2]] }
    };
    with(1.0).accepted();
    for x in [1.0_f64.next_up(), 1.0_f64.next_down()] {
        assert!(with(x).rejected("broken-segment").has("extra-flag"));
    }
}

/// A segment that goes on beyond its end, or backwards, is no chain.
#[test]
fn segment_past_its_end() {
    let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 2.0], [1.0, -2.0], [1.0, 0.0]];
    let cells = [0, 4, 2, 4, 1, 2, 0, 3, 4, 3, 1, 4];
    let case = |segments: &[[u32; 2]], flags: &[[u32; 2]]| Case {
        complex: Owned::new(&points, 2, &cells),
        segments: segments.to_vec(),
        flags: flags.to_vec(),
    };
    case(&[[0, 1]], &[[0, 4], [1, 4]]).accepted();
    case(&[[0, 4]], &[[0, 4]]).accepted();
    assert!(case(&[[0, 4]], &[[0, 4], [1, 4]]).judged().has("extra-flag"));
    assert!(case(&[[0, 5]], &[]).judged().has("segment-out-of-range"));
}

/// A lost site inside an edge: the chain must not run past it, nor turn back for it.
#[test]
fn segment_that_ends_inside_an_edge() {
    let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 2.0], [1.0, 0.0]];
    for segment in [[0, 3], [3, 0], [1, 3], [3, 1], [3, 2]] {
        let case = Case {
            complex: Owned::new(&points, 2, &[0, 1, 2]),
            segments: vec![segment],
            flags: vec![],
        };
        assert!(case.rejected("broken-segment").has("unused-point"));
    }
}

#[test]
fn flip_of_an_unconstrained_edge() {
    // Convex position: both diagonals are possible, one is Delaunay.
    let points = [[0.0, 0.0], [4.0, 1.0], [5.0, 5.0], [1.0, 4.0]];
    let with = |cells: &[u32], segments: &[[u32; 2]]| Case {
        complex: Owned::new(&points, 2, cells),
        segments: segments.to_vec(),
        flags: segments.to_vec(),
    };
    let (long, short) = ([0, 1, 2, 0, 2, 3], [0, 1, 3, 1, 2, 3]);
    with(&short, &[]).accepted();
    with(&long, &[[0, 2]]).accepted();
    let verdict = with(&long, &[]).rejected("not-delaunay");
    assert_eq!((verdict.level, verdict.counts.len()), (Level::Triangulation, 1));
    // A flag that no segment asks for exempts nothing.
    let mut flagged = with(&long, &[]);
    flagged.flags.push([0, 2]);
    assert!(flagged.rejected("extra-flag").has("not-delaunay"));
}

#[test]
fn tie_the_wrong_way() {
    let mut complex = square_grid(2);
    complex.cells[..6].copy_from_slice(&[0, 1, 4, 0, 4, 3]);
    let case = Case { complex, segments: vec![[6, 8]], flags: vec![[6, 7], [7, 8]] };
    case.rejected("wrong-tie");
    let verdict = case.judged_with(Options::foreign());
    assert!(verdict.ok && verdict.level == Level::WeaklyConstrained && verdict.ties == 4);
}

#[test]
fn lost_constraint_site_and_moved_orientation() {
    let mut case = noded();
    case.complex.cells.swap(0, 1);
    case.rejected("negative-cell");
    let mut case = noded();
    case.complex.points.push([8.5, 0.5]);
    case.segments.push([9, 1]);
    assert!(case.rejected("unused-point").has("broken-segment"));
}

/// Ends of segments may be repeated points that no cell uses.
#[test]
fn segments_between_repeated_points() {
    let mut case = noded();
    let points = &mut case.complex.points;
    points.extend([points[7], points[3]]);
    case.segments[2] = [9, 10];
    case.segments.push([9, 7]);
    case.accepted();
}

#[test]
fn collinear_points() {
    let points = [[1.0, 2.0], [3.0, 6.0], [2.0, 4.0], [0.0, 0.0]];
    let case = |cells: &[u32], segments: &[[u32; 2]], flags: &[[u32; 2]]| Case {
        complex: Owned::new(&points, 1, cells),
        segments: segments.to_vec(),
        flags: flags.to_vec(),
    };
    let chain = [3, 0, 0, 2, 2, 1];
    case(&chain, &[[1, 0]], &[[0, 2], [1, 2]]).accepted();
    case(&chain, &[], &[]).accepted();
    case(&chain, &[[1, 0]], &[[1, 0]]).rejected("flag-not-edge");
    case(&chain, &[[1, 0]], &[[1, 2]]).rejected("missing-flag");
    case(&chain, &[[2, 0]], &[[0, 2], [2, 1]]).rejected("extra-flag");
    let one = Case {
        complex: Owned::new(&[[1.0, 1.0], [1.0, 1.0]], 0, &[0]),
        segments: vec![[0, 1]],
        flags: vec![],
    };
    one.accepted();
    let none = Owned { points: Vec::new(), dimension: None, cells: Vec::new() };
    Case { complex: none.clone(), segments: vec![], flags: vec![] }.accepted();
    Case { complex: none, segments: vec![[0, 0]], flags: vec![] }.rejected("segment-out-of-range");
}

/// Every single flip of a right answer is told.
#[test]
fn every_other_triangulation_is_rejected() {
    let mut random = Random(51);
    let mut flips = 0;
    for _ in 0..20 {
        let points = random.grid::<2>(8, 6);
        let segments = naive::tests::noded_segments(&mut random, &points, 4);
        let cells = naive::constrained(&points, &segments);
        let flags = naive::tests::covered(&points, &cells, &segments);
        let right = Case { complex: Owned::of_cells(&points, &cells), segments, flags };
        if right.complex.dimension != Some(2) {
            continue;
        }
        right.accepted();
        for i in 0..cells.len() {
            for j in 0..i {
                let a: Vec<u32> = difference(&cells[i], &cells[j]);
                let b = difference(&cells[j], &cells[i]);
                if a.len() != 1 {
                    continue;
                }
                let common: Vec<u32> = cells[i].iter().copied().filter(|v| *v != a[0]).collect();
                let mut flipped = cells.clone();
                flipped[i] = vec![a[0], b[0], common[0]];
                flipped[j] = vec![a[0], b[0], common[1]];
                let case = Case { complex: Owned::of_cells(&points, &flipped), ..right.clone() };
                assert!(!case.judged().ok);
                flips += 1;
            }
        }
    }
    assert!(flips > 50, "{flips}");
}

fn difference(a: &[u32], b: &[u32]) -> Vec<u32> {
    a.iter().copied().filter(|v| !b.contains(v)).collect()
}

/// A star of long chains through one hub: the search by direction must not scan all neighbours.
#[test]
fn star_of_chains() {
    let mut points = vec![[0.0, 0.0]];
    let mut segments = Vec::new();
    for i in 0..60u32 {
        let (x, y) = (f64::from(i) + 1.0, f64::from(60 - i));
        points.push([x, y]);
        points.push([2.0 * x, 2.0 * y]);
        segments.push([0, 2 * i + 2]);
    }
    let mut cells = Vec::new();
    let mut flags = Vec::new();
    for i in 0..60u32 {
        let (a, b) = (2 * i + 1, 2 * i + 2);
        flags.extend([[0, a], [a, b]]);
        if i > 0 {
            // The ring goes clockwise.
            cells.extend([0, a, a - 2, a - 2, a, b - 2, a, b, b - 2]);
        }
    }
    let case = Case { complex: Owned::new(&points, 2, &cells), segments, flags };
    let verdict = case.judged();
    assert!(!verdict.has("broken-segment") && !verdict.has("missing-flag"), "{verdict}");
    assert_eq!(verdict.counts.keys().filter(|k| k.contains("flag")).count(), 0);
}

#[test]
fn many_with_every_row_constrained() {
    let side = 100;
    let complex = square_grid(side);
    let row = |j: u32| j * (side + 1);
    let segments = (0..=side).map(|j| [row(j), row(j) + side]).collect();
    let flags =
        (0..=side).flat_map(|j| (0..side).map(move |i| [row(j) + i, row(j) + i + 1])).collect();
    let case = Case { complex, segments, flags };
    let verdict = judge_constrained(
        &case.complex.complex(),
        &case.segments,
        &case.flags,
        &Options::default(),
    );
    assert!(verdict.ok && verdict.level == Level::Constrained, "{verdict}");
}
