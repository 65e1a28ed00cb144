use proptest::prelude::*;

use crate::testing::raster;
use crate::{CodeFault, Colour, OrthTree, Raster};

fn leads_back<const N: usize>(raster: &Raster<N>) {
    let tree = OrthTree::from_raster(raster);
    assert_eq!(tree.to_raster(raster.depth()).as_ref(), Ok(raster));
    let black = raster.cells().iter().filter(|inside| **inside).count() as u128;
    assert_eq!(tree.volume(raster.depth()), Some(black));
}

proptest! {
    #[test]
    fn rasters_lead_back(
        line in raster::<1>(7), plane in raster::<2>(5), space in raster::<3>(3), four in raster::<4>(2),
    ) {
        leads_back(&line);
        leads_back(&plane);
        leads_back(&space);
        leads_back(&four);
        prop_assert_eq!(Raster::from_pbm(&plane.to_pbm()), Ok(plane));
    }
}

#[test]
fn a_raster_too_coarse_is_refused() {
    let tree = OrthTree::<2>::from_text("(BWW(WBBW").unwrap();
    assert_eq!(tree.to_raster(1), Err(CodeFault::Raster { depth: 1 }));
    assert_eq!(tree.to_raster(15), Err(CodeFault::Raster { depth: 15 }));
}

#[test]
fn pictures_of_any_size_are_filled_up() {
    let picture = Raster::from_pbm("P1 # a comment\n3 2\n1 0 1\n011\n").unwrap();
    assert_eq!(picture.to_pbm(), "P1\n4 4\n0000\n0000\n1010\n0110\n");
    let nothing = Raster::from_pbm("P1\n0 0\n").unwrap();
    assert_eq!(OrthTree::from_raster(&nothing), OrthTree::of(Colour::White));
    assert_eq!(Raster::from_pbm("P1\n2 2\n101"), Err(CodeFault::Truncated { at: 3 }));
    assert_eq!(Raster::from_pbm("P1\n2 2\n1012"), Err(CodeFault::Symbol { at: 3 }));
    assert_eq!(Raster::from_pbm("P5\n2 2\n1012"), Err(CodeFault::Symbol { at: 0 }));
}
