//! Running algorithms by name, and what all their results have in common.

use std::time::Instant;

use delone_cdt::{Cdt, Domain, Fill, FillError};
use delone_check::Verdict;
use delone_delaunay::{
    Delaunay, Fingerprint, KernelKind, Options, Order, Regular, Stopped, regular,
    regular_unless_stopped,
};
use delone_formats::Document;
use delone_mesh::Mesh;
use delone_probe::Probe;
use delone_sites::{Arrangement, WeightedSites};
use serde_json::{Map, Value, json};

use crate::cli;
use crate::failure::Failure;
use crate::judge;
use crate::subject::{Body, Subject};

/// A result of any algorithm.
pub(crate) enum Triangulation {
    Plane(Delaunay<2>),
    Space(Delaunay<3>),
    RegularPlane(Regular<2>),
    RegularSpace(Regular<3>),
    Constrained(Cdt),
}

/// Evaluates `$answer` with the mesh of any result, named `$mesh`.
macro_rules! with_mesh {
    ($triangulation:expr, $mesh:ident => $answer:expr) => {
        with_mesh!($triangulation, $mesh => $answer; Plane Space RegularPlane RegularSpace Constrained)
    };
    ($triangulation:expr, $mesh:ident => $answer:expr; $($kind:ident)*) => {
        match $triangulation {
            $(Triangulation::$kind(result) => {
                let $mesh = result.mesh();
                $answer
            })*
        }
    };
}

/// The one algorithm for sites with weights.
const FOR_WEIGHTS: &str = "bowyer-watson";

/// A result, and the seconds that its construction took.
pub(crate) struct Built {
    pub(crate) triangulation: Triangulation,
    pub(crate) seconds: f64,
}

/// The options that the command line names.
pub(crate) fn options(run: &cli::Run) -> Options {
    Options {
        kernel: match run.kernel {
            cli::Kernel::Adaptive => KernelKind::Adaptive,
            cli::Kernel::Exact => KernelKind::Exact,
        },
        order: match run.order {
            cli::Order::Brio => Order::Brio,
            cli::Order::Hilbert => Order::Hilbert,
            cli::Order::AsGiven => Order::AsGiven,
            cli::Order::Lexicographic => Order::Lexicographic,
        },
        seed: run.seed,
        threads: run.threads,
    }
}

/// The algorithms that apply to a subject, and are meant for as many sites.
pub(crate) fn names(subject: &Subject) -> Vec<&'static str> {
    fn delaunay<const D: usize>(count: usize) -> Vec<&'static str> {
        let rows = delone_delaunay::algorithms::<D>();
        rows.iter().filter(|row| count <= row.sites_max).map(|row| row.name).collect()
    }
    match &subject.body {
        Body::Plane(sites) => delaunay::<2>(sites.len()),
        Body::Space(sites) => delaunay::<3>(sites.len()),
        Body::WeightedPlane(_) | Body::WeightedSpace(_) => vec![FOR_WEIGHTS],
        Body::Graph(_) | Body::Crossed(_) => {
            let rows = delone_cdt::algorithms();
            let fits = |row: &&delone_cdt::Algorithm| subject.vertex_count() <= row.sites_max;
            rows.iter().filter(fits).map(|row| row.name).collect()
        }
    }
}

/// Every algorithm of any kind, once.
pub(crate) fn all_names() -> Vec<&'static str> {
    let mut names: Vec<&'static str> = delone_cdt::algorithms().iter().map(|a| a.name).collect();
    names.extend(delone_delaunay::algorithms::<2>().iter().map(|a| a.name));
    names.extend(delone_delaunay::algorithms::<3>().iter().map(|a| a.name));
    names.sort_unstable();
    names.dedup();
    names
}

/// The algorithm asked for, or the first one that applies.
pub(crate) fn choose(subject: &Subject, asked: Option<&str>) -> Result<&'static str, Failure> {
    let names = names(subject);
    let Some(asked) = asked else { return Ok(names[0]) };
    names.iter().find(|name| **name == asked).copied().ok_or_else(|| {
        Failure::input(format!(
            "no algorithm for this input is called {asked}: there are {}",
            names.join(", ")
        ))
    })
}

/// The algorithms that apply and can be stopped.
pub(crate) fn stoppable(subject: &Subject) -> Vec<&'static str> {
    fn delaunay<const D: usize>() -> Vec<&'static str> {
        let rows = delone_delaunay::algorithms::<D>();
        rows.iter().filter(|row| row.run_unless_stopped.is_some()).map(|row| row.name).collect()
    }
    match &subject.body {
        Body::Plane(_) => delaunay::<2>(),
        Body::Space(_) => delaunay::<3>(),
        Body::WeightedPlane(_) | Body::WeightedSpace(_) => vec![FOR_WEIGHTS],
        Body::Graph(_) | Body::Crossed(_) => Vec::new(),
    }
}

/// Runs an algorithm that applies to the subject; `probe` listens if there is one.
///
/// # Panics
/// If no such algorithm applies: ask [`choose`] first.
pub(crate) fn run(
    subject: &Subject,
    name: &str,
    options: &Options,
    probe: Option<&mut dyn Probe>,
) -> Built {
    macro_rules! run {
        ($algorithms:expr, $input:expr, $wrap:expr) => {{
            let algorithm = $algorithms.into_iter().find(|algorithm| algorithm.name == name);
            let algorithm = algorithm.expect("the name was chosen from these");
            timed(|| {
                $wrap(match probe {
                    None => (algorithm.run)($input, options),
                    Some(probe) => (algorithm.run_with)($input, options, probe),
                })
            })
        }};
    }
    match &subject.body {
        Body::Plane(sites) => run!(delone_delaunay::algorithms::<2>(), sites, Triangulation::Plane),
        Body::Space(sites) => run!(delone_delaunay::algorithms::<3>(), sites, Triangulation::Space),
        Body::WeightedPlane(sites) => {
            timed(|| Triangulation::RegularPlane(by_weights(sites, options, probe)))
        }
        Body::WeightedSpace(sites) => {
            timed(|| Triangulation::RegularSpace(by_weights(sites, options, probe)))
        }
        Body::Graph(pslg) => run!(delone_cdt::algorithms(), pslg, Triangulation::Constrained),
        Body::Crossed(graph) => run_crossed(graph, name, probe),
    }
}

/// Runs a CDT algorithm under the arrangement's own kernel.
fn run_crossed(graph: &Arrangement, name: &str, probe: Option<&mut dyn Probe>) -> Built {
    let algorithm = delone_cdt::algorithms().into_iter().find(|algorithm| algorithm.name == name);
    let algorithm = algorithm.expect("the name was chosen from these");
    let start = Instant::now();
    let result = match probe {
        None => (algorithm.run_crossed)(graph, &mut ()),
        Some(probe) => (algorithm.run_crossed)(graph, probe),
    };
    let seconds = start.elapsed().as_secs_f64();
    Built { seconds, triangulation: Triangulation::Constrained(result) }
}

fn timed(work: impl FnOnce() -> Triangulation) -> Built {
    let start = Instant::now();
    let triangulation = work();
    Built { triangulation, seconds: start.elapsed().as_secs_f64() }
}

fn by_weights<const D: usize>(
    sites: &WeightedSites<D>,
    options: &Options,
    probe: Option<&mut dyn Probe>,
) -> Regular<D> {
    match probe {
        None => regular(sites, options, &mut ()),
        Some(mut probe) => regular(sites, options, &mut probe),
    }
}

/// Runs an algorithm that can be stopped, unless the probe says not to go on.
///
/// # Panics
/// If the algorithm is none of [`stoppable`].
pub(crate) fn run_unless_stopped(
    subject: &Subject,
    name: &str,
    options: &Options,
    mut probe: &mut dyn Probe,
) -> Result<Built, Stopped> {
    macro_rules! run {
        ($d:literal, $sites:expr) => {{
            let rows = delone_delaunay::algorithms::<$d>();
            let row = rows.into_iter().find(|row| row.name == name);
            let run = row.and_then(|row| row.run_unless_stopped);
            run.expect("the name was chosen from these")($sites, options, probe)
        }};
    }
    let start = Instant::now();
    let triangulation = match &subject.body {
        Body::Plane(sites) => Triangulation::Plane(run!(2, sites)?),
        Body::Space(sites) => Triangulation::Space(run!(3, sites)?),
        Body::WeightedPlane(sites) => {
            Triangulation::RegularPlane(regular_unless_stopped(sites, options, &mut probe)?)
        }
        Body::WeightedSpace(sites) => {
            Triangulation::RegularSpace(regular_unless_stopped(sites, options, &mut probe)?)
        }
        Body::Graph(_) | Body::Crossed(_) => {
            unreachable!("no algorithm for segments can be stopped")
        }
    };
    Ok(Built { triangulation, seconds: start.elapsed().as_secs_f64() })
}

/// Counts that results print.
pub(crate) struct Sizes {
    pub(crate) vertices: usize,
    pub(crate) cells: usize,
    pub(crate) hull_facets: usize,
    pub(crate) dimension: Option<usize>,
}

pub(crate) fn sizes_of<const D: usize>(mesh: &Mesh<D>, vertices: usize) -> Sizes {
    let (cells, hull_facets) = (mesh.solid_cells().count(), mesh.ghost_cells().count());
    Sizes { vertices, cells, hull_facets, dimension: mesh.dimension() }
}

impl Triangulation {
    pub(crate) fn sizes(&self, subject: &Subject) -> Sizes {
        let hidden = match self {
            Self::RegularPlane(result) => result.hidden().len(),
            Self::RegularSpace(result) => result.hidden().len(),
            _ => 0,
        };
        with_mesh!(self, mesh => sizes_of(mesh, subject.vertex_count() - hidden))
    }

    /// What only results of this kind have to tell.
    pub(crate) fn extra(&self, subject: &Subject) -> Map<String, Value> {
        let (key, value) = match (self, &subject.body) {
            (Self::RegularPlane(result), Body::WeightedPlane(sites)) => {
                ("hidden", json!(result.hidden_inputs(sites)))
            }
            (Self::RegularSpace(result), Body::WeightedSpace(sites)) => {
                ("hidden", json!(result.hidden_inputs(sites)))
            }
            _ => ("hidden", json!([])),
        };
        [(key.to_owned(), value)].into_iter().collect()
    }

    pub(crate) fn fingerprint(&self, subject: &Subject) -> Fingerprint {
        match (self, &subject.body) {
            (Self::Plane(result), Body::Plane(sites)) => result.fingerprint(sites),
            (Self::Space(result), Body::Space(sites)) => result.fingerprint(sites),
            (Self::RegularPlane(result), Body::WeightedPlane(sites)) => result.fingerprint(sites),
            (Self::RegularSpace(result), Body::WeightedSpace(sites)) => result.fingerprint(sites),
            (Self::Constrained(result), Body::Graph(pslg)) => result.fingerprint(pslg),
            (Self::Constrained(result), Body::Crossed(graph)) => result.fingerprint(&**graph),
            _ => unreachable!("a result belongs to its subject"),
        }
    }

    pub(crate) fn verdict(&self, subject: &Subject) -> Verdict {
        match (self, &subject.body) {
            (Self::Plane(result), Body::Plane(sites)) => judge::delaunay(sites, result),
            (Self::Space(result), Body::Space(sites)) => judge::delaunay(sites, result),
            (Self::RegularPlane(result), Body::WeightedPlane(sites)) => {
                judge::regular(sites, result)
            }
            (Self::RegularSpace(result), Body::WeightedSpace(sites)) => {
                judge::regular(sites, result)
            }
            (Self::Constrained(result), Body::Graph(pslg)) => judge::cdt(pslg, result),
            (Self::Constrained(result), Body::Crossed(graph)) => judge::arranged(graph, result),
            _ => unreachable!("a result belongs to its subject"),
        }
    }

    /// The solid cells as input points, flat, and how many make a cell.
    pub(crate) fn cells(&self, subject: &Subject) -> (Vec<u32>, usize) {
        let names = subject.names();
        let (ids, count) = with_mesh!(self, mesh => (judge::solid_ids(mesh), mesh.corner_count()));
        (ids.into_iter().map(|site| names[site as usize]).collect(), count)
    }

    /// The constrained edges as input points.
    pub(crate) fn constrained(&self, subject: &Subject) -> Vec<[u32; 2]> {
        let names = subject.names();
        match self {
            Self::Constrained(result) => result
                .constrained_edges()
                .into_iter()
                .map(|edge| edge.map(|site| names[site as usize]))
                .collect(),
            _ => Vec::new(),
        }
    }

    /// What a rule says is inside, if this is a CDT.
    pub(crate) fn domain(&self, subject: &Subject, fill: &Fill) -> Result<Domain, FillError> {
        match (self, &subject.body) {
            (Self::Constrained(cdt), Body::Graph(pslg)) => Domain::new(cdt, pslg, fill),
            (Self::Constrained(cdt), Body::Crossed(graph)) => Domain::new(cdt, &**graph, fill),
            _ => unreachable!("only graphs are filled"),
        }
    }

    /// Takes the triangles that are outside out of this result's document.
    pub(crate) fn keep_inside(&self, domain: &Domain, document: &mut Document) {
        if let Self::Constrained(cdt) = self {
            let mut cells = cdt.cells();
            document.triangles.retain(|_| {
                cells.next().is_some_and(|cell| domain.is_inside(domain.regions().of_cell(cell)))
            });
        }
    }

    /// The input with the cells as faces, and the constrained edges as segments.
    pub(crate) fn document(&self, subject: &Subject) -> Document {
        let mut document = subject.document.clone();
        document.points.extend(subject.added().as_flattened());
        document.segments = self.constrained(subject);
        document.segment_markers.clear();
        (document.triangles, document.tets, document.polygons) = Default::default();
        (document.cell_attributes, document.attributes_per_cell) = Default::default();
        let (cells, count) = self.cells(subject);
        match count {
            4 => document.tets = cells.as_chunks::<4>().0.to_vec(),
            3 => document.triangles = cells.as_chunks::<3>().0.to_vec(),
            2 if document.segments.is_empty() => {
                document.segments = cells.as_chunks::<2>().0.to_vec()
            }
            _ => {}
        }
        document
    }
}
