//! A small generator of its own (splitmix64), so that inputs outlive updates of dependencies.

/// A seeded stream of numbers.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The stream of this seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// 64 bits.
    pub const fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    /// Uniform in [0, 1), a multiple of 2^-53.
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
    pub const fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (0.5 / (1u64 << 52) as f64)
    }

    /// An integer in `low..high`.
    ///
    /// # Panics
    /// If the range is empty.
    pub fn integer(&mut self, low: i64, high: i64) -> i64 {
        assert!(low < high, "an empty range");
        low + (self.bits() % high.abs_diff(low)).cast_signed()
    }

    /// As [`Random::integer`], a double.
    #[expect(clippy::cast_precision_loss, reason = "integers of inputs are small")]
    pub fn whole(&mut self, low: i64, high: i64) -> f64 {
        self.integer(low, high) as f64
    }

    /// An exponent in `low..high`.
    ///
    /// # Panics
    /// If the range is empty.
    pub fn exponent(&mut self, low: i32, high: i32) -> i32 {
        i32::try_from(self.integer(low.into(), high.into())).expect("between two of that type")
    }

    /// An index in `0..n`.
    ///
    /// # Panics
    /// If `n` is zero.
    pub fn index(&mut self, n: usize) -> usize {
        usize::try_from(self.bits() % n as u64).expect("below a number of that type")
    }

    /// A full mantissa in [1, 2) with a random sign, times 2 to a power in `low..=high`.
    ///
    /// # Panics
    /// If the range is empty.
    pub fn scaled(&mut self, low: i32, high: i32) -> f64 {
        let exponent = self.exponent(low, high + 1);
        let value = (1.0 + self.unit())
            * power_of_two(exponent / 2)
            * power_of_two(exponent - exponent / 2);
        if self.bits() & 1 == 0 { value } else { -value }
    }

    /// True once in `n`.
    pub const fn once_in(&mut self, n: u64) -> bool {
        self.bits().is_multiple_of(n)
    }
}

/// 2 to a power between -1022 and 1023.
#[must_use]
pub fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(u64::from((exponent + 1023).cast_unsigned()) << 52)
}
