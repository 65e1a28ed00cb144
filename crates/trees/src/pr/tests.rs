use proptest::prelude::*;

use crate::{Cell, Frame, OutsideFrame, PrTree};

fn is_as_defined<const N: usize>(sites: &[[f64; N]], depth: u8, capacity: usize) {
    let frame = Frame::around(sites, depth).unwrap();
    let tree = PrTree::new(sites, &frame, capacity).unwrap();
    let place: Vec<Cell<N>> = sites.iter().map(|&site| frame.cell_at(site).unwrap()).collect();
    let place = &place;
    let in_cell = |cell: Cell<N>| (0..sites.len()).filter(move |&i| cell.holds(place[i]));
    let mut all = Vec::new();
    for (leaf, cell) in tree.leaves().cells().enumerate() {
        let mut found = tree.sites(leaf).to_vec();
        all.extend(found.iter().map(|&site| site as usize));
        found.sort_unstable();
        let expected: Vec<u32> = in_cell(cell).map(|i| u32::try_from(i).unwrap()).collect();
        assert_eq!(found, expected);
        assert_eq!(tree.leaves().is_black(leaf), !found.is_empty());
        // No smaller than it must be, no larger than it may be.
        assert!(found.len() <= capacity || cell.level() == depth);
        if cell.level() > 0 {
            let above = Cell::new(cell.anchor().map(|c| c >> 1), cell.level() - 1).unwrap();
            assert!(in_cell(above).count() > capacity);
        }
    }
    all.sort_unstable();
    assert!(all.into_iter().eq(0..sites.len()), "each site in one leaf");
    for &site in sites {
        let leaf = tree.leaf_at(site).unwrap();
        assert!(tree.sites(leaf).iter().any(|&other| sites[other as usize] == site));
    }
    for pair in sites.windows(2) {
        let lower: [f64; N] = std::array::from_fn(|axis| pair[0][axis].min(pair[1][axis]));
        let upper: [f64; N] = std::array::from_fn(|axis| pair[0][axis].max(pair[1][axis]) + 0.25);
        let inside = |p: &[f64; N]| (0..N).all(|i| lower[i] <= p[i] && p[i] <= upper[i]);
        let found = tree.within(sites, lower, upper);
        assert!(found.is_sorted());
        assert!(
            found.iter().map(|&i| i as usize).eq((0..sites.len()).filter(|&i| inside(&sites[i])))
        );
    }
}

proptest! {
    #[test]
    fn sites_are_in_their_leaves(
        plane in prop::collection::vec(prop::array::uniform2(-20i8..20), 0..20),
        space in prop::collection::vec(prop::array::uniform3(-4i8..4), 0..20),
        depth in 0u8..7, capacity in 0usize..4,
    ) {
        let plane: Vec<[f64; 2]> = plane.iter().map(|p| p.map(|c| f64::from(c) / 2.0)).collect();
        let space: Vec<[f64; 3]> = space.iter().map(|p| p.map(f64::from)).collect();
        is_as_defined(&plane, depth, capacity);
        is_as_defined(&space, depth, capacity);
    }
}

#[test]
fn crowds_are_told() {
    let sites = [[0.0, 0.0], [1.0, 1.0], [1.0, 1.0], [1.0, 1.0f64.next_down()]];
    let frame = Frame::around(&sites, 4).unwrap();
    let tree = PrTree::new(&sites, &frame, 2).unwrap();
    let crowded: Vec<usize> = tree.crowded().collect();
    assert_eq!(crowded.len(), 1);
    assert_eq!((tree.leaves().cell(crowded[0]).level(), tree.sites(crowded[0]).len()), (4, 3));
}

#[test]
fn sites_outside_are_refused() {
    let frame = Frame::around(&[[0.0, 0.0], [1.0, 1.0]], 4).unwrap();
    let refused = |site| PrTree::new(&[[0.5, 0.5], site], &frame, 1).err();
    assert_eq!(refused([1.5, 0.5]), Some(OutsideFrame { site: 1 }));
    assert_eq!(refused([f64::NAN, 0.5]), Some(OutsideFrame { site: 1 }));
    let tree = PrTree::new(&[[0.5, 0.5]], &frame, 1).unwrap();
    assert_eq!(tree.within(&[[0.5, 0.5]], [-9.0, -9.0], [9.0, 9.0]), [0]);
    assert!(tree.within(&[[0.5, 0.5]], [0.75, 0.0], [0.25, 1.0]).is_empty());
    assert_eq!(tree.leaf_at([2.0, 0.0]), None);
}
