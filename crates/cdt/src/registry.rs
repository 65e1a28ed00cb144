//! Every CDT algorithm by name: what the lab, the tests and the benches walk.

use delone_delaunay::{KernelKind, Options, divide_conquer};
use delone_mesh::{Mesh, VertexId};
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

/// All algorithms; the first is the one to take if nothing speaks for another.
#[must_use]
pub fn algorithms() -> Vec<Algorithm> {
    vec![
        Algorithm {
            name: "cavity",
            papers: &["SB15", "Ang97"],
            run: |pslg, options| cavity(pslg, options, &mut ()),
            run_with: |pslg, options, mut probe| cavity(pslg, options, &mut probe),
        },
        Algorithm {
            name: "chew",
            papers: &["Che89", "GS85"],
            run: |pslg, options| chew(pslg, options, &mut ()),
            run_with: |pslg, options, mut probe| chew(pslg, options, &mut probe),
        },
    ]
}

/// The CDT by Chew's divide and conquer.
pub fn chew(pslg: &Pslg, options: &Options, probe: &mut impl Probe) -> Cdt {
    match options.kernel {
        KernelKind::Exact => chew_under(&Exact::new(pslg.sites().points()), pslg, probe),
        _ => chew_under(&Adaptive::new(pslg.sites().points()), pslg, probe),
    }
}

fn chew_under<K>(kernel: &K, pslg: &Pslg, probe: &mut impl Probe) -> Cdt
where
    K: PlaneKernel,
    K::Reordered: PlaneKernel,
{
    let (sorted, ranks) = (pslg.sites().sorted(), pslg.sites().ranks());
    let ranked: Vec<[u32; 2]> = pslg
        .subsegments()
        .iter()
        .map(|ends| {
            let [a, b] = ends.map(|site| ranks[site as usize]);
            [a.min(b), a.max(b)]
        })
        .collect();
    let kernel = kernel.reordered(sorted);
    let rings = crate::chew::chew(&kernel, sorted.len(), &ranked, probe);
    match crate::chew::hand_over(&rings, &kernel, sorted) {
        Some((mesh, constrained)) => Cdt::new(mesh, constrained),
        None => {
            let line: Vec<VertexId> = sorted.iter().map(|&v| VertexId::new(v as usize)).collect();
            on_a_line(Mesh::chain(&line), pslg)
        }
    }
}

/// All sites in line: the triangulation is their chain, and each subsegment is an edge of it.
fn on_a_line(mesh: Mesh<2>, pslg: &Pslg) -> Cdt {
    let constrained = chain::constrained_cells(&mesh, pslg.subsegments());
    Cdt::new(mesh, constrained)
}

/// The CDT by Delaunay triangulation and [`insert_segments`].
pub fn cavity(pslg: &Pslg, options: &Options, probe: &mut impl Probe) -> Cdt {
    match options.kernel {
        KernelKind::Exact => cavity_under(&Exact::new(pslg.sites().points()), pslg, probe),
        _ => cavity_under(&Adaptive::new(pslg.sites().points()), pslg, probe),
    }
}

fn cavity_under(kernel: &impl PlaneKernel, pslg: &Pslg, probe: &mut impl Probe) -> Cdt {
    let mesh = divide_conquer(kernel, pslg.sites(), probe);
    if mesh.dimension() == Some(2) {
        let (mesh, constrained) =
            insert_segments(mesh, kernel, pslg.sites().len(), pslg.subsegments(), probe);
        Cdt::new(mesh, constrained)
    } else {
        on_a_line(mesh, pslg)
    }
}
