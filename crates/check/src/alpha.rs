//! The judge of alpha filtrations: every simplex with its squared radius.
//!
//! **Claim.** The simplices of the highest dimension are judged as a Delaunay triangulation or, with weights, a regular one; the others
//! must be their faces, each once. The value of a simplex is, by definition, the least squared radius of the smallest spheres
//! (orthogonal ones, with weights) of itself and of all simplices of the triangulation that have it, among the spheres with no
//! vertex inside: those are the centres where the power to the simplex is least. In a triangulation that was proved, the vertices of a
//! simplex's own cells bound its Voronoi face, and no others have to be looked at.
//! **Values.** As text: all as doubles, which must be the nearest to the value (of two, either); or, if any has a `/`, all as fractions,
//! which must be equal to it. A value too large for doubles can only be told as a fraction.
//! **Cost.** For N simplices of dimension d, some 2^d N determinants in big integers. No rank, order or attachment is used.

mod radius;

use std::collections::{BTreeMap, BTreeSet};

use crate::cells::Complex;
use crate::delaunay::judge_delaunay;
use crate::fault::Fault;
use crate::options::Options;
use crate::regular::judge_regular;
use crate::sites::witnesses;
use crate::verdict::{Level, Report, Verdict};
use radius::{Claimed, Integers, Radius};

/// Judges whether these simplices, each with its squared radius as text, are the alpha filtration of the points, with weights if there
/// are any.
///
/// ```
/// use delone_check::{Level, Options, judge_alpha};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]];
/// let simplices = [vec![0], vec![1], vec![2], vec![0, 1], vec![0, 2], vec![1, 2], vec![0, 1, 2]];
/// let right = ["0", "0", "0", "4", "2.25", "6.25", "6.25"];
/// let claim = |values: [&str; 7]| simplices.clone().into_iter().zip(values.map(String::from)).collect::<Vec<_>>();
/// let verdict = judge_alpha(&points, None, &claim(right), &Options::foreign());
/// assert!(verdict.ok && verdict.level == Level::AlphaFiltration, "{verdict}");
/// let wrong = ["0", "0", "0", "4", "2.25", "6", "6.25"];
/// assert!(judge_alpha(&points, None, &claim(wrong), &Options::foreign()).has("wrong-value"));
/// ```
#[must_use]
pub fn judge_alpha<const D: usize>(
    points: &[[f64; D]],
    weights: Option<&[f64]>,
    claim: &[(Vec<u32>, String)],
    options: &Options,
) -> Verdict {
    let width = claim.iter().map(|(vertices, _)| vertices.len()).max().unwrap_or(0);
    let top = claim.iter().filter(|(vertices, _)| vertices.len() == width);
    let cells: Vec<u32> = top.flat_map(|(vertices, _)| vertices.iter().copied()).collect();
    let complex = Complex { points, dimension: width.checked_sub(1), cells: &cells };
    let verdict = match weights {
        None => judge_delaunay(&complex, options),
        Some(weights) => judge_regular(&complex, weights, options),
    };
    let is_proved = verdict.ok;
    let mut report = Report::resumed(verdict, options.faults_max);
    if !is_proved {
        return report.verdict(); // nothing has a value
    }
    let cells = cells.chunks_exact(width.max(1));
    let around = around(cells);
    let of_faces = report.check("A1: the faces of the cells, each once", |report| {
        check_faces(points, claim, &around, report);
    });
    let of_values = report.check("A2: every value is that of the definition", |report| {
        check_values(points, &values(points, weights, &around), claim, report);
    });
    if of_faces && of_values {
        report.reached(Level::AlphaFiltration);
    }
    report.verdict()
}

/// Each simplex, by its sorted vertices, with the vertices of its cells.
type Around = BTreeMap<Vec<u32>, BTreeSet<u32>>;

fn around<'c>(cells: impl Iterator<Item = &'c [u32]>) -> Around {
    let mut around = Around::new();
    for cell in cells {
        for face in faces(cell) {
            around.entry(face).or_default().extend(cell);
        }
    }
    around
}

/// All faces of a simplex, itself too, by sorted vertices.
fn faces(simplex: &[u32]) -> impl Iterator<Item = Vec<u32>> {
    let mut sorted = simplex.to_vec();
    sorted.sort_unstable();
    (1u32..1 << sorted.len()).map(move |set| {
        let members = (0u32..).zip(&sorted).filter(|&(i, _)| set >> i & 1 == 1);
        members.map(|(_, &v)| v).collect()
    })
}

/// A1.
fn check_faces<const D: usize>(
    points: &[[f64; D]],
    claim: &[(Vec<u32>, String)],
    around: &Around,
    report: &mut Report,
) {
    let mut told = BTreeSet::new();
    for (vertices, _) in claim {
        let mut sorted = vertices.clone();
        sorted.sort_unstable();
        if !around.contains_key(&sorted) || !told.insert(sorted) {
            report.fault(Fault::ExtraSimplex { simplex: witnesses(points, vertices) });
        }
    }
    for simplex in around.keys().filter(|simplex| !told.contains(*simplex)) {
        report.fault(Fault::MissingSimplex { simplex: witnesses(points, simplex) });
    }
}

/// The value of each simplex: the least radius, among itself and those that have it, of the spheres with no vertex inside.
fn values<const D: usize>(
    points: &[[f64; D]],
    weights: Option<&[f64]>,
    around: &Around,
) -> BTreeMap<Vec<u32>, Radius> {
    let integers = Integers::new(points, weights);
    let mut values: BTreeMap<Vec<u32>, Radius> = BTreeMap::new();
    for (simplex, near) in around {
        let mut others = near.iter().filter(|&v| !simplex.contains(v));
        if others.any(|&v| integers.is_inside(simplex, v)) {
            continue;
        }
        let radius = integers.radius(simplex);
        for face in faces(simplex) {
            match values.get_mut(&face) {
                Some(least) if *least <= radius => {}
                Some(least) => *least = radius.clone(),
                None => drop(values.insert(face, radius.clone())),
            }
        }
    }
    values
}

/// A2. What is no face has no value, and was told by A1.
fn check_values<const D: usize>(
    points: &[[f64; D]],
    values: &BTreeMap<Vec<u32>, Radius>,
    claim: &[(Vec<u32>, String)],
    report: &mut Report,
) {
    let are_fractions = claim.iter().any(|(_, value)| value.contains('/'));
    for (vertices, text) in claim {
        let mut sorted = vertices.clone();
        sorted.sort_unstable();
        let Some(value) = values.get(&sorted) else { continue };
        let claimed = Claimed::read(text, are_fractions);
        if !claimed.is_some_and(|claimed| claimed.tells(value)) {
            let simplex = witnesses(points, vertices);
            report.fault(Fault::WrongValue {
                simplex,
                claimed: text.clone(),
                value: value.to_string(),
            });
        }
    }
}

#[cfg(test)]
mod tests;
