use delone_delaunay::{Options, regular};
use delone_predicates::Dyadic;
use delone_workloads::Rng;

use super::*;
use crate::testing::{naive_values, of};

fn doubles<const D: usize>(filtration: &AlphaFiltration<D>) -> Vec<f64> {
    filtration.spectrum().map(|value| value.to_f64()).collect()
}

#[test]
fn a_square_grid_has_three_values() {
    let grid: Vec<[f64; 2]> = (0..25u8).map(|i| [i / 5, i % 5].map(f64::from)).collect();
    let filtration = of(&grid);
    assert_eq!(doubles(&filtration), [0.0, 0.25, 0.5]);
    let simplices = filtration.simplices();
    for edge in simplices.of_dimension(1).map(SimplexId::new) {
        let &[a, b] = simplices.vertices(edge) else { panic!("an edge has two ends") };
        let is_diagonal = b - a != 1 && b - a != 5;
        assert_eq!(filtration.rank(edge), if is_diagonal { 2 } else { 1 });
        assert!(!filtration.is_attached(edge));
    }
}

#[test]
fn an_obtuse_triangle_gives_its_long_edge_its_value() {
    let filtration = of(&[[0.0, 0.0], [8.0, 0.0], [4.0, 1.0]]);
    let find = |vertices: &[u32]| filtration.simplices().find(vertices).unwrap();
    let (edge, triangle) = (find(&[0, 1]), find(&[0, 1, 2]));
    assert!(filtration.is_attached(edge));
    assert_eq!(filtration.witness(edge), triangle);
    // R = abc / 4A = 8 * 17 / 16
    assert_eq!(filtration.value(edge).to_f64(), 8.5 * 8.5);
}

#[test]
fn sites_in_a_flat_have_the_values_of_the_flat() {
    let square = of(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [2.0, 2.0], [5.0, 1.0]]);
    let turned =
        of(&[[1.0, 0.0, 0.0], [1.0, 2.0, 0.0], [1.0, 0.0, 2.0], [1.0, 2.0, 2.0], [1.0, 5.0, 1.0]]);
    assert_eq!(doubles(&square), doubles(&turned));
    assert_eq!(square.ranks(), turned.ranks());
    assert_eq!(
        doubles(&of(&[[3.0, 1.0, 0.0], [1.0, 1.0, 0.0], [8.0, 1.0, 0.0]])),
        [0.0, 1.0, 6.25]
    );
    assert_eq!(doubles(&of(&[[3.0], [1.0], [8.0]])), [0.0, 1.0, 6.25]);
    assert_eq!(doubles(&of(&[[3.0, 5.0]])), [0.0]);
    assert_eq!(doubles::<2>(&of(&[])), [0.0; 0]);
}

#[test]
fn scaling_keeps_the_order_at_both_ends_of_the_range() {
    let mut rng = Rng::new(3);
    let points: Vec<[f64; 3]> =
        (0..30).map(|_| [0; 3].map(|_| rng.below(17) as f64 - 8.0)).collect();
    let plain = of(&points);
    for scale in [2f64.powi(-1050), 2f64.powi(1000)] {
        let scaled: Vec<[f64; 3]> = points.iter().map(|p| p.map(|x| x * scale)).collect();
        assert_eq!(of(&scaled).ranks(), plain.ranks(), "{scale}");
    }
}

#[test]
fn more_weight_for_all_shifts_the_values() {
    let points = [[0.0, 0.0], [4.0, 0.0], [1.0, 3.0], [5.0, 5.0], [2.0, 2.0]];
    let with = |more: f64| {
        let sites =
            WeightedSites::new(&points, &[1.0, 0.0, 2.0, 0.5, -1.0].map(|w| w + more)).unwrap();
        AlphaFiltration::of_regular(&sites, &regular(&sites, &Options::default(), &mut ()))
    };
    let (plain, shifted) = (with(0.0), with(8.0));
    assert_eq!(plain.ranks(), shifted.ranks());
    for (a, b) in plain.spectrum().zip(shifted.spectrum()) {
        let less = a.numerator().clone() - Dyadic::from(8) * a.denominator();
        assert_eq!(b, SquaredRadius::new(less, a.denominator().clone()));
    }
}

/// Values of every simplex against the definition, for a set of points of a small grid.
fn as_defined<const D: usize>(points: &[[f64; D]], weights: Option<&[f64]>) -> usize {
    let filtration = match weights {
        None => of(points),
        Some(weights) => {
            let sites = WeightedSites::new(points, weights).unwrap();
            AlphaFiltration::of_regular(&sites, &regular(&sites, &Options::default(), &mut ()))
        }
    };
    let simplices = filtration.simplices();
    let expected = naive_values(points, weights, simplices);
    let mut attached = 0;
    for (id, expected) in expected.iter().enumerate() {
        let simplex = SimplexId::new(id);
        let value = filtration.value(simplex);
        let ours = (value.numerator().to_f64(), value.denominator().to_f64());
        // Small integers: products of these are exact.
        assert_eq!(
            ours.0 * expected.1 as f64,
            expected.0 as f64 * ours.1,
            "{:?} of {points:?} {weights:?}",
            simplices.vertices(simplex)
        );
        attached += usize::from(filtration.is_attached(simplex));
    }
    let order = filtration.order();
    assert!(order.is_sorted_by_key(|&id| (filtration.ranks()[id as usize], id)));
    attached
}

fn subset<const D: usize>(grid: &[[f64; D]], set: u32) -> Vec<[f64; D]> {
    (0..grid.len()).filter(|&i| set >> i & 1 == 1).map(|i| grid[i]).collect()
}

#[test]
fn values_are_those_of_the_definition() {
    let plane: Vec<[f64; 2]> = (0..12u8).map(|i| [i / 3, i % 3].map(f64::from)).collect();
    let space: Vec<[f64; 3]> =
        (0..12u8).map(|i| [i / 4, i / 2 % 2, i % 2].map(f64::from)).collect();
    let mut rng = Rng::new(1);
    let mut attached = [0; 4];
    for set in 0..1 << 12 {
        let points = subset(&plane, set);
        let weights: Vec<f64> = points.iter().map(|_| rng.below(4) as f64).collect();
        attached[0] += as_defined(&points, None);
        attached[1] += as_defined(&points, Some(&weights));
        let points = subset(&space, set);
        attached[2] += as_defined(&points, None);
        if set % 4 == 0 {
            attached[3] += as_defined(&points, Some(&weights[..points.len()]));
        }
    }
    assert!(attached.iter().all(|&count| count > 1000), "{attached:?}");
}

#[test]
fn values_are_those_of_the_definition_on_random_sites() {
    let mut rng = Rng::new(7);
    let mut attached = 0;
    for round in 0..120 {
        let mut coordinate = || rng.below(5) as f64;
        let mut points: Vec<[f64; 3]> = (0..7).map(|_| [0; 3].map(|_| coordinate())).collect();
        points.sort_by(|a, b| a.partial_cmp(b).unwrap());
        points.dedup();
        let weights: Vec<f64> = points.iter().map(|_| coordinate()).collect();
        attached += as_defined(&points, (round % 2 == 0).then_some(&weights[..]));
    }
    assert!(attached > 500, "{attached}");
}

#[test]
fn values_do_not_depend_on_the_order_of_input() {
    let mut rng = Rng::new(4);
    let mut points: Vec<[f64; 2]> =
        (0..60).map(|_| [rng.below(9) as f64, rng.below(9) as f64]).collect();
    let first = of(&points);
    rng.shuffle(&mut points);
    let second = of(&points);
    assert_eq!(doubles(&first), doubles(&second));
    let count = |filtration: &AlphaFiltration<2>| {
        let mut ranks = filtration.ranks().to_vec();
        ranks.sort_unstable();
        ranks
    };
    assert_eq!(count(&first), count(&second));
}
