//! Triangulations beside their peers: who takes part, and what each is given.
//!
//! Everyone gets the same points in the same order and is timed from them to its triangulation: ours with validation, removal of
//! duplicates and, with segments, noding (`Sites::new`, `cdt::from_points`); peers as their documentation
//! recommends (bulk loading, range insertion). The conversion of points to a peer's types before, and of its triangles to ours after,
//! are not timed. What comes out is judged once by `delone-check`, as foreign output: ties may be broken in any way.

mod contestants;

use delone::check::{Complex, Options, judge_constrained, judge_delaunay};

pub use contestants::{Peers, plane, space};

/// Points, and segments by index; in the plane or in space.
#[derive(Clone, Debug)]
pub struct Task<const D: usize> {
    /// The points.
    pub points: Vec<[f64; D]>,
    /// Segments, for a constrained triangulation; none for a Delaunay triangulation.
    pub segments: Vec<[u32; 2]>,
}

/// One run.
#[derive(Clone, Debug)]
pub struct Run {
    /// From the points to the triangulation.
    pub seconds: f64,
    /// The cells, flat, as points; `None` if the contestant refused.
    pub cells: Option<Vec<u32>>,
}

/// Who takes part.
pub struct Contestant<'p, const D: usize> {
    /// Its name in tables.
    pub name: &'static str,
    /// Whether it is ours.
    pub ours: bool,
    /// Runs it.
    pub run: Box<dyn FnMut(&Task<D>) -> Run + 'p>,
}

impl<const D: usize> std::fmt::Debug for Contestant<'_, D> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// Whether the judge accepts these cells for this task.
#[must_use]
pub fn accepted<const D: usize>(task: &Task<D>, cells: &[u32]) -> bool {
    let complex = Complex { points: &task.points, dimension: Some(D), cells };
    if task.segments.is_empty() {
        return judge_delaunay(&complex, &Options::foreign()).ok;
    }
    let points: Vec<[f64; 2]> = task.points.iter().map(|p| [p[0], p[1]]).collect();
    let complex = Complex { points: &points, dimension: Some(D), cells };
    judge_constrained(&complex, &task.segments, &task.segments, &Options::foreign()).ok
}
