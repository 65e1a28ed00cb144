//! The judge of regular triangulations: points with weights, of which some are hidden.
//!
//! **Claim.** The vertices are judged like those of a Delaunay triangulation, with heights
//! `|p|^2 - w`: if they tile their hull, and no facet is in conflict, the lifted cells are their
//! lower hull. What is no vertex must be hidden: in that hull, and in conflict with no cell, so that
//! its lifted point is not below any hyperplane of the lower hull. Then it changes nothing.
//! **Cost.** That of Delaunay, and one sign for each cell and each hidden point.

use crate::cells::{Complex, Triangulation};
use crate::exact::{Integer, Pure, Sign};
use crate::facets::Facets;
use crate::fault::Fault;
use crate::local::check_local;
use crate::options::{Backend, Options, Ties};
use crate::sites::{witness, witnesses};
use crate::space::Place;
use crate::triangulation::{check_triangulation, facets_of};
use crate::verdict::{Level, Report, Verdict};

/// Judges whether the complex is the regular triangulation of its points with these weights, one for
/// each. Points that are no vertices must be hidden; of equal points only a heaviest may be a vertex.
///
/// ```
/// use delone_check::{Complex, Level, Options, judge_regular};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0]];
/// let complex = Complex { points: &points, dimension: Some(2), cells: &[0, 1, 2] };
/// let verdict = judge_regular(&complex, &[0.0, 0.0, 0.0, -9.0], &Options::default());
/// assert!(verdict.ok && verdict.level == Level::Regular, "{verdict}");
/// assert!(judge_regular(&complex, &[0.0; 4], &Options::default()).has("not-hidden"));
/// ```
#[must_use]
pub fn judge_regular<const D: usize>(
    complex: &Complex<'_, D>,
    weights: &[f64],
    options: &Options,
) -> Verdict {
    match options.backend {
        Backend::Pure => judge::<D, Pure>(complex, weights, options),
        #[cfg(feature = "rug")]
        Backend::Gmp => judge::<D, crate::exact::Gmp>(complex, weights, options),
    }
}

fn judge<const D: usize, I: Integer>(
    complex: &Complex<'_, D>,
    weights: &[f64],
    options: &Options,
) -> Verdict {
    let mut report = Report::new(options.faults_max);
    let Some(t) = Triangulation::<D, I>::read_weighted(complex, weights, options, &mut report)
    else {
        return report.verdict();
    };
    let facets = facets_of(&t);
    check_triangulation(&t, &facets, &mut report);
    let tiles = report.is_clean();
    report.check_given(tiles, "D2: locally regular across every facet", |report| {
        if t.dimension > 0 {
            check_local(&t, &facets, |_| false, options.ties, report);
        }
    });
    report.check_given(tiles, "H1: what is no vertex is in the hull", |report| {
        check_in_hull(&t, &facets, report);
    });
    report.check_given(tiles, "H2: what is no vertex is in conflict with no cell", |report| {
        check_hidden(&t, options.ties, report);
    });
    let faults = ["not-delaunay", "not-hidden", "beyond-hull"];
    if tiles && faults.iter().all(|kind| report.count(kind) == 0) {
        let strict = options.ties == Ties::Strict && report.count("wrong-tie") == 0;
        report.reached(if strict { Level::Regular } else { Level::WeaklyRegular });
    }
    report.verdict()
}

/// The points that are no vertices.
fn unused<const D: usize, I: Integer>(t: &Triangulation<'_, D, I>) -> Vec<u32> {
    let mut used = vec![false; t.space.points.len()];
    for &v in &t.cells {
        if let Some(mark) = used.get_mut(v as usize) {
            *mark = true;
        }
    }
    (0u32..).zip(used).filter(|&(_, used)| !used).map(|(id, _)| id).collect()
}

/// H1: no hidden point is strictly beyond a facet of the boundary.
fn check_in_hull<const D: usize, I: Integer>(
    t: &Triangulation<'_, D, I>,
    facets: &Facets<'_>,
    report: &mut Report,
) {
    let hidden = unused(t);
    let boundary = facets.groups().filter(|group| group.len() == 1).map(|group| group[0]);
    for facet in boundary.filter(|_| t.dimension > 0) {
        let Some(sign) = t.signs[facets.cell_number(&facet)] else { continue };
        let apex = facets.apex(&facet);
        for &q in &hidden {
            let moved: Vec<u32> =
                facets.cell(&facet).iter().map(|&v| if v == apex { q } else { v }).collect();
            if t.space.orient(&moved).times(sign) == Sign::Negative {
                let facet = witnesses(t.space.points, &facets.vertices(&facet));
                report.fault(Fault::BeyondHull { point: witness(t.space.points, q), facet });
            }
        }
    }
}

/// H2: each hidden point against each cell.
fn check_hidden<const D: usize, I: Integer>(
    t: &Triangulation<'_, D, I>,
    ties: Ties,
    report: &mut Report,
) {
    for q in unused(t) {
        for (cell, &sign) in t.signs.iter().enumerate() {
            let (Some(sign), corners) = (sign.filter(|&s| s != Sign::Zero), t.cell(cell)) else {
                continue; // told by T1 or T2
            };
            let witnesses = || witnesses(t.space.points, corners);
            let inside = || witness(t.space.points, q);
            match t.space.in_sphere(corners, sign, q) {
                Place::Outside => {}
                Place::Inside => {
                    report.fault(Fault::NotHidden { point: inside(), cell: witnesses() });
                }
                Place::On { perturbed_inside } => {
                    report.tie();
                    if perturbed_inside && ties == Ties::Strict {
                        report.fault(Fault::WrongTie { cell: witnesses(), inside: inside() });
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
