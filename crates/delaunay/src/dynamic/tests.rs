use delone_mesh::Level;
use delone_predicates::{Adaptive, Weighted};

use super::*;

struct Random(u64);

impl Random {
    fn below(&mut self, n: u32) -> u32 {
        self.0 += 1;
        u32::try_from((scatter(self.0) >> 32) % u64::from(n)).unwrap()
    }
}

fn lattice<const D: usize>(side: u32, count: u32) -> Vec<[f64; D]> {
    let point = |mut i: u32| {
        [(); D].map(|()| {
            let x = i % side;
            i /= side;
            f64::from(x)
        })
    };
    (0..count).map(point).collect()
}

/// Equal to what is built of the sites present from scratch, and whole.
fn check<const D: usize, K: Kernel<D>>(it: &Dynamic<D, K>, present: &[bool]) {
    let order: Vec<u32> = (0u32..).zip(present).filter(|p| *p.1).map(|p| p.0).collect();
    let scratch = bowyer_watson(&it.kernel, &order, &mut ());
    assert_eq!(it.mesh().faults(Level::Sphere, present.len()), [], "{order:?}");
    assert_eq!(it.mesh().canonical(id_of), scratch.canonical(id_of), "{order:?}");
    assert_eq!(it.mesh().dimension(), scratch.dimension());
    let shown = scratch.cells_by_vertex(present.len());
    for (site, cell) in (0u32..).zip(shown) {
        assert_eq!(it.cell_of(site).is_some(), cell.is_some(), "{order:?}: {site}");
        if let Some(cell) = it.cell_of(site) {
            assert!(it.mesh().corners(cell).contains(&VertexId::new(site as usize)), "Inv 1");
        }
        let hidden = present[site as usize] && cell.is_none();
        assert_eq!(it.hidden().any(|h| h == site), hidden, "{order:?}: {site}");
    }
}

/// Random insertions and removals, each checked.
fn churn<const D: usize, K: Kernel<D>>(kernel: K, count: usize, steps: u32, random: &mut Random) {
    let mut it = Dynamic::<D, K>::new(kernel, count);
    let mut present = vec![false; count];
    for step in 0..steps {
        let site = random.below(u32::try_from(count).unwrap());
        let slot = &mut present[site as usize];
        // More come than go in the first half.
        if !*slot && (step < steps / 2 || random.below(3) == 0) {
            assert_ne!(it.insert(site, &mut ()), Inserted::Present);
            *slot = true;
        } else if *slot && (step >= steps / 2 || random.below(4) == 0) {
            assert!(it.remove(site, &mut ()));
            *slot = false;
        }
        check(&it, &present);
    }
}

#[test]
fn sites_come_and_go_on_small_grids() {
    let mut random = Random(11);
    for round in 0..12 {
        let flat = lattice::<2>(4, 5 + round);
        churn::<2, _>(Adaptive::new(&flat), flat.len(), 60, &mut random);
        let solid = lattice::<3>(3, 8 + round);
        churn::<3, _>(Adaptive::new(&solid), solid.len(), 50, &mut random);
    }
    let four = lattice::<4>(2, 16);
    churn::<4, _>(Adaptive::new(&four), 16, 40, &mut random);
}

#[test]
fn sites_come_and_go_in_general_position() {
    let mut random = Random(12);
    let points: Vec<[f64; 2]> =
        (0..60).map(|_| [random.below(1000), random.below(1000)].map(f64::from)).collect();
    let mut distinct = points.clone();
    distinct.sort_unstable_by(|p, q| p.partial_cmp(q).unwrap());
    distinct.dedup();
    churn::<2, _>(Adaptive::new(&distinct), distinct.len(), 240, &mut random);
    let space: Vec<[f64; 3]> = (0..40u32)
        .map(|i| [f64::from(i), f64::from(i * i % 41), f64::from(i * i * i % 43)])
        .collect();
    churn::<3, _>(Adaptive::new(&space), 40, 160, &mut random);
}

#[test]
fn weighted_sites_come_and_go() {
    let mut random = Random(13);
    for round in 0..12 {
        let flat = lattice::<2>(4, 16);
        let weights: Vec<f64> = (0..16).map(|_| f64::from(random.below(2 + round))).collect();
        churn::<2, _>(Weighted::new(&flat, weights), 16, 60, &mut random);
        let solid = lattice::<3>(3, 20);
        let weights: Vec<f64> = (0..20).map(|_| f64::from(random.below(2 + round))).collect();
        churn::<3, _>(Weighted::new(&solid, weights), 20, 40, &mut random);
    }
}

#[test]
fn hidden_sites_come_back() {
    let points = [[0.0, 0.0], [8.0, 0.0], [0.0, 8.0], [2.0, 2.0], [3.0, 2.0], [2.0, 3.0]];
    let kernel = Weighted::new(points, [0.0, 0.0, 0.0, 20.0, 0.0, 0.0]);
    let mut it = Dynamic::<2, _>::new(kernel, 6);
    for site in [0, 1, 2, 4, 5] {
        assert_eq!(it.insert(site, &mut ()), Inserted::Vertex);
    }
    assert_eq!(it.insert(3, &mut ()), Inserted::Vertex);
    assert_eq!(it.hidden().collect::<Vec<_>>(), [4, 5]);
    assert!(it.remove(3, &mut ()));
    assert_eq!(it.hidden().count(), 0);
    check(&it, &[true, true, true, false, true, true]);
}

#[test]
fn a_removed_apex_leaves_its_flat_neighbours() {
    // 4 sees only the facet 0 1 2 of a solid that reaches down to 3.
    let points =
        [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [1.0, 1.0, -5.0], [1.0, 1.0, 1.0]];
    let mut it = Dynamic::<3, _>::new(Adaptive::new(points), 5);
    (0..5).for_each(|site| assert_eq!(it.insert(site, &mut ()), Inserted::Vertex));
    assert_eq!(it.spanning_neighbours_of(4), Some(vec![0, 1, 2, 3]));
    assert!(it.remove(4, &mut ()));
    check(&it, &[true, true, true, true, false]);
    assert!(it.remove(3, &mut ()));
    assert_eq!(it.mesh().dimension(), Some(2));
}

impl<const D: usize, K: Kernel<D>> Dynamic<D, K> {
    fn spanning_neighbours_of(&mut self, site: u32) -> Option<Vec<u32>> {
        let cell = self.cell_of(site)?;
        gather_star(&self.mesh, VertexId::new(site as usize), cell, &mut self.cavity);
        self.spanning_neighbours()
    }
}

#[test]
fn what_is_there_does_not_come_again() {
    let mut it = Dynamic::<1, _>::new(Adaptive::new([[0.0], [1.0]]), 2);
    assert!(!it.remove(0, &mut ()));
    assert_eq!(it.insert(0, &mut ()), Inserted::Vertex);
    assert_eq!(it.insert(0, &mut ()), Inserted::Present);
    assert!(it.remove(0, &mut ()) && !it.remove(0, &mut ()));
    assert_eq!(it.mesh().dimension(), None);
}
