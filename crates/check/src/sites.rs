//! The points themselves: finite, used, and distinct where used (T8).
//!
//! **Out.** For every point the id of a used point equal to it, if any; else of the least point
//! equal to it. **Cost.** One sort of the points by coordinates.

use crate::fault::{Fault, Simplex, Witness};
use crate::space::lexicographic;
use crate::verdict::Report;

/// A point as a witness. `id` must be in range.
pub(crate) fn witness<const D: usize>(points: &[[f64; D]], id: u32) -> Witness {
    let at = points.get(id as usize).map(|p| p.to_vec()).unwrap_or_default();
    Witness { id, at }
}

/// A simplex as a witness.
pub(crate) fn witnesses<const D: usize>(points: &[[f64; D]], ids: &[u32]) -> Simplex {
    ids.iter().map(|&id| witness(points, id)).collect()
}

/// Reports coordinates that are NaN or infinite; whether there are none.
pub(crate) fn check_finite<const D: usize>(points: &[[f64; D]], report: &mut Report) -> bool {
    report.check("coordinates are finite", |report| {
        for (id, p) in (0u32..).zip(points) {
            if p.iter().any(|x| !x.is_finite()) {
                report.fault(Fault::NotFinite { point: witness(points, id) });
            }
        }
    })
}

/// Reports weights that are NaN or infinite, or not one for each point; whether there are none.
pub(crate) fn check_weights<const D: usize>(
    points: &[[f64; D]],
    weights: Option<&[f64]>,
    report: &mut Report,
) -> bool {
    let Some(weights) = weights else { return true };
    report.check("there is a finite weight for each point", |report| {
        if weights.len() != points.len() {
            let expected = points.len().to_string();
            report.fault(Fault::BadLength { array: "weights", length: weights.len(), expected });
        }
        for (id, &weight) in (0u32..).zip(weights).take(points.len()) {
            if !weight.is_finite() {
                report.fault(Fault::WeightNotFinite { point: witness(points, id), weight });
            }
        }
    })
}

/// What it means that a point is not used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unused {
    /// A fault, unless it equals one that is.
    Fault,
    /// That it is hidden, which is to be proved elsewhere.
    Hidden,
}

/// T8: every point is used or equals a used point, and no two used points are equal. Returns the
/// representatives.
pub(crate) fn check_used<const D: usize>(
    points: &[[f64; D]],
    vertices: &[u32],
    unused: Unused,
    report: &mut Report,
) -> Vec<u32> {
    let mut used = vec![false; points.len()];
    for &v in vertices {
        if let Some(mark) = used.get_mut(v as usize) {
            *mark = true;
        }
    }
    let mut order: Vec<u32> = (0u32..).zip(points).map(|(id, _)| id).collect();
    let at = |id: u32| &points[id as usize];
    order.sort_unstable_by(|&u, &v| lexicographic(at(u), at(v)).then(u.cmp(&v)));
    let mut representative = vec![0; points.len()];
    let claim = match unused {
        Unused::Fault => "T8: every point is a vertex or equals one; vertices are distinct points",
        Unused::Hidden => "T8: vertices are distinct points",
    };
    report.check(claim, |report| {
        for equal in order.chunk_by(|&u, &v| at(u) == at(v)) {
            let mut among = equal.iter().copied().filter(|&v| used[v as usize]);
            let first = among.next();
            if first.is_none() && unused == Unused::Fault {
                report.fault(Fault::UnusedPoint { point: witness(points, equal[0]) });
            }
            let first = first.unwrap_or(equal[0]);
            for again in among {
                report.fault(Fault::DuplicatePoint { point: witness(points, again), first });
            }
            for &v in equal {
                representative[v as usize] = first;
                if !used[v as usize] && v != first {
                    report.duplicate();
                }
            }
        }
    });
    representative
}
