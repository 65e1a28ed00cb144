//! A constrained Delaunay triangulator of the kind that passes its author's tests, to be found out by `delone fuzz`:
//!
//! ```sh
//! cargo build --release -p delone-lab --example buggy_cdt
//! delone fuzz cdt --program 'target/release/examples/buggy_cdt {in} {out}'
//! ```
//!
//! It trusts doubles, and takes a circle for empty if nothing is deeper in it than 1e-9. Points are swept from left to right,
//! segments forced in by flips, the rest made Delaunay by Lawson's flips; all of it by looking through lists.

use delone_formats::{Document, Format, read_path, write, write_atomically};
use std::error::Error;
use std::path::Path;

/// "Nobody has points closer than this."
const EPSILON: f64 = 1e-9;
const FLIPS_MAX: usize = 10_000;

type Point = [f64; 2];
type Edge = [usize; 2];

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().collect();
    let [_, given, written] = &words[..] else { return Err("buggy_cdt IN OUT".into()) };
    let mut document = read_path(Path::new(given), None)?.pop().ok_or("no input")?;
    let points = document.points_2d()?.to_vec();
    let segments: Vec<Edge> = document.segments.iter().map(|s| s.map(|v| v as usize)).collect();
    let mut cdt = Cdt { points, triangles: Vec::new(), fixed: Vec::new() };
    cdt.sweep();
    segments.into_iter().for_each(|segment| cdt.force(segment));
    cdt.legalize();
    let id = |v: usize| u32::try_from(v).expect("few points");
    document.triangles = cdt.triangles.iter().map(|t| t.map(id)).collect();
    save(&document, Path::new(written))
}

fn save(document: &Document, path: &Path) -> Result<(), Box<dyn Error>> {
    write_atomically(path, |out| write(document, Format::Ele, out))?;
    Ok(())
}

struct Cdt {
    points: Vec<Point>,
    triangles: Vec<[usize; 3]>,
    fixed: Vec<Edge>,
}

impl Cdt {
    fn orient(&self, a: usize, b: usize, c: usize) -> f64 {
        let [a, b, c] = [a, b, c].map(|v| self.points[v]);
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    }

    fn in_circle(&self, [a, b, c]: [usize; 3], d: usize) -> f64 {
        let d = self.points[d];
        let [a, b, c] = [a, b, c].map(|v| [self.points[v][0] - d[0], self.points[v][1] - d[1]]);
        let lift = |p: Point| p[0] * p[0] + p[1] * p[1];
        let minor = |p: Point, q: Point| p[0] * q[1] - p[1] * q[0];
        lift(a) * minor(b, c) + lift(b) * minor(c, a) + lift(c) * minor(a, b)
    }

    /// Any triangulation: from left to right, each point is joined to what it sees of the hull.
    fn sweep(&mut self) {
        let mut order: Vec<usize> = (0..self.points.len()).collect();
        order.sort_by(|&u, &v| self.points[u].partial_cmp(&self.points[v]).expect("numbers"));
        order.dedup_by_key(|v| self.points[*v]);
        let bend = (2..order.len()).find(|&i| self.orient(order[0], order[1], order[i]) != 0.0);
        let Some(bend) = bend else { return };
        for pair in order[..bend].windows(2) {
            let (a, b, c) = (pair[0], pair[1], order[bend]);
            let turned = self.orient(a, b, c) < 0.0;
            self.triangles.push(if turned { [b, a, c] } else { [a, b, c] });
        }
        for &p in &order[bend + 1..] {
            let edges: Vec<Edge> = self.edges().collect();
            let hull = edges.iter().filter(|[u, v]| !edges.contains(&[*v, *u]));
            let seen: Vec<Edge> =
                hull.copied().filter(|&[u, v]| self.orient(u, v, p) < 0.0).collect();
            self.triangles.extend(seen.into_iter().map(|[u, v]| [v, u, p]));
        }
    }

    fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        self.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
    }

    /// The place of the triangle to the left of an edge, and its third corner.
    fn left_of(&self, [u, v]: Edge) -> Option<(usize, usize)> {
        self.triangles.iter().enumerate().find_map(|(place, t)| {
            let i = (0..3).find(|&i| [t[i], t[(i + 1) % 3]] == [u, v])?;
            Some((place, t[(i + 2) % 3]))
        })
    }

    /// Exchanges the diagonal of two triangles, if they make a convex quadrilateral.
    fn flip(&mut self, [u, v]: Edge) -> bool {
        let (Some((one, p)), Some((other, q))) = (self.left_of([u, v]), self.left_of([v, u]))
        else {
            return false;
        };
        let convex = self.orient(q, v, p) > 0.0 && self.orient(p, u, q) > 0.0;
        if convex {
            (self.triangles[one], self.triangles[other]) = ([q, v, p], [p, u, q]);
        }
        convex
    }

    fn force(&mut self, [a, b]: Edge) {
        for _ in 0..FLIPS_MAX {
            if self.edges().any(|[u, v]| [u, v] == [a, b] || [v, u] == [a, b]) {
                break;
            }
            let crossing: Vec<Edge> =
                self.edges().filter(|&[u, v]| self.crosses([a, b], [u, v])).collect();
            if !crossing.into_iter().any(|edge| self.flip(edge)) {
                break;
            }
        }
        self.fixed.push([a, b]);
    }

    fn crosses(&self, [a, b]: Edge, [u, v]: Edge) -> bool {
        self.orient(a, b, u) * self.orient(a, b, v) < 0.0
            && self.orient(u, v, a) * self.orient(u, v, b) < 0.0
    }

    /// Lawson's flips, "up to rounding".
    fn legalize(&mut self) {
        for _ in 0..FLIPS_MAX {
            let edges: Vec<Edge> = self.edges().collect();
            let flipped = edges.into_iter().any(|[u, v]| {
                let fixed = self.fixed.contains(&[u, v]) || self.fixed.contains(&[v, u]);
                let deep = self
                    .left_of([u, v])
                    .zip(self.left_of([v, u]))
                    .is_some_and(|((_, p), (_, q))| self.in_circle([u, v, p], q) > EPSILON);
                !fixed && deep && self.flip([u, v])
            });
            if !flipped {
                return;
            }
        }
    }
}
