//! What the tests of this crate have in common.

use delone_check::{
    Angles, Binary, Complex, Conformed, Options, Promise, SteinerPoint, Verdict, judge_conforming,
    judge_constrained, judge_refined,
};
use delone_predicates::{Dyadic, Sign};
use delone_sites::Pslg;

use crate::{Conforming, Refined, SteinerPoint as Added};

pub(crate) fn pslg(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Pslg {
    Pslg::new(points, segments).unwrap_or_else(|error| panic!("{error}"))
}

/// What the judge says.
pub(crate) fn judged(pslg: &Pslg, conforming: &Conforming, promise: Promise) -> Verdict {
    with_conformed(pslg, conforming, promise, judge_conforming)
}

/// What the judge says of a refined triangulation that is complete.
pub(crate) fn judged_with_angles(pslg: &Pslg, refined: &Refined, cosine_square: f64) -> Verdict {
    let (inside, exceptions) = refined.promised();
    let angles = Angles { cosine_square, inside: &inside, exceptions: &exceptions };
    let judge =
        |conformed: &Conformed<'_>, options: &Options| judge_refined(conformed, &angles, options);
    with_conformed(pslg, refined.triangulation(), Promise::Constrained, judge)
}

fn with_conformed(
    pslg: &Pslg,
    conforming: &Conforming,
    promise: Promise,
    judge: impl FnOnce(&Conformed<'_>, &Options) -> Verdict,
) -> Verdict {
    let mesh = conforming.mesh();
    let cells: Vec<u32> = mesh
        .solid_cells()
        .flat_map(|cell| mesh.corners(cell))
        .map(|v| u32::try_from(v.index()).unwrap())
        .collect();
    let points = pslg.sites().points();
    if mesh.dimension() != Some(2) {
        let complex = Complex { points, dimension: mesh.dimension(), cells: &cells };
        let flags = conforming.constrained_edges();
        return judge_constrained(&complex, pslg.segments(), flags, &Options::default());
    }
    let sites = pslg.sites().len();
    let on = conforming.steiner_points().iter().enumerate().map(|(i, point)| match point {
        Added::On { ends, t, .. } => SteinerPoint::On { ends: *ends, t: binary(t) },
        Added::Free => SteinerPoint::At(conforming.positions()[sites + i]),
        Added::FreeExactly { at } => SteinerPoint::Exactly(at.each_ref().map(binary)),
    });
    let steiner: Vec<SteinerPoint<'_>> = on.collect();
    let conformed = Conformed {
        points,
        steiner: &steiner,
        cells: &cells,
        segments: pslg.segments(),
        constrained: conforming.constrained_edges(),
        promise,
    };
    judge(&conformed, &Options::default())
}

/// A number by its digits.
fn binary(x: &Dyadic) -> Binary<'_> {
    let negative = x.sign() == Sign::Negative;
    Binary { mantissa: x.mantissa(), exponent: x.exponent(), negative }
}
