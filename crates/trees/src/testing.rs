//! Trees for tests.

use proptest::prelude::*;

use crate::{Colour, OrthTree, Raster};

/// Any raster up to a depth, noisy or made of blocks.
pub(crate) fn raster<const N: usize>(depth_max: u8) -> impl Strategy<Value = Raster<N>> {
    (0..=depth_max, 0u8..3, any::<u64>()).prop_map(|(depth, coarser, seed)| {
        let inside = |anchor: [u32; N]| {
            let block = anchor.map(|c| c >> coarser);
            let mixed = block.iter().fold(seed, |hash, &c| {
                let hash = (hash ^ u64::from(c)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
                hash ^ hash >> 29
            });
            mixed >> 17 & 1 == 1
        };
        Raster::new(depth, inside).unwrap()
    })
}

pub(crate) fn tree<const N: usize>(depth_max: u8) -> impl Strategy<Value = OrthTree<N>> {
    raster(depth_max).prop_map(|raster| OrthTree::from_raster(&raster))
}

/// By definition: each gray node has sons of two colours, or a gray one.
pub(crate) fn is_normal(colours: &[Colour], arity: usize) -> bool {
    colours.iter().enumerate().filter(|&(_, &colour)| colour == Colour::Gray).all(|(gray, _)| {
        let sons = &colours[gray + 1..=gray + arity];
        sons.contains(&Colour::Gray) || sons.iter().any(|son| *son != sons[0])
    })
}
