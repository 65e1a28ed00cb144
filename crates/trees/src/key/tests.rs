use proptest::prelude::*;

use crate::{Cell, DEPTH_MAX, Key};

fn agrees<const N: usize>(level: u8, seed: u64, steps: [i8; N]) {
    let place = |axis: usize| {
        let mixed =
            seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(u32::try_from(17 * axis).unwrap());
        // Often at the border.
        let side = 1u64 << level;
        let place = match mixed % 5 {
            0 => mixed % 3 % side,
            1 => side - 1 - mixed % 3 % side,
            _ => (mixed >> 8) % side,
        };
        u32::try_from(place).unwrap()
    };
    let cell = Cell::new(std::array::from_fn(place), level).unwrap();
    let key = Key::of(cell);
    assert_eq!((key.cell(), key.digits(), key.level()), (cell, cell.key(), level));
    assert_eq!(key.neighbour(steps).map(Key::cell), cell.neighbour(steps), "{cell:?} {steps:?}");
}

proptest! {
    #[test]
    fn keys_have_the_neighbours_of_their_cells(
        level in 0u8..=DEPTH_MAX, seed in any::<u64>(), far in any::<bool>(), steps in prop::array::uniform4(any::<i8>()),
    ) {
        let [a, b, c, d] = steps.map(|step| if far { step } else { step % 2 });
        agrees(level, seed, [a]);
        agrees(level, seed, [a, b]);
        agrees(level, seed, [a, b, c]);
        agrees(level, seed, [a, b, c, d]);
    }
}

#[test]
fn keys_are_sorted_as_depth_first() {
    let tree = crate::OrthTree::<3>::from_text("(WB(WWWWWWWBWWWWW").unwrap();
    let keys: Vec<Key<3>> = tree.cells().map(|(cell, _)| Key::of(cell)).collect();
    assert!(keys.is_sorted());
}
