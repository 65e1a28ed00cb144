//! Sites and segments before noding, for an algorithm that nodes on its way.

use super::{Pslg, PslgError};
use crate::Sites;

/// Usable sites and segments, these not yet cut where they meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Unnoded {
    sites: Sites<2>,
    segments: Vec<[u32; 2]>,
}

/// A piece of a segment: between two sites on it, with none between.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Piece {
    /// The sites at its ends, the smaller id first.
    pub(super) ends: [u32; 2],
    /// The segment.
    pub(super) segment: u32,
    /// Its place among the segment's pieces, from its first end on.
    pub(super) place: u32,
}

impl Piece {
    /// The piece between two sites that is number `place` of `segment`, from its first end on.
    #[must_use]
    pub fn new([a, b]: [u32; 2], segment: u32, place: u32) -> Self {
        Self { ends: [a.min(b), a.max(b)], segment, place }
    }
}

impl Unnoded {
    /// Checks points and segments (pairs of point indices).
    ///
    /// # Errors
    /// As [`Pslg::new`], which then also looks for crossings.
    pub fn new(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Result<Self, PslgError> {
        let named = |ends: &[usize; 2]| ends.iter().all(|&point| point < points.len());
        let countable = u32::try_from(segments.len()).is_ok_and(|count| count < u32::MAX - 1);
        match Sites::new(points) {
            Ok(sites) if countable && segments.iter().all(named) => {
                let site_of = sites.site_of();
                let segments = segments.iter().map(|ends| ends.map(|p| site_of[p])).collect();
                Ok(Self { sites, segments })
            }
            _ => Err(Pslg::new(points, segments).expect_err("the pass above found a fault")),
        }
    }

    /// The sites.
    #[must_use]
    pub fn sites(&self) -> &Sites<2> {
        &self.sites
    }

    /// The segments, their ends as sites; both ends of one may be one site.
    #[must_use]
    pub fn segments(&self) -> &[[u32; 2]] {
        &self.segments
    }

    /// The PSLG of these pieces, of which no two cross: all of each segment of positive length, in any order.
    #[must_use]
    pub fn noded(self, pieces: &[Piece]) -> Pslg {
        Pslg::of_pieces(self.sites, self.segments, pieces)
    }
}
