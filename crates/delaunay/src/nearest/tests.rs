use delone_sites::scatter;

use super::*;
use crate::{Options, delaunay};

const ONE: NonZeroUsize = NonZeroUsize::MIN;
const TWO: NonZeroUsize = NonZeroUsize::new(2).unwrap();

fn check<const D: usize>(points: &[[f64; D]], queries: &[[f64; D]]) {
    let sites = Sites::new(points).unwrap();
    let triangulation = delaunay(&sites, &Options::default(), &mut ());
    let found = nearest_sites(&triangulation, &sites, queries, ONE).unwrap();
    for (q, &nearest) in queries.iter().zip(&found) {
        let at = |site: u32| &sites.points()[site as usize];
        let expected = sites.sorted().iter().copied().min_by(|&u, &v| {
            compare_distances(q, at(u), at(v)) // the first, so the least in rank, of several
        });
        assert_eq!(nearest, expected, "{q:?}");
    }
    assert_eq!(found, nearest_sites(&triangulation, &sites, queries, TWO).unwrap());
}

fn random<const D: usize>(count: u64, side: u64, seed: u64) -> Vec<[f64; D]> {
    let coordinate = |i: u64| f64::from(u32::try_from(scatter(i) % side).unwrap());
    let point = |i: u64| std::array::from_fn(|axis| coordinate(seed + 100 * i + axis as u64));
    (0..count).map(point).collect()
}

#[test]
fn brute_force_finds_the_same() {
    check::<2>(&random(200, 1000, 1), &random(2500, 1200, 1 << 20));
    check::<3>(&random(100, 1000, 2), &random(300, 1200, 1 << 20));
    check::<4>(&random(30, 100, 3), &random(100, 120, 1 << 20));
}

#[test]
fn ties_go_to_the_least_site() {
    check::<2>(&random(40, 6, 4), &random(400, 8, 1 << 20));
    check::<3>(&random(40, 3, 5), &random(200, 4, 1 << 20));
    let square = [[2.0, 2.0], [2.0, 0.0], [0.0, 2.0], [0.0, 0.0]];
    let sites = Sites::new(&square).unwrap();
    let triangulation = delaunay(&sites, &Options::default(), &mut ());
    let found = nearest_sites(&triangulation, &sites, &[[1.0, 1.0], [2.0, 1.0]], ONE);
    assert_eq!(found, Ok(vec![Some(3), Some(1)]));
}

#[test]
fn in_a_flat_and_off_it() {
    let line: Vec<[f64; 3]> = (0..9).map(f64::from).map(|x| [x, 2.0 * x, 1.0]).collect();
    check(&line, &random(200, 20, 7));
    let plane: Vec<[f64; 3]> = random::<2>(30, 9, 8).iter().map(|&[x, y]| [x, y, x + y]).collect();
    check(&plane, &random(200, 12, 9));
    check(&[[1.0, 1.0]], &random(20, 5, 10));
    let nothing = Sites::<2>::new(&[]).unwrap();
    let empty = delaunay(&nothing, &Options::default(), &mut ());
    assert_eq!(nearest_sites(&empty, &nothing, &[[1.0, 1.0]], ONE), Ok(vec![None]));
    assert!(nearest_sites(&empty, &nothing, &[[f64::NAN, 1.0]], ONE).is_err());
}
