//! Insertion orders: Hilbert's curve, and biased randomized rounds along it.
//!
//! **Paper.** \[ACR03\]: a site that is not in a later round is in this one with a constant probability, there 1/2, here 7/8 (few and large rounds
//! keep to one place for longer: a fifth less time for a million sites in space, though there 3 % more cells are made); inside
//! a round any order may serve, here that of Hilbert's curve, in the bit-parallel form of \[Ski04\]. The curve runs through a grid; sites
//! that are crowded in one of its squares get a grid of their own.
//! **Out.** A permutation of the sites. It depends on their positions alone and influences time only.
//! **Cost.** O(n log n).

use crate::Sites;

/// Rounds end when no more than this many sites are left.
const FIRST_ROUND: usize = 64;

/// A site is left for earlier rounds if so many bits of a hash are zero.
const BITS_A_ROUND: u32 = 3;

/// More sites than this at one place of the curve are told apart.
const CROWD: usize = 8;

/// Points whose keys are found in step.
const LANES: usize = 8;

/// A bijective hash: one step of the SplitMix64 generator \[SLF14\]. Wherever an algorithm wants randomness it scatters
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
        let doublings = (self.len() / FIRST_ROUND).checked_ilog2().map_or(0, |log| log + 1);
        let rounds = doublings.div_ceil(BITS_A_ROUND);
        let earlier = |rank| (scatter(seed ^ rank).trailing_zeros() / BITS_A_ROUND).min(rounds);
        self.order_by(|rank| u64::from(rounds - earlier(rank)))
    }

    /// All sites along Hilbert's curve.
    #[must_use]
    pub fn hilbert_order(&self) -> Vec<u32> {
        self.order_by(|_| 0)
    }

    fn order_by(&self, round: impl Fn(u64) -> u64) -> Vec<u32> {
        let ranks = 0u32..u32::try_from(self.len()).expect("sites have ids of 32 bits");
        // Round, place on the curve and rank in one number: equal places stay in lexicographic order.
        let mut keyed: Vec<u128> =
            ranks.map(|rank| u128::from(round(u64::from(rank))) << 96 | u128::from(rank)).collect();
        self.place_on_curve(&mut keyed);
        keyed.sort_unstable();
        self.refine(&mut keyed);
        keyed.into_iter().map(|item| self.sorted()[low_half(item) as usize]).collect()
    }

    /// Sets the places of sites on the curve around them; false if they are all at one position.
    fn place_on_curve(&self, keyed: &mut [u128]) -> bool {
        let point = |item: u128| self.points()[self.sorted()[low_half(item) as usize] as usize];
        let curve = Curve::around_each(keyed.iter().map(|&item| point(item)));
        for lanes in keyed.chunks_mut(LANES) {
            let at = |lane: usize| point(lanes[lane.min(lanes.len() - 1)]);
            let keys = curve.keys::<LANES>(&std::array::from_fn(at));
            for (item, &key) in lanes.iter_mut().zip(&keys) {
                *item = *item & !(u128::from(u64::MAX) << 32) | u128::from(key) << 32;
            }
        }
        curve.extent > 0.0
    }

    /// Sites in crowds at one place of the curve get a curve of their own: clusters may be as narrow as they like.
    ///
    /// It ends: on a curve around several positions there is more than one place.
    fn refine(&self, keyed: &mut [u128]) {
        let mut ranges = vec![(0, keyed.len())];
        while let Some((first, end)) = ranges.pop() {
            let mut start = first;
            for run in keyed[first..end].chunk_by_mut(|a, b| *a >> 32 == *b >> 32) {
                let range = (start, start + run.len());
                start = range.1;
                if run.len() > CROWD && self.place_on_curve(run) {
                    run.sort_unstable();
                    ranges.push(range);
                }
            }
        }
    }
}

/// The last 32 bits.
#[expect(clippy::cast_possible_truncation, reason = "that is what is wanted")]
pub(crate) const fn low_half(value: u128) -> u32 {
    value as u32
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
        6 | 7 => 9,
        _ => 8,
    };

    /// The curve through the smallest cube at the low corner of the points' bounding box that holds them.
    #[must_use]
    pub fn around(points: &[[f64; D]]) -> Self {
        Self::around_each(points.iter().copied())
    }

    fn around_each(points: impl Iterator<Item = [f64; D]>) -> Self {
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
    pub fn key(&self, point: &[f64; D]) -> u64 {
        let [key] = self.keys(&[*point]);
        key
    }

    /// The places of several points: they are found in step, since each is one long chain of dependent operations.
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the float is between 0 and 2^BITS - 1, and casts saturate"
    )]
    pub fn keys<const N: usize>(&self, points: &[[f64; D]; N]) -> [u64; N] {
        let top = f64::from(u32::MAX >> (32 - Self::BITS));
        let mut x = [[0; N]; D];
        for (axis, lanes) in x.iter_mut().enumerate() {
            for (coordinate, point) in lanes.iter_mut().zip(points) {
                let offset = point[axis] * self.scale - self.low[axis] * self.scale;
                *coordinate =
                    if self.extent > 0.0 { (offset / self.extent * top) as u32 } else { 0 };
            }
        }
        transpose(&mut x, Self::BITS);
        std::array::from_fn(|lane| Self::interleave(x.map(|lanes| lanes[lane])))
    }

    /// The bits of the coordinates by turns, the highest of the first one first.
    fn interleave(x: [u32; D]) -> u64 {
        let mut key = 0;
        for byte in (0..Self::BITS.div_ceil(8)).rev() {
            if key != 0 {
                key <<= 8 * D;
            }
            for (axis, coordinate) in x.iter().enumerate() {
                let spread = Self::SPREAD[(coordinate >> (8 * byte) & 0xff) as usize];
                key |= spread << (D - 1 - axis);
            }
        }
        key
    }

    /// A byte's bits at every D-th place.
    const SPREAD: [u64; 256] = {
        let mut table = [0; 256];
        let mut i = 0;
        while i < 8 * table.len() {
            let (byte, bit) = (i / 8, i % 8);
            if bit * D < 64 {
                table[byte] |= (byte as u64 >> bit & 1) << (bit * D);
            }
            i += 1;
        }
        table
    };
}

/// Turns grid coordinates, of N points in step, into the key's bits, axis by axis \[Ski04\].
fn transpose<const D: usize, const N: usize>(x: &mut [[u32; N]; D], bits: u32) {
    for bit in (1..bits).rev() {
        let below = (1u32 << bit) - 1;
        for axis in 0..D {
            let (mut first, mut other) = (x[0], x[axis]);
            for (first, other) in first.iter_mut().zip(&mut other) {
                // If the bit is set, invert what is below it on the first axis; else exchange that with this axis.
                let set = (*other >> bit & 1).wrapping_neg() & below;
                let exchange = (*first ^ *other) & below & !set;
                *first ^= exchange | set;
                *other ^= exchange;
            }
            (x[axis], x[0]) = (other, first); // in this order: they may be one
        }
    }
    for lane in 0..N {
        for axis in 1..D {
            x[axis][lane] ^= x[axis - 1][lane];
        }
        // Each bit becomes the parity of those above it.
        let mut parity = x[D - 1][lane] >> 1;
        for shift in [1, 2, 4, 8, 16] {
            parity ^= parity >> shift;
        }
        for coordinates in &mut *x {
            coordinates[lane] ^= parity;
        }
    }
}
