use super::*;

/// Two crossing diagonals in a rectangle, by hand; `spoil` makes it wrong.
fn judged(spoil: impl FnOnce(&mut Data)) -> Verdict {
    let mut data = Data {
        points: vec![[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0], [1.0, 9.0]],
        crossings: vec![[0, 2, 1, 3]],
        cells: vec![0, 1, 5, 1, 2, 5, 2, 3, 5, 3, 0, 5, 2, 4, 3],
        segments: vec![[0, 2], [3, 1]],
        constrained: vec![[0, 5], [5, 1], [2, 5], [5, 3]],
    };
    spoil(&mut data);
    let arranged = Arranged {
        points: &data.points,
        crossings: &data.crossings,
        cells: &data.cells,
        segments: &data.segments,
        constrained: &data.constrained,
    };
    judge_arranged(&arranged, &Options::default())
}

struct Data {
    points: Vec<[f64; 2]>,
    crossings: Vec<[u32; 4]>,
    cells: Vec<u32>,
    segments: Vec<[u32; 2]>,
    constrained: Vec<[u32; 2]>,
}

#[test]
fn the_right_answer_is_accepted() {
    let verdict = judged(|_| {});
    assert!(verdict.ok && verdict.level == Level::Constrained, "{verdict}");
}

#[test]
fn each_fault_is_found() {
    let rejected = |kind: &str, spoil: &dyn Fn(&mut Data)| {
        let verdict = judged(spoil);
        assert!(!verdict.ok && verdict.has(kind), "expected {kind} in\n{verdict}");
    };
    rejected("unused-point", &|data| data.crossings[0] = [0, 1, 3, 2]); // parallel lines
    rejected("negative-cell", &|data| data.cells.swap(0, 1));
    rejected("folded-facet", &|data| data.cells.extend([0, 1, 5]));
    rejected("reflex-ridge", &|data| data.cells.truncate(9));
    rejected("unused-point", &|data| data.cells.truncate(12));
    rejected("duplicate-point", &|data| data.points[4] = [1.5, 0.5]);
    rejected("broken-segment", &|data| data.segments.push([0, 4]));
    rejected("missing-flag", &|data| data.constrained.truncate(3));
    rejected("extra-flag", &|data| data.constrained.push([0, 1]));
    rejected("unused-point", &|data| data.segments.truncate(1)); // nothing crosses there then
    rejected("not-finite", &|data| data.points[0][1] = f64::NAN);
    rejected("bad-length", &|data| data.cells.truncate(8));
    rejected("bad-length", &|data| data.segments.push([0, 5]));
    // 0 1 5 and 1 2 5 with the diagonal 0 2 through 5: flat.
    rejected("negative-cell", &|data| data.cells[..6].copy_from_slice(&[0, 1, 2, 0, 2, 5]));
}

/// Ties and circles, with crossings as corners: a unit square around a crossing of diagonals far away would not do; so the
/// square's own corners are crossings.
#[test]
fn ties_between_crossings_follow_the_perturbation() {
    // Four lines x = 0, x = 1, y = 0, y = 1 cross in the corners 8 to 11 of a square.
    let points = vec![
        [0.0, -1.0],
        [0.0, 2.0],
        [1.0, -1.0],
        [1.0, 2.0],
        [-1.0, 0.0],
        [2.0, 0.0],
        [-1.0, 1.0],
        [2.0, 1.0],
    ];
    let crossings = vec![[0, 1, 4, 5], [2, 3, 4, 5], [2, 3, 6, 7], [0, 1, 6, 7]];
    let around = [
        0, 8, 4, 4, 8, 6, 8, 11, 6, 6, 11, 1, 1, 11, 10, 1, 10, 3, 3, 10, 7, 10, 5, 7, 10, 9, 5, 5,
        9, 2, 9, 8, 2, 2, 8, 0,
    ];
    let mut seen = Vec::new();
    for [s, t] in [[8u32, 10], [9, 11]] {
        let inner = if s == 8 { [8, 9, 10, 8, 10, 11] } else { [8, 9, 11, 9, 10, 11] };
        let cells: Vec<u32> = around.iter().chain(&inner).copied().collect();
        let flags = [
            [0, 8],
            [8, 11],
            [11, 1],
            [2, 9],
            [9, 10],
            [10, 3],
            [4, 8],
            [8, 9],
            [9, 5],
            [6, 11],
            [11, 10],
            [10, 7],
        ];
        let arranged = Arranged {
            points: &points,
            crossings: &crossings,
            cells: &cells,
            segments: &[[0, 1], [2, 3], [4, 5], [6, 7]],
            constrained: &flags,
        };
        let verdict = judge_arranged(&arranged, &Options::default());
        let kinds: Vec<&str> =
            verdict.counts.keys().copied().filter(|&kind| kind != "wrong-tie").collect();
        seen.push((s, t, verdict.ok, verdict.has("wrong-tie"), kinds.len(), verdict.ties > 0));
    }
    // The largest corner, 10, is lifted most, and so is cut off: the diagonal is 9 11.
    assert_eq!(seen[1], (9, 11, true, false, 0, true), "{seen:?}");
    assert!(seen[0].3 && !seen[0].2, "{seen:?}");
}
