//! Numbers of all exponents for the tests of the tiers.

/// splitmix64
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    pub(crate) fn below(&mut self, count: u32) -> u32 {
        u32::try_from(self.bits() % u64::from(count)).expect("below a number of that type")
    }

    /// A full mantissa at some exponent in `-range..=range`.
    pub(crate) fn wide(&mut self, range: u32) -> f64 {
        let field = 1023 + u64::from(self.below(2 * range + 1)) - u64::from(range);
        f64::from_bits(self.bits() & !(0x7ff << 52) | field << 52)
    }

    /// Any finite double.
    pub(crate) fn any(&mut self) -> f64 {
        let value = f64::from_bits(self.bits());
        if value.is_finite() { value } else { 0.0 }
    }

    /// Zero, or plus or minus a power of two from a few that lie far apart.
    pub(crate) fn power(&mut self) -> f64 {
        let powers = [0.0, 5e-324, 2f64.powi(-1000), 2f64.powi(-512), 1.0, 2.0];
        let powers = [&powers[..], &[2f64.powi(512), 2f64.powi(1000), 2f64.powi(1001)]].concat();
        let power = powers[self.below(9) as usize];
        if self.below(2) == 0 { power } else { -power }
    }
}
