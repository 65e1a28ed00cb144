//! The judge of constrained Delaunay triangulations in the plane, collinear points included.
//!
//! K1: the complex tiles the hull ([`crate::triangulation`]), and is locally Delaunay across every
//! interior edge that lies on no input segment ([`crate::local`]). K2, K4: every segment is a chain
//! of edges; K3: the flags are the union of the chains ([`crate::chains`]). These are the local
//! criterion of the constrained Delaunay triangulation, which has one solution under the
//! perturbation; visibility need not be evaluated. An edge is exempt because it lies on a segment,
//! not because it is flagged.

use crate::cells::{Complex, Triangulation};
use crate::chains::{Edges, check_flags, cover};
use crate::exact::{Integer, Pure};
use crate::local::check_local;
use crate::options::{Backend, Options, Ties};
use crate::triangulation::{check_triangulation, facets_of};
use crate::verdict::{Level, Report, Verdict};

/// Judges whether the complex is the constrained Delaunay triangulation of its points and these
/// input `segments`.
///
/// Vertices may lie in the interior of segments, and segments may overlap and repeat; a segment
/// between equal points asks for nothing. `constrained` are the edges that the output flags, as a
/// set.
#[must_use]
pub fn judge_constrained(
    complex: &Complex<'_, 2>,
    segments: &[[u32; 2]],
    constrained: &[[u32; 2]],
    options: &Options,
) -> Verdict {
    match options.backend {
        Backend::Pure => judge::<Pure>(complex, segments, constrained, options),
        #[cfg(feature = "rug")]
        Backend::Gmp => judge::<crate::exact::Gmp>(complex, segments, constrained, options),
    }
}

fn judge<I: Integer>(
    complex: &Complex<'_, 2>,
    segments: &[[u32; 2]],
    constrained: &[[u32; 2]],
    options: &Options,
) -> Verdict {
    let mut report = Report::new(options.faults_max);
    let Some(t) = Triangulation::<2, I>::read(complex, options, &mut report) else {
        return report.verdict();
    };
    let facets = facets_of(&t);
    check_triangulation(&t, &facets, &mut report);
    let tiles = report.is_clean();

    let mut edges = Edges::of(&t, &facets);
    let mut covered = Vec::new();
    report.check_given(
        tiles,
        "K2, K4: every segment is an exactly collinear chain of edges",
        |report| {
            covered = cover(&t, &mut edges, segments, report, |_, _, _| None);
        },
    );
    report.check_given(tiles, "K3: the flagged edges are those on segments", |report| {
        check_flags(t.space.points, &edges, &covered, constrained, report);
    });
    let keeps = report.is_clean();
    report.check_given(tiles, "D2: locally delaunay across every edge on no segment", |report| {
        // In dimension 2 the edges are the facets, in the same order.
        let exempt = |number: usize| t.dimension == 2 && covered[number].first.is_some();
        if t.dimension > 0 {
            check_local(&t, &facets, exempt, options.ties, report);
        }
    });
    if tiles && keeps && report.count("not-delaunay") == 0 {
        let strict = options.ties == Ties::Strict && report.count("wrong-tie") == 0;
        report.reached(if strict { Level::Constrained } else { Level::WeaklyConstrained });
    }
    report.verdict()
}

#[cfg(test)]
mod tests;
