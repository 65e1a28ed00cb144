//! Planar straight-line graphs: sites and segments, checked and noded at the door.
//!
//! **Definition.** The segments of a noded PSLG meet in common end points only. Input segments may run through sites
//! and over one another; here they are cut there, which moves nothing. They may not cross elsewhere: that would need a
//! new vertex, and is refused with every crossing listed.
//!
//! **Cost.** O((n + m) log n): a sweep finds the sites on segments, and that none cross (`sweep.rs`). If some do, even at
//! sites, sites are looked for in the strips that each segment passes (`strips.rs`), and if they do elsewhere, all pairs near
//! each other are looked at.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a site inside a segment | the segment is cut there | `a_site_inside_a_segment_cuts_it` |
//! | segments overlap | they share subsegments | `overlaps_share_subsegments` |
//! | a segment of no length | dropped, and listed | `segments_of_no_length_are_dropped_and_listed` |
//! | two segments cross at a site | cut there, not refused | `crossing_at_a_site_is_no_crossing` |
//! | any of these, where the input must be noded already | refused, all of them listed | `strict_lists_everything_that_is_repaired` |

mod coverage;
mod crossings;
mod faults;
mod survey;
mod unnoded;

use delone_predicates::{Adaptive, Kernel};

use crate::strips::Strips;
use crate::sweep::sweep;
use crate::{Chains, Sites};
pub use coverage::Coverage;
pub use faults::{Crossing, PslgError, PslgFault};
use survey::Survey;
pub use unnoded::{Piece, Unnoded};

#[cfg(test)]
#[expect(clippy::cast_possible_truncation, reason = "the numbers of the tests are small")]
mod tests;

/// A noded planar straight-line graph.
#[derive(Clone, Debug, PartialEq)]
pub struct Pslg {
    pub(crate) sites: Sites<2>,
    pub(crate) segments: Vec<[u32; 2]>,
    pub(crate) subsegments: Vec<[u32; 2]>,
    pub(crate) chains: Chains,
    pub(crate) dropped: Vec<u32>,
}

impl Pslg {
    /// Checks and nodes points and segments (pairs of point indices).
    ///
    /// Equal points become one site, segments are cut at the points on them, pieces that are covered several times are
    /// kept once (and [counted](crate::Noded::coverage)), segments of no length are dropped. [`Pslg::strict`] refuses all that.
    ///
    /// # Errors
    /// With every coordinate that is not finite, every segment that names no point, and every crossing of the others.
    pub fn new(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Result<Self, PslgError> {
        let Survey { pslg, planar, mut faults, names } = Survey::of(points, segments);
        faults.extend(names.crossings(&pslg, planar));
        if faults.is_empty() { Ok(pslg) } else { Err(PslgError(faults)) }
    }

    /// Nodes points and segments, which may cross; or says why it cannot.
    pub(crate) fn crossed(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Result<Self, PslgError> {
        let Survey { pslg, faults, .. } = Survey::of(points, segments);
        if faults.is_empty() { Ok(pslg) } else { Err(PslgError(faults)) }
    }

    /// [`Pslg::new`] for input that must be a planar straight-line graph as it stands.
    ///
    /// ```
    /// use delone_sites::Pslg;
    ///
    /// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
    /// let refused = Pslg::strict(&points, &[[0, 1], [2, 3]]).unwrap_err();
    /// assert_eq!(refused.to_string(), "point 2 at (1, 0) lies inside segment 0: split the segment there");
    /// assert!(Pslg::new(&points, &[[0, 1], [2, 3]]).is_ok());
    /// ```
    ///
    /// # Errors
    /// With everything that [`Pslg::new`] refuses or repairs: also equal points, segments of no length, points inside
    /// segments, overlaps and repeated segments.
    pub fn strict(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Result<Self, PslgError> {
        let Survey { pslg, planar, mut faults, names } = Survey::of(points, segments);
        faults.extend(names.repaired(&pslg));
        faults.extend(names.crossings(&pslg, planar));
        if faults.is_empty() { Ok(pslg) } else { Err(PslgError(faults)) }
    }

    /// Cuts each segment at the sites inside it, and unites equal pieces. Whether none cross is known if the sweep says so.
    fn noded(sites: Sites<2>, segments: Vec<[u32; 2]>) -> (Self, Planar) {
        match by_sweep(&sites, &segments) {
            Some(pieces) => (Self::of_pieces(sites, segments, &pieces), Planar::Known),
            None => {
                let pieces = by_strips(&sites, &segments);
                (Self::of_pieces(sites, segments, &pieces), Planar::Unknown)
            }
        }
    }

    /// Of segments and the pieces that they are cut into.
    pub(crate) fn of_pieces(sites: Sites<2>, segments: Vec<[u32; 2]>, pieces: &[Piece]) -> Self {
        let of_no_length = (0u32..).zip(&segments).filter(|(_, [a, b])| a == b);
        let dropped = of_no_length.map(|(segment, _)| segment).collect();
        let (subsegments, chains) = united(sites.len(), pieces, segments.len());
        Self { sites, segments, subsegments, chains, dropped }
    }

    #[cfg(test)]
    pub(crate) fn noded_for_tests(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Self {
        let sites = Sites::new(points).expect("points of tests are finite");
        let ends = segments.iter().map(|ends| ends.map(|point| sites.site_of()[point])).collect();
        Self::noded(sites, ends).0
    }

    /// The sites.
    #[must_use]
    pub fn sites(&self) -> &Sites<2> {
        &self.sites
    }

    /// The input segments, their ends as sites.
    #[must_use]
    pub fn segments(&self) -> &[[u32; 2]] {
        &self.segments
    }

    /// The noded segments, smaller site first, in increasing order, each once.
    #[must_use]
    pub fn subsegments(&self) -> &[[u32; 2]] {
        &self.subsegments
    }

    /// For each input segment its subsegments from its first end to its second.
    #[must_use]
    pub fn chains(&self) -> &Chains {
        &self.chains
    }

    /// Input segments of no length: both ends are one site.
    #[must_use]
    pub fn dropped(&self) -> &[u32] {
        &self.dropped
    }
}

/// Whether it is known that no two pieces cross.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Planar {
    Known,
    Unknown,
}

/// Segments as pairs of ranks, the smaller first.
fn ranked(ranks: &[u32], segments: &[[u32; 2]]) -> Vec<[u32; 2]> {
    let ranked = |ends: &[u32; 2]| {
        let [a, b] = ends.map(|site| ranks[site as usize]);
        [a.min(b), a.max(b)]
    };
    segments.iter().map(ranked).collect()
}

/// The pieces of segments that do not cross, not even at sites.
fn by_sweep(sites: &Sites<2>, segments: &[[u32; 2]]) -> Option<Vec<Piece>> {
    let kernel = Adaptive::new(sites.points()).reordered(sites.sorted());
    let swept = sweep(&kernel, sites.len(), &ranked(&sites.ranks(), segments))?;
    Some(unnoded::pieces_of(sites, segments, &swept))
}

/// The pieces of segments, whether they cross or not.
fn by_strips(sites: &Sites<2>, segments: &[[u32; 2]]) -> Vec<Piece> {
    let ranks = sites.ranks();
    let strips = Strips::new(sites.points(), sites.sorted());
    let mut pieces: Vec<Piece> = Vec::with_capacity(segments.len());
    for (segment, &[a, b]) in (0u32..).zip(segments) {
        if a == b {
            continue;
        }
        let [from, to] = [a, b].map(|site| ranks[site as usize]);
        let inside = strips.inside(from.min(to), from.max(to));
        let mut stops: Vec<u32> =
            inside.into_iter().map(|rank| sites.sorted()[rank as usize]).collect();
        if from > to {
            stops.reverse();
        }
        let mut before = a;
        for (place, stop) in (0u32..).zip(stops.into_iter().chain([b])) {
            pieces.push(Piece::new([before, stop], segment, place));
            before = stop;
        }
    }
    pieces
}

/// Unites equal pieces: the distinct ones, and for each segment its own by index.
fn united(sites: usize, pieces: &[Piece], segments: usize) -> (Vec<[u32; 2]>, Chains) {
    let mut distinct: Vec<[u32; 2]> = Vec::with_capacity(pieces.len());
    let mut lengths = vec![0u32; segments];
    pieces.iter().for_each(|piece| lengths[piece.segment as usize] += 1);
    let mut chains = Chains::of_lengths(lengths.into_iter());
    for Piece { ends, segment, place } in sorted(sites, pieces) {
        if distinct.last() != Some(&ends) {
            distinct.push(ends);
        }
        let piece = u32::try_from(distinct.len() - 1).expect("a planar graph has at most 3n edges");
        chains.set(segment, place, piece);
    }
    (distinct, chains)
}

/// The pieces in increasing order: counted by their smaller ends, which is quicker than to sort them, and sorted from there.
fn sorted(sites: usize, pieces: &[Piece]) -> Vec<Piece> {
    let mut starts = vec![0u32; sites + 2];
    pieces.iter().for_each(|piece| starts[piece.ends[0] as usize + 2] += 1);
    for site in 2..starts.len() {
        starts[site] += starts[site - 1];
    }
    let mut sorted = vec![Piece::new([0, 0], 0, 0); pieces.len()];
    for &piece in pieces {
        let place = &mut starts[piece.ends[0] as usize + 1];
        sorted[*place as usize] = piece;
        *place += 1;
    }
    for run in sorted.chunk_by_mut(|a, b| a.ends[0] == b.ends[0]) {
        run.sort_unstable();
    }
    sorted
}
