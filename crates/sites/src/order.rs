//! Insertion orders: Hilbert's curve, and biased randomized rounds along it.
//!
//! **Paper.** [ACR03]: each site is in the last round with probability 1/2, in the one before with 1/4, and so on; inside
//! a round any order may serve, here that of Hilbert's curve, in the bit-parallel form of [Ski04].
//! **Out.** A permutation of the sites. It depends on their positions alone and influences time only.
//! **Cost.** O(n log n).

use crate::Sites;

/// Rounds end when no more than this many sites are left.
const FIRST_ROUND: usize = 64;

/// A bijective hash: one step of the SplitMix64 generator [SLF14]. Wherever an algorithm wants randomness it scatters
/// something that is the input's own, so that every run is the same.
#[must_use]
pub const fn scatter(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A number that orders like the coordinate, which is finite and not -0.0.
#[inline]
#[must_use]
pub const fn sortable(coordinate: f64) -> u64 {
    let bits = coordinate.to_bits();
    // Doubles are sign and magnitude: negative ones are turned round, and put below.
    if bits >> 63 == 0 { bits | 1 << 63 } else { !bits }
}

impl<const D: usize> Sites<D> {
    /// Biased randomized rounds, each along Hilbert's curve. Randomness is a hash of the lexicographic rank and `seed`,
    /// so that the order of positions does not depend on the order of input.
    #[must_use]
    pub fn brio_order(&self, seed: u64) -> Vec<u32> {
        let rounds = (self.len() / FIRST_ROUND).checked_ilog2().map_or(0, |log| log + 1);
        let last = u64::from(rounds);
        self.order_by(|rank| last - u64::from(scatter(seed ^ rank).trailing_zeros().min(rounds)))
    }

    /// All sites along Hilbert's curve.
    #[must_use]
    pub fn hilbert_order(&self) -> Vec<u32> {
        self.order_by(|_| 0)
    }

    fn order_by(&self, round: impl Fn(u64) -> u64) -> Vec<u32> {
        let curve = Curve::around(self.points());
        let mut keyed: Vec<(u64, u64, u32)> = (0u64..)
            .zip(self.sorted())
            .map(|(rank, &site)| (round(rank), curve.key(&self.points()[site as usize]), site))
            .collect();
        // The sort is stable and starts from the lexicographic order: equal keys stay in it.
        keyed.sort_by_key(|&(round, key, _)| (round, key));
        keyed.into_iter().map(|(_, _, site)| site).collect()
    }
}

/// Hilbert's curve on a grid around some points.
#[derive(Clone, Copy, Debug)]
pub struct Curve<const D: usize> {
    low: [f64; D],
    extent: f64,
    scale: f64,
}

impl<const D: usize> Curve<D> {
    /// Bits of the grid on each axis, so that a key fits 64 bits.
    const BITS: u32 = match D {
        0 | 1 => 32,
        2 => 31,
        3 => 21,
        4 => 15,
        5 => 12,
        _ => 9,
    };

    /// The curve through the smallest cube at the low corner of the points' bounding box that holds them.
    #[must_use]
    pub fn around(points: &[[f64; D]]) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
        for point in points {
            for axis in 0..D {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        // Halved where the difference of two finite doubles may not be one.
        let wide = (0..D).any(|axis| (high[axis] - low[axis]).is_infinite());
        let scale = if wide { 0.5 } else { 1.0 };
        let extents = (0..D).map(|axis| high[axis] * scale - low[axis] * scale);
        Self { low, extent: extents.fold(0.0, f64::max), scale }
    }

    /// The place of a point along the curve.
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the float is between 0 and 2^BITS - 1, and casts saturate"
    )]
    pub fn key(&self, point: &[f64; D]) -> u64 {
        let top = f64::from(u32::MAX >> (32 - Self::BITS));
        let mut x: [u32; D] = std::array::from_fn(|axis| {
            let offset = point[axis] * self.scale - self.low[axis] * self.scale;
            if self.extent > 0.0 { (offset / self.extent * top) as u32 } else { 0 }
        });
        transpose(&mut x, Self::BITS);
        let mut key = 0;
        for bit in (0..Self::BITS).rev() {
            for coordinate in x {
                key = key << 1 | u64::from(coordinate >> bit & 1);
            }
        }
        key
    }
}

/// Turns grid coordinates into the key's bits, axis by axis [Ski04].
fn transpose<const D: usize>(x: &mut [u32; D], bits: u32) {
    for bit in (1..bits).rev() {
        let (q, p) = (1u32 << bit, (1u32 << bit) - 1);
        for axis in 0..D {
            if x[axis] & q != 0 {
                x[0] ^= p;
            } else {
                let t = (x[0] ^ x[axis]) & p;
                x[0] ^= t;
                x[axis] ^= t;
            }
        }
    }
    for axis in 1..D {
        x[axis] ^= x[axis - 1];
    }
    let mut t = 0;
    for bit in (1..bits).rev() {
        if x[D - 1] & 1 << bit != 0 {
            t ^= (1 << bit) - 1;
        }
    }
    x.iter_mut().for_each(|coordinate| *coordinate ^= t);
}
