use delone_delaunay::Options;
use delone_sites::{Pslg, PslgError, scatter};

use super::{chew_from_points, from_points};
use crate::{Cdt, cavity};

fn in_two_steps(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Result<(Pslg, Cdt), PslgError> {
    let pslg = Pslg::new(points, segments)?;
    let cdt = cavity(&pslg, &Options::default(), &mut ());
    Ok((pslg, cdt))
}

/// Compares the two ways; whether the input was accepted.
fn compare(points: &[[f64; 2]], segments: &[[usize; 2]]) -> bool {
    let expected = in_two_steps(points, segments);
    let accepted = same(from_points(points, segments, &mut ()), &expected, points, segments);
    same(chew_from_points(points, segments, &mut ()), &expected, points, segments);
    accepted
}

fn same(
    result: Result<(Pslg, Cdt), PslgError>,
    expected: &Result<(Pslg, Cdt), PslgError>,
    points: &[[f64; 2]],
    segments: &[[usize; 2]],
) -> bool {
    match (result, expected) {
        (Ok((pslg, cdt)), Ok((expected, by_cavity))) => {
            assert_eq!(&pslg, expected, "{points:?} {segments:?}");
            assert_eq!(cdt.canonical(), by_cavity.canonical(), "{points:?} {segments:?}");
            assert_eq!(cdt.constrained_edges(), pslg.subsegments(), "{points:?} {segments:?}");
            true
        }
        (Err(error), Err(expected)) => {
            assert_eq!(error.to_string(), expected.to_string());
            false
        }
        (one, other) => panic!("{one:?} and {other:?} for {points:?} {segments:?}"),
    }
}

fn grid(width: usize, height: usize) -> Vec<[f64; 2]> {
    let row = |y: usize| (0..width).map(move |x| [x as f64, y as f64]);
    (0..height).flat_map(row).collect()
}

fn all_pairs(count: usize) -> Vec<[usize; 2]> {
    (0..count).flat_map(|a| (0..a).map(move |b| [a, b])).collect()
}

#[test]
fn every_soup_of_a_grid_is_noded_on_the_way() {
    let points = grid(3, 3);
    let segments = all_pairs(9);
    let (mut accepted, mut refused) = (0, 0);
    for i in 0..segments.len() {
        for j in 0..=i {
            for k in 0..=j {
                let soup = [segments[i], segments[j], segments[k]];
                *if compare(&points, &soup) { &mut accepted } else { &mut refused } += 1;
            }
        }
    }
    assert!(accepted > 1000 && refused > 1000, "{accepted} {refused}");
}

#[test]
fn larger_soups_are_noded_on_the_way() {
    let points = grid(6, 5);
    let segments = all_pairs(30);
    let mut accepted = 0;
    for case in 0..2000u64 {
        let count = 2 + usize::try_from(case % 6).unwrap();
        let drawn = (0..count as u64).map(|i| scatter(case * 64 + i) % segments.len() as u64);
        let soup: Vec<[usize; 2]> = drawn.map(|i| segments[usize::try_from(i).unwrap()]).collect();
        accepted += usize::from(compare(&points, &soup));
    }
    assert!(accepted > 100, "{accepted}");
}

#[test]
fn segments_along_a_line_of_sites_are_cut_at_each() {
    let line: Vec<[f64; 2]> = (0..7).map(|x| [f64::from(x), 0.0]).collect();
    assert!(compare(&line, &[[0, 6], [2, 4], [5, 1]])); // all sites in line
    let mut with_roof = line;
    with_roof.push([3.0, 1.0]);
    assert!(compare(&with_roof, &[[0, 6], [2, 4], [5, 1], [3, 3]])); // along the hull
}

#[test]
fn bad_input_is_named_as_at_the_door() {
    assert!(!compare(&[[0.0, f64::NAN], [1.0, 0.0]], &[[0, 1], [0, 7]]));
    assert!(!compare(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], &[[0, 1], [0, 3]]));
}
