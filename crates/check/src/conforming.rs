//! The judge of triangulations with Steiner points, in ratios of its own.
//!
//! **In.** Points; further vertices, each either a point on a segment between two points, by an exact parameter, or a free point;
//! cells over all of them; the input segments.
//! **Method.** A1 to A6 as in [`crate::judge_arranged`]: the cells tile the hull, and each segment is a chain of edges, exactly in
//! line: their union is the segment. S1: parameters are strictly between 0 and 1. S2: each vertex that is said to be on a segment
//! is inside a chain. S3: locally Delaunay across every edge, segments too, ties by the perturbation: on a tiling of the
//! hull this is the Delaunay triangulation. S4: the closed diametral disks of subsegments hold no apex of a cell beside
//! them, and so, in a Delaunay triangulation, no other vertex.
//! **Cost.** Sorting, and some signs of big integers for each edge; no filters.

use crate::arranged::{points_of, unit_of};
use crate::exact::{Integer, Number, Pure, Sign};
use crate::fault::Fault;
use crate::options::{Options, Ties};
use crate::scene::{Ratio, Scene, Sides};
use crate::verdict::{Level, Report, Verdict};
use std::collections::BTreeSet;

mod angles;
mod doubles;

pub use angles::{Angles, judge_refined};
pub use doubles::judge_conforming_doubles;

/// A number in binary digits, `mantissa 2^exponent` or its opposite.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Binary<'a> {
    /// The digits of the magnitude, least significant limb first.
    pub mantissa: &'a [u64],
    /// The exponent of their unit.
    pub exponent: i64,
    /// Whether it is below zero.
    pub negative: bool,
}

/// A vertex that was added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SteinerPoint<'a> {
    /// `a + t (b - a)`, where a and b are the points `ends`.
    On {
        /// The two points.
        ends: [u32; 2],
        /// The parameter.
        t: Binary<'a>,
    },
    /// A point in doubles.
    At([f64; 2]),
    /// A point in numbers of any length.
    Exactly([Binary<'a>; 2]),
}

/// What a triangulation with Steiner points is said to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Promise {
    /// Delaunay up to the visibility that segments block.
    Constrained,
    /// Delaunay, each segment a chain of edges.
    Conforming,
    /// The same, the closed diametral disk of each subsegment being empty.
    EmptyDisks,
}

/// A triangulation over points and Steiner points, as plain data.
#[derive(Clone, Copy, Debug)]
pub struct Conformed<'a> {
    /// The points: vertices 0, 1, ..
    pub points: &'a [[f64; 2]],
    /// The vertices after them.
    pub steiner: &'a [SteinerPoint<'a>],
    /// Three vertices for each cell, counter-clockwise.
    pub cells: &'a [u32],
    /// The input segments between points; they may overlap and repeat.
    pub segments: &'a [[u32; 2]],
    /// The edges flagged as constrained.
    pub constrained: &'a [[u32; 2]],
    /// What it is said to be.
    pub promise: Promise,
}

/// The most binary digits of a number that are looked at.
const DIGITS_MAX: u64 = 1 << 20;

/// Judges whether the cells are the triangulation that is promised.
///
/// ```
/// use delone_check::{Binary, Conformed, Level, Options, Promise, SteinerPoint, judge_conforming};
///
/// let verdict = judge_conforming(
///     &Conformed {
///         points: &[[0.0, 0.0], [3.0, 1.0], [6.0, 0.0], [3.0, -1.0]],
///         steiner: &[SteinerPoint::On { ends: [0, 2], t: Binary { mantissa: &[1], exponent: -1, negative: false } }],
///         cells: &[0, 4, 1, 4, 2, 1, 0, 3, 4, 4, 3, 2],
///         segments: &[[0, 2]],
///         constrained: &[[0, 4], [2, 4]],
///         promise: Promise::EmptyDisks,
///     },
///     &Options::default(),
/// );
/// assert!(verdict.ok && verdict.level == Level::Conforming, "{verdict}");
/// ```
#[must_use]
pub fn judge_conforming(conformed: &Conformed<'_>, options: &Options) -> Verdict {
    judge(conformed, options, |_, _, _| {})
}

/// Judges, and asks what is `more`, of the triangulation and its edges on segments.
fn judge(
    conformed: &Conformed<'_>,
    options: &Options,
    more: impl FnOnce(&Scene<'_>, &BTreeSet<[u32; 2]>, &mut Report),
) -> Verdict {
    let mut report = Report::new(options.faults_max);
    let Some(scene) = read(conformed, &mut report) else { return report.verdict() };
    let edges = scene.edges(&mut report);
    scene.check_boundary(&edges, &mut report);
    scene.check_used(&mut report);
    let tiles = report.is_clean();
    let covered = scene.check_chains(&edges, &mut report);
    check_on_chains(&scene, conformed.steiner, &covered, &mut report);
    let keeps = report.is_clean();
    if conformed.promise == Promise::Constrained {
        let claim = "A8: locally delaunay across every edge on no segment";
        scene.check_local(&edges, claim, &covered, options.ties, &mut report);
    } else {
        let claim = "S3: locally delaunay across every edge";
        scene.check_local(&edges, claim, &BTreeSet::new(), options.ties, &mut report);
    }
    if conformed.promise == Promise::EmptyDisks {
        check_disks(&scene, &edges, &covered, &mut report);
    }
    more(&scene, &covered, &mut report);
    if tiles && report.is_clean() {
        let strict = options.ties == Ties::Strict;
        report.reached(match (conformed.promise, strict) {
            (Promise::Constrained, true) => Level::Constrained,
            (Promise::Constrained, false) => Level::WeaklyConstrained,
            (_, true) => Level::Conforming,
            (_, false) => Level::WeaklyConforming,
        });
    } else if tiles && !keeps {
        report.reached(Level::Triangulation);
    }
    report.verdict()
}

fn read<'a>(conformed: &Conformed<'a>, report: &mut Report) -> Option<Scene<'a>> {
    let count = conformed.points.len();
    let free = conformed.steiner.iter().map(|steiner| match *steiner {
        SteinerPoint::At(point) => point,
        SteinerPoint::On { .. } | SteinerPoint::Exactly(_) => [0.0; 2],
    });
    let plain: Vec<[f64; 2]> = conformed.points.iter().copied().chain(free).collect();
    if !crate::sites::check_finite(&plain, report) {
        return None;
    }
    let mut scene = Scene {
        points: conformed.points,
        at: points_of(&plain),
        cells: conformed.cells,
        segments: conformed.segments,
        constrained: conformed.constrained,
    };
    if !scene.check_ids(plain.len(), report) {
        return None;
    }
    let unit = unit_of(&plain);
    let sound = report.check("S1: parameters are strictly between 0 and 1", |report| {
        for (v, steiner) in (0u32..).skip(count).zip(conformed.steiner) {
            let place = match *steiner {
                SteinerPoint::At(_) => continue,
                SteinerPoint::On { ends, t } => on_segment(&scene, ends, t),
                SteinerPoint::Exactly(numbers) => exactly(numbers, unit),
            };
            match (place, steiner) {
                (Some(place), _) => scene.at[v as usize] = place,
                (None, SteinerPoint::On { ends, .. }) => {
                    let ends = scene.witnesses(ends);
                    report.fault(Fault::OffSegment { point: v, ends });
                }
                // Of more digits than are looked at.
                (None, _) => report.fault(Fault::NotFinite { point: scene.witness(v) }),
            }
        }
    });
    let defined = sound
        && report.check("A1: vertices are defined, and distinct where used", |report| {
            scene.check_distinct(report);
        });
    defined.then_some(scene)
}

/// The point of a segment between two of the points, if its parameter is strictly between 0 and 1.
fn on_segment(scene: &Scene<'_>, ends: [u32; 2], t: Binary<'_>) -> Option<Ratio> {
    if ends.iter().any(|&end| end as usize >= scene.points.len()) {
        return None;
    }
    let [numerator, denominator] = ratio(t)?;
    let inside = numerator.exact_sign() == Sign::Positive
        && denominator.minus(&numerator).exact_sign() == Sign::Positive;
    let [a, b] = ends.map(|end| &scene.at[end as usize]);
    inside.then(|| between(a, b, &[numerator, denominator]))
}

/// A point on the lattice of that unit, or between its points.
fn exactly([x, y]: [Binary<'_>; 2], unit: i32) -> Option<Ratio> {
    let over_unit = |x: Binary<'_>| {
        let exponent = x.exponent.checked_sub(unit.into())?;
        ratio(Binary { exponent, ..x })
    };
    let ([x, of_x], [y, of_y]) = (over_unit(x)?, over_unit(y)?);
    Some([x.times(&of_y), y.times(&of_x), of_x.times(&of_y)])
}

/// A number as a ratio, the denominator a power of two; `None` if it has too many digits.
fn ratio(Binary { mantissa, exponent, negative }: Binary<'_>) -> Option<[Pure; 2]> {
    let digits = u32::try_from(exponent.unsigned_abs()).ok();
    let digits = digits.filter(|&digits| u64::from(digits) <= DIGITS_MAX)?;
    if mantissa.len() as u64 > DIGITS_MAX / 64 + 1 {
        return None;
    }
    let [above, below] = if exponent < 0 { [0, digits] } else { [digits, 0] };
    let halves = mantissa.iter().flat_map(|&limb| [limb & 0xffff_ffff, limb >> 32]);
    let zero = || Pure::shifted(0, 0);
    let magnitude = (0u32..).zip(halves).fold(zero(), |sum, (place, half)| {
        sum.plus(&Pure::shifted(half.cast_signed(), 32 * place + above))
    });
    let numerator = if negative { zero().minus(&magnitude) } else { magnitude };
    Some([numerator, Pure::shifted(1, below)])
}

/// `a + t (b - a)` for points of the lattice.
fn between(a: &Ratio, b: &Ratio, [numerator, denominator]: &[Pure; 2]) -> Ratio {
    let [x, y] = [0, 1].map(|axis| {
        let step = b[axis].minus(&a[axis]);
        a[axis].times(denominator).plus(&step.times(numerator))
    });
    [x, y, denominator.clone()]
}

/// S2: a vertex that is on a segment is inside a chain of edges, and so has two of them.
fn check_on_chains(
    scene: &Scene<'_>,
    steiner: &[SteinerPoint<'_>],
    covered: &BTreeSet<[u32; 2]>,
    report: &mut Report,
) {
    report.check("S2: what is said to be on a segment is inside a chain of edges", |report| {
        let mut degrees = vec![0; scene.at.len()];
        covered.iter().flatten().for_each(|&v| degrees[v as usize] += 1);
        for (v, steiner) in (0u32..).skip(scene.points.len()).zip(steiner) {
            if let SteinerPoint::On { ends, .. } = steiner
                && degrees[v as usize] != 2
            {
                let ends = scene.witnesses(ends);
                report.fault(Fault::OffSegment { point: v, ends });
            }
        }
    });
}

/// S4.
fn check_disks(
    scene: &Scene<'_>,
    sides: &Sides,
    covered: &BTreeSet<[u32; 2]>,
    report: &mut Report,
) {
    report.check("S4: the closed diametral disks of subsegments are empty", |report| {
        for edge in covered {
            for v in sides.get(edge).into_iter().flatten().copied().flatten() {
                if scene.dot(v, *edge) != Sign::Positive {
                    let edge = scene.witnesses(edge);
                    report.fault(Fault::EncroachedEdge { edge, by: scene.witness(v) });
                }
            }
        }
    });
}

#[cfg(test)]
mod tests;
