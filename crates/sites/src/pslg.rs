//! Planar straight-line graphs: sites and segments, checked and noded at the door.
//!
//! **Definition.** The segments of a noded PSLG meet in common end points only. Input segments may run through sites
//! and over one another; here they are cut there, which moves nothing. They may not cross elsewhere: that would need a
//! new vertex, and is refused with every crossing listed.
//!
//! **Cost.** Sites on segments: by segment, the boxes that it meets (`boxes.rs`). Crossings: a sweep tells whether there are
//! any in O((n + m) log n) (`sweep.rs`); only then are all pairs near each other looked at.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a site inside a segment | the segment is cut there | `a_site_inside_a_segment_cuts_it` |
//! | segments overlap | they share subsegments | `overlaps_share_subsegments` |
//! | a segment of no length | dropped, and listed | `segments_of_no_length_are_dropped_and_listed` |
//! | two segments cross at a site | cut there, not refused | `crossing_at_a_site_is_no_crossing` |

use std::fmt;

use delone_predicates::{Adaptive, Kernel, Sign, orient2d};

use crate::boxes::{Box2, BoxTree};
use crate::sweep::any_crossing;
use crate::{NotFinite, Sites, SitesError};

/// A noded planar straight-line graph.
#[derive(Clone, Debug, PartialEq)]
pub struct Pslg {
    sites: Sites<2>,
    segments: Vec<[u32; 2]>,
    subsegments: Vec<[u32; 2]>,
    chains: Vec<Vec<u32>>,
    dropped: Vec<u32>,
}

/// Two input segments that cross in their interiors, away from any site.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The two segments, by input index.
    pub segments: [u32; 2],
    /// Where, in doubles, rounded.
    pub near: [f64; 2],
}

/// One thing wrong with a planar straight-line graph.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum PslgFault {
    /// A coordinate is NaN or infinite.
    NotFinite(NotFinite),
    /// A segment names a point that is not there.
    NoSuchPoint {
        /// The segment, by input index.
        segment: usize,
        /// What it names.
        point: usize,
        /// How many points there are.
        count: usize,
    },
    /// Two segments cross.
    Crossing(Crossing),
    /// More points or segments than ids.
    TooMany(usize),
}

/// Why a planar straight-line graph was refused: every fault.
#[derive(Clone, Debug, PartialEq)]
pub struct PslgError(pub Vec<PslgFault>);

impl fmt::Display for PslgFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite(fault) => fault.fmt(f),
            Self::NoSuchPoint { segment, point, count } => {
                write!(
                    f,
                    "segment {segment} names point {point}, but there are {count} points: indices go from 0"
                )
            }
            Self::Crossing(Crossing { segments: [a, b], near: [x, y] }) => write!(
                f,
                "segments {a} and {b} cross near ({x}, {y}): split them at a common vertex"
            ),
            Self::TooMany(count) => {
                write!(f, "{count} points or segments are more than ids can name")
            }
        }
    }
}

impl fmt::Display for PslgError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<String> = self.0.iter().map(ToString::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for PslgError {}

impl From<SitesError> for PslgError {
    fn from(error: SitesError) -> Self {
        match error {
            SitesError::NotFinite(all) => Self(all.into_iter().map(PslgFault::NotFinite).collect()),
            SitesError::TooMany(count) => Self(vec![PslgFault::TooMany(count)]),
        }
    }
}

impl Pslg {
    /// Checks and nodes points and segments (pairs of point indices).
    ///
    /// # Errors
    /// With every coordinate that is not finite and every segment that names no point; if there are none of these,
    /// with every crossing.
    pub fn new(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Result<Self, PslgError> {
        let mut faults = no_such_points(points.len(), segments);
        if u32::try_from(segments.len()).is_err() {
            faults.push(PslgFault::TooMany(segments.len()));
        }
        let sites = match Sites::new(points) {
            Ok(sites) if faults.is_empty() => sites,
            Ok(_) => return Err(PslgError(faults)),
            Err(error) => {
                faults.splice(0..0, PslgError::from(error).0);
                return Err(PslgError(faults));
            }
        };
        let ends: Vec<[u32; 2]> =
            segments.iter().map(|ends| ends.map(|point| sites.site_of()[point])).collect();
        let noded = Self::noded(sites, ends);
        let crossings = if noded.is_crossed() { noded.crossings() } else { Vec::new() };
        if crossings.is_empty() {
            Ok(noded)
        } else {
            Err(PslgError(crossings.into_iter().map(PslgFault::Crossing).collect()))
        }
    }

    /// Cuts each segment at the sites inside it, and unites equal pieces.
    fn noded(sites: Sites<2>, segments: Vec<[u32; 2]>) -> Self {
        let points = sites.points();
        let ranks = sites.ranks();
        let boxes: Vec<Box2> = points.iter().map(|&p| Box2::of(p, p)).collect();
        let tree = BoxTree::new(&boxes);
        let mut pieces: Vec<([u32; 2], u32, u32)> = Vec::new(); // ends, segment, place in it
        let mut dropped = Vec::new();
        for (segment, &[a, b]) in (0u32..).zip(&segments) {
            if a == b {
                dropped.push(segment);
                continue;
            }
            let mut stops = sites_on(points, &tree, a, b);
            stops.sort_unstable_by_key(|&site| ranks[site as usize]);
            if ranks[a as usize] > ranks[b as usize] {
                stops.reverse();
            }
            for (place, ends) in (0u32..).zip(stops.windows(2)) {
                pieces.push(([ends[0].min(ends[1]), ends[0].max(ends[1])], segment, place));
            }
        }
        let (subsegments, chains) = united(pieces, segments.len());
        Self { sites, segments, subsegments, chains, dropped }
    }

    #[cfg(test)]
    pub(crate) fn noded_for_tests(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Self {
        let sites = Sites::new(points).expect("points of tests are finite");
        let ends = segments.iter().map(|ends| ends.map(|point| sites.site_of()[point])).collect();
        Self::noded(sites, ends)
    }

    /// Whether any two subsegments cross.
    fn is_crossed(&self) -> bool {
        let (sorted, ranks) = (self.sites.sorted(), self.sites.ranks());
        let ranked = |ends: &[u32; 2]| {
            let [a, b] = ends.map(|site| ranks[site as usize]);
            [a.min(b), a.max(b)]
        };
        let segments: Vec<[u32; 2]> = self.subsegments.iter().map(ranked).collect();
        let kernel = Adaptive::new(self.sites.points()).reordered(sorted);
        any_crossing(&kernel, sorted.len(), &segments)
    }

    /// Every pair of input segments that cross, by index. O(those near each other): for input that is refused.
    fn crossings(&self) -> Vec<Crossing> {
        let points = self.sites.points();
        let ends = |piece: u32| self.subsegments[piece as usize].map(|site| points[site as usize]);
        let boxes: Vec<Box2> =
            (0u32..).take(self.subsegments.len()).map(&ends).map(|[a, b]| Box2::of(a, b)).collect();
        let tree = BoxTree::new(&boxes);
        let mut parents = vec![Vec::new(); self.subsegments.len()];
        for (segment, chain) in (0u32..).zip(&self.chains) {
            chain.iter().for_each(|&piece| parents[piece as usize].push(segment));
        }
        let mut crossings = Vec::new();
        for piece in (0u32..).take(self.subsegments.len()) {
            let [a, b] = ends(piece);
            tree.for_each_near(a, b, |other| {
                if other <= piece {
                    return;
                }
                let [c, d] = ends(other);
                if cross(a, b, c, d) {
                    for &s in &parents[piece as usize] {
                        for &t in &parents[other as usize] {
                            let segments = [s.min(t), s.max(t)];
                            crossings.push(Crossing { segments, near: near(a, b, c, d) });
                        }
                    }
                }
            });
        }
        crossings.sort_unstable_by_key(|crossing| crossing.segments);
        crossings
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
    pub fn chains(&self) -> &[Vec<u32>] {
        &self.chains
    }

    /// Input segments of no length: both ends are one site.
    #[must_use]
    pub fn dropped(&self) -> &[u32] {
        &self.dropped
    }
}

fn no_such_points(count: usize, segments: &[[usize; 2]]) -> Vec<PslgFault> {
    let bad = |(segment, ends): (usize, &[usize; 2])| {
        ends.map(|point| PslgFault::NoSuchPoint { segment, point, count })
    };
    let bad = segments.iter().enumerate().flat_map(bad);
    bad.filter(|fault| matches!(fault, PslgFault::NoSuchPoint { point, .. } if *point >= count))
        .collect()
}

/// The sites on the closed segment from `a` to `b`, in no order.
fn sites_on(points: &[[f64; 2]], tree: &BoxTree, a: u32, b: u32) -> Vec<u32> {
    let [pa, pb] = [a, b].map(|site| points[site as usize]);
    let mut found = Vec::new();
    // The box of a site is the site, and the tree visits boxes that meet the segment's box and its line.
    tree.for_each_near(pa, pb, |site| {
        if orient2d(pa, pb, points[site as usize]) == Sign::Zero {
            found.push(site);
        }
    });
    found
}

/// Unites equal pieces: the distinct ones, and for each segment its own by index.
fn united(
    mut pieces: Vec<([u32; 2], u32, u32)>,
    segments: usize,
) -> (Vec<[u32; 2]>, Vec<Vec<u32>>) {
    pieces.sort_unstable();
    let mut distinct: Vec<[u32; 2]> = Vec::new();
    let mut placed: Vec<(u32, u32, u32)> = Vec::with_capacity(pieces.len());
    for (ends, segment, place) in pieces {
        if distinct.last() != Some(&ends) {
            distinct.push(ends);
        }
        let piece = u32::try_from(distinct.len() - 1).expect("a planar graph has at most 3n edges");
        placed.push((segment, place, piece));
    }
    placed.sort_unstable();
    let mut chains = vec![Vec::new(); segments];
    placed.into_iter().for_each(|(segment, _, piece)| chains[segment as usize].push(piece));
    (distinct, chains)
}

/// Whether the interiors of `ab` and `cd` meet in one point.
fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> bool {
    orient2d(a, b, c) * orient2d(a, b, d) == Sign::Negative
        && orient2d(c, d, a) * orient2d(c, d, b) == Sign::Negative
}

/// The crossing of the lines, rounded: for messages.
fn near(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> [f64; 2] {
    let cross = |u: [f64; 2], v: [f64; 2]| u[0] * v[1] - u[1] * v[0];
    let minus = |u: [f64; 2], v: [f64; 2]| [u[0] - v[0], u[1] - v[1]];
    let t = cross(minus(c, a), minus(d, c)) / cross(minus(b, a), minus(d, c));
    let t = if t.is_finite() { t.clamp(0.0, 1.0) } else { 0.5 };
    [0, 1].map(|axis| a[axis] * (1.0 - t) + b[axis] * t)
}
