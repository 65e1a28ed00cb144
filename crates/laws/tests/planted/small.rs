//! A small triangulator with faults to choose from: Bowyer and Watson's insertion over a list of triangles, then segments by
//! flips. Slow, and right where [`Fault::None`] is asked for.

use delone::predicates::{Adaptive, Kernel, Naive, PlaneKernel, Side, Sign};

/// What is wrong with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// Nothing.
    None,
    /// Orientations in doubles.
    RoundedOrient,
    /// In-circle tests in doubles.
    RoundedInCircle,
    /// A filter whose bound is 64 times too small.
    ShortFilter,
    /// A point on an edge of the hull is not in conflict with its ghost.
    HullEdgeIgnored,
    /// A point in line with an edge of the hull is in conflict with its ghost, wherever it is.
    GhostsClosed,
    /// The first three points are taken for a triangle.
    FirstThree,
    /// Points closer than 1e-12 are one.
    MergesNear,
    /// Beyond 1e77 in-circle tests overflow, and say no.
    Overflows,
    /// Denormals are zero.
    FlushesDenormals,
    /// Coordinates are read as single precision.
    SinglePrecision,
    /// 0.0 and -0.0 are two points.
    ZerosDiffer,
    /// Cocircular ties go by index.
    TiesByIndex,
    /// On the circle is inside.
    TiesInside,
    /// Of seven points or more, the last is lost.
    LastOfSeven,
    /// A segment through a vertex is lost.
    ThroughVertexLost,
    /// Restoring the Delaunay property flips constraints as well.
    FlipsConstraints,
    /// After a segment is in, nothing is restored.
    NeverRestores,
    /// There is room for six segments.
    SixSegments,
}

const GHOST: usize = usize::MAX;
/// More flips than any input of a few points needs.
const FLIPS_MAX: usize = 20_000;

/// The triangles, counter-clockwise.
pub(crate) fn triangulate(
    points: &[[f64; 2]],
    segments: &[[u32; 2]],
    fault: Fault,
) -> Vec<[usize; 3]> {
    let seen = points.iter().map(|p| p.map(|x| misread(x, fault))).collect::<Vec<_>>();
    let mut small = Small { points: &seen, fault, triangles: Vec::new(), constrained: Vec::new() };
    let names = small.names();
    let mut order: Vec<usize> = (0..points.len()).filter(|&v| names[v] == v).collect();
    if fault == Fault::LastOfSeven && order.len() >= 7 {
        order.pop();
    }
    small.start(&mut order);
    order.into_iter().for_each(|v| small.insert(v));
    let room = if fault == Fault::SixSegments { 6 } else { usize::MAX };
    for ends in segments.iter().take(room) {
        small.constrain(ends.map(|v| names[v as usize]));
    }
    small.triangles.retain(|t| !t.contains(&GHOST));
    small.triangles
}

fn misread(x: f64, fault: Fault) -> f64 {
    match fault {
        #[expect(clippy::cast_possible_truncation, reason = "this is the fault")]
        Fault::SinglePrecision => f64::from(x as f32).clamp(f64::MIN, f64::MAX),
        Fault::FlushesDenormals if x.is_subnormal() => 0.0,
        _ => x,
    }
}

struct Small<'p> {
    points: &'p [[f64; 2]],
    fault: Fault,
    triangles: Vec<[usize; 3]>,
    constrained: Vec<[usize; 2]>,
}

impl Small<'_> {
    /// For each point the first one that it equals.
    fn names(&self) -> Vec<usize> {
        let equal = |p: [f64; 2], q: [f64; 2]| match self.fault {
            Fault::MergesNear => (0..2).all(|i| (p[i] - q[i]).abs() < 1e-12),
            Fault::ZerosDiffer => p.map(f64::to_bits) == q.map(f64::to_bits),
            _ => p == q,
        };
        let first = |v: usize| (0..v).find(|&u| equal(self.points[u], self.points[v]));
        (0..self.points.len()).map(|v| first(v).unwrap_or(v)).collect()
    }

    fn orient(&self, a: usize, b: usize, c: usize) -> Sign {
        if self.fault == Fault::RoundedOrient {
            return Naive::new(self.points).orient(&[a, b, c]);
        }
        if self.fault == Fault::ShortFilter {
            let [p, q, r] = [a, b, c].map(|v| self.points[v]);
            let (left, right) = ((p[0] - r[0]) * (q[1] - r[1]), (p[1] - r[1]) * (q[0] - r[0]));
            let bound = (left.abs() + right.abs()) * f64::EPSILON * 1.5 / 64.0;
            if (left - right).abs() > bound {
                return Sign::of(left - right);
            }
        }
        Adaptive::new(self.points).orient(&[a, b, c])
    }

    fn is_inside(&self, [a, b, c]: [usize; 3], q: usize) -> bool {
        let exact = Adaptive::new(self.points);
        let sign = match self.fault {
            Fault::RoundedInCircle => Naive::new(self.points).lifted(&[a, b, c], q),
            Fault::Overflows if [a, b, c, q].iter().any(|&v| self.is_huge(v)) => Sign::Negative,
            _ => exact.lifted(&[a, b, c], q),
        };
        match (sign, self.fault) {
            (Sign::Positive, _) | (Sign::Zero, Fault::TiesInside) => true,
            (Sign::Negative, _) => false,
            (Sign::Zero, Fault::TiesByIndex) => q < a.min(b).min(c),
            (Sign::Zero, _) => exact.in_sphere(&[a, b, c], q) == Side::Positive,
        }
    }

    fn is_huge(&self, v: usize) -> bool {
        self.points[v].iter().any(|x| x.abs() > 1e77)
    }

    /// The first triangle, of points taken out of `order`, and its ghosts.
    fn start(&mut self, order: &mut Vec<usize>) {
        let (a, b) = (order[0], order[1]);
        let third = (2..order.len()).find(|&i| {
            self.fault == Fault::FirstThree || self.orient(a, b, order[i]) != Sign::Zero
        });
        let c = order.remove(third.expect("the points are not all in line"));
        order.drain(..2);
        let [a, b] = if self.orient(a, b, c) == Sign::Negative { [b, a] } else { [a, b] };
        self.triangles = vec![[a, b, c], [b, a, GHOST], [c, b, GHOST], [a, c, GHOST]];
    }

    fn in_conflict(&self, [a, b, c]: [usize; 3], p: usize) -> bool {
        if c != GHOST {
            return self.is_inside([a, b, c], p);
        }
        match self.orient(a, b, p) {
            Sign::Positive => true,
            Sign::Negative => false,
            Sign::Zero => match self.fault {
                Fault::HullEdgeIgnored => false,
                Fault::GhostsClosed => true,
                _ => self.is_between(a, b, p),
            },
        }
    }

    /// Whether `p`, in line with `a` and `b`, is between them.
    fn is_between(&self, a: usize, b: usize, p: usize) -> bool {
        let kernel = Adaptive::new(self.points);
        let order = kernel.compare_lexicographic(a, p);
        order.is_ne() && order == kernel.compare_lexicographic(p, b)
    }

    fn insert(&mut self, p: usize) {
        let (dug, kept): (Vec<_>, Vec<_>) =
            self.triangles.iter().partition(|&&t| self.in_conflict(t, p));
        let sides = |t: &[usize; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
        let inner: Vec<[usize; 2]> = dug.iter().flat_map(sides).collect();
        self.triangles = kept;
        for &[u, v] in inner.iter().filter(|[u, v]| !inner.contains(&[*v, *u])) {
            self.triangles.push(if u == GHOST {
                [v, p, GHOST]
            } else if v == GHOST {
                [p, u, GHOST]
            } else {
                [u, v, p]
            });
        }
    }

    /// Puts a segment in, in pieces between the vertices on it.
    fn constrain(&mut self, [a, b]: [usize; 2]) {
        let mut on: Vec<usize> = self.vertices();
        on.retain(|&v| v != a && v != b && self.orient(a, b, v) == Sign::Zero);
        on.retain(|&v| self.is_between(a, b, v));
        if a == b || (self.fault == Fault::ThroughVertexLost && !on.is_empty()) {
            return;
        }
        on.extend([a, b]);
        let kernel = Adaptive::new(self.points);
        on.sort_by(|&u, &v| kernel.compare_lexicographic(u, v));
        for piece in on.windows(2) {
            self.force([piece[0], piece[1]]);
            self.constrained.push([piece[0], piece[1]]);
        }
        if self.fault != Fault::NeverRestores {
            self.restore();
        }
    }

    fn vertices(&self) -> Vec<usize> {
        let mut all: Vec<usize> = self.triangles.as_flattened().to_vec();
        all.sort_unstable();
        all.dedup();
        all.retain(|&v| v != GHOST);
        all
    }

    /// Flips what crosses an edge until it is there.
    fn force(&mut self, [a, b]: [usize; 2]) {
        let mut flips = 0;
        while !self.edges().any(|e| e == [a, b]) {
            let kernel = Adaptive::new(self.points);
            let crosses = |[u, v]: [usize; 2]| {
                ![u, v].contains(&a)
                    && ![u, v].contains(&b)
                    && kernel.orient(&[a, b, u]) * kernel.orient(&[a, b, v]) == Sign::Negative
                    && kernel.orient(&[u, v, a]) * kernel.orient(&[u, v, b]) == Sign::Negative
            };
            let crossing: Vec<[usize; 2]> = self.edges().filter(|&e| crosses(e)).collect();
            let convex: Vec<[usize; 2]> =
                crossing.iter().copied().filter(|&e| self.can_flip(e)).collect();
            assert!(!convex.is_empty() && flips < FLIPS_MAX, "a crossed edge can be flipped");
            self.flip(convex[flips % convex.len()]);
            flips += 1;
        }
    }

    /// All edges of solid triangles, as their triangles have them.
    fn edges(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let solid = self.triangles.iter().filter(|t| !t.contains(&GHOST));
        solid.flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a], [b, a], [c, b], [a, c]])
    }

    /// The vertex to the left of an edge, and its triangle's place.
    fn left_of(&self, [u, v]: [usize; 2]) -> Option<(usize, usize)> {
        self.triangles.iter().enumerate().find_map(|(place, t)| {
            let corner = (0..3).find(|&i| [t[i], t[(i + 1) % 3]] == [u, v])?;
            let apex = t[(corner + 2) % 3];
            (!t.contains(&GHOST)).then_some((apex, place))
        })
    }

    fn can_flip(&self, [u, v]: [usize; 2]) -> bool {
        let (Some((p, _)), Some((q, _))) = (self.left_of([u, v]), self.left_of([v, u])) else {
            return false;
        };
        let kernel = Adaptive::new(self.points);
        kernel.cross([u, v, q, p]) == Sign::Positive
            && kernel.orient(&[q, v, p]) == Sign::Positive
            && kernel.orient(&[p, u, q]) == Sign::Positive
    }

    fn flip(&mut self, [u, v]: [usize; 2]) {
        let (p, one) = self.left_of([u, v]).expect("it can be flipped");
        let (q, other) = self.left_of([v, u]).expect("it can be flipped");
        (self.triangles[one], self.triangles[other]) = ([q, v, p], [p, u, q]);
    }

    /// Lawson's flips.
    fn restore(&mut self) {
        for _ in 0..FLIPS_MAX {
            let illegal = self.edges().find(|&[u, v]| {
                let fixed = self.constrained.iter().any(|e| *e == [u, v] || *e == [v, u]);
                (!fixed || self.fault == Fault::FlipsConstraints)
                    && self.can_flip([u, v])
                    && self
                        .left_of([u, v])
                        .zip(self.left_of([v, u]))
                        .is_some_and(|((p, _), (q, _))| self.is_inside([u, v, p], q))
            });
            let Some(edge) = illegal else { return };
            self.flip(edge);
        }
        panic!("flips end");
    }
}
