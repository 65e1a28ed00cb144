use super::*;
use crate::exact::Pure;
use crate::testing::Random;

fn space<const D: usize>(points: &[[f64; D]]) -> Space<'_, D, Pure> {
    Space::new(points, true)
}

#[test]
fn unit_simplices_are_positive_and_hold_their_middle() {
    let triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.25, 0.25], [2.0, 2.0]];
    let s = space(&triangle);
    assert_eq!(s.orient(&[0, 1, 2]), Sign::Positive);
    assert_eq!(s.in_sphere(&[0, 1, 2], Sign::Positive, 3), Place::Inside);
    assert_eq!(s.in_sphere(&[1, 0, 2], Sign::Negative, 3), Place::Inside);
    assert_eq!(s.in_sphere(&[0, 1, 2], Sign::Positive, 4), Place::Outside);
    let tetrahedron = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.2, 0.2, 0.2],
        [2.0, 2.0, 2.0],
    ];
    let s = space(&tetrahedron);
    assert_eq!(s.orient(&[0, 1, 2, 3]), Sign::Positive);
    assert_eq!(s.in_sphere(&[0, 1, 2, 3], Sign::Positive, 4), Place::Inside);
    assert_eq!(s.in_sphere(&[0, 1, 2, 3], Sign::Positive, 5), Place::Outside);
}

#[test]
fn the_greatest_point_leaves_the_circle() {
    let square = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let s = space(&square);
    let on = |cell: &[u32], q| s.in_sphere(cell, s.orient(cell), q);
    assert_eq!(on(&[0, 1, 2], 3), Place::On { perturbed_inside: false });
    assert_eq!(on(&[1, 3, 2], 0), Place::On { perturbed_inside: false });
    assert_eq!(on(&[0, 1, 3], 2), Place::On { perturbed_inside: true });
    assert_eq!(on(&[0, 3, 2], 1), Place::On { perturbed_inside: true });
}

/// All numbers, filtered or not, on points of the whole range and on small grids: one verdict, from
/// either side of a facet.
#[test]
fn every_arithmetic_gives_the_same_place() {
    let mut random = Random(11);
    for round in 0..2000 {
        let points: Vec<[f64; 3]> = match round % 3 {
            0 => (0..5).map(|_| std::array::from_fn(|_| random.double())).collect(),
            1 => random.grid(5, 3),
            _ => (0..5)
                .map(|_| {
                    std::array::from_fn(|_| {
                        let x = f64::from(random.below(3)) * 0.1;
                        if random.below(4) == 0 { x.next_up() } else { x }
                    })
                })
                .collect(),
        };
        let filtered = space(&points);
        let plain: Space<'_, 3, Pure> = Space::new(&points, false);
        let (cell, other) = ([0, 1, 2, 3], [0, 2, 1, 4]);
        let o = plain.orient(&cell);
        assert_eq!(filtered.orient(&cell), o);
        #[cfg(feature = "rug")]
        {
            let gmp: Space<'_, 3, crate::exact::Gmp> = Space::new(&points, false);
            assert_eq!(gmp.orient(&cell), o);
            assert!(o == Sign::Zero || gmp.in_sphere(&cell, o, 4) == plain.in_sphere(&cell, o, 4));
        }
        let distinct = (0..5).all(|i| (0..i).all(|j| points[i] != points[j]));
        if o == Sign::Zero || !distinct {
            continue;
        }
        let place = plain.in_sphere(&cell, o, 4);
        assert_eq!(filtered.in_sphere(&cell, o, 4), place, "{points:?}");
        let o2 = plain.orient(&other);
        if o2 == o {
            // Both cells share the facet 0 1 2, on opposite sides: the test is symmetric.
            assert_eq!(plain.in_sphere(&other, o2, 3), place, "{points:?}");
        }
    }
}
