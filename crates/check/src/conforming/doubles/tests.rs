use super::*;

/// The kite with its long diagonal, and what stands for the middle of it.
fn kite(middle: [f64; 2], flags: Option<&[[u32; 2]]>, options: &Options) -> Verdict {
    let points = [[0.0, 0.0], [3.0, 1.0], [6.0, 0.0], [3.0, -1.0], middle];
    let cells = [0, 4, 1, 4, 2, 1, 0, 3, 4, 4, 3, 2];
    let complex = Complex { points: &points, dimension: Some(2), cells: &cells };
    judge_conforming_doubles(&complex, 4, &[[0, 2]], flags, options)
}

const HALVES: [[u32; 2]; 2] = [[4, 0], [2, 4]];

fn distances(verdict: &Verdict) -> Vec<f64> {
    let told = verdict.faults.iter().filter_map(|fault| match fault {
        Fault::BesideSegment { distance, .. } => Some(*distance),
        _ => None,
    });
    told.collect()
}

#[test]
fn on_the_segment_it_conforms() {
    for flags in [None, Some(&HALVES[..])] {
        let strict = kite([3.0, 0.0], flags, &Options::default());
        assert!(strict.ok && strict.level == Level::Conforming, "{strict}");
        let weak = kite([3.0, 0.0], flags, &Options::foreign());
        assert!(weak.ok && weak.level == Level::WeaklyConforming, "{weak}");
    }
    assert!(kite([3.0, 0.0], Some(&HALVES[..1]), &Options::default()).has("missing-flag"));
    assert!(
        kite([3.0, 0.0], Some(&[[0, 4], [4, 2], [1, 4]]), &Options::default()).has("extra-flag")
    );
}

/// The one fault; what is left proved is a Delaunay triangulation, with the segment bent.
#[test]
fn off_the_segment_the_distance_is_told() {
    for off in [1e-20, -1e-20, 5e-324, 0.5f64.powi(60)] {
        let verdict = kite([3.0, off], Some(&HALVES), &Options::default());
        assert_eq!(distances(&verdict), [off.abs()], "{verdict}");
        assert_eq!((verdict.faults.len(), verdict.level), (1, Level::Delaunay), "{verdict}");
        assert!(verdict.proved.iter().any(|claim| claim.starts_with("S5")), "{verdict}");
        // Without flags nothing says which point was meant to be on it.
        let verdict = kite([3.0, off], None, &Options::default());
        assert!(verdict.has("broken-segment") && distances(&verdict).is_empty(), "{verdict}");
        assert!(verdict.proved.iter().all(|claim| !claim.starts_with("K2")), "{verdict}");
    }
}

/// A segment of length 5 2^k from the origin, and points across it: 1.5 + d above 2 on 3 x = 4 y is 4 d / 5 off.
#[test]
fn distances_are_right_over_the_range_of_doubles() {
    for k in [0, 300, 900, -300, -1000] {
        let unit = 2f64.powi(k);
        let d = 0.5f64.powi(40);
        let points = [[0.0, 0.0], [4.0, 3.0], [2.0, -9.0], [-2.0, 9.0], [2.0, 1.5 + d]];
        let points = points.map(|point| point.map(|x| x * unit));
        let cells = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4];
        let complex = Complex { points: &points, dimension: Some(2), cells: &cells };
        let judge = |backend| {
            let options = Options { backend, ..Options::default() };
            judge_conforming_doubles(&complex, 4, &[[1, 0]], Some(&[[0, 4], [4, 1]]), &options)
        };
        let verdict = judge(Backend::Pure);
        let [distance] = distances(&verdict)[..] else { panic!("{verdict}") };
        let expected = 0.8 * d * unit;
        assert!((distance / expected - 1.0).abs() < 1e-15, "2^{k}: {distance:e} {expected:e}");
        assert!(Backend::all().iter().all(|&backend| judge(backend) == verdict), "2^{k}");
    }
}

/// Flagged edges through an input point are other segments' edges: the way round is no bent segment.
#[test]
fn a_way_through_input_points_is_none() {
    let points = [[0.0, 0.0], [3.0, 1.0], [6.0, 0.0], [3.0, -1.0]];
    let complex = Complex { points: &points, dimension: Some(2), cells: &[0, 3, 1, 3, 2, 1] };
    let flags = [[0, 1], [1, 2]];
    let segments = [[0, 2], [0, 1], [1, 2]];
    let judge = |points| {
        judge_conforming_doubles(&complex, points, &segments, Some(&flags), &Options::default())
    };
    let verdict = judge(4);
    assert!(verdict.has("broken-segment") && distances(&verdict).is_empty(), "{verdict}");
    assert_eq!(distances(&judge(1)), [1.0], "were it a Steiner point, it would be one off");
}

/// Two points off one segment, and a third exactly on it: two faults, of which the first is nearer to the end it starts from.
#[test]
fn every_point_off_a_segment_is_told() {
    let (up, down) = (0.5f64.powi(50), -0.5f64.powi(49));
    let points =
        [[0.0, 0.0], [8.0, 0.0], [4.0, 9.0], [4.0, -9.0], [2.0, up], [4.0, 0.0], [6.0, down]];
    let cells = [
        0, 4, 2, 4, 5, 2, 5, 6, 2, 6, 1, 2, //
        0, 3, 4, 4, 3, 5, 5, 3, 6, 6, 3, 1,
    ];
    let complex = Complex { points: &points, dimension: Some(2), cells: &cells };
    let flags = [[0, 4], [4, 5], [5, 6], [6, 1]];
    let options = Options::default();
    let verdict = judge_conforming_doubles(&complex, 4, &[[0, 1]], Some(&flags), &options);
    assert_eq!(distances(&verdict), [up, -down], "{verdict}");
    assert_eq!(verdict.faults.len(), 2, "{verdict}");
}

/// Where a fan of flagged edges leaves the segment's end, the one along it is taken.
#[test]
fn the_least_turn_leads_on() {
    let points = [[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [4.0, 2.0], [4.0, -1e-9]];
    let cells = [0, 4, 3, 4, 1, 3, 1, 2, 3];
    let complex = Complex { points: &points, dimension: Some(2), cells: &cells };
    let flags = [[0, 3], [3, 2], [0, 4], [4, 1]];
    let segments = [[0, 1], [0, 2]];
    let verdict =
        judge_conforming_doubles(&complex, 3, &segments, Some(&flags), &Options::default());
    assert_eq!(distances(&verdict), [1e-9], "{verdict}");
}

#[test]
fn what_is_not_delaunay_is_told_as_well() {
    let points = [[0.0, 0.0], [3.0, 1.0], [6.0, 0.0], [3.0, -1.0]];
    let complex = Complex { points: &points, dimension: Some(2), cells: &[0, 2, 1, 0, 3, 2] };
    let verdict = judge_conforming_doubles(&complex, 4, &[[0, 2]], None, &Options::default());
    assert!(verdict.has("not-delaunay") && verdict.level == Level::Triangulation, "{verdict}");
}

#[test]
fn lines_and_nothing() {
    let line = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0]];
    let complex = Complex { points: &line, dimension: Some(1), cells: &[0, 2, 2, 1] };
    let verdict = judge_conforming_doubles(&complex, 2, &[[0, 1]], None, &Options::foreign());
    assert!(verdict.ok && verdict.level == Level::WeaklyConforming, "{verdict}");
    let nothing = Complex { points: &[], dimension: None, cells: &[] };
    assert!(judge_conforming_doubles(&nothing, 0, &[], None, &Options::default()).ok);
}
