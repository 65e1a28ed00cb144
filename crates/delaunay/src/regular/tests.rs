use delone_check::{Complex, Options as Judge, judge_regular, naive};
use delone_mesh::Level;
use delone_sites::{Sites, scatter};

use super::*;
use crate::{Order, delaunay};

fn below(seed: &mut u64, n: u32) -> f64 {
    *seed += 1;
    f64::from(u32::try_from(scatter(*seed) >> 32).unwrap() % n)
}

/// Brute force, the judge, and every order; returns the triangulation.
fn check<const D: usize>(points: &[[f64; D]], weights: &[f64]) -> Regular<D> {
    let sites = WeightedSites::new(points, weights).unwrap();
    let first = regular(&sites, &Options::default(), &mut ());
    assert_eq!(first.mesh().faults(Level::Sphere, points.len()), []);
    for order in [Order::AsGiven, Order::Hilbert, Order::Lexicographic] {
        let other = regular(&sites, &Options { order, ..Options::default() }, &mut ());
        assert_eq!(other.canonical(), first.canonical(), "{points:?} {weights:?}");
        assert_eq!(other.hidden(), first.hidden());
        assert_eq!(other.fingerprint(&sites), first.fingerprint(&sites));
    }
    let input_of = sites.input_of();
    let (mesh, mut definition) = (first.mesh(), naive::regular(points, weights).concat());
    let mut found = mesh.canonical(|v| input_of[v.index()]);
    assert_eq!(found, definition, "{points:?} {weights:?}");
    found.sort_unstable();
    definition.sort_unstable();
    definition.dedup();
    let hidden = first.hidden_inputs(&sites);
    let all = (0..u32::try_from(points.len()).unwrap()).filter(|v| !definition.contains(v));
    assert_eq!(hidden, all.collect::<Vec<_>>());
    let corners = mesh.solid_cells().flat_map(|cell| mesh.corners(cell));
    let cells: Vec<u32> = corners.map(|v| input_of[v.index()]).collect();
    let complex = Complex { points, dimension: mesh.dimension(), cells: &cells };
    let verdict = judge_regular(&complex, weights, &Judge::default());
    assert!(verdict.ok && verdict.level == delone_check::Level::Regular, "{verdict}");
    first
}

#[test]
fn hidden_sites_are_those_of_the_definition() {
    let (mut seed, mut hidden, mut shown) = (0, 0, 0);
    for round in 0..150u32 {
        let count = 1 + round as usize % 12;
        let (side, heavy) = (3 + round % 4, 1 + 4 * (round % 7));
        let points: Vec<[f64; 2]> =
            (0..count).map(|_| [below(&mut seed, side), below(&mut seed, side)]).collect();
        let weights: Vec<f64> = (0..count).map(|_| below(&mut seed, heavy)).collect();
        let result = check(&points, &weights);
        hidden += result.hidden().len();
        shown += count - result.hidden().len();
    }
    assert!(hidden > 50 && shown > 300, "{hidden} hidden, {shown} not");
    for round in 0..60u32 {
        let count = 1 + round as usize % 9;
        let points: Vec<[f64; 3]> =
            (0..count).map(|_| [(); 3].map(|()| below(&mut seed, 3))).collect();
        let weights: Vec<f64> = (0..count).map(|_| below(&mut seed, 1 + round % 4)).collect();
        check(&points, &weights);
    }
}

#[test]
fn equal_positions_hide_all_but_the_heaviest() {
    let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [0.0, 0.0], [4.0, 0.0]];
    let result = check(&points, &[0.0, 1.0, 0.0, 2.0, 1.0]);
    let sites = WeightedSites::new(&points, &[0.0, 1.0, 0.0, 2.0, 1.0]).unwrap();
    assert_eq!((result.hidden(), result.hidden_inputs(&sites)), (&[][..], vec![0, 4]));
    assert_eq!(check(&[[1.0, 2.0]; 3], &[1.0, 3.0, 2.0]).mesh().dimension(), Some(0));
    assert_eq!(check::<2>(&[], &[]).mesh().dimension(), None);
}

#[test]
fn regular_in_a_flat() {
    let mut seed = 7;
    for round in 0..40u32 {
        let count = 2 + round as usize % 8;
        let line: Vec<[f64; 2]> =
            (0..count).map(|_| below(&mut seed, 12)).map(|x| [x, 3.0 - 2.0 * x]).collect();
        let weights: Vec<f64> = (0..count).map(|_| below(&mut seed, 30)).collect();
        check(&line, &weights);
        let plane: Vec<[f64; 3]> = (0..count)
            .map(|_| [below(&mut seed, 4), below(&mut seed, 4)])
            .map(|[x, y]| [x, y, x + 2.0 * y])
            .collect();
        check(&plane, &weights);
    }
}

#[test]
fn equal_weights_are_delaunay() {
    let points: Vec<[f64; 2]> =
        (0..300u32).map(|i| [f64::from(i * 37 % 19), f64::from(i * i % 23)]).collect();
    let sites = WeightedSites::new(&points, &vec![2.5; 300]).unwrap();
    let plain = delaunay(&Sites::new(&points).unwrap(), &Options::default(), &mut ());
    let result = regular(&sites, &Options::default(), &mut ());
    assert_eq!((result.canonical(), result.hidden()), (plain.canonical(), &[][..]));
}

#[test]
fn a_few_heavy_sites_hide_most() {
    let mut seed = 9;
    let points: Vec<[f64; 2]> =
        (0..400).map(|_| [below(&mut seed, 1000), below(&mut seed, 1000)]).collect();
    let weights: Vec<f64> = (0..400).map(|i| if i % 40 == 0 { 40_000.0 } else { 0.0 }).collect();
    let sites = WeightedSites::new(&points, &weights).unwrap();
    let result = regular(&sites, &Options::default(), &mut ());
    assert!(result.hidden().len() > 200, "{}", result.hidden().len());
    let mesh = result.mesh();
    let corners = mesh.solid_cells().flat_map(|cell| mesh.corners(cell));
    let cells: Vec<u32> = corners.map(|v| sites.input_of()[v.index()]).collect();
    let complex = Complex { points: &points, dimension: Some(2), cells: &cells };
    let verdict = judge_regular(&complex, &weights, &Judge::default());
    assert!(verdict.ok, "{verdict}");
}
