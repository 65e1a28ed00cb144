//! Random points inside a triangulated region, and along its segments.
//!
//! Triangles are chosen by their areas in doubles; a point drawn in one is rounded, and kept if it is exactly inside or on the
//! boundary of that triangle: no sample is outside of the region.

use delone_formats::Document;
use delone_predicates::{Sign, orient2d};
use delone_workloads::Rng;

use crate::cli::Method;

/// A region of some area.
pub(crate) struct Inside {
    triangles: Vec<[[f64; 2]; 3]>,
    segments: Vec<[[f64; 2]; 2]>,
    /// Sums of areas and of lengths, each with the one of its own last.
    areas: Vec<f64>,
    lengths: Vec<f64>,
}

fn sums(sizes: impl Iterator<Item = f64>) -> Vec<f64> {
    sizes
        .scan(0.0, |sum, size| {
            *sum += size;
            Some(*sum)
        })
        .collect()
}

/// Which of these sums a random number falls below.
fn choose(sums: &[f64], rng: &mut Rng) -> Option<usize> {
    let at = rng.unit() * sums.last()?;
    Some(sums.partition_point(|&sum| sum <= at).min(sums.len() - 1))
}

fn between(a: [f64; 2], b: [f64; 2], t: f64) -> [f64; 2] {
    [0, 1].map(|axis| a[axis] * (1.0 - t) + b[axis] * t)
}

impl Inside {
    /// The triangles of a document, and its segments; `None` if they have no area.
    pub(crate) fn new(document: &Document) -> Option<Self> {
        let points = document.points.as_chunks::<2>().0;
        let at = |v: u32| points[v as usize];
        let triangles: Vec<[[f64; 2]; 3]> = document.triangles.iter().map(|t| t.map(at)).collect();
        let segments: Vec<[[f64; 2]; 2]> = document.segments.iter().map(|s| s.map(at)).collect();
        let doubled = |[a, b, c]: &[[f64; 2]; 3]| {
            ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
        };
        let areas = sums(triangles.iter().map(doubled));
        let lengths = sums(segments.iter().map(|[a, b]| (b[0] - a[0]).hypot(b[1] - a[1])));
        areas.last().is_some_and(|&sum| sum > 0.0 && sum.is_finite()).then_some(Self {
            triangles,
            segments,
            areas,
            lengths,
        })
    }

    pub(crate) fn sample(&self, method: Method, n: usize, seed: u64) -> Vec<[f64; 2]> {
        let rng = &mut Rng::named("sample", seed);
        match method {
            Method::Uniform => self.uniform(rng).take(n).collect(),
            Method::Boundary => (0..n).filter_map(|_| self.on_boundary(rng)).collect(),
            Method::Jittered => self.jittered(n, rng),
            Method::Poisson => self.poisson(n, rng),
        }
    }

    /// The side of a square whose area is an n-th of the region's.
    fn spacing(&self, n: usize) -> f64 {
        let count = f64::from(u32::try_from(n).unwrap_or(u32::MAX).max(1));
        (self.areas.last().copied().unwrap_or(0.0) / 2.0 / count).sqrt()
    }

    fn uniform(&self, rng: &mut Rng) -> impl Iterator<Item = [f64; 2]> {
        std::iter::from_fn(|| {
            // Of points drawn in a triangle that is no sliver nearly all are in it: a thousand failures have no chance.
            (0..1000).find_map(|_| {
                let triangle = self.triangles[choose(&self.areas, rng)?];
                let (s, t) = (rng.unit(), rng.unit());
                let (s, t) = if s + t > 1.0 { (1.0 - s, 1.0 - t) } else { (s, t) };
                let [a, b, c] = triangle;
                let p = [0, 1].map(|x| a[x] + s * (b[x] - a[x]) + t * (c[x] - a[x]));
                is_in(&triangle, p).then_some(p)
            })
        })
    }

    fn on_boundary(&self, rng: &mut Rng) -> Option<[f64; 2]> {
        let [a, b] = self.segments[choose(&self.lengths, rng)?];
        Some(between(a, b, rng.unit()))
    }

    /// A random point in each square of a lattice, if it is inside.
    fn jittered(&self, n: usize, rng: &mut Rng) -> Vec<[f64; 2]> {
        let step = self.spacing(n);
        let corners = self.triangles.as_flattened();
        let low = [0, 1].map(|x| corners.iter().map(|p| p[x]).fold(f64::INFINITY, f64::min));
        let high = [0, 1].map(|x| corners.iter().map(|p| p[x]).fold(f64::NEG_INFINITY, f64::max));
        let mut points = Vec::new();
        let mut y = low[1];
        while y < high[1] {
            let mut x = low[0];
            while x < high[0] {
                let p = [x + step * rng.unit(), y + step * rng.unit()];
                if self.triangles.iter().any(|triangle| is_in(triangle, p)) {
                    points.push(p);
                }
                x += step;
            }
            y += step;
        }
        points
    }

    /// Darts, of which those are kept that are at least so far from all before: thirty for each point wanted.
    fn poisson(&self, n: usize, rng: &mut Rng) -> Vec<[f64; 2]> {
        // Random darts pack until disks of half the distance cover about 0.547 of the plane.
        let distance = self.spacing(n) * (0.547f64 * 4.0 / std::f64::consts::PI).sqrt();
        let mut cells: std::collections::BTreeMap<[i64; 2], Vec<[f64; 2]>> = Default::default();
        #[expect(clippy::cast_possible_truncation, reason = "a cast saturates: far cells are one")]
        let cell = |p: [f64; 2]| p.map(|x| (x / distance).floor() as i64);
        let mut points: Vec<[f64; 2]> = Vec::new();
        for p in self.uniform(rng).take(n.saturating_mul(30)) {
            let [i, j] = cell(p);
            let is_near = |q: &[f64; 2]| (q[0] - p[0]).hypot(q[1] - p[1]) < distance;
            let around = (-1..=1)
                .flat_map(|x| (-1..=1).map(move |y| [i.saturating_add(x), j.saturating_add(y)]));
            let mut around = around.filter_map(|cell| cells.get(&cell)).flatten();
            if !around.any(is_near) {
                points.push(p);
                cells.entry([i, j]).or_default().push(p);
            }
        }
        points
    }
}

/// Whether a point is in a triangle or on its boundary.
fn is_in(&[a, b, c]: &[[f64; 2]; 3], p: [f64; 2]) -> bool {
    let turn = orient2d(a, b, c);
    [[a, b], [b, c], [c, a]].iter().all(|&[q, r]| {
        let side = orient2d(q, r, p);
        side == turn || side == Sign::Zero
    })
}
