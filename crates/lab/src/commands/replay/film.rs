//! Meshes after each step, as the spans of a scene: what came when, and when it went.

use std::collections::BTreeMap;

use delone_draw::{Scene, Span, Step};
use delone_mesh::Mesh;
use delone_probe::{Counts, Moment};

use super::recording::Notes;
use crate::pictures::{edges, outer};

/// Things by corners, with the step since which they are there; and those that have gone.
struct Track<const N: usize> {
    present: BTreeMap<[u32; N], u32>,
    gone: Vec<Span<N>>,
}

impl<const N: usize> Track<N> {
    const fn new() -> Self {
        Self { present: BTreeMap::new(), gone: Vec::new() }
    }

    /// What is there from `step` on; how many went and came.
    fn update(&mut self, step: u32, things: impl Iterator<Item = [u32; N]>) -> [usize; 2] {
        let before = std::mem::take(&mut self.present);
        self.present = things.map(|thing| (thing, step)).collect();
        let mut went = 0;
        for (corners, from) in before {
            match self.present.get_mut(&corners) {
                Some(since) => *since = from,
                None => {
                    went += 1;
                    self.gone.push(Span { corners, from, until: step });
                }
            }
        }
        [went, self.present.values().filter(|&&since| since == step).count()]
    }

    fn spans(self) -> Vec<Span<N>> {
        let left = self.present.into_iter();
        let left = left.map(|(corners, from)| Span { corners, from, until: u32::MAX });
        self.gone.into_iter().chain(left).collect()
    }
}

/// A scene in the making.
pub(super) struct Film {
    points: Vec<[f64; 2]>,
    triangles: Track<3>,
    constraints: Track<2>,
    ghosts: Track<2>,
    forced: Track<2>,
    wires: Track<2>,
    steps: Vec<Step>,
    /// The edges of the Delaunay triangulation of all sites, once it is done.
    delaunay: Option<Vec<[u32; 2]>>,
    /// Questions asked in all steps together.
    pub(super) asked: u64,
}

impl Film {
    /// No step yet but the first, which shows the sites.
    pub(super) fn new(points: &[[f64; 2]]) -> Self {
        Self {
            points: points.to_vec(),
            triangles: Track::new(),
            constraints: Track::new(),
            ghosts: Track::new(),
            forced: Track::new(),
            wires: Track::new(),
            steps: vec![Step { title: "nothing yet".to_owned(), ..Step::default() }],
            delaunay: None,
            asked: 0,
        }
    }

    pub(super) fn steps(&self) -> usize {
        self.steps.len()
    }

    /// From here on edges that come and are not there now are not Delaunay.
    pub(super) fn delaunay_is_done(&mut self) {
        self.delaunay = Some(edges(self.triangles.present.keys()));
    }

    /// What is there after a step.
    pub(super) fn step(
        &mut self,
        title: &str,
        mesh: &Mesh<2>,
        constraints: &[[u32; 2]],
        marked: &[u32],
        counts: &Counts,
        notes: &Notes,
    ) {
        let step = self.now();
        let changes = self.triangles.update(step, triangles(mesh).into_iter());
        self.constraints.update(step, constraints.iter().copied());
        self.ghosts.update(step, hull(mesh).into_iter());
        self.wires.update(step, std::iter::empty());
        let known = self.delaunay.as_deref();
        let forced = known.map_or_else(Vec::new, |known| {
            let mut edges = edges(self.triangles.present.keys());
            edges.retain(|edge| known.binary_search(edge).is_err());
            edges
        });
        self.forced.update(step, forced.into_iter());
        self.tell(title, "triangles", changes, marked, counts, notes);
    }

    /// The step to come.
    fn now(&self) -> u32 {
        u32::try_from(self.steps.len()).expect("steps of an input of few sites")
    }

    /// What an algorithm shows of its inside; edges on the sides of triangles are not told once more.
    pub(super) fn moment(&mut self, moment: &Moment<'_>, counts: &Counts, notes: &Notes) {
        let step = self.now();
        let turned = moment.triangles.iter().map(|&triangle| smallest_first(triangle));
        let changes = self.triangles.update(step, turned);
        let sides = edges(self.triangles.present.keys());
        let sorted = moment.edges.iter().map(|&[a, b]| [a.min(b), a.max(b)]);
        let loose = sorted.filter(|edge| sides.binary_search(edge).is_err());
        let wires = self.wires.update(step, loose);
        let (changes, what) = if moment.triangles.is_empty() {
            (wires, "loose edges")
        } else {
            (changes, "triangles")
        };
        self.tell(moment.title, what, changes, moment.marked, counts, notes);
    }

    /// These are there from the first step on.
    pub(super) fn constraints(&mut self, edges: &[[u32; 2]]) {
        self.constraints.update(0, edges.iter().copied());
    }

    fn tell(
        &mut self,
        title: &str,
        what: &str,
        [went, came]: [usize; 2],
        marked: &[u32],
        counts: &Counts,
        notes: &Notes,
    ) {
        let (asked, lines) = notes.take();
        self.asked += asked;
        let done: Vec<String> = counts
            .named()
            .into_iter()
            .filter(|&(_, count)| count > 0)
            .map(|(name, count)| format!("{count} {}", name.replace('_', " ")))
            .collect();
        let mut detail = format!("{}\n{}", done.join(", "), lines.join("\n"));
        if asked > lines.len() as u64 {
            detail.push_str(&format!("\nand {} more questions", asked - lines.len() as u64));
        }
        let asked = if asked > 0 { format!(", {asked} questions") } else { String::new() };
        let title = format!("{title}: {went} {what} go, {came} come{asked}");
        let detail = detail.trim().to_owned();
        self.steps.push(Step { title, detail, marked: marked.to_vec() });
    }

    pub(super) fn scene(self) -> Scene {
        Scene {
            points: self.points,
            triangles: self.triangles.spans(),
            constraints: self.constraints.spans(),
            ghosts: self.ghosts.spans(),
            forced: self.forced.spans(),
            wires: self.wires.spans(),
            steps: self.steps,
        }
    }
}

/// The solid triangles, smallest corner first.
fn triangles(mesh: &Mesh<2>) -> Vec<[u32; 3]> {
    if mesh.dimension() != Some(2) {
        return Vec::new();
    }
    let corners = mesh.solid_cells().map(|cell| {
        let ids: Vec<u32> = mesh.corners(cell).iter().map(|v| id(v.index())).collect();
        [ids[0], ids[1], ids[2]]
    });
    corners.map(smallest_first).collect()
}

fn smallest_first(mut triangle: [u32; 3]) -> [u32; 3] {
    let first = (0..3).min_by_key(|&i| triangle[i]).unwrap_or(0);
    triangle.rotate_left(first);
    triangle
}

/// The edges of the hull, counter-clockwise.
fn hull(mesh: &Mesh<2>) -> Vec<[u32; 2]> {
    outer(&triangles(mesh))
}

fn id(index: usize) -> u32 {
    u32::try_from(index).expect("a handle fits 32 bits")
}
