//! Triangulations with Steiner points: judged in exact ratios, the same in any order of input, and beside CGAL's.
//!
//! | module | inputs |
//! |---|---|
//! | `workloads` | the corpus: workloads, inputs by hand, regressions |
//! | `files` | the collected files |
//! | `refined` | the same, refined |
//! | `effort` | no input: bounds of effort, ratios |

mod effort;
mod files;
mod refined;
mod workloads;

use delone::Pslg;
use delone::check::{
    Angles, Conformed, Options, Promise, SteinerPoint, Verdict, judge_conforming, judge_refined,
};
use delone::conforming::{Conforming, Method, Refined, SteinerPoint as Added};
use delone_tests::id;

/// What a method promises.
fn promise(method: &Method) -> Promise {
    if method.empties_disks { Promise::EmptyDisks } else { Promise::Conforming }
}

/// What the judge says.
fn judged(pslg: &Pslg, conforming: &Conforming, promise: Promise) -> Verdict {
    with_conformed(pslg, conforming, promise, judge_conforming)
}

/// What the judge says of a refined triangulation that is complete, and of its angles.
fn judged_with_angles(pslg: &Pslg, refined: &Refined, cosine_square: f64) -> Verdict {
    let (inside, exceptions) = refined.promised();
    let angles = Angles { cosine_square, inside: &inside, exceptions: &exceptions };
    with_conformed(pslg, refined.triangulation(), Promise::Constrained, |conformed, options| {
        judge_refined(conformed, &angles, options)
    })
}

fn with_conformed(
    pslg: &Pslg,
    conforming: &Conforming,
    promise: Promise,
    judge: impl FnOnce(&Conformed<'_>, &Options) -> Verdict,
) -> Verdict {
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
    judge(&conformed, &Options::default())
}
