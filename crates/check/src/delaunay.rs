//! The judge of Delaunay triangulations, in any dimension, degenerate ones included.

use crate::cells::{Complex, Triangulation};
use crate::exact::{Integer, Pure};
use crate::local::check_local;
use crate::options::{Backend, Options, Ties};
use crate::triangulation::{check_triangulation, facets_of};
use crate::verdict::{Level, Report, Verdict};

/// Judges whether the complex is the Delaunay triangulation of its points.
///
/// Every fault is reported; nothing in the data can make this panic. See the [crate] for what is
/// proved how.
#[must_use]
pub fn judge_delaunay<const D: usize>(complex: &Complex<'_, D>, options: &Options) -> Verdict {
    match options.backend {
        Backend::Pure => judge::<D, Pure>(complex, options),
        #[cfg(feature = "rug")]
        Backend::Gmp => judge::<D, crate::exact::Gmp>(complex, options),
    }
}

fn judge<const D: usize, I: Integer>(complex: &Complex<'_, D>, options: &Options) -> Verdict {
    let mut report = Report::new(options.faults_max);
    let Some(t) = Triangulation::<D, I>::read(complex, options, &mut report) else {
        return report.verdict();
    };
    let facets = facets_of(&t);
    check_triangulation(&t, &facets, &mut report);
    let tiles = report.is_clean();
    report.check_given(tiles, delaunay_claim(options.ties), |report| {
        if t.dimension > 0 {
            check_local(&t, &facets, |_| false, options.ties, report);
        }
    });
    if tiles && report.count("not-delaunay") == 0 {
        let strict = options.ties == Ties::Strict && report.count("wrong-tie") == 0;
        report.reached(if strict { Level::Delaunay } else { Level::WeaklyDelaunay });
    }
    report.verdict()
}

fn delaunay_claim(ties: Ties) -> &'static str {
    match ties {
        Ties::Strict => {
            "D2: locally delaunay across every facet, ties as the perturbation has them"
        }
        Ties::Weak => "D2: locally delaunay across every facet, ties either way",
    }
}

#[cfg(test)]
mod tests;
