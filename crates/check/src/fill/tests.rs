use super::*;

/// A square of side 3 with a square hole of side 1 in its middle, triangulated by hand; the hole's cells come last.
fn square() -> (Vec<[f64; 2]>, Vec<u32>, Vec<[u32; 2]>) {
    let points =
        [[0, 0], [3, 0], [3, 3], [0, 3], [1, 1], [2, 1], [2, 2], [1, 2]].map(|p| p.map(f64::from));
    let mut cells = Vec::new();
    for i in 0..4u32 {
        let j = (i + 1) % 4;
        cells.extend([i, j, 4 + j, i, 4 + j, 4 + i]);
    }
    cells.extend([4, 5, 6, 4, 6, 7]);
    let outer = (0..4u32).map(|i| [i, (i + 1) % 4]);
    let inner = (0..4u32).map(|i| [4 + (i + 1) % 4, 4 + i]); // clockwise
    (points.to_vec(), cells, outer.chain(inner).collect())
}

const RULES: [FillRule<'_>; 5] = [
    FillRule::EvenOdd,
    FillRule::NonZero,
    FillRule::Positive,
    FillRule::Nesting,
    FillRule::Exterior,
];

/// The verdicts by rule: whether the ring, and whether the hole, is to be inside.
fn check(segments: &[[u32; 2]], expected: [[bool; 2]; 5]) {
    let (points, cells, _) = square();
    let complex = Complex { points: &points, dimension: Some(2), cells: &cells };
    for (rule, expected) in RULES.into_iter().zip(expected) {
        for claim in [[false, false], [false, true], [true, false], [true, true]] {
            let inside = [[claim[0]; 8].as_slice(), &[claim[1]; 2]].concat();
            let verdict = judge_fill(&complex, segments, &inside, rule, &Options::default());
            assert_eq!(verdict.ok, claim == expected, "{rule:?} {claim:?}: {verdict}");
            let wrong = usize::from(claim[0] != expected[0]) + usize::from(claim[1] != expected[1]);
            assert_eq!(verdict.counts.get("wrong-side").copied().unwrap_or(0), wrong);
        }
    }
}

#[test]
fn holes_by_every_rule() {
    let (_, _, segments) = square();
    check(&segments, [[true, false], [true, false], [true, false], [true, false], [true, true]]);
    // The hole's ring turned: wound twice.
    let turned: Vec<[u32; 2]> =
        segments.iter().map(|&[a, b]| if a >= 4 { [b, a] } else { [a, b] }).collect();
    check(&turned, [[true, false], [true, true], [true, true], [true, false], [true, true]]);
    // All clockwise.
    let back: Vec<[u32; 2]> = turned.iter().map(|&[a, b]| [b, a]).collect();
    check(&back, [[true, false], [true, true], [false, false], [true, false], [true, true]]);
    // The hole's ring twice.
    let twice = [&segments[..], &segments[4..]].concat();
    check(&twice, [[true, true], [true, true], [true, false], [true, false], [true, true]]);
}

#[test]
fn seeds_drain_their_regions() {
    let (points, cells, segments) = square();
    let complex = Complex { points: &points, dimension: Some(2), cells: &cells };
    for (seeds, expected) in [
        (vec![], [true, true]),
        (vec![[9.0, 9.0]], [true, true]),
        (vec![[1.5, 1.5]], [true, false]), // on a free edge
        (vec![[1.25, 1.5]], [true, false]),
        (vec![[0.5, 1.5]], [false, true]),
        (vec![[0.5, 1e-300], [1.5, 1.75]], [false, false]),
    ] {
        for claim in [[false, false], [false, true], [true, false], [true, true]] {
            let inside = [[claim[0]; 8].as_slice(), &[claim[1]; 2]].concat();
            let rule = FillRule::Seeds(&seeds);
            let verdict = judge_fill(&complex, &segments, &inside, rule, &Options::default());
            assert_eq!(verdict.ok, claim == expected, "{seeds:?} {claim:?}: {verdict}");
        }
    }
}

#[test]
fn slits_count_for_nothing() {
    let (_, _, mut segments) = square();
    segments.push([0, 4]); // a bridge
    check(&segments, [[true, false], [true, false], [true, false], [true, false], [true, true]]);
}

#[test]
fn a_flag_within_a_region_leaks() {
    let (points, cells, segments) = square();
    let complex = Complex { points: &points, dimension: Some(2), cells: &cells };
    for cell in 0..10 {
        let mut inside = [[true; 8].as_slice(), &[false; 2]].concat();
        inside[cell] = !inside[cell];
        let verdict =
            judge_fill(&complex, &segments, &inside, FillRule::EvenOdd, &Options::default());
        assert!(verdict.has("fill-leaks"), "{cell}: {verdict}");
    }
    let short = judge_fill(&complex, &segments, &[true], FillRule::EvenOdd, &Options::default());
    assert!(short.has("bad-length"));
    // Without its outer ring, nothing keeps the hull's cells inside.
    let open =
        judge_fill(&complex, &segments[4..], &[true; 10], FillRule::Exterior, &Options::default());
    assert!(open.has("fill-leaks"));
}
