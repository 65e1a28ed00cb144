//! The law of other programs' triangulations: what the judge says of them, ties broken in any way.

use delone::check::{Complex, Options, Verdict, judge_constrained, judge_delaunay};
use delone::delaunay::{self, delaunay};

use crate::case::Case;
use crate::fuzz::Broken;

/// Whether a program can be asked for cells at all: the points span their space.
#[must_use]
pub fn is_solid<const D: usize>(case: &Case<D>) -> bool {
    let options = delaunay::Options::default();
    delaunay(&case.sites(), &options, &mut ()).mesh().dimension() == Some(D)
}

/// Judges cells, flat, by input point: Delaunay, or constrained Delaunay if the case has segments.
///
/// # Errors
/// If the judge rejects them: the law is `judge`, the place the first kind of fault.
pub fn judged<const D: usize>(
    case: &Case<D>,
    cells: &[u32],
    options: &Options,
) -> Result<(), Broken> {
    let complex = Complex { points: &case.points, dimension: Some(D), cells };
    let verdict = if case.segments.is_empty() {
        judge_delaunay(&complex, options)
    } else {
        let points: Vec<[f64; 2]> = case.points.iter().map(|p| [p[0], p[1]]).collect();
        let complex = Complex { points: &points, dimension: Some(D), cells };
        judge_constrained(&complex, &case.segments, &case.segments, options)
    };
    accept(&verdict)
}

/// A rejection as a broken law. Flags are not asked for: files of triangles have none.
fn accept(verdict: &Verdict) -> Result<(), Broken> {
    let is_flag = |kind: &str| matches!(kind, "missing-flag" | "extra-flag" | "flag-not-edge");
    let Some(fault) = verdict.faults.iter().find(|fault| !is_flag(fault.kind())) else {
        return Ok(());
    };
    let place = fault.kind().to_owned();
    Err(Broken { law: "judge".to_owned(), place, message: fault.to_string() })
}
