//! Any finite coordinates brought into the unit cube, each axis on its own, with the proportions beside them.
//!
//! **Invariants.** 1. Coordinates are first scaled by a power of two that brings the largest below 2^1000 and keeps the
//! smallest denormal, so no difference overflows and no span vanishes. 2. `unit` returns numbers of [0, 1] only.

/// Where one axis begins, how long it is.
#[derive(Clone, Copy, Debug)]
struct Axis {
    scale: f64,
    low: f64,
    span: f64,
}

/// The bounding box of some points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame<const D: usize> {
    axes: [Axis; D],
    /// Length of each axis over that of the longest; all zero if all points are equal.
    pub(crate) proportions: [f64; D],
}

impl<const D: usize> Frame<D> {
    /// Around the finite ones of `points`.
    pub(crate) fn around<'p>(points: impl IntoIterator<Item = &'p [f64; D]>) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
        for p in points.into_iter().filter(|p| is_finite(p)) {
            for i in 0..D {
                (low[i], high[i]) = (low[i].min(p[i]), high[i].max(p[i]));
            }
        }
        if low[0] > high[0] {
            (low, high) = ([0.0; D], [0.0; D]);
        }
        let axis = |i: usize, scale: f64| {
            let (low, high) = (low[i] * scale, high[i] * scale);
            Axis { scale, low, span: high - low }
        };
        let size = |i: usize| low[i].abs().max(high[i].abs());
        let common = scale_for((0..D).map(size).fold(0.0, f64::max));
        let spans = std::array::from_fn::<f64, D, _>(|i| axis(i, common).span);
        let longest = spans.iter().copied().fold(0.0, f64::max);
        Self {
            axes: std::array::from_fn(|i| axis(i, scale_for(size(i)))),
            proportions: spans.map(|span| if longest > 0.0 { span / longest } else { 0.0 }),
        }
    }

    /// Whether axis `i` has any length, be it too short to show in its proportion.
    pub(crate) fn is_spread(&self, i: usize) -> bool {
        self.axes[i].span > 0.0
    }

    /// The place of `p` along each axis, 0 to 1; the middle of an axis without length. None if `p` is not finite.
    pub(crate) fn unit(&self, p: [f64; D]) -> Option<[f64; D]> {
        let place = |i: usize| {
            let Axis { scale, low, span } = self.axes[i];
            if span > 0.0 { ((p[i] * scale - low) / span).clamp(0.0, 1.0) } else { 0.5 }
        };
        is_finite(&p).then(|| std::array::from_fn(place))
    }
}

fn is_finite<const D: usize>(p: &[f64; D]) -> bool {
    p.iter().all(|x| x.is_finite())
}

/// Inv 1: 2^-64 for the largest doubles, 2^900 for those near the denormals, else 1.
fn scale_for(size: f64) -> f64 {
    let power = |e: u64| f64::from_bits((1023 + e) << 52);
    if size > power(1000) {
        1.0 / power(64)
    } else if size < 1.0 / power(900) {
        power(900)
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests;
