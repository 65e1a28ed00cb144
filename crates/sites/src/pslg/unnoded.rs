//! Sites and segments before noding, for an algorithm that nodes on its way.

use super::{Pslg, PslgError, ranked};
use crate::{Sites, Swept};

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

/// The pieces of segments between sites, as a sweep over ranks has found them.
pub(super) fn pieces_of(sites: &Sites<2>, segments: &[[u32; 2]], swept: &Swept) -> Vec<Piece> {
    let mut places = vec![0u32; segments.len()];
    let mut pieces = Vec::with_capacity(swept.members.len());
    for &[segment, piece] in &swept.members {
        let ends = swept.pieces[piece as usize].map(|rank| sites.sorted()[rank as usize]);
        let place = &mut places[segment as usize];
        pieces.push(Piece::new(ends, segment, *place));
        *place += 1;
    }
    // The sweep goes from left to right, some segments from right to left.
    for piece in &mut pieces {
        let count = places[piece.segment as usize];
        if count > 1 && is_backward(sites, segments[piece.segment as usize]) {
            piece.place = count - 1 - piece.place;
        }
    }
    pieces
}

fn is_backward(sites: &Sites<2>, ends: [u32; 2]) -> bool {
    let [a, b] = ends.map(|site| sites.points()[site as usize]);
    a > b
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

    /// The PSLG of what a [`sweep`](crate::sweep()) over these segments has found, vertices being the sites in lexicographic order.
    #[must_use]
    pub fn swept(self, swept: &Swept) -> Pslg {
        let pieces = pieces_of(&self.sites, &self.segments, swept);
        Pslg::of_pieces(self.sites, self.segments, &pieces)
    }

    /// The segments by ranks of sites in lexicographic order, the smaller first.
    #[must_use]
    pub fn ranked(&self) -> Vec<[u32; 2]> {
        ranked(&self.sites.ranks(), &self.segments)
    }

    /// The PSLG of these pieces, of which no two cross: all of each segment of positive length, in any order.
    #[must_use]
    pub fn noded(self, pieces: &[Piece]) -> Pslg {
        Pslg::of_pieces(self.sites, self.segments, pieces)
    }
}
