//! The judge of conforming Delaunay triangulations whose vertices all are in doubles, as other programs write them.
//!
//! **In.** A complex over points and Steiner points; segments between the points; perhaps the edges that the output flags as on
//! segments.
//! **Method.** K1 to K4 as in [`crate::judge_constrained`], but no edge is exempt from D2: so the triangulation is the Delaunay
//! triangulation of its vertices. A Steiner point that was rounded is off its segment, as a rule, and the chain breaks there.
//! If flagged edges lead on all the same, through Steiner points, to the segment's other end (S5), then each of these that is not
//! in line is a fault with its distance; else the segment is broken.
//! **Cost.** That of `judge_constrained`; and for each step off a segment some big integers for each flagged edge there.

use crate::cells::{Complex, Triangulation};
use crate::chains::{Edges, check_flags, cover};
use crate::exact::{Integer, Pure, Sign};
use crate::fault::Fault;
use crate::local::check_local;
use crate::options::{Backend, Options, Ties};
use crate::sites::{witness, witnesses};
use crate::triangulation::{check_triangulation, facets_of};
use crate::verdict::{Level, Report, Verdict};
use std::collections::BTreeSet;

/// Judges whether the complex is the Delaunay triangulation of all its vertices, with each of the `segments` a chain of edges,
/// exactly in line.
///
/// The first `points` of the complex's points are input points, the others are Steiner points. `constrained` are the edges that the
/// output flags as on segments, if it flags any: they tell which Steiner points were meant to be on which segment.
///
/// ```
/// use delone_check::{Complex, Options, judge_conforming_doubles};
///
/// let judge = |middle: [f64; 2]| {
///     let points = [[0.0, 0.0], [3.0, 1.0], [6.0, 0.0], [3.0, -1.0], middle];
///     let cells = [0, 4, 1, 4, 2, 1, 0, 3, 4, 4, 3, 2];
///     let complex = Complex { points: &points, dimension: Some(2), cells: &cells };
///     let flags = [[0, 4], [4, 2]];
///     judge_conforming_doubles(&complex, 4, &[[0, 2]], Some(&flags), &Options::foreign())
/// };
/// assert!(judge([3.0, 0.0]).ok);
/// let off = judge([3.0, 1e-20]);
/// assert!(off.has("off-segment") && off.faults[0].to_string().contains("1e-20 off segment 0"));
/// ```
#[must_use]
pub fn judge_conforming_doubles(
    complex: &Complex<'_, 2>,
    points: usize,
    segments: &[[u32; 2]],
    constrained: Option<&[[u32; 2]]>,
    options: &Options,
) -> Verdict {
    let claim = Claim { points, segments, constrained };
    match options.backend {
        Backend::Pure => judge::<Pure>(complex, &claim, options),
        #[cfg(feature = "rug")]
        Backend::Gmp => judge::<crate::exact::Gmp>(complex, &claim, options),
    }
}

struct Claim<'a> {
    points: usize,
    segments: &'a [[u32; 2]],
    constrained: Option<&'a [[u32; 2]]>,
}

fn judge<I: Integer>(complex: &Complex<'_, 2>, claim: &Claim<'_>, options: &Options) -> Verdict {
    let mut report = Report::new(options.faults_max);
    let Some(t) = Triangulation::<2, I>::read(complex, options, &mut report) else {
        return report.verdict();
    };
    let facets = facets_of(&t);
    check_triangulation(&t, &facets, &mut report);
    let tiles = report.is_clean();
    check_chains(&t, &mut Edges::of(&t, &facets), claim, &mut report);
    let keeps = report.is_clean();
    report.check_given(tiles, "D2: locally delaunay across every edge", |report| {
        if t.dimension > 0 {
            check_local(&t, &facets, |_| false, options.ties, report);
        }
    });
    if tiles && report.count("not-delaunay") == 0 {
        let strict = options.ties == Ties::Strict && report.count("wrong-tie") == 0;
        report.reached(match (keeps, strict) {
            (true, true) => Level::Conforming,
            (true, false) => Level::WeaklyConforming,
            (false, true) => Level::Delaunay,
            (false, false) => Level::WeaklyDelaunay,
        });
    }
    report.verdict()
}

/// S5, K2, K3.
fn check_chains<I: Integer>(
    t: &Triangulation<'_, 2, I>,
    edges: &mut Edges,
    claim: &Claim<'_>,
    report: &mut Report,
) {
    let tiles = report.is_clean();
    let flagged = claim.constrained.unwrap_or(&[]).iter();
    let flagged: BTreeSet<[u32; 2]> = flagged.map(|&[a, b]| [a.min(b), a.max(b)]).collect();
    let (mut covered, mut beside) = (Vec::new(), Vec::new());
    let leads = "S5: edges lead from end to end of each segment, in line or flagged";
    let whole = report.check_given(tiles, leads, |report| {
        covered = cover(t, edges, claim.segments, report, |edges, segment, [at, end]| {
            let path = Path { t, flagged: &flagged, points: claim.points, end };
            let vertices = path.from(edges, at)?;
            let ends = claim.segments[segment].map(|v| t.representative[v as usize]);
            beside.extend(vertices.iter().filter_map(|&v| {
                let distance = distance(t, v, ends)?;
                let ends = witnesses(t.space.points, &claim.segments[segment]);
                let point = witness(t.space.points, v);
                Some(Fault::BesideSegment { segment, ends, point, distance })
            }));
            Some(vertices)
        });
    });
    let in_line = "K2, K4: every segment is an exactly collinear chain of edges";
    report.check_given(whole, in_line, |report| {
        beside.into_iter().for_each(|fault| report.fault(fault));
    });
    if let Some(flags) = claim.constrained {
        let claim = "K3: the flagged edges are those of the segments";
        report.check_given(whole, claim, |report| {
            check_flags(t.space.points, edges, &covered, flags, report);
        });
    }
}

/// Flagged edges towards the end of a segment.
struct Path<'a, I> {
    t: &'a Triangulation<'a, 2, I>,
    flagged: &'a BTreeSet<[u32; 2]>,
    points: usize,
    end: u32,
}

impl<I: Integer> Path<'_, I> {
    /// The vertices after a point of the segment, up to its end; none if no flagged edge leads on somewhere.
    fn from(&self, edges: &Edges, start: u32) -> Option<Vec<u32>> {
        let mut vertices = vec![start];
        let mut at = start;
        while at != self.end {
            assert!(vertices.len() <= self.t.space.points.len(), "each step is nearer to the end");
            at = self.next(edges, start, at)?;
            vertices.push(at);
        }
        vertices.remove(0);
        Some(vertices)
    }

    /// The neighbour by a flagged edge that is further on and not beyond the end: that of the least turn. An input point that is not in
    /// line belongs to other segments.
    fn next(&self, edges: &Edges, start: u32, at: u32) -> Option<u32> {
        // A step across the segment and along it.
        let step = |from: u32, to: u32| {
            let [[c, d], [cross, dot]] =
                [from, to].map(|v| self.t.space.products(start, self.end, v).0);
            [cross.minus(&c), dot.minus(&d)]
        };
        let is_onwards = |from: u32, to: u32| step(from, to)[1].exact_sign() == Sign::Positive;
        let is_in_line = |w: u32| step(start, w)[0].exact_sign() == Sign::Zero;
        let leads_on = |w: &u32| {
            self.flagged.contains(&[at.min(*w), at.max(*w)])
                && is_onwards(at, *w)
                && (*w == self.end || is_onwards(*w, self.end))
                && (*w as usize >= self.points || is_in_line(*w))
        };
        let turns_less = |w: u32, than: u32| {
            let ([c, d], [cross, dot]) = (step(at, w), step(at, than));
            let of_squares = c.times(&c).times(&dot.times(&dot));
            of_squares.minus(&cross.times(&cross).times(&d.times(&d))).exact_sign()
                == Sign::Negative
        };
        let candidates = edges.around(at).iter().copied().filter(leads_on);
        candidates.reduce(|u, w| if turns_less(w, u) { w } else { u })
    }
}

/// The distance of a vertex from the line through two others, if it is not on it: the least double there is, if it is less.
fn distance<I: Integer>(t: &Triangulation<'_, 2, I>, v: u32, [a, b]: [u32; 2]) -> Option<f64> {
    let ([cross, _], low) = t.space.products(a, b, v);
    let ([_, square], _) = t.space.products(a, b, b);
    if cross.exact_sign() == Sign::Zero {
        return None;
    }
    // cross / sqrt(square), in units of 2^low; each is a double times a power of two, that of the square an even one.
    let ((cross, times), (square, twice)) = (cross.magnitude(), square.magnitude());
    let root = (square * f64::from(1 + twice % 2)).sqrt();
    let mut exponent = low.saturating_add_unsigned(times).saturating_sub_unsigned(twice / 2);
    let mut distance = cross / root;
    while exponent != 0 {
        let step = exponent.clamp(-512, 512);
        distance *= 2f64.powi(step);
        exponent -= step;
    }
    Some(distance.max(f64::from_bits(1)))
}

#[cfg(test)]
mod tests;
