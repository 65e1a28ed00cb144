use delone_check::Promise;

use super::*;
use crate::testing::{judged, pslg};

#[test]
fn a_line_conforms() {
    let graph = pslg(&[[0.0, 0.0], [1.0, 1.0], [3.0, 3.0], [2.0, 2.0]], &[[0, 2]]);
    let conforming = conform(&graph, &Encroached, &ConformOptions::default(), &mut ());
    assert!(judged(&graph, &conforming, Promise::EmptyDisks).ok);
    assert_eq!(conforming.constrained_edges(), [[0, 1], [1, 3], [2, 3]]);
}

#[test]
fn a_right_angle_encroaches() {
    let graph = pslg(&[[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [1.0, -2.0]], &[[0, 1]]);
    let options = ConformOptions::default();
    // (1, 1) is on the diametral circle: a closed disk holds it. The edge is Delaunay.
    let weak = conform(&graph, &Missing, &options, &mut ());
    let strong = conform(&graph, &Encroached, &options, &mut ());
    assert_eq!((weak.steiner_points().len(), strong.steiner_points().len()), (0, 1));
    assert!(judged(&graph, &strong, Promise::EmptyDisks).ok);
}
