//! Files of the user's own, of which generated cases take pieces.

use std::sync::Arc;

use delone::workloads::Rng;

use crate::case::Case;
use crate::choices::Choices;
use crate::id;

/// Points, flat, of the plane or of space; and segments by index.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// 2 or 3.
    pub dimension: usize,
    /// Finite coordinates, `dimension` for each point.
    pub points: Vec<f64>,
    /// Pairs of points.
    pub segments: Vec<[u32; 2]>,
}

/// Pieces in an order; a case is a pure function of target, seed, number and these.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Corpus {
    pieces: Vec<Arc<Piece>>,
    digest: u64,
}

/// No files.
pub const NO_CORPUS: &Corpus = &Corpus { pieces: Vec::new(), digest: 0 };

impl Corpus {
    /// Of these pieces; those without points are left out.
    ///
    /// # Panics
    /// If a coordinate is not finite, or a segment names no point.
    #[must_use]
    pub fn new(mut pieces: Vec<Piece>) -> Self {
        pieces.retain(|piece| !piece.points.is_empty());
        let mut digest = 0;
        let mut take = |word: u64| digest = Rng::new(digest ^ word).next_u64();
        for piece in &pieces {
            assert!(piece.points.iter().all(|x| x.is_finite()), "a coordinate is finite");
            let count = id(piece.points.len() / piece.dimension);
            assert!(piece.segments.as_flattened().iter().all(|&v| v < count), "ends are points");
            take(piece.dimension as u64);
            piece.points.iter().for_each(|x| take(x.to_bits()));
            piece.segments.as_flattened().iter().for_each(|&v| take(u64::from(v)));
        }
        Self { pieces: pieces.into_iter().map(Arc::new).collect(), digest }
    }

    /// How many pieces there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.pieces.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// A hash of everything in it; 0 if there is nothing.
    #[must_use]
    pub const fn digest(&self) -> u64 {
        self.digest
    }

    fn of_dimension(&self, dimension: usize) -> impl Iterator<Item = &Arc<Piece>> {
        self.pieces.iter().filter(move |piece| piece.dimension == dimension)
    }
}

/// The most points that a case takes from one piece.
const TAKEN_MAX: usize = 7;

/// Consecutive points of one piece or of two, with the segments between them; nothing, and no choice made, without a corpus.
pub(crate) fn taken<const D: usize>(choices: &mut dyn Choices) -> Case<D> {
    let mut case = Case::of_points(crate::generate::NAME, Vec::new());
    let count = choices.corpus().of_dimension(D).count();
    if count == 0 {
        return case;
    }
    for _ in 0..choices.index(3) {
        let which = choices.index(count);
        let piece = choices.corpus().of_dimension(D).nth(which).expect("which < count").clone();
        let points = piece.points.as_chunks::<D>().0;
        let start = choices.index(points.len());
        let end = points.len().min(start + 1 + choices.index(TAKEN_MAX));
        let (range, before) = (id(start)..id(end), id(case.points.len()));
        case.points.extend(&points[start..end]);
        let inside = piece.segments.iter().filter(|ends| ends.iter().all(|v| range.contains(v)));
        case.segments.extend(inside.map(|ends| ends.map(|v| v - range.start + before)));
    }
    case
}

#[cfg(test)]
mod tests;
