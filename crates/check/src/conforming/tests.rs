use super::*;

struct Data {
    points: Vec<[f64; 2]>,
    mantissa: Vec<u64>,
    exponent: i64,
    free: Option<[f64; 2]>,
    exact: Option<[Binary<'static>; 2]>,
    cells: Vec<u32>,
    segments: Vec<[u32; 2]>,
    constrained: Vec<[u32; 2]>,
    promise: Promise,
}

/// A number that is not below zero.
fn binary(mantissa: &[u64], exponent: i64) -> Binary<'_> {
    Binary { mantissa, exponent, negative: false }
}

/// A kite whose long diagonal is split in its middle, by hand; `spoil` makes it wrong.
fn judged(spoil: impl FnOnce(&mut Data)) -> Verdict {
    let mut data = Data {
        points: vec![[0.0, 0.0], [3.0, 1.0], [6.0, 0.0], [3.0, -1.0]],
        mantissa: vec![1],
        exponent: -1,
        free: None,
        exact: None,
        cells: vec![0, 4, 1, 4, 2, 1, 0, 3, 4, 4, 3, 2],
        segments: vec![[0, 2]],
        constrained: vec![[0, 4], [2, 4]],
        promise: Promise::EmptyDisks,
    };
    spoil(&mut data);
    let on = SteinerPoint::On { ends: [0, 2], t: binary(&data.mantissa, data.exponent) };
    let steiner = match data.exact {
        Some(exact) => [SteinerPoint::Exactly(exact)],
        None => [data.free.map_or(on, SteinerPoint::At)],
    };
    let conformed = Conformed {
        points: &data.points,
        steiner: &steiner,
        cells: &data.cells,
        segments: &data.segments,
        constrained: &data.constrained,
        promise: data.promise,
    };
    judge_conforming(&conformed, &Options::default())
}

#[test]
fn the_right_answer_is_accepted() {
    for (promise, level) in [
        (Promise::Constrained, Level::Constrained),
        (Promise::Conforming, Level::Conforming),
        (Promise::EmptyDisks, Level::Conforming),
    ] {
        let verdict = judged(|data| data.promise = promise);
        assert!(verdict.ok && verdict.level == level, "{verdict}");
        let verdict = judged(|data| {
            data.promise = promise;
            data.free = Some([3.0, 0.0]); // as good
        });
        assert!(verdict.ok, "{verdict}");
    }
}

#[test]
fn each_fault_is_found() {
    let rejected = |kind: &str, spoil: &dyn Fn(&mut Data)| {
        let verdict = judged(spoil);
        assert!(!verdict.ok && verdict.has(kind), "expected {kind} in\n{verdict}");
    };
    rejected("off-segment", &|data| data.exponent = 0); // the end itself
    rejected("off-segment", &|data| data.mantissa = Vec::new()); // the other end
    rejected("off-segment", &|data| data.mantissa = vec![3]);
    rejected("off-segment", &|data| data.exponent = i64::MIN);
    rejected("off-segment", &|data| data.exponent = -(1 << 40));
    rejected("off-segment", &|data| data.segments.clear()); // on no segment then
    rejected("off-segment", &|data| data.segments.push([1, 3])); // two cross there: not noded
    rejected("broken-segment", &|data| data.free = Some([3.0, 1e-300])); // not on it
    rejected("missing-flag", &|data| data.constrained.truncate(1));
    rejected("bad-length", &|data| data.cells.push(0));
    rejected("bad-length", &|data| data.segments.push([0, 4])); // segments are between points
    rejected("not-finite", &|data| data.free = Some([f64::NAN, 0.0]));
    rejected("negative-cell", &|data| data.cells.swap(0, 1));
    rejected("unused-point", &|data| data.points.push([3.0, 0.5]));
}

/// A free point need be no double: by its digits it is on the diagonal, or off it by less than any double tells, on either side.
#[test]
fn free_points_are_exact() {
    let at = |y: Binary<'static>| {
        // 3 = 3/2 * 2, in a unit below that of the doubles and one above.
        let x = [binary(&[3], 0), binary(&[0, 3], -64)];
        x.map(|x| judged(|data| data.exact = Some([x, y])))
    };
    for verdict in at(Binary::default()) {
        assert!(verdict.ok, "{verdict}");
    }
    for negative in [false, true] {
        for verdict in at(Binary { negative, ..binary(&[1], -5000) }) {
            assert!(verdict.has("broken-segment"), "{negative}: {verdict}");
        }
    }
    let below = judged(|data| {
        data.points.iter_mut().for_each(|p| p[0] -= 6.0);
        data.exact = Some([Binary { negative: true, ..binary(&[3], 0) }, Binary::default()]);
    });
    assert!(below.ok, "{below}");
    let endless = Binary { exponent: i64::MIN, ..binary(&[1], 0) };
    assert!(at(endless).iter().all(|verdict| verdict.has("not-finite")));
    let high = judged(|data| {
        data.exact = Some([binary(&[3], 0), binary(&[1], 1)]); // (3, 2): beyond the kite
    });
    assert!(!high.ok, "{high}");
}

/// A segment that stays constrained only: its diametral disk holds both others, and so does the circle.
#[test]
fn the_promises_differ() {
    let points = [[0.0, 0.0], [6.0, 0.0], [3.0, 1.0], [3.0, -1.0]];
    let high = [[0.0, 0.0], [6.0, 0.0], [3.0, 2.0], [3.0, -40.0]];
    let judge = |points: &[[f64; 2]], promise| {
        let conformed = Conformed {
            points,
            steiner: &[],
            cells: &[0, 1, 2, 1, 0, 3],
            segments: &[[0, 1]],
            constrained: &[[0, 1]],
            promise,
        };
        judge_conforming(&conformed, &Options::default())
    };
    assert!(judge(&points, Promise::Constrained).ok);
    assert!(judge(&points, Promise::Conforming).has("not-delaunay"));
    assert!(judge(&high, Promise::Conforming).ok, "an edge of the Delaunay triangulation");
    assert!(judge(&high, Promise::EmptyDisks).has("encroached-edge"), "(3, 2) is 2 from (3, 0)");
    // On the circle: closed disks.
    let right = [[0.0, 0.0], [6.0, 0.0], [3.0, 3.0], [3.0, -40.0]];
    assert!(judge(&right, Promise::Conforming).ok);
    assert!(judge(&right, Promise::EmptyDisks).has("encroached-edge"));
}

/// Parameters of many limbs are read in full: a bit in the last place moves the vertex off the place where it ties.
#[test]
fn long_parameters_are_exact() {
    let judge = |low: u64| {
        let mantissa = [low, 0, 1 << 63];
        let steiner = [SteinerPoint::On { ends: [0, 1], t: binary(&mantissa, -192) }];
        let conformed = Conformed {
            points: &[[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [1.0, -1.0], [1.0, 0.0]],
            steiner: &steiner,
            cells: &[0, 5, 2, 5, 1, 2, 0, 3, 5, 5, 3, 1],
            segments: &[[0, 1]],
            constrained: &[[0, 5], [1, 5]],
            promise: Promise::Conforming,
        };
        judge_conforming(&conformed, &Options::default())
    };
    assert!(judge(0).ok, "the Steiner point stands for the equal point 4\n{}", judge(0));
    let moved = judge(1);
    assert!(moved.has("unused-point"), "point 4 is another vertex now\n{moved}");
}

/// A right triangle with the angles of 45 degrees at 0 and 2, as a refined triangulation; whether it is accepted.
fn refined(segments: &[[u32; 2]], cosine_square: f64, exceptions: &[usize]) -> Verdict {
    let conformed = Conformed {
        points: &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]],
        steiner: &[],
        cells: &[0, 1, 2],
        segments,
        constrained: segments,
        promise: Promise::Constrained,
    };
    let angles = Angles { cosine_square, inside: &[true], exceptions };
    judge_refined(&conformed, &angles, &Options::default())
}

#[test]
fn the_least_angle_is_decided_exactly() {
    assert!(refined(&[], 0.5, &[]).ok, "45 degrees were asked for");
    assert!(refined(&[], 0.5f64.next_up(), &[]).ok, "less");
    assert!(refined(&[], 0.5f64.next_down(), &[]).has("small-angle"), "a little more");
    assert!(refined(&[], 0.0, &[]).has("small-angle"), "90");
    assert!(refined(&[], 2.0, &[]).ok, "nothing");
}

#[test]
fn exceptions_touch_small_input_angles() {
    let sharp = [[0, 1], [0, 2]];
    assert!(refined(&sharp, 0.3, &[0]).ok, "45 degrees between segments");
    assert!(refined(&sharp, 0.3, &[]).has("small-angle"), "it is not named");
    assert!(refined(&[[0, 1], [1, 2]], 0.3, &[0]).has("no-exception"), "90 degrees");
    assert!(refined(&[[0, 1]], 0.3, &[0]).has("no-exception"), "one segment");
    assert!(refined(&sharp, 0.3, &[1]).has("bad-length"), "there is no such cell");
}

/// Two segments from 0 with Steiner points in their middles: the cell between these is at the small angle, by their labels.
#[test]
fn exceptions_are_found_beyond_the_first_shell() {
    let middle = |end| SteinerPoint::On { ends: [0, end], t: binary(&[1], -1) };
    let judged = |second: SteinerPoint<'_>| {
        let conformed = Conformed {
            points: &[[0.0, 0.0], [8.0, 0.0], [8.0, 6.0]],
            steiner: &[middle(1), second],
            cells: &[0, 3, 4, 3, 1, 4, 4, 1, 2],
            segments: &[[0, 1], [0, 2]],
            constrained: &[[0, 3], [1, 3], [0, 4], [2, 4]],
            promise: Promise::Constrained,
        };
        let angles = Angles { cosine_square: 0.01, inside: &[true; 3], exceptions: &[0, 1, 2] };
        judge_refined(&conformed, &angles, &Options::default())
    };
    assert!(judged(middle(2)).ok, "{}", judged(middle(2)));
    // A free point tells of no segment, and leaves one cell with the ends of the other alone.
    assert!(judged(SteinerPoint::At([4.0, 3.0])).has("no-exception"));
}
