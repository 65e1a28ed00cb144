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
