use delone_check::Promise;
use delone_probe::{Event, Probe};

use crate::testing::{judged, pslg};
use crate::{ConformOptions, Limits, conform_by_protection};

#[test]
fn protection_of_a_square_and_a_cross() {
    let square = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];
    let graph = pslg(&square, &[[0, 1], [1, 2], [2, 3], [3, 0]]);
    let conforming = conform_by_protection(&graph, &ConformOptions::default(), &mut ());
    assert!(judged(&graph, &conforming, Promise::EmptyDisks).ok);
    assert_eq!(conforming.steiner_points(), [], "disks touch in the corners and avoid the rest");
    // A segment one unit from another asks for parts of two units at most, at once and without a triangulation.
    let lines = [[0.0, 0.0], [16.0, 0.0], [0.0, 1.0], [16.0, 1.0]];
    let graph = pslg(&lines, &[[0, 1], [2, 3]]);
    let conforming = conform_by_protection(&graph, &ConformOptions::default(), &mut ());
    assert!(judged(&graph, &conforming, Promise::EmptyDisks).ok);
    assert_eq!(conforming.steiner_points().len(), 2 * 15, "halves of 16 below 2 are 1");
}

#[test]
fn protection_leaves_slivers_to_the_adaptive_method() {
    let wedge = |height: f64| pslg(&[[0.0, 0.0], [64.0, height], [64.0, 0.0]], &[[0, 1], [0, 2]]);
    let limits = Limits { vertices_max: 2_000 };
    let options = ConformOptions { limits, ..ConformOptions::default() };
    let conforming = conform_by_protection(&wedge(1.0), &options, &mut ());
    assert!(conforming.is_complete());
    assert!(judged(&wedge(1.0), &conforming, Promise::EmptyDisks).ok);
    let pure = ConformOptions { cuts_max: 5_000, ..options };
    let conforming = conform_by_protection(&wedge(1e-9), &pure, &mut ());
    assert!(!conforming.is_complete(), "a billion points");
    assert!(judged(&wedge(1e-9), &conforming, Promise::Constrained).ok);
    let conforming = conform_by_protection(&wedge(1e-9), &options, &mut ());
    assert!(conforming.is_complete() && conforming.steiner_points().len() < 100, "adaptively");
    assert!(judged(&wedge(1e-9), &conforming, Promise::EmptyDisks).ok);
}

/// Goes on so many times.
struct Patience(usize);

impl Probe for Patience {
    fn on(&mut self, _: Event) {}

    fn goes_on(&mut self) -> bool {
        let goes_on = self.0 > 0;
        self.0 = self.0.saturating_sub(1);
        goes_on
    }
}

#[test]
fn protection_stops_between_any_two_cuts() {
    let wedge = pslg(&[[0.0, 0.0], [64.0, 1.0], [64.0, 0.0]], &[[0, 1], [0, 2]]);
    let options = ConformOptions::default();
    let all = conform_by_protection(&wedge, &options, &mut ()).steiner_points().len();
    assert!(all > 100, "both segments are cut often: {all}");
    for patience in [0, 1, 2, 50, all - 1] {
        let stopped = conform_by_protection(&wedge, &options, &mut Patience(patience));
        assert_eq!((stopped.steiner_points().len(), stopped.is_complete()), (patience, false));
        assert!(judged(&wedge, &stopped, Promise::Constrained).ok);
    }
}

/// From the smallest double to the largest: nothing overflows, and no cut is beyond an end.
#[test]
fn protection_over_the_whole_range() {
    let (far, large) = (1.8268770466636286e47, f64::MAX / 2.0);
    let needles = [[0.0, 0.0], [0.0, 1.0], [far, 0.0], [large, 1.0]];
    let cross = [[-f64::MAX, 5e-324], [f64::MAX, 5e-324], [1.0, f64::MAX], [1.0, 1.0]];
    for (points, segments) in
        [(needles, [[1, 3], [1, 2], [1, 0]]), (cross, [[0, 1], [2, 3], [1, 2]])]
    {
        let graph = pslg(&points, &segments);
        let options = ConformOptions { cuts_max: 8, ..ConformOptions::default() };
        let conforming = conform_by_protection(&graph, &options, &mut ());
        assert!(conforming.is_complete());
        assert!(judged(&graph, &conforming, Promise::EmptyDisks).ok);
    }
}

#[test]
fn protection_keeps_to_the_limit() {
    let points = [[0.0, 0.0], [4.0, 0.0], [0.0, -1.0], [0.0, -2.0], [4.0, 2.0]];
    let graph = pslg(&points, &[[1, 4], [0, 2], [2, 3], [1, 3], [0, 4], [1, 0], [1, 2]]);
    for cuts_max in [0, 256] {
        let with = |vertices_max: usize| {
            let options =
                ConformOptions { cuts_max, limits: Limits { vertices_max }, ..Default::default() };
            conform_by_protection(&graph, &options, &mut ())
        };
        let enough = with(usize::MAX).kernel().len();
        for vertices_max in 5..=enough {
            let conforming = with(vertices_max);
            assert!(conforming.kernel().len() <= vertices_max, "{vertices_max}");
            assert_eq!(conforming.is_complete(), vertices_max == enough, "{vertices_max}");
        }
    }
}
