//! Every CDT algorithm by name: what the lab, the tests and the benches walk.

use delone_delaunay::{KernelKind, Options, delaunay};
use delone_predicates::{Adaptive, Exact, PlaneKernel};
use delone_probe::Probe;
use delone_sites::Pslg;

use crate::{Cdt, chain, insert_segments};

/// One CDT algorithm.
#[derive(Clone, Copy, Debug)]
pub struct Algorithm {
    /// Its name on the command line.
    pub name: &'static str,
    /// Keys of the papers it follows.
    pub papers: &'static [&'static str],
    /// Runs it.
    pub run: fn(&Pslg, &Options) -> Cdt,
    /// Runs it and tells the probe.
    pub run_with: fn(&Pslg, &Options, &mut dyn Probe) -> Cdt,
}

/// All algorithms.
#[must_use]
pub fn algorithms() -> Vec<Algorithm> {
    vec![Algorithm {
        name: "cavity",
        papers: &["SB15", "Ang97"],
        run: |pslg, options| cavity(pslg, options, &mut ()),
        run_with: |pslg, options, mut probe| cavity(pslg, options, &mut probe),
    }]
}

/// The CDT by Delaunay triangulation and [`insert_segments`].
pub fn cavity(pslg: &Pslg, options: &Options, probe: &mut impl Probe) -> Cdt {
    match options.kernel {
        KernelKind::Exact => cavity_under(&Exact::new(pslg.sites().points()), pslg, options, probe),
        _ => cavity_under(&Adaptive::new(pslg.sites().points()), pslg, options, probe),
    }
}

fn cavity_under(
    kernel: &impl PlaneKernel,
    pslg: &Pslg,
    options: &Options,
    probe: &mut impl Probe,
) -> Cdt {
    let mesh = delaunay(pslg.sites(), options, probe).into_mesh();
    if mesh.dimension() == Some(2) {
        let (mesh, constrained) =
            insert_segments(mesh, kernel, pslg.sites().len(), pslg.subsegments(), probe);
        Cdt::new(mesh, constrained)
    } else {
        let constrained = chain::constrained_cells(&mesh, pslg.subsegments());
        Cdt::new(mesh, constrained)
    }
}
