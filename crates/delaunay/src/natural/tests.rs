use delone_sites::scatter;

use super::*;
use crate::{Options, PowerDiagram, delaunay};

const ONE: NonZeroUsize = NonZeroUsize::MIN;
const TWO: NonZeroUsize = NonZeroUsize::new(2).unwrap();

fn found(points: &[[f64; 2]], queries: &[[f64; 2]]) -> Vec<Vec<(u32, f64)>> {
    let sites = Sites::new(points).unwrap();
    let triangulation = delaunay(&sites, &Options::default(), &mut ());
    let found = natural_neighbours(&triangulation, &sites, queries, ONE).unwrap();
    assert_eq!(found, natural_neighbours(&triangulation, &sites, queries, TWO).unwrap());
    found
}

fn random(count: u64, side: u64, seed: u64) -> Vec<[f64; 2]> {
    let coordinate = |i: u64| f64::from(u32::try_from(scatter(i) % side).unwrap());
    (0..count).map(|i| [coordinate(seed + 2 * i), coordinate(seed + 2 * i + 1)]).collect()
}

/// The areas of the window-bounded regions with and without the query, site by site.
#[test]
fn shares_are_stolen_areas() {
    let points = random(25, 100, 1);
    let window = [[-1e4, -1e4], [1e4, 1e4]];
    let areas = |points: &[[f64; 2]]| {
        let sites = Sites::new(points).unwrap();
        let triangulation = delaunay(&sites, &Options::default(), &mut ());
        let diagram = PowerDiagram::of_delaunay(&triangulation, &sites).unwrap();
        let count = u32::try_from(sites.len()).unwrap();
        (0..count).map(|site| area(&diagram.polygon(site, window)).abs()).collect::<Vec<f64>>()
    };
    let before = areas(&points);
    for q in [[41.5, 52.5], [60.25, 33.0], [50.0, 50.5]] {
        let after = areas(&[&points[..], &[q]].concat());
        let shares = found(&points, &[q]).remove(0);
        assert!(shares.len() >= 3);
        for (site, (before, after_)) in before.iter().zip(&after).enumerate() {
            let expected = (before - after_) / after[points.len()];
            let share = shares.iter().find(|&&(s, _)| s as usize == site).map_or(0.0, |s| s.1);
            assert!((share - expected).abs() < 1e-5, "{q:?}: site {site}, {share} for {expected}");
        }
    }
}

#[test]
fn shares_add_up_and_their_mean_is_the_point() {
    let points = random(200, 1000, 7);
    let queries = random(2000, 1000, 1 << 30);
    let mut inside = 0;
    for (q, shares) in queries.iter().zip(found(&points, &queries)) {
        if shares.is_empty() {
            continue;
        }
        inside += 1;
        let sum: f64 = shares.iter().map(|s| s.1).sum();
        let mean = |axis: usize| -> f64 {
            shares.iter().map(|&(site, share)| share * points[site as usize][axis]).sum()
        };
        assert!((sum - 1.0).abs() < 1e-12 && shares.iter().all(|s| s.1 > -1e-9), "{shares:?}");
        assert!((mean(0) - q[0]).abs() < 1e-6 && (mean(1) - q[1]).abs() < 1e-6, "{q:?} {shares:?}");
    }
    assert!(inside > 1500, "{inside}");
}

#[test]
fn the_centre_of_a_square() {
    let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [9.0, 1.0]];
    let shares = found(&square, &[[1.0, 1.0]]).remove(0);
    let of = |site: u32| shares.iter().find(|s| s.0 == site).map_or(0.0, |s| s.1);
    assert!((0..4).all(|site| (of(site) - 0.25).abs() < 1e-15), "{shares:?}");
    assert!(of(4).abs() < 1e-15);
}

#[test]
fn sites_and_hull_edges() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let shares = found(&square, &[[4.0, 4.0], [1.0, 0.0]]);
    assert_eq!(shares[0], [(2, 1.0)]);
    let mut edge = shares[1].clone();
    edge.sort_unstable_by_key(|share| share.0);
    assert_eq!(edge, [(0, 0.75), (1, 0.25)]);
}

#[test]
fn outside_there_is_nothing() {
    let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]];
    assert_eq!(found(&square, &[[0.0, 1.0], [5.0, 0.0]]), [vec![], vec![]]);
    let line = Sites::new(&[[0.0, 0.0], [1.0, 1.0]]).unwrap();
    let chain = delaunay(&line, &Options::default(), &mut ());
    let refused = natural_neighbours(&chain, &line, &[[0.5, 0.5]], ONE);
    assert_eq!(refused, Err(LocateError::Flat(Some(1))));
}
