//! Triangulations with Steiner points: judged in exact ratios, the same in any order of input, and beside CGAL's.
//!
//! | module | inputs |
//! |---|---|
//! | `workloads` | the corpus: workloads, inputs by hand, regressions |
//! | `files` | the collected files |

mod files;
mod workloads;

use delone::Pslg;
use delone::check::{Conformed, Options, Promise, SteinerPoint, Verdict, judge_conforming};
use delone::conforming::{Conforming, Method, SteinerPoint as Added};
use delone_tests::id;

/// What a method promises.
fn promise(method: &Method) -> Promise {
    if method.empties_disks { Promise::EmptyDisks } else { Promise::Conforming }
}

/// What the judge says.
fn judged(pslg: &Pslg, conforming: &Conforming, promise: Promise) -> Verdict {
    let mesh = conforming.mesh();
    let corners = mesh.solid_cells().flat_map(|cell| mesh.corners(cell));
    let cells: Vec<u32> = corners.map(|v| id(v.index())).collect();
    let sites = pslg.sites().len();
    let on = conforming.steiner_points().iter().enumerate().map(|(i, point)| match point {
        Added::On { ends, t, .. } => {
            SteinerPoint::On { ends: *ends, mantissa: t.mantissa(), exponent: t.exponent() }
        }
        Added::Free => SteinerPoint::At(conforming.positions()[sites + i]),
    });
    let steiner: Vec<SteinerPoint<'_>> = on.collect();
    let conformed = Conformed {
        points: pslg.sites().points(),
        steiner: &steiner,
        cells: &cells,
        segments: pslg.segments(),
        constrained: conforming.constrained_edges(),
        promise,
    };
    judge_conforming(&conformed, &Options::default())
}
