use std::sync::Arc;

use super::{Corpus, Piece};
use crate::fuzz::{Input, target};

fn square(side: f64) -> Piece {
    let points = vec![0.0, 0.0, side, 0.0, side, side, 0.0, side];
    Piece { dimension: 2, points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]] }
}

#[test]
fn cases_take_points_and_segments_of_files() {
    let target = target("crossings").unwrap();
    let corpus = Arc::new(Corpus::new(vec![square(777.25), square(-3e100)]));
    let with = target.clone().with_corpus(corpus);
    let cases: Vec<Input> = (0..200).map(|k| with.case(1, k)).collect();
    assert!(
        (0..200).zip(&cases).all(|(k, case)| with.case(1, k) == *case),
        "case k is a function of k"
    );
    let has = |x: f64| {
        let holds = |input: &&Input| match input {
            Input::Plane(case) => case.points.as_flattened().contains(&x),
            _ => false,
        };
        cases.iter().filter(holds).count()
    };
    assert!(has(777.25) > 30 && has(-3e100) > 30, "{} {}", has(777.25), has(-3e100));
    let side = |input: &&Input| match input {
        Input::Plane(case) => case
            .segments
            .iter()
            .any(|ends| ends.map(|v| case.points[v as usize]) == [[777.25, 0.0], [777.25, 777.25]]),
        _ => false,
    };
    assert!(cases.iter().filter(side).count() > 10, "segments come along");
}

#[test]
fn without_a_corpus_nothing_changes() {
    let target = target("cdt").unwrap();
    let with = target.clone().with_corpus(Arc::new(Corpus::default()));
    assert!((0..50).all(|k| with.case(3, k) == target.case(3, k)));
}

#[test]
fn the_digest_tells_corpora_apart() {
    let digest = |pieces: &[Piece]| Corpus::new(pieces.to_vec()).digest();
    assert_ne!(digest(&[square(1.0)]), digest(&[square(2.0)]));
    assert_ne!(digest(&[square(1.0), square(2.0)]), digest(&[square(2.0), square(1.0)]));
    let empty = Piece { dimension: 3, points: vec![], segments: vec![] };
    assert_eq!(digest(&[empty]), 0);
}
