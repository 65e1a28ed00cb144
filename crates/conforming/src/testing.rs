//! What the tests of this crate have in common.

use delone_check::{
    Complex, Conformed, Options, Promise, SteinerPoint, Verdict, judge_conforming,
    judge_constrained,
};
use delone_sites::Pslg;

use crate::{Conforming, SteinerPoint as Added};

pub(crate) fn pslg(points: &[[f64; 2]], segments: &[[usize; 2]]) -> Pslg {
    Pslg::new(points, segments).unwrap_or_else(|error| panic!("{error}"))
}

/// What the judge says.
pub(crate) fn judged(pslg: &Pslg, conforming: &Conforming, promise: Promise) -> Verdict {
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
        Added::On { ends, t, .. } => {
            SteinerPoint::On { ends: *ends, mantissa: t.mantissa(), exponent: t.exponent() }
        }
        Added::Free => SteinerPoint::At(conforming.positions()[sites + i]),
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
    judge_conforming(&conformed, &Options::default())
}
