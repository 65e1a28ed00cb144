//! Where the vertices are, with or without weights: the exact answers that a filtration keeps needing.

use std::cmp::Ordering;

use delone_predicates::{Adaptive, Dyadic, Metric, SquaredRadius, Weighted};

/// The kernel of plain or of weighted sites.
#[derive(Clone, Debug)]
pub(crate) enum Geometry<const D: usize> {
    Plain(Adaptive<Vec<[f64; D]>>),
    Weighted(Weighted<Vec<[f64; D]>, Vec<f64>>),
}

/// A vertex as kernels take it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Site(pub(crate) u32);

impl From<Site> for usize {
    #[inline]
    fn from(site: Site) -> Self {
        site.0 as Self
    }
}

/// The vertices as kernels take them, as many as there are of them, in a buffer.
#[inline]
pub(crate) fn named<'b>(vertices: &[u32], buffer: &'b mut [Site; 8]) -> &'b [Site] {
    for (slot, &vertex) in buffer.iter_mut().zip(vertices) {
        *slot = Site(vertex);
    }
    &buffer[..vertices.len()]
}

impl<const D: usize> Geometry<D> {
    /// The exact squared radius of a simplex, or of the sphere orthogonal to it.
    pub(crate) fn squared_radius(&self, vertices: &[u32]) -> SquaredRadius {
        let (mut buffer, vertices) = ([Site(0); 8], vertices);
        let simplex = named(vertices, &mut buffer);
        match self {
            Self::Plain(kernel) => kernel.exact_squared_radius(simplex),
            Self::Weighted(kernel) => kernel.exact_squared_radius(simplex),
        }
    }

    /// The longer side of the bounding box of all sites; zero without any.
    pub(crate) fn longer_side(&self) -> Dyadic {
        let points: &[[f64; D]] = match self {
            Self::Plain(kernel) => kernel.points(),
            Self::Weighted(kernel) => kernel.points(),
        };
        let side = |axis: usize| {
            let low = points.iter().map(|p| p[axis]).fold(f64::INFINITY, f64::min);
            let high = points.iter().map(|p| p[axis]).fold(f64::NEG_INFINITY, f64::max);
            Dyadic::from(high) - Dyadic::from(low)
        };
        if points.is_empty() {
            Dyadic::ZERO
        } else {
            (0..D).map(side).max().unwrap_or(Dyadic::ZERO)
        }
    }
}

/// A simplex whose radius is wanted, and what is known of it in doubles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measured {
    pub(crate) bounds: [f64; 2],
    pub(crate) simplex: u32,
}

impl Measured {
    /// The simplex with bounds that differ in the last digits only, these ones if they do.
    #[inline]
    pub(crate) fn new<const D: usize>(
        kernel: &impl Metric<D>,
        simplex: u32,
        vertices: &[Site],
        bounds: Option<[f64; 2]>,
    ) -> Self {
        let bounds = bounds.unwrap_or_else(|| kernel.radius_bounds(vertices));
        let [low, high] = bounds;
        let is_narrow = high - low <= 1e-6 * high.abs().min(low.abs()); // a matter of time, not of truth
        if is_narrow {
            return Self { bounds, simplex };
        }
        let nearest = kernel.squared_radius(vertices);
        let below = if nearest == f64::INFINITY { f64::MAX } else { nearest.next_down() };
        Self { bounds: [below, nearest.next_up()], simplex }
    }

    /// The lower bound as a number of the same order.
    #[inline]
    pub(crate) fn image(&self) -> u64 {
        const SIGN: u64 = 1 << 63;
        let bits = self.bounds[0].to_bits();
        if bits & SIGN == 0 { bits | SIGN } else { !bits }
    }

    /// The order of two radii, if the bounds tell it.
    #[inline]
    pub(crate) fn order(&self, other: &Self) -> Option<Ordering> {
        let ([a, b], [c, d]) = (self.bounds, other.bounds);
        if b < c {
            Some(Ordering::Less)
        } else if d < a {
            Some(Ordering::Greater)
        } else if a == b && c == d {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
}
