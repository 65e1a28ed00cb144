use super::*;
use crate::testing::{Owned, Random, jittered, square_grid};

mod degenerate;
mod large;

/// The verdict under every arithmetic, which must be one.
fn judged<const D: usize>(input: &Owned<D>, options: Options) -> Verdict {
    let verdict = judge_delaunay(&input.complex(), &options);
    for filtered in [true, false] {
        for &backend in Backend::all() {
            let other = Options { filtered, backend, ..options };
            assert_eq!(judge_delaunay(&input.complex(), &other), verdict, "{other:?}");
        }
    }
    verdict
}

fn strict<const D: usize>(input: &Owned<D>) -> Verdict {
    judged(input, Options::default())
}

fn weak<const D: usize>(input: &Owned<D>) -> Verdict {
    judged(input, Options::foreign())
}

fn accepted<const D: usize>(input: &Owned<D>) {
    let verdict = strict(input);
    assert!(verdict.ok && verdict.level == Level::Delaunay, "{verdict}");
}

fn rejected<const D: usize>(input: &Owned<D>, kind: &str) -> Verdict {
    let verdict = strict(input);
    assert!(!verdict.ok && verdict.has(kind), "expected {kind} in\n{verdict}");
    assert!(verdict.faults.iter().all(|f| !f.to_string().is_empty()));
    verdict
}

/// Twelve points in general position: every planted fault is a fault of that kind alone.
fn scattered() -> Owned<2> {
    let mut random = Random(31);
    Owned::delaunay(&random.grid::<2>(12, 1000))
}

fn scattered_in_space() -> Owned<3> {
    let mut random = Random(32);
    Owned::delaunay(&random.grid::<3>(10, 1000))
}

/// A cell of which every vertex also belongs to another cell, and no facet is on the boundary.
fn inner_cell(input: &Owned<2>) -> usize {
    let cells: Vec<&[u32]> = input.cells.chunks(3).collect();
    let shared = |c: usize| {
        let common = |d: usize| cells[c].iter().filter(|v| cells[d].contains(v)).count();
        (0..cells.len()).filter(|&d| common(d) == 2).count()
    };
    (0..cells.len()).find(|&c| shared(c) == 3).unwrap()
}

#[test]
fn right_answers_are_accepted() {
    accepted(&scattered());
    accepted(&scattered_in_space());
    accepted(&jittered(12, 33));
    let mut random = Random(34);
    accepted(&Owned::delaunay(&random.grid::<2>(40, 7)));
    accepted(&Owned::delaunay(&random.grid::<3>(14, 3)));
}

#[test]
fn a_cocircular_grid_has_one_right_answer() {
    let grid = square_grid(9);
    let verdict = strict(&grid);
    assert!(verdict.ok, "{verdict}");
    assert_eq!((verdict.level, verdict.ties), (Level::Delaunay, 81));
}

/// Fault 1: A vertex replaced by another: every cell, corner and replacement.
#[test]
fn swapped_vertex() {
    let right = scattered();
    let mut kinds = std::collections::BTreeSet::new();
    for place in 0..right.cells.len() {
        let start = place / 3 * 3;
        for other in (0..12).filter(|v| !right.cells[start..start + 3].contains(v)) {
            let mut input = right.clone();
            input.cells[place] = other;
            let options = Options::foreign();
            let verdict = judge_delaunay(&input.complex(), &options);
            assert!(verdict.level == Level::Unproved, "{verdict}");
            kinds.extend(verdict.counts.into_keys());
        }
    }
    for kind in [
        "crowded-facet",
        "folded-facet",
        "reflex-ridge",
        "open-boundary",
        "winds-again",
        "unseen-facet",
    ] {
        assert!(kinds.contains(kind), "{kinds:?}");
    }
}

/// Fault 2: A diagonal flipped where the points are in general position.
#[test]
fn flipped_diagonal() {
    let points = [[0.0, 0.0], [4.0, 1.0], [5.0, 5.0], [1.0, 4.0]];
    let right = Owned::delaunay(&points);
    let mut flipped = Owned::new(&points, 2, &[0, 1, 2, 0, 2, 3]);
    if right.cells.chunks(3).any(|c| c.contains(&0) && c.contains(&2)) {
        flipped.cells = vec![0, 1, 3, 1, 2, 3];
    }
    accepted(&right);
    let verdict = rejected(&flipped, "not-delaunay");
    assert_eq!(verdict.level, Level::Triangulation);
    assert_eq!(verdict.counts.len(), 1);
    assert!(!weak(&flipped).ok);
}

/// Fault 3: An inner cell dropped: the hole is a second, reflex boundary.
#[test]
fn dropped_inner_cell() {
    let mut input = scattered();
    let cell = inner_cell(&input);
    input.cells.drain(cell * 3..cell * 3 + 3);
    rejected(&input, "reflex-ridge");
    let mut grid = square_grid(5);
    grid.cells.drain(72..75);
    assert!(rejected(&grid, "disconnected").has("euler"));
}

/// Fault 4: A cell on the boundary dropped, in space: the hull is not convex.
#[test]
fn dropped_outer_cell() {
    let mut input = scattered_in_space();
    let cells: Vec<&[u32]> = input.cells.chunks(4).collect();
    let outer = (0..cells.len())
        .find(|&c| {
            let twin = |d: usize| cells[c].iter().filter(|v| cells[d].contains(v)).count() == 3;
            (0..cells.len()).filter(|&d| twin(d)).count() == 3
        })
        .unwrap();
    input.cells.drain(outer * 4..outer * 4 + 4);
    rejected(&input, "reflex-ridge");
}

/// Fault 5: A cell that occurs twice.
#[test]
fn duplicate_cell() {
    let mut input = scattered();
    let cell = input.cells[..3].to_vec();
    input.cells.extend([cell[1], cell[2], cell[0]]);
    let verdict = rejected(&input, "duplicate-cell");
    assert_eq!(verdict.counts["duplicate-cell"], 1);
    let mut alone = Owned::new(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], 2, &[0, 1, 2, 1, 2, 0]);
    rejected(&alone, "duplicate-cell");
    alone.cells.truncate(3);
    accepted(&alone);
}

/// Fault 6: A cell turned over; accepted where any orientation is.
#[test]
fn flipped_orientation() {
    let mut input = scattered();
    input.cells.swap(0, 1);
    assert!(rejected(&input, "negative-cell").has("folded-facet"));
    assert!(weak(&input).ok);
    let mut input = scattered_in_space();
    input.cells.swap(5, 6);
    rejected(&input, "negative-cell");
    assert!(weak(&input).ok);
}

/// Fault 7: A site that no cell uses; but a repeated point need not be used.
#[test]
fn lost_site() {
    let mut input = scattered();
    input.points.push([501.5, 499.25]);
    let verdict = rejected(&input, "unused-point");
    assert_eq!(verdict.counts.len(), 1);
    let mut repeated = scattered();
    repeated.points.push(repeated.points[3]);
    repeated.points.push(repeated.points[3]);
    accepted(&repeated);
    assert_eq!(strict(&repeated).duplicates, 2);
}

/// Fault 8: Two equal points, both used.
#[test]
fn equal_points_used() {
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]];
    rejected(&Owned::new(&points, 2, &[0, 1, 2, 3, 4, 2]), "duplicate-point");
    // Negative zero is zero.
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [-0.0, 0.0]];
    accepted(&Owned::new(&points, 2, &[0, 1, 2]));
}

/// Fault 9: Ids out of range, ghosts among the cells, repeated vertices: told, not panicked about.
#[test]
fn bad_ids() {
    for id in [12, u32::MAX] {
        let mut input = scattered();
        input.cells[4] = id;
        rejected(&input, "id-out-of-range");
    }
    let mut input = scattered();
    input.cells[4] = input.cells[3];
    rejected(&input, "repeated-vertex");
}

/// Fault 10: Shapes that mean nothing.
#[test]
fn bad_shapes() {
    let mut input = scattered();
    input.cells.pop();
    rejected(&input, "bad-length");
    for dimension in [None, Some(3), Some(usize::MAX)] {
        let input = Owned { dimension, ..scattered() };
        rejected(&input, "bad-dimension");
    }
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let mut input = scattered();
        input.points[5][1] = x;
        let verdict = judge_delaunay(&input.complex(), &Options::default());
        assert!(verdict.has("not-finite"));
    }
    rejected(&Owned { cells: Vec::new(), ..scattered() }, "unused-point");
}

/// Fault 11: One ulp across an edge: a flat cell turns negative, and back.
#[test]
fn moved_by_one_ulp() {
    let with = |x: f64| {
        let points = [[0.0, 0.0], [1.0, 1.0], [x, 0.5], [1.0, 0.0]];
        Owned::new(&points, 2, &[0, 1, 2, 0, 3, 1])
    };
    rejected(&with(0.5), "flat-cell");
    rejected(&with(0.5_f64.next_up()), "negative-cell");
    let verdict = strict(&with(0.5_f64.next_down()));
    assert!(!verdict.has("negative-cell") && !verdict.has("flat-cell"));
}

/// Fault 12: One ulp across a circle.
#[test]
fn moved_by_one_ulp_across_a_circle() {
    let with = |x: f64| {
        Owned::new(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [x, 1.0]], 2, &[0, 1, 2, 1, 3, 2])
    };
    assert_eq!(strict(&with(1.0)).ties, 1);
    accepted(&with(1.0));
    accepted(&with(1.0_f64.next_up()));
    assert_eq!(strict(&with(1.0_f64.next_up())).ties, 0);
    rejected(&with(1.0_f64.next_down()), "not-delaunay");
}

/// Fault 13: a star of triangles that winds twice around its centre, all positive and in order.
#[test]
fn double_cover() {
    let corners = [[10.0, 0.0], [3.0, 9.0], [-8.0, 6.0], [-8.0, -6.0], [3.0, -9.0]];
    let mut points = vec![[0.0, 0.0]];
    points.extend(corners);
    points.extend(corners.map(|[x, y]| [x * 1.125, y * 1.125]));
    let cells: Vec<u32> = (0..10).flat_map(|i| [0, 1 + i, 1 + (i + 1) % 10]).collect();
    let input = Owned::new(&points, 2, &cells);
    let verdict = strict(&input);
    assert!(!verdict.ok, "{verdict}");
    assert!(!verdict.has("negative-cell") && !verdict.has("folded-facet"));
    assert!(verdict.has("reflex-ridge") || verdict.has("winds-again"), "{verdict}");
}

/// Fault 13b: the same, convex at every corner, so that only the ray can tell.
#[test]
fn double_cover_with_convex_boundary() {
    let input = twice_around();
    let verdict = rejected(&input, "winds-again");
    assert!(!verdict.has("reflex-ridge") && !verdict.has("unseen-facet"), "{verdict}");
    assert!(!verdict.has("euler"), "euler's formula does not notice");
}

/// Six corners of two congruent triangles, one turned by a half turn, visited in one round of two
/// turns.
fn twice_around() -> Owned<2> {
    let a = [[12.0, 0.0], [-6.0, 10.0], [-6.0, -10.0]];
    let b = a.map(|[x, y]| [x + 0.5, y + 0.25]);
    let mut points = vec![[0.0, 0.0]];
    points.extend(a);
    points.extend(b);
    let cells: Vec<u32> = (0..6).flat_map(|i| [0, 1 + i, 1 + (i + 1) % 6]).collect();
    Owned::new(&points, 2, &cells)
}

/// Fault 14: a suspension of that double cover: a surface in space, convex at every ridge.
#[test]
fn double_cover_in_space() {
    let flat = twice_around();
    let mut points: Vec<[f64; 3]> = flat.points.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    points.extend([[0.0, 0.0, 20.0], [0.0, 0.0, -20.0]]);
    let mut cells = Vec::new();
    for triangle in flat.cells.chunks(3) {
        let [a, b, c] = [triangle[0], triangle[1], triangle[2]];
        cells.extend([a, b, c, 7]);
        cells.extend([b, a, c, 8]);
    }
    rejected(&Owned::new(&points, 3, &cells), "winds-again");
}

/// Fault 15: A fold: two cells on one side of their facet.
#[test]
fn fold() {
    let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 3.0], [2.0, 1.0]];
    rejected(&Owned::new(&points, 2, &[0, 1, 2, 0, 1, 3]), "folded-facet");
}

/// Fault 16: A triangulated polygon that is not convex.
#[test]
fn hull_not_convex() {
    let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [3.0, 1.0]];
    rejected(&Owned::new(&points, 2, &[0, 1, 3, 1, 2, 3]), "reflex-ridge");
}

/// Fault 17: Ties the other way: rejected strictly, accepted weakly.
#[test]
fn tie_the_wrong_way() {
    let mut grid = square_grid(4);
    let right = strict(&grid);
    grid.cells[..6].copy_from_slice(&[0, 1, 6, 0, 6, 5]);
    let verdict = rejected(&grid, "wrong-tie");
    assert_eq!((verdict.counts["wrong-tie"], verdict.counts.len()), (1, 1));
    assert_eq!((verdict.level, verdict.ties), (Level::WeaklyDelaunay, right.ties));
    let verdict = weak(&grid);
    assert!(verdict.ok);
    assert_eq!((verdict.level, verdict.ties), (Level::WeaklyDelaunay, right.ties));
}

/// Fault 18: Two triangulations side by side, or touching in a point.
#[test]
fn two_pieces() {
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [5.0, 0.0], [6.0, 0.0], [5.0, 1.0]];
    rejected(&Owned::new(&points, 2, &[0, 1, 2, 3, 4, 5]), "disconnected");
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    rejected(&Owned::new(&points, 2, &[0, 1, 2, 0, 3, 4]), "open-boundary");
}

/// Any other triangulation of the same points is told: every flip of an edge, one at a time.
#[test]
fn every_single_flip_is_found() {
    let input = scattered();
    let cells: Vec<&[u32]> = input.cells.chunks(3).collect();
    let mut flips = 0;
    for i in 0..cells.len() {
        for j in 0..i {
            let Some(a) = cells[i].iter().find(|v| !cells[j].contains(v)) else { continue };
            let apexes: Vec<u32> =
                cells[j].iter().copied().filter(|v| !cells[i].contains(v)).collect();
            if apexes.len() != 1 {
                continue;
            }
            let common: Vec<u32> = cells[i].iter().copied().filter(|v| v != a).collect();
            let mut flipped = input.clone();
            flipped.cells[3 * i..3 * i + 3].copy_from_slice(&[*a, apexes[0], common[0]]);
            flipped.cells[3 * j..3 * j + 3].copy_from_slice(&[*a, apexes[0], common[1]]);
            assert!(!weak(&flipped).ok);
            flips += 1;
        }
    }
    assert!(flips > 10, "{flips}");
}

#[test]
fn faults_are_capped_but_counted() {
    let mut grid = square_grid(8);
    for cell in grid.cells.chunks_mut(3) {
        cell.swap(0, 1);
    }
    let verdict = judge_delaunay(&grid.complex(), &Options::default());
    assert_eq!(verdict.counts["negative-cell"], 128);
    assert_eq!(verdict.faults.iter().filter(|f| f.kind() == "negative-cell").count(), 20);
    assert!(verdict.to_string().contains("and 108 more of negative-cell"));
}

/// Nothing in the data can make the judge panic.
#[test]
fn garbage_is_rejected_without_panic() {
    let mut random = Random(37);
    for _ in 0..300 {
        let n = 1 + random.below(8);
        let points = random.grid::<2>(n as usize, 3);
        let cells: Vec<u32> = (0..random.below(30)).map(|_| random.below(n + 1)).collect();
        for k in 0..3 {
            let verdict = weak(&Owned::new(&points, k, &cells));
            assert_eq!(verdict.ok, verdict.faults.is_empty());
        }
    }
}
