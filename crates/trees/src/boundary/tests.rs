use proptest::prelude::*;

use super::direction;
use crate::testing::tree;
use crate::{Frame, Joined, OrthTree};

type Ring = Vec<[u32; 2]>;

/// Twice the area, positive counter-clockwise.
fn twice_the_area(ring: &Ring) -> i64 {
    let wide = |p: [u32; 2]| p.map(i64::from);
    let next = |i: usize| wide(ring[(i + 1) % ring.len()]);
    (0..ring.len()).map(|i| (wide(ring[i]), next(i))).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum()
}

fn length(ring: &Ring) -> u64 {
    let next = |i: usize| ring[(i + 1) % ring.len()];
    let side = |i: usize| ring[i][0].abs_diff(next(i)[0]) + ring[i][1].abs_diff(next(i)[1]);
    (0..ring.len()).map(|i| u64::from(side(i))).sum()
}

proptest! {
    #[test]
    fn rings_bound_what_is_black(tree in tree::<2>(5)) {
        let depth = tree.depth();
        for joined in [Joined::ByFacets, Joined::AtCorners] {
            let rings = tree.boundary(joined);
            let areas: Vec<i64> = rings.iter().map(twice_the_area).collect();
            let volume = i64::try_from(tree.volume(depth).unwrap()).unwrap();
            prop_assert_eq!(areas.iter().sum::<i64>(), 2 * volume);
            let surface = u64::try_from(tree.surface(depth).unwrap()).unwrap();
            prop_assert_eq!(rings.iter().map(length).sum::<u64>(), surface);
            // A ring around each piece, and one around each hole: Euler's number.
            let outer = areas.iter().filter(|&&area| area > 0).count();
            let holes = areas.len() - outer;
            prop_assert_eq!(outer, tree.components(joined).count);
            prop_assert_eq!(i64::try_from(outer).unwrap() - i64::try_from(holes).unwrap(), tree.euler(joined));
            for ring in &rings {
                let n = ring.len();
                let side = |i: usize| direction((ring[i % n], ring[(i + 1) % n]));
                prop_assert!((0..n).all(|i| (side(i) + side(i + 1)) % 2 == 1), "sides alternate");
            }
        }
    }

    #[test]
    fn the_complex_is_closed(tree in tree::<2>(4)) {
        let frame = Frame::around(&[[0.0, 0.0], [8.0, 8.0]], 6).unwrap();
        let complex = tree.boundary_complex(&frame, Joined::ByFacets);
        let rings = tree.boundary(Joined::ByFacets);
        let sides: usize = rings.iter().map(Vec::len).sum();
        prop_assert_eq!(complex.vertices().len(), sides);
        let mut degree = vec![0; sides];
        if sides > 0 {
            let edges = complex.cells(1);
            prop_assert_eq!(edges.len(), sides);
            edges.iter().flatten().for_each(|&v| degree[v as usize] += 1);
        }
        prop_assert!(degree.iter().all(|&count| count == 2));
        let scale = 8.0 / f64::from(1u32 << tree.depth());
        let places = rings.iter().flatten().map(|p| p.map(|c| f64::from(c) * scale));
        prop_assert!(places.eq(complex.vertices().iter().copied()));
    }
}

#[test]
fn cells_that_meet_in_a_corner_are_joined_as_asked() {
    let tree = OrthTree::<2>::from_text("(BWWB").unwrap();
    let apart = tree.boundary(Joined::ByFacets);
    assert_eq!(apart, [[[0, 0], [1, 0], [1, 1], [0, 1]], [[1, 1], [2, 1], [2, 2], [1, 2]]]);
    let one = tree.boundary(Joined::AtCorners);
    assert_eq!(one, [[[0, 0], [1, 0], [1, 1], [2, 1], [2, 2], [1, 2], [1, 1], [0, 1]]]);
}
