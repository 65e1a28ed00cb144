use std::collections::BTreeMap;

use delone_delaunay::{Options, regular};
use delone_sites::WeightedSites;
use delone_workloads::Rng;

use super::*;
use crate::testing::of;

/// The standard reduction of the whole boundary matrix, in some order of the simplices.
fn matrix<const D: usize>(
    filtration: &AlphaFiltration<D>,
    order: &[u32],
) -> Vec<(u32, Option<u32>)> {
    let mut place = vec![0; order.len()];
    order.iter().enumerate().for_each(|(i, &id)| place[id as usize] = i);
    let mut by_low: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    let mut pairs = Vec::new();
    let mut is_paired = vec![false; order.len()];
    for (j, &id) in order.iter().enumerate() {
        let facets = filtration.simplices().facets(SimplexId::new(id as usize));
        let mut column: Vec<usize> = facets.iter().map(|&facet| place[facet as usize]).collect();
        column.sort_unstable();
        while let Some(other) = column.last().and_then(|low| by_low.get(low)) {
            let both = column.iter().chain(other);
            let mut sum: Vec<usize> = both.copied().collect();
            sum.sort_unstable();
            let odd = sum.chunk_by(|a, b| a == b).filter(|same| same.len() % 2 == 1);
            column = odd.map(|same| same[0]).collect();
        }
        if let Some(&low) = column.last() {
            pairs.push((order[low], Some(id)));
            (is_paired[low], is_paired[j]) = (true, true);
            by_low.insert(low, column);
        }
    }
    pairs.extend(
        order.iter().enumerate().filter(|(j, _)| !is_paired[*j]).map(|(_, &id)| (id, None)),
    );
    pairs.sort_unstable();
    pairs
}

fn ours(persistence: &Persistence) -> Vec<(u32, Option<u32>)> {
    let ids = |(_, pair): (usize, Pair)| {
        (narrow(pair.birth.index()), pair.death.map(|death| narrow(death.index())))
    };
    let mut pairs: Vec<_> = persistence.all().map(ids).collect();
    pairs.sort_unstable();
    pairs
}

fn points<const D: usize>(rng: &mut Rng, count: usize, side: u64) -> Vec<[f64; D]> {
    (0..count).map(|_| [0; D].map(|_| rng.below(side) as f64)).collect()
}

/// Also that the bars are those of another order of equals.
fn check<const D: usize>(filtration: &AlphaFiltration<D>, rng: &mut Rng) -> usize {
    let persistence = filtration.persistence();
    let order = filtration.order();
    assert_eq!(ours(&persistence), matrix(filtration, &order));
    let mut shuffled: Vec<u32> = order.clone();
    rng.shuffle(&mut shuffled);
    let dimension = |id: u32| filtration.simplices().dimension_of(SimplexId::new(id as usize));
    shuffled.sort_by_key(|&id| (filtration.ranks()[id as usize], dimension(id)));
    let rank = |id: u32| filtration.ranks()[id as usize];
    let bar = |(birth, death): (u32, Option<u32>)| Bar {
        dimension: dimension(birth),
        birth: rank(birth),
        death: death.map(rank),
    };
    let bars = matrix(filtration, &shuffled).into_iter().map(bar);
    let mut bars: Vec<Bar> = bars.filter(|bar| bar.death != Some(bar.birth)).collect();
    bars.sort_unstable();
    assert_eq!(persistence.bars(filtration), bars);
    bars.iter().filter(|bar| bar.dimension > 0).count()
}

#[test]
fn pairs_are_those_of_the_matrix() {
    let mut rng = Rng::new(9);
    let mut bars = [0; 4];
    for side in [3, 5, 30] {
        for _ in 0..6 {
            bars[0] += check(&of(&points::<2>(&mut rng, 25, side)), &mut rng);
            bars[1] += check(&of(&points::<3>(&mut rng, 20, side)), &mut rng);
            bars[2] += check(&of(&points::<4>(&mut rng, 12, side)), &mut rng);
            let space = points::<2>(&mut rng, 15, side);
            let weights: Vec<f64> = space.iter().map(|_| rng.below(side) as f64).collect();
            let sites = WeightedSites::new(&space, &weights).unwrap();
            let regular = regular(&sites, &Options::default(), &mut ());
            bars[3] += check(&AlphaFiltration::of_regular(&sites, &regular), &mut rng);
        }
    }
    assert!(bars.iter().all(|&count| count > 10), "{bars:?}");
    check(&of(&[[0.0, 1.0], [0.0, 2.0], [0.0, 4.0]]), &mut rng);
    check(&of(&[[0.0, 1.0]]), &mut rng);
    check(&of::<2>(&[]), &mut rng);
    let flat: Vec<[f64; 3]> =
        points::<2>(&mut rng, 15, 6).iter().map(|p| [p[0], 3.0, p[1]]).collect();
    check(&of(&flat), &mut rng);
}

#[test]
fn diagrams_do_not_depend_on_ties() {
    let grid: Vec<[f64; 2]> = (0..16u8).map(|i| [i / 4, i % 4].map(f64::from)).collect();
    let filtration = of(&grid);
    let bars = filtration.persistence().bars(&filtration);
    let count = |dimension, birth, death| {
        bars.iter().filter(|&&bar| bar == Bar { dimension, birth, death }).count()
    };
    // Ranks 0, 1, 2 are 0, 1/4, 1/2: edges join at 1/4, which makes nine squares, filled at 1/2.
    assert_eq!((count(0, 0, Some(1)), count(0, 0, None), count(1, 1, Some(2))), (15, 1, 9));
    assert_eq!(bars.len(), 25);
    check(&filtration, &mut Rng::new(1));
}
