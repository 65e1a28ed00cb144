//! The judge of constrained Delaunay triangulations with crossings as vertices, in ratios of its own.
//!
//! **In.** Points; for each further vertex the four points whose two lines define it; cells over both; the input segments.
//! **Method.** A vertex is `(x : y : w)` in big integers, `w > 0`. A1: vertices are defined and distinct. A2: cells are
//! positive. A3: each edge has one cell on either side, or is on the boundary. A4: the boundary is one convex polygon, wound
//! once; with A2 and A3 the cells tile it (the degree of the covering is one everywhere). A5: every vertex is used, so the
//! polygon is their hull. A6: each segment is a chain of edges, exactly in line, and the flagged edges are those. A7: each
//! vertex that is no point is where chains cross: four flagged edges or more meet there. A8: across each edge on no segment,
//! locally Delaunay, ties by the perturbation.
//! **Cost.** Sorting, and some signs of big integers for each edge; no filters.

use crate::exact::lattice::Span;
use crate::exact::{Integer, Lattice, Number, Pure, Sign};
use crate::fault::Fault;
use crate::options::{Options, Ties};
use crate::scene::{Ratio, Scene};
use crate::verdict::{Level, Report, Verdict};
use std::collections::BTreeSet;

/// A triangulation over points and crossings, as plain data.
#[derive(Clone, Copy, Debug)]
pub struct Arranged<'a> {
    /// The points: vertices 0, 1, ..
    pub points: &'a [[f64; 2]],
    /// The vertices after them: the crossing of the line of the first two points with that of the last two.
    pub crossings: &'a [[u32; 4]],
    /// Three vertices for each cell, counter-clockwise.
    pub cells: &'a [u32],
    /// The input segments between points; they may cross, overlap and repeat.
    pub segments: &'a [[u32; 2]],
    /// The edges flagged as constrained.
    pub constrained: &'a [[u32; 2]],
}

/// Judges whether the cells are the constrained Delaunay triangulation of the arrangement of the segments.
///
/// ```
/// use delone_check::{Arranged, Level, Options, judge_arranged};
///
/// let points = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]];
/// let verdict = judge_arranged(
///     &Arranged {
///         points: &points,
///         crossings: &[[0, 2, 1, 3]],
///         cells: &[0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4],
///         segments: &[[0, 2], [1, 3]],
///         constrained: &[[0, 4], [1, 4], [2, 4], [3, 4]],
///     },
///     &Options::default(),
/// );
/// assert!(verdict.ok && verdict.level == Level::Constrained, "{verdict}");
/// ```
#[must_use]
pub fn judge_arranged(arranged: &Arranged<'_>, options: &Options) -> Verdict {
    let mut report = Report::new(options.faults_max);
    let Some(scene) = read(arranged, &mut report) else { return report.verdict() };
    let edges = scene.edges(&mut report);
    scene.check_boundary(&edges, &mut report);
    scene.check_used(&mut report);
    let tiles = report.is_clean();
    let covered = scene.check_chains(&edges, &mut report);
    check_crossed(&scene, &covered, &mut report);
    let keeps = report.is_clean();
    let claim = "A8: locally delaunay across every edge on no segment";
    scene.check_local(&edges, claim, &covered, options.ties, &mut report);
    if tiles && report.is_clean() {
        let strict = options.ties == Ties::Strict;
        report.reached(if strict { Level::Constrained } else { Level::WeaklyConstrained });
    } else if tiles && !keeps {
        report.reached(Level::Triangulation);
    }
    report.verdict()
}

fn read<'a>(arranged: &Arranged<'a>, report: &mut Report) -> Option<Scene<'a>> {
    if !crate::sites::check_finite(arranged.points, report) {
        return None;
    }
    let points = arranged.points.len();
    let mut scene = Scene {
        points: arranged.points,
        at: points_of(arranged.points),
        cells: arranged.cells,
        segments: arranged.segments,
        constrained: arranged.constrained,
    };
    if !scene.check_ids(points + arranged.crossings.len(), report) {
        return None;
    }
    let lines = arranged.crossings.as_flattened();
    if let Some(&id) = lines.iter().find(|&&id| (id as usize) >= points) {
        let expected = format!("ids of points, which are below {points}, but there is {id}");
        report.fault(Fault::BadLength { array: "crossings", length: lines.len(), expected });
        return None;
    }
    for ids in arranged.crossings {
        let [a, b, c, d] = ids.map(|id| scene.at[id as usize].clone());
        scene.at.push(crossing([&a, &b, &c, &d]));
    }
    let defined = report.check("A1: vertices are defined, and distinct where used", |report| {
        scene.check_distinct(report);
    });
    defined.then_some(scene)
}

/// The exponent of the unit of a lattice that has all these points.
pub(crate) fn unit_of(points: &[[f64; 2]]) -> i32 {
    Span::of(points.iter().flatten().copied()).map_or(0, |span| span.low)
}

/// Points as ratios, on one lattice.
pub(crate) fn points_of(points: &[[f64; 2]]) -> Vec<Ratio> {
    let lattice: Lattice<Pure> = Lattice::new(unit_of(points));
    let ratio = |p: &[f64; 2]| {
        let [x, y] = p.map(|x| lattice.integer(x));
        [x, y, Pure::shifted(1, 0)]
    };
    points.iter().map(ratio).collect()
}

/// A7.
fn check_crossed(scene: &Scene<'_>, covered: &BTreeSet<[u32; 2]>, report: &mut Report) {
    report.check("A7: segments cross at every vertex that is no point", |report| {
        let mut degrees = vec![0; scene.at.len()];
        covered.iter().flatten().for_each(|&v| degrees[v as usize] += 1);
        for v in (0u32..).take(scene.at.len()).skip(scene.points.len()) {
            if degrees[v as usize] < 4 {
                report.fault(Fault::UnusedPoint { point: scene.witness(v) });
            }
        }
    });
}

/// The crossing of the lines through two points each; `w = 0` if they are parallel.
fn crossing([a, b, c, d]: [&Ratio; 4]) -> Ratio {
    let line = |p: &Ratio, q: &Ratio| {
        [[1, 2], [2, 0], [0, 1]].map(|[i, j]| p[i].times(&q[j]).minus(&p[j].times(&q[i])))
    };
    let [x, y, w] = line(&line(a, b), &line(c, d));
    if w.exact_sign() == Sign::Negative {
        let zero = Pure::shifted(0, 0);
        [x, y, w].map(|value| zero.minus(&value))
    } else {
        [x, y, w]
    }
}

#[cfg(test)]
mod tests;
