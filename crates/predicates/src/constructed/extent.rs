//! The box of a growing set of points, and the bounds of static filters that follow from it.

use crate::filter::Bounds;

/// The box of the points so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent<const D: usize> {
    low: [f64; D],
    high: [f64; D],
}

impl<const D: usize> Extent<D> {
    /// Of no points.
    pub(super) const EMPTY: Self = Self { low: [f64::INFINITY; D], high: [f64::NEG_INFINITY; D] };

    /// Whether the box grew.
    pub(super) fn include(&mut self, point: &[f64; D]) -> bool {
        let before = (self.low, self.high);
        for ((low, high), &x) in self.low.iter_mut().zip(&mut self.high).zip(point) {
            (*low, *high) = (low.min(x), high.max(x));
        }
        before != (self.low, self.high)
    }

    /// For the points as plain ones.
    pub(super) fn bounds(&self) -> Bounds {
        if self.is_empty() { Bounds::NONE } else { Bounds::of(&[self.low, self.high]) }
    }

    /// For points whose nearest doubles these are (see the module above).
    pub(super) fn wide_bounds(&self) -> Bounds {
        if self.is_empty() {
            return Bounds::NONE;
        }
        let magnitude: [f64; D] = std::array::from_fn(|axis| {
            let (low, high) = (self.low[axis], self.high[axis]);
            (high - low) + 2.0 * low.abs().max(high.abs()) + 4.0 * f64::MIN_POSITIVE
        });
        let Bounds { orient, lifted } = Bounds::of(&[[0.0; D], magnitude]);
        Bounds { orient: 2.0 * orient, lifted: 2.0 * lifted }
    }

    /// The largest magnitude of a coordinate.
    pub(super) fn far(&self) -> f64 {
        self.low.iter().chain(&self.high).fold(0.0, |far: f64, x| far.max(x.abs()))
    }

    fn is_empty(&self) -> bool {
        self.low.iter().zip(&self.high).any(|(low, high)| low > high)
    }
}
