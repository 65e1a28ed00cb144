//! The project's own random numbers: xoshiro256** seeded by SplitMix64.
//!
//! **Paper.** Blackman and Vigna, *Scrambled linear pseudorandom number generators* (2021), constants as published;
//! gaussians by Karney, *Sampling exactly from the normal distribution* (2016), on top of von Neumann's comparison trick.
//! **Invariants.** 1. The stream is a contract: a seed printed in a bug report means the same sites for ever.
//! 2. Only `+ - * /` and `sqrt`, which IEEE 754 rounds in one way, so every machine gets the same bits. No `sin`, `ln`, `exp`.

/// A stream of random numbers, a pure function of its seed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rng {
    state: [u64; 4],
}

impl Rng {
    /// The stream of `seed`: four outputs of SplitMix64 are the state.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let mut x = seed;
        let mut next = || {
            x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let z = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ (z >> 31)
        };
        Self { state: [next(), next(), next(), next()] }
    }

    /// The stream of a named thing under `seed`: two names share no stream (FNV-1a of the name, xor the seed).
    #[must_use]
    pub fn named(name: &str, seed: u64) -> Self {
        let mut hash = crate::fingerprint::Fnv::new();
        hash.bytes(name.as_bytes());
        Self::new(hash.value() ^ seed)
    }

    /// 64 random bits.
    pub fn next_u64(&mut self) -> u64 {
        let s = &mut self.state;
        let out = s[1].wrapping_mul(5).rotate_left(7).wrapping_mul(9);
        let t = s[1] << 17;
        s[2] ^= s[0];
        s[3] ^= s[1];
        s[1] ^= s[2];
        s[0] ^= s[3];
        s[2] ^= t;
        s[3] = s[3].rotate_left(45);
        out
    }

    /// Uniform among the 2^53 multiples of 2^-53 in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.next_u64() >> 11) as f64 * crate::num::pow2(-53)
    }

    /// `lo + (hi - lo) * unit`, rounded.
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// Uniform in `0..bound`, without bias (Lemire's multiplication with rejection); 0 when `bound` is 0.
    pub fn below(&mut self, bound: u64) -> u64 {
        loop {
            let wide = u128::from(self.next_u64()) * u128::from(bound);
            let (high, low) = (high_half(wide), low_half(wide));
            // The lowest 2^64 mod bound values of `low` would favour some results.
            if low >= bound || bound == 0 || low >= bound.wrapping_neg() % bound {
                return high;
            }
        }
    }

    /// Uniform in `0..bound`, for indices.
    pub fn index(&mut self, bound: usize) -> usize {
        crate::num::count(self.below(bound as u64))
    }

    /// Uniform in `lo..=hi`.
    ///
    /// # Panics
    /// If `lo > hi`.
    pub fn integer(&mut self, lo: i64, hi: i64) -> i64 {
        assert!(lo <= hi, "an empty range has no integer to draw");
        let span = hi.wrapping_sub(lo).cast_unsigned().wrapping_add(1);
        let offset = if span == 0 { self.next_u64() } else { self.below(span) };
        lo.wrapping_add(offset.cast_signed())
    }

    /// Heads or tails.
    pub fn coin(&mut self) -> bool {
        self.next_u64() >> 63 == 1
    }

    /// True once in `every` draws on average.
    pub fn one_in(&mut self, every: u64) -> bool {
        self.below(every) == 0
    }

    /// Standard normal, by comparing uniforms only.
    pub fn gauss(&mut self) -> f64 {
        loop {
            // k >= 0 with weight exp(-k/2), then kept with exp(-k(k-1)/2): together exp(-k^2/2).
            let mut k = 0_u32;
            while self.exp_minus(0.5) {
                k += 1;
            }
            if !(0..k * k.saturating_sub(1)).all(|_| self.exp_minus(0.5)) {
                continue;
            }
            // A fraction x, kept with exp(-x(2k+x)/2), as k+1 trials with an exponent below 1.
            let (x, floor) = (self.unit(), f64::from(k));
            let z = x * (2.0 * floor + x) / (2.0 * floor + 2.0);
            if (0..=k).all(|_| self.exp_minus(z)) {
                let size = floor + x;
                return if self.coin() { size } else { -size };
            }
        }
    }

    /// True with probability exp(-z) for z in [0, 1]: the longest run z > u1 > u2 > .. has even length (von Neumann).
    fn exp_minus(&mut self, z: f64) -> bool {
        let (mut last, mut even) = (z, true);
        loop {
            let u = self.unit();
            if u >= last {
                return even;
            }
            (last, even) = (u, !even);
        }
    }

    /// Uniform on the unit circle up to rounding: a point of the disk, normalised.
    pub fn direction(&mut self) -> [f64; 2] {
        loop {
            let [x, y] = [self.between(-1.0, 1.0), self.between(-1.0, 1.0)];
            let norm = x * x + y * y;
            if norm <= 1.0 && norm > 1e-6 {
                let r = norm.sqrt();
                return [x / r, y / r];
            }
        }
    }

    /// Fisher and Yates, from the end.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.index(last + 1));
        }
    }
}

#[expect(clippy::cast_possible_truncation, reason = "the low half is what is asked for")]
fn low_half(wide: u128) -> u64 {
    wide as u64
}

fn high_half(wide: u128) -> u64 {
    (wide >> 64) as u64
}

#[cfg(test)]
mod tests;
