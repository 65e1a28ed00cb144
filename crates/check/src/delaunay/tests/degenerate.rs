//! Points in lower-dimensional flats, and coordinates of the whole range.

use super::*;
use crate::testing::kuhn_grid;
use crate::{Orientation, naive};

#[test]
fn lower_dimensions_are_accepted() {
    accepted(&Owned::<2> { points: Vec::new(), dimension: None, cells: Vec::new() });
    accepted(&Owned::new(&[[7.0, 8.0, 9.0]], 0, &[0]));
    accepted(&Owned::new(&[[7.0, 8.0], [7.0, 8.0]], 0, &[1]));
    let line = [[1.0, 1.0], [3.0, 3.0], [2.0, 2.0], [0.0, 0.0]];
    accepted(&Owned::new(&line, 1, &[3, 0, 0, 2, 2, 1]));
    accepted(&Owned::new(&line, 1, &[0, 3, 2, 0, 1, 2])); // from right to left
    let upright = [[2.0, 0.5, 1.0], [2.0, 0.5, -1.0], [2.0, 0.5, 0.0]];
    accepted(&Owned::new(&upright, 1, &[1, 2, 2, 0]));
    let mut random = Random(35);
    let tilted: Vec<[f64; 3]> =
        random.grid::<2>(14, 5).iter().map(|&[x, y]| [y, x - 2.0 * y, 3.0 * x + y]).collect();
    let input = Owned::delaunay(&tilted);
    assert_eq!(input.dimension, Some(2));
    let verdict = judged(&input, Options { orientation: Orientation::Any, ..Options::default() });
    assert!(verdict.ok && verdict.level == Level::Delaunay, "{verdict}");
}

#[test]
fn lower_dimensions_are_rejected_for_what_they_lack() {
    let line = [[1.0, 1.0], [3.0, 3.0], [2.0, 2.0], [0.0, 0.0]];
    rejected(&Owned::new(&line, 1, &[3, 0, 2, 1]), "disconnected");
    rejected(&Owned::new(&line, 1, &[3, 0, 0, 1]), "unused-point");
    rejected(&Owned::new(&line, 1, &[3, 2, 2, 1, 0, 3]), "negative-cell");
    rejected(&Owned::new(&line, 1, &[3, 0, 2, 0, 2, 1]), "negative-cell");
    rejected(&Owned::new(&line, 2, &[3, 0, 2]), "flat-cell");
    let mut bent = line;
    bent[1][1] = bent[1][1].next_up();
    rejected(&Owned::new(&bent, 1, &[3, 0, 0, 2, 2, 1]), "off-flat");
    rejected(&Owned::new(&line, 0, &[2]), "off-flat");
    rejected(&Owned::new(&[[1.0], [1.0]], 0, &[0, 0]), "duplicate-cell");
    rejected(&Owned::new(&[[1.0], [1.0]], 0, &[0, 1]), "duplicate-point");
}

/// The smallest and the largest doubles in one triangulation.
#[test]
fn the_whole_range_of_doubles() {
    let points = [[0.0, 0.0], [5e-324, 0.0], [0.0, 1.7e308], [1.7e308, 1.0]];
    let cells = naive::delaunay(&points);
    let mut input = Owned::new(&points, 2, &cells.concat());
    let any = Options { orientation: Orientation::Any, ..Options::default() };
    assert!(judged(&input, any).ok);
    input.points[3] = [f64::MAX, 5e-324];
    let cells = naive::delaunay(&input.points);
    input.cells = cells.concat();
    assert!(judged(&input, any).ok);
    let mut random = Random(36);
    for _ in 0..20 {
        let points: Vec<[f64; 2]> = (0..7).map(|_| [random.double(), random.double()]).collect();
        let input = Owned::new(&points, 2, &naive::delaunay(&points).concat());
        assert!(judged(&input, any).ok, "{points:?}");
    }
}

/// Flat boundary facets and cospherical cells everywhere, in space.
#[test]
fn kuhn_cubes_are_weakly_delaunay() {
    for side in 1..4 {
        let input = kuhn_grid(side);
        let verdict = weak(&input);
        assert!(verdict.ok && verdict.level == Level::WeaklyDelaunay, "{verdict}");
        assert!(verdict.ties > 0 && rejected(&input, "wrong-tie").counts.len() == 1);
    }
    let mut input = kuhn_grid(3);
    let middle = 4 * (6 * 13 + 2);
    input.cells.drain(middle..middle + 4);
    assert!(rejected(&input, "disconnected").has("reflex-ridge"));
}
