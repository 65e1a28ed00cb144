//! The published lines on which a rounded orientation is wrong in patterns.

use crate::num::{pow2, real};

/// A line through two points, and a square of ULPs close to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Classroom {
    /// The lower left corner of the square.
    pub near: [f64; 2],
    /// Two points far from it, on the line.
    pub far: [[f64; 2]; 2],
}

/// The three of figure 2 of Kettner, Mehlhorn, Pion, Schirra and Yap (2008), of 256 x 256 ULPs there.
pub const CLASSROOM: [Classroom; 3] = [
    Classroom { near: [0.5, 0.5], far: [[12.0, 12.0], [24.0, 24.0]] },
    Classroom {
        near: [0.500_000_000_000_025_3, 0.500_000_000_000_017_1],
        far: [[17.3; 2], [24.000_000_000_000_05, 24.000_000_000_000_053]],
    },
    Classroom { near: [0.5, 0.5], far: [[8.8; 2], [12.1; 2]] },
];

impl Classroom {
    /// The points of the square, `side` in a row, from the lowest row up. Those of a row are 2^-53 apart.
    pub fn square(&self, side: usize) -> impl Iterator<Item = [f64; 2]> + use<> {
        let [x, y] = self.near;
        let step = pow2(-53);
        (0..side * side).map(move |i| [x + real(i % side) * step, y + real(i / side) * step])
    }
}
