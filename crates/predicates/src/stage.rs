//! Which stage of a kernel answered.

/// The stage that found a sign, from the cheapest to the dearest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Stage {
    /// The filter whose bound holds for the whole point set.
    StaticFilter,
    /// The filter whose bound is computed from the points of the call.
    DynamicFilter,
    /// Exact integers that fit into machine words of 64 and 128 bits.
    MachineWords,
    /// Exact integers, differences of one limb of 64 bits.
    OneLimb,
    /// A sum of doubles without error, of products in their range.
    Distilled,
    /// Exact integers, differences of two limbs.
    TwoLimbs,
    /// Exact integers, differences of four limbs.
    FourLimbs,
    /// Doubles without differences, scaled, for exponents that lie far apart.
    LeadingTerms,
    /// Sums of monomials, for exponents that lie far apart.
    LongSum,
    /// Exact integers of fixed widths, of constructed points.
    FixedWidth,
    /// Exact numbers of any length, of constructed points.
    Dyadic,
    /// Plain doubles, right or wrong.
    Unfiltered,
    /// Not told: the kernel has no stages, or does not count them.
    Untold,
}

impl Stage {
    /// All stages, in order.
    pub const ALL: [Self; 13] = [
        Self::StaticFilter,
        Self::DynamicFilter,
        Self::MachineWords,
        Self::OneLimb,
        Self::Distilled,
        Self::TwoLimbs,
        Self::FourLimbs,
        Self::LeadingTerms,
        Self::LongSum,
        Self::FixedWidth,
        Self::Dyadic,
        Self::Unfiltered,
        Self::Untold,
    ];
}
