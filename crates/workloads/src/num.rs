//! Every conversion between numbers, so that no other file casts.

/// The id of the `i`-th site.
pub(crate) fn id(i: usize) -> u32 {
    u32::try_from(i).expect("`generate` caps n at SITES_MAX, which fits 32 bits")
}

/// `i` as a double, exact up to 2^53.
pub(crate) fn real(i: usize) -> f64 {
    i as f64
}

/// `i` as a double, exact up to 2^53 either way.
pub(crate) fn signed(i: i64) -> f64 {
    i as f64
}

/// A count as a signed integer.
pub(crate) fn int(i: usize) -> i64 {
    i64::try_from(i).expect("counts stay below 2^63")
}

/// An integer known to lie in `0..bound`, for a bound that was a `usize`.
pub(crate) fn count(i: u64) -> usize {
    usize::try_from(i).expect("a value drawn below a usize is one")
}

/// 2^e for a normal exponent.
pub(crate) const fn pow2(e: i64) -> f64 {
    assert!(-1022 <= e && e <= 1023, "2^e must be a normal double");
    f64::from_bits((1023 + e).cast_unsigned() << 52)
}

/// The smallest `k` with `k * k >= n`: the side of a square that holds `n` sites.
pub(crate) fn side(n: usize) -> usize {
    let k = n.isqrt();
    if k * k < n { k + 1 } else { k }
}

/// `x` moved by `steps` ULPs.
pub(crate) fn nudge(x: f64, steps: i64) -> f64 {
    let mut y = x;
    for _ in 0..steps.unsigned_abs() {
        y = if steps > 0 { y.next_up() } else { y.next_down() };
    }
    y
}
