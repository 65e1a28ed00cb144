//! Every CDT algorithm by name: what the lab, the tests and the benches walk.

use delone_delaunay::{KernelKind, Options, divide_conquer, divide_conquer_sorted};
use delone_mesh::{Mesh, VertexId};
use delone_predicates::{Adaptive, Exact, PlaneKernel};
use delone_probe::{Event, Probe};
use delone_sites::{Arrangement, Pslg, PslgError, sweep};

use crate::flips::insert_by_flips;
use crate::{Cdt, chain, chew_from_points, from_points, insert_segments, naive};

/// One CDT algorithm.
#[derive(Clone, Copy, Debug)]
pub struct Algorithm {
    /// Its name on the command line.
    pub name: &'static str,
    /// Keys of the papers it follows.
    pub papers: &'static [&'static str],
    /// The most sites that it is meant for: it runs on more, for longer than anybody waits.
    pub sites_max: usize,
    /// Runs it.
    pub run: fn(&Pslg, &Options) -> Cdt,
    /// Runs it and tells the probe.
    pub run_with: fn(&Pslg, &Options, &mut dyn Probe) -> Cdt,
    /// Runs it on segments that may cross, and tells the probe; the kernel is that of the arrangement.
    pub run_crossed: fn(&Arrangement, &mut dyn Probe) -> Cdt,
    /// From points and segments, if it has a shorter way there than over a noded graph.
    pub from_points: Option<FromPoints>,
}

/// From points and segments (pairs of point indices) to the noded graph and its CDT.
pub type FromPoints = fn(&[[f64; 2]], &[[usize; 2]]) -> Result<(Pslg, Cdt), PslgError>;

/// All algorithms; the first is the one to take if nothing speaks for another.
#[must_use]
pub fn algorithms() -> Vec<Algorithm> {
    vec![
        Algorithm {
            name: "cavity",
            papers: &["SB15", "Ang97"],
            sites_max: usize::MAX,
            run: |pslg, options| cavity(pslg, options, &mut ()),
            run_with: |pslg, options, mut probe| cavity(pslg, options, &mut probe),
            run_crossed: |graph, mut probe| crossed(Method::Cavity, graph, &mut probe),
            from_points: Some(|points, segments| from_points(points, segments, &mut ())),
        },
        Algorithm {
            name: "chew",
            papers: &["Che89", "GS85"],
            sites_max: usize::MAX,
            run: |pslg, options| chew(pslg, options, &mut ()),
            run_with: |pslg, options, mut probe| chew(pslg, options, &mut probe),
            run_crossed: |graph, mut probe| crossed(Method::Chew, graph, &mut probe),
            from_points: Some(|points, segments| chew_from_points(points, segments, &mut ())),
        },
        Algorithm {
            name: "flips",
            papers: &["Slo93", "Law77"],
            sites_max: usize::MAX,
            run: |pslg, options| flips(pslg, options, &mut ()),
            run_with: |pslg, options, mut probe| flips(pslg, options, &mut probe),
            run_crossed: |graph, mut probe| crossed(Method::Flips, graph, &mut probe),
            from_points: None,
        },
        Algorithm {
            name: "naive",
            papers: &["LL86"],
            sites_max: 40,
            run: |pslg, options| by_definition(pslg, options, &mut ()),
            run_with: |pslg, options, mut probe| by_definition(pslg, options, &mut probe),
            run_crossed: |graph, mut probe| crossed(Method::Naive, graph, &mut probe),
            from_points: None,
        },
    ]
}

/// How a CDT is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    Cavity,
    Chew,
    Flips,
    Naive,
}

/// A noded graph without its coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Graph<'g> {
    /// The vertices in lexicographic order.
    pub(crate) sorted: &'g [u32],
    /// Pairs of vertices, smaller first, in increasing order.
    pub(crate) subsegments: &'g [[u32; 2]],
}

impl Method {
    /// The CDT of a graph under a kernel; `delaunay` makes the Delaunay mesh of its vertices.
    pub(crate) fn run<K, P: Probe>(
        self,
        kernel: &K,
        graph: Graph<'_>,
        delaunay: impl FnOnce(&mut P) -> Mesh<2>,
        probe: &mut P,
    ) -> Cdt
    where
        K: PlaneKernel<Reordered: PlaneKernel>,
    {
        let count = graph.sorted.len();
        let mesh = match self {
            Self::Chew => match chew_mesh(kernel, graph, probe) {
                Some((mesh, constrained)) => return Cdt::new(mesh, constrained),
                None => chain_of(graph.sorted),
            },
            Self::Cavity | Self::Flips | Self::Naive => delaunay(probe),
        };
        if mesh.dimension() != Some(2) {
            // All vertices in line: the triangulation is their chain, and each subsegment is an edge of it.
            let constrained = chain::constrained_cells(&mesh, graph.subsegments);
            return Cdt::new(mesh, constrained);
        }
        let (mesh, constrained) = match self {
            Self::Flips => insert_by_flips(mesh, kernel, count, graph.subsegments, probe),
            Self::Naive => {
                let cells = naive::wrap(kernel, count, graph.subsegments);
                probe.on(Event::Site { done: count, total: count });
                let mesh = Mesh::from_cells(2, &cells).expect("the cells tile the hull");
                let constrained = marked(&mesh, graph.subsegments);
                (mesh, constrained)
            }
            Self::Cavity | Self::Chew => {
                insert_segments(mesh, kernel, count, graph.subsegments, probe)
            }
        };
        Cdt::new(mesh, constrained)
    }
}

/// Which half-edges of a mesh are subsegments.
fn marked(mesh: &Mesh<2>, subsegments: &[[u32; 2]]) -> Vec<bool> {
    let facets = mesh.cells().flat_map(|cell| mesh.facets(cell));
    let is_subsegment = |h| {
        let ends = [mesh.origin(h), mesh.destination(h)];
        let mut ids = ends.map(|v| u32::try_from(v.index()).unwrap_or(u32::MAX)); // the ghost is no site
        ids.sort_unstable();
        subsegments.binary_search(&ids).is_ok()
    };
    facets.map(is_subsegment).collect()
}

fn chain_of(sorted: &[u32]) -> Mesh<2> {
    let line: Vec<VertexId> = sorted.iter().map(|&v| VertexId::new(v as usize)).collect();
    Mesh::chain(&line)
}

fn chew_mesh<K>(
    kernel: &K,
    graph: Graph<'_>,
    probe: &mut impl Probe,
) -> Option<(Mesh<2>, Vec<bool>)>
where
    K: PlaneKernel<Reordered: PlaneKernel>,
{
    let mut ranks = vec![0; graph.sorted.len()];
    for (rank, &vertex) in (0u32..).zip(graph.sorted) {
        ranks[vertex as usize] = rank;
    }
    let ranked: Vec<[u32; 2]> = graph
        .subsegments
        .iter()
        .map(|ends| {
            let [a, b] = ends.map(|vertex| ranks[vertex as usize]);
            [a.min(b), a.max(b)]
        })
        .collect();
    let kernel = kernel.reordered(graph.sorted);
    let mut swept =
        sweep(&kernel, graph.sorted.len(), &ranked).expect("a noded graph has no crossings");
    let rings = crate::chew::chew(&kernel, &mut swept, graph.sorted, probe);
    crate::chew::hand_over(rings, &kernel, graph.sorted)
}

fn run(method: Method, pslg: &Pslg, options: &Options, probe: &mut impl Probe) -> Cdt {
    let points = pslg.sites().points();
    match options.kernel {
        KernelKind::Exact => run_under(method, &Exact::new(points), pslg, probe),
        _ => run_under(method, &Adaptive::new(points), pslg, probe),
    }
}

fn run_under<K>(method: Method, kernel: &K, pslg: &Pslg, probe: &mut impl Probe) -> Cdt
where
    K: PlaneKernel<Reordered: PlaneKernel>,
{
    let sites = pslg.sites();
    let graph = Graph { sorted: sites.sorted(), subsegments: pslg.subsegments() };
    method.run(kernel, graph, |probe| divide_conquer(kernel, sites, probe), probe)
}

/// The CDT of an arrangement.
fn crossed(method: Method, graph: &Arrangement, probe: &mut impl Probe) -> Cdt {
    let (kernel, sorted) = (graph.kernel(), graph.sorted());
    let abstracted = Graph { sorted, subsegments: graph.subsegments() };
    method.run(kernel, abstracted, |probe| divide_conquer_sorted(kernel, sorted, probe), probe)
}

/// The CDT of segments that may cross, every crossing a vertex: by Delaunay triangulation and [`insert_segments`], under the
/// arrangement's own kernel.
pub fn cdt_of_arrangement(graph: &Arrangement, probe: &mut impl Probe) -> Cdt {
    crossed(Method::Cavity, graph, probe)
}

/// The CDT by Chew's divide and conquer.
pub fn chew(pslg: &Pslg, options: &Options, probe: &mut impl Probe) -> Cdt {
    run(Method::Chew, pslg, options, probe)
}

/// The CDT by Delaunay triangulation and [`insert_segments`].
pub fn cavity(pslg: &Pslg, options: &Options, probe: &mut impl Probe) -> Cdt {
    run(Method::Cavity, pslg, options, probe)
}

/// The CDT by Delaunay triangulation and flips, first of what the segments cross, then to what is Delaunay: \[Slo93\], \[Law77\].
pub fn flips(pslg: &Pslg, options: &Options, probe: &mut impl Probe) -> Cdt {
    run(Method::Flips, pslg, options, probe)
}

/// The CDT by its definition: O(n^2 m), for small inputs.
fn by_definition(pslg: &Pslg, options: &Options, probe: &mut impl Probe) -> Cdt {
    run(Method::Naive, pslg, options, probe)
}
