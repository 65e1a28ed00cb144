use delone_workloads::Rng;

use super::*;
use crate::refine::{Limits, RefineOptions, refine};
use crate::testing::pslg;

const BOX: [[f64; 2]; 4] =
    [[-1000.0, -1000.0], [1000.0, -1000.0], [1000.0, 1000.0], [-1000.0, 1000.0]];

/// Chains of points in a box: what is narrowest at 20.7 degrees.
fn gap_in_box(chains: &[&[[f64; 2]]]) -> Option<Gap> {
    let graph = in_box(chains);
    narrowest_gap(&graph, &Fill::Exterior, 20.7).unwrap()
}

fn in_box(chains: &[&[[f64; 2]]]) -> Pslg {
    let mut points = BOX.to_vec();
    let mut segments = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
    for chain in chains {
        for (place, &point) in chain.iter().enumerate() {
            let v = points.iter().position(|&p| p == point).unwrap_or(points.len());
            if v == points.len() {
                points.push(point);
            }
            if place > 0 {
                let before = points.iter().position(|&p| p == chain[place - 1]).unwrap();
                segments.push([before, v]);
            }
        }
    }
    pslg(&points, &segments)
}

#[test]
fn a_gap_is_as_long_as_its_segments_face_each_other() {
    let tangent = 20.7f64.to_radians().tan();
    let near = |x: f64, y: f64| (x - y).abs() < 1e-9 * y;
    // Level, from 200 to 700; from 200 over the end at 600, where the width is 2; the same the other way round, from 0.
    for (end, above, length, width) in [
        (800.0, [[200.0, 1.0], [700.0, 1.0]], 500.0, 1.0),
        (600.0, [[200.0, 1.0], [800.0, 2.5]], 400.0, 2.0),
        (800.0, [[-400.0, 2.0], [400.0, 1.0]], 400.0, 1.5),
    ] {
        let below = [[0.0, 0.0], [end, 0.0]];
        let gap = gap_in_box(&[&below, &above]).unwrap();
        assert!(near(gap.length, length) && near(gap.width, width), "{gap:?}");
        assert!(near(gap.triangles_min, COUNTED * length * tangent / width / 2.0), "{gap:?}");
        assert_eq!(gap.subsegments, [4, 5]);
    }
    // They do not face each other at all, or too little for what they are apart.
    assert_eq!(gap_in_box(&[&[[0.0, 0.0], [90.0, 0.0]], &[[100.0, 0.1], [200.0, 0.1]]]), None);
    assert_eq!(gap_in_box(&[&[[0.0, 0.0], [90.0, 0.0]], &[[0.0, 9.0], [90.0, 9.0]]]), None);
}

#[test]
fn a_wedge_is_no_gap() {
    assert_eq!(gap_in_box(&[&[[500.0, 0.01], [0.0, 0.0], [500.0, 0.0]]]), None);
}

#[test]
fn gaps_count_where_they_are_inside() {
    let square = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
    let gap_beside = |second: [[f64; 2]; 4]| {
        let all: Vec<[f64; 2]> = square.into_iter().chain(second).collect();
        let ring = |o: usize| (0..4).map(move |i| [o + i, o + (i + 1) % 4]);
        let graph = pslg(&all, &ring(0).chain(ring(4)).collect::<Vec<_>>());
        narrowest_gap(&graph, &Fill::Exterior, 20.7).unwrap()
    };
    assert_eq!(gap_beside(square.map(|[x, y]| [x + 9.000_001, y])), None, "outside");
    let found = gap_beside([[1e-6, 1.0], [3.0, 1.0], [3.0, 8.0], [1e-6, 8.0]]).unwrap();
    assert!((found.length - 7.0).abs() < 1e-9 && (found.width - 1e-6).abs() < 1e-12, "{found:?}");
}

/// A segment between two others that meet in an apex: their exceptions may be all there is across the gap.
#[test]
fn a_gap_within_a_wedge_is_not_told() {
    let (a, c) = ([[-100.0, -1.0], [100.0, -1.0]], [[-80.0, 0.5], [80.0, 0.5]]);
    let wedge = |height: f64| [[-98.0, 0.0], [0.0, height], [98.0, 0.0]];
    let (sharp, blunt) = (wedge(200.0), wedge(100.0));
    assert_eq!(gap_in_box(&[&a, &c, &sharp]), None, "52 degrees");
    assert!(gap_in_box(&[&a, &c, &blunt]).is_some(), "89 degrees");
    assert!(gap_in_box(&[&a, &c]).is_some());
}

/// Segments at apexes lead from one side of the gap to the other, or not quite.
#[test]
fn a_gap_round_which_apexes_lead_is_not_told() {
    let (a, c) = ([[-200.0, 0.0], [95.0, 0.0]], [[-200.0, 1.0], [100.0, 1.0]]);
    // Apexes at the first, the third, the fourth and the last: below a, round the right, and back to c.
    let way = [[-200.0, 0.0], [50.0, -20.0], [130.0, -5.0], [60.0, 20.0], [100.0, 1.0]];
    assert_eq!(gap_in_box(&[&a, &c, &way]), None);
    let mut broken = way[1..].to_vec();
    broken[0] = [52.0, -20.0];
    assert!(gap_in_box(&[&a, &c, &way[..2], &broken]).is_some());
}

/// Segments along each other at random, their ends joined at random: no triangulation has fewer triangles than its gaps ask for.
#[test]
fn refined_triangulations_have_as_many_triangles_as_gaps_ask_for() {
    let mut random = Rng::new(5);
    let mut number = |from: f64, to: f64| from + (to - from) * random.unit();
    let mut told = 0;
    for _ in 0..60 {
        let mut chains: Vec<Vec<[f64; 2]>> = Vec::new();
        let mut y = 0.0;
        for _ in 0..4 {
            let chain =
                [number(-400.0, -300.0), number(300.0, 400.0)].map(|x| [x, y + number(0.0, 0.4)]);
            y += 0.5 + number(0.0, 5.0);
            chains.push(chain.to_vec());
        }
        if number(0.0, 1.0) < 0.5 {
            let [from, to] = [chains[0][0], chains[1][0]];
            chains.push(vec![from, to]);
        }
        let chains: Vec<&[[f64; 2]]> = chains.iter().map(Vec::as_slice).collect();
        let graph = in_box(&chains);
        for angle_deg_min in [10.0, 20.7, 30.0] {
            let limits = Limits { vertices_max: 100_000 };
            let options = RefineOptions { angle_deg_min, limits, ..RefineOptions::default() };
            let refined = refine(&graph, &Fill::Exterior, &options, &mut ()).unwrap();
            assert!(refined.is_complete());
            if let Some(gap) = narrowest_gap(&graph, &Fill::Exterior, angle_deg_min).unwrap() {
                assert!(refined.cells().count() as f64 >= gap.triangles_min, "{gap:?}");
                told += 1;
            }
        }
    }
    assert!(told > 90, "{told} of 180 have gaps");
}
