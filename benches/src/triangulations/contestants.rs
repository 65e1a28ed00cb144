//! The contestants: ours on one and two threads, CGAL, spade, delaunator.

use std::cell::RefCell;
use std::num::NonZeroUsize;
use std::time::Instant;

use delone::cdt::{Cdt, chew_from_points, from_points};
use delone::delaunay::{Options, algorithms};
use delone::mesh::Mesh;
use delone::sites::PslgError;
use delone::{Pslg, Sites};
use delone_tests::cgal::{Answer, Cgal};
use spade::{ConstrainedDelaunayTriangulation, DelaunayTriangulation, Point2, Triangulation};

use super::{Contestant, Run, Task};

/// Peers that live in a process of their own.
#[derive(Debug)]
pub struct Peers {
    cgal: Option<RefCell<Cgal>>,
}

impl Peers {
    /// Starts those that are there.
    #[must_use]
    pub fn start() -> Self {
        Self { cgal: Cgal::start().map(RefCell::new) }
    }
}

/// Who triangulates the plane: points alone, or with segments.
#[must_use]
pub fn plane(peers: &Peers, constrained: bool, threads_max: usize) -> Vec<Contestant<'_, 2>> {
    let mut all = Vec::new();
    if constrained {
        let run = |task: &Task<2>| ours_constrained(from_points, task);
        all.push(Contestant { name: "cavity", ours: true, run: Box::new(run) });
        let run = |task: &Task<2>| ours_constrained(chew_from_points, task);
        all.push(Contestant { name: "chew", ours: true, run: Box::new(run) });
        all.push(peer("spade", spade_constrained));
    } else {
        ours(&mut all, threads_max);
        all.push(peer("spade", spade_delaunay));
        all.push(peer("delaunator", delaunator_delaunay));
    }
    if let Some(cgal) = &peers.cgal {
        all.push(peer("CGAL", move |task: &Task<2>| {
            let mut cgal = cgal.borrow_mut();
            let answer = match constrained {
                true => cgal.cdt(&task.points, &task.segments),
                false => cgal.delaunay(&task.points),
            };
            answered(answer, cgal.seconds())
        }));
    }
    all
}

/// Who triangulates space.
#[must_use]
pub fn space(peers: &Peers) -> Vec<Contestant<'_, 3>> {
    let mut all = Vec::new();
    ours(&mut all, 1);
    if let Some(cgal) = &peers.cgal {
        all.push(peer("CGAL", move |task: &Task<3>| {
            let mut cgal = cgal.borrow_mut();
            let answer = cgal.delaunay(&task.points);
            answered(answer, cgal.seconds())
        }));
    }
    all
}

fn peer<'p, const D: usize>(
    name: &'static str,
    run: impl FnMut(&Task<D>) -> Run + 'p,
) -> Contestant<'p, D> {
    Contestant { name, ours: false, run: Box::new(run) }
}

#[expect(clippy::disallowed_methods, reason = "it times")]
fn timed<T>(run: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = run();
    (start.elapsed().as_secs_f64(), result)
}

fn answered(answer: Answer, seconds: f64) -> Run {
    match answer {
        Answer::Cells { cells, .. } => Run { seconds, cells: Some(cells) },
        Answer::Refused(_) => Run { seconds, cells: None },
    }
}

/// The first algorithm of the registry, on one thread and on more.
fn ours<const D: usize>(all: &mut Vec<Contestant<'_, D>>, threads_max: usize) {
    for threads in (1..=threads_max).filter_map(NonZeroUsize::new) {
        let run = move |task: &Task<D>| {
            let options = Options { threads, ..Options::default() };
            let algorithm = algorithms::<D>()[0];
            let (seconds, (sites, result)) = timed(|| {
                let sites = Sites::new_in_parallel(&task.points, threads);
                let sites = sites.expect("workloads are finite");
                let result = (algorithm.run)(&sites, &options);
                (sites, result)
            });
            Run { seconds, cells: Some(cells(result.mesh(), sites.input_of())) }
        };
        let name = if threads.get() == 1 { "ours" } else { "ours, 2 threads" };
        all.push(Contestant { name, ours: true, run: Box::new(run) });
    }
}

/// From points and segments to the noded graph and its triangulation.
type FromPoints = fn(&[[f64; 2]], &[[usize; 2]], &mut ()) -> Result<(Pslg, Cdt), PslgError>;

fn ours_constrained(run: FromPoints, task: &Task<2>) -> Run {
    let segments: Vec<[usize; 2]> =
        task.segments.iter().map(|ends| ends.map(|id| id as usize)).collect();
    let (seconds, result) = timed(|| run(&task.points, &segments, &mut ()));
    let (pslg, result) = result.expect("the workload has no crossings");
    Run { seconds, cells: Some(cells(result.mesh(), pslg.sites().input_of())) }
}

fn cells<const D: usize>(mesh: &Mesh<D>, input_of: &[u32]) -> Vec<u32> {
    let corners = mesh.solid_cells().flat_map(|cell| mesh.corners(cell));
    corners.map(|vertex| input_of[vertex.index()]).collect()
}

fn spade_points(task: &Task<2>) -> Vec<Point2<f64>> {
    task.points.iter().map(|&[x, y]| Point2::new(x, y)).collect()
}

/// The triangles: bulk loading keeps the order of points, so that a vertex's number is its point's.
fn spade_run<T: Triangulation<Vertex = Point2<f64>>, E>(
    load: impl FnOnce() -> Result<T, E>,
) -> Run {
    let (seconds, result) = timed(load);
    let cells = result.ok().map(|triangulation| {
        let faces = triangulation.inner_faces();
        let corners = faces.flat_map(|face| face.vertices().map(|v| v.fix().index()));
        corners.map(|v| u32::try_from(v).expect("ids of 32 bits")).collect()
    });
    Run { seconds, cells }
}

fn spade_delaunay(task: &Task<2>) -> Run {
    let points = spade_points(task);
    spade_run(|| DelaunayTriangulation::<Point2<f64>>::bulk_load_stable(points))
}

fn spade_constrained(task: &Task<2>) -> Run {
    let points = spade_points(task);
    let edges = task.segments.iter().map(|edge| edge.map(|id| id as usize)).collect();
    spade_run(|| ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(points, edges))
}

fn delaunator_delaunay(task: &Task<2>) -> Run {
    let points: Vec<delaunator::Point> =
        task.points.iter().map(|&[x, y]| delaunator::Point { x, y }).collect();
    let (seconds, result) = timed(|| delaunator::triangulate(&points));
    let corners = result.triangles.iter();
    let cells = corners.map(|&v| u32::try_from(v).expect("ids of 32 bits")).collect();
    Run { seconds, cells: Some(cells) }
}
