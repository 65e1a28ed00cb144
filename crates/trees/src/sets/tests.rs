use proptest::prelude::*;

use crate::testing::{is_normal, tree};
use crate::{Colour, OrthTree};

const DEPTH: u8 = 4;

fn set_algebra<const N: usize>(a: &OrthTree<N>, b: &OrthTree<N>, c: &OrthTree<N>) {
    let (none, all) = (OrthTree::of(Colour::White), OrthTree::of(Colour::Black));
    assert_eq!(a.union(b), b.union(a));
    assert_eq!(a.union(&b.union(c)), a.union(b).union(c));
    assert_eq!(a.intersection(&b.union(c)), a.intersection(b).union(&a.intersection(c)));
    assert_eq!(a.union(b).complement(), a.complement().intersection(&b.complement()));
    assert_eq!(a.difference(b), a.intersection(&b.complement()));
    assert_eq!(a.symmetric_difference(b).symmetric_difference(b), *a);
    assert_eq!(a.complement().complement(), *a);
    assert_eq!((a.union(&a.complement()), a.intersection(&a.complement())), (all, none));
    let volume = |tree: OrthTree<N>| tree.volume(DEPTH).unwrap();
    assert_eq!(
        volume(a.union(b)) + volume(a.intersection(b)),
        volume(a.clone()) + volume(b.clone())
    );
    assert!(is_normal(a.union(b).colours(), 1 << N));
}

/// Cell by cell, on rasters.
fn as_on_rasters<const N: usize>(a: &OrthTree<N>, b: &OrthTree<N>) {
    let cells = |tree: &OrthTree<N>| tree.to_raster(DEPTH).unwrap().cells().to_vec();
    let each = |op: fn(bool, bool) -> bool| -> Vec<bool> {
        cells(a).into_iter().zip(cells(b)).map(|(a, b)| op(a, b)).collect()
    };
    assert_eq!(cells(&a.union(b)), each(|a, b| a || b));
    assert_eq!(cells(&a.intersection(b)), each(|a, b| a && b));
    assert_eq!(cells(&a.difference(b)), each(|a, b| a && !b));
    assert_eq!(cells(&a.symmetric_difference(b)), each(|a, b| a != b));
    assert_eq!(cells(&a.complement()), each(|a, _| !a));
}

proptest! {
    #[test]
    fn set_algebra_holds(
        quads in [tree::<2>(DEPTH), tree::<2>(DEPTH), tree::<2>(DEPTH)],
        octs in [tree::<3>(3), tree::<3>(3), tree::<3>(3)],
    ) {
        let [a, b, c] = quads;
        set_algebra(&a, &b, &c);
        as_on_rasters(&a, &b);
        let [a, b, c] = octs;
        set_algebra(&a, &b, &c);
        as_on_rasters(&a, &b);
    }
}
