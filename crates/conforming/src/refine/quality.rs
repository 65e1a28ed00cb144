//! Whether a triangle keeps the bounds.
//!
//! The least angle of a triangle is opposite its shortest edge. It is less than the bound if `(u . v)^2 > c |u|^2 |v|^2` for the
//! two edges u, v from there, c being the square of the bound's cosine. In doubles the two sides are off by a few roundings,
//! and by what rounded positions are off: where they are no further apart than that, exact numbers decide.

use delone_mesh::VertexId;
use delone_predicates::{Constructed, Dyadic, Sign};

use super::centre::{centre, exact_centre};
use super::queue::Urgency;
use super::{Centre, RefineOptions, SizeField};
use crate::live::{Live, id};
use crate::vector::{self, Vector, between};

/// Relative, of a dozen roundings.
pub(super) const ROUNDING: f64 = 1e-14;

/// What is further off than this is off for certain, if edges are not too short.
const CLEAR: f64 = 1e-6;

/// Where doubles are fine enough for a place near the shortest edge, 64 times what they are off by is less than this part of that.
const FINE: f64 = 0.25;

/// What is wrong with a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Flaw {
    Skinny,
    Large,
}

/// The bounds.
pub(super) struct Quality<'a> {
    centre: Centre,
    /// The square of the cosine of the least angle.
    pub(super) cosine_square: f64,
    /// The cosine of twice the least angle, squared; 1 if this is 45 degrees or more.
    lens: f64,
    cotangent: f64,
    area_max: f64,
    size: Option<SizeField<'a>>,
    /// Whether areas or edges are bounded at all.
    bounds_size: bool,
    /// By how much rounded positions put off products of edges, relative, and times the shortest edge.
    rounding: f64,
    /// The square of the shortest edge at which that is less than half of what is clear.
    clear_from: f64,
    /// The square of the shortest edge at which doubles are fine enough for places near it.
    fine_from: f64,
}

impl<'a> Quality<'a> {
    /// For vertices of coordinates up to `far` in magnitude.
    pub(super) fn new(options: &RefineOptions<'a>, far: f64) -> Self {
        let angle = options.angle_deg_min.clamp(0.0, 60.0).to_radians();
        let cosine_square = options.cosine_square();
        let rounding = 32.0 * f64::EPSILON * far;
        let double = (2.0 * cosine_square - 1.0).max(0.0);
        Self {
            centre: options.centre,
            cosine_square,
            lens: double * double,
            cotangent: 1.0 / (angle / 2.0).tan(),
            area_max: options.area_max,
            size: options.size,
            bounds_size: options.area_max < f64::INFINITY || options.size.is_some(),
            rounding,
            clear_from: (rounding / (0.5 * CLEAR)).powi(2),
            fine_from: (rounding / FINE).powi(2),
        }
    }

    /// What is wrong, if anything, and how urgent that is.
    #[inline]
    pub(super) fn flaw(&self, live: &Live, corners: [VertexId; 3]) -> Option<(Flaw, Urgency)> {
        let at = live.positions(corners);
        let [shortest, middle, longest] = sorted_squares(at);
        let (left, squares) = cosines([shortest, middle, longest]);
        let right = self.cosine_square * squares;
        // Far from the bound, and of edges long enough.
        let is_far = (left - right).abs() > CLEAR * squares && right.is_normal();
        let is_skinny = if is_far && shortest > self.clear_from {
            left > right
        } else {
            self.is_nearly_skinny(live, corners)
        };
        let flaw = if is_skinny {
            Flaw::Skinny
        } else if self.bounds_size && self.is_large(live, corners, shortest, longest) {
            Flaw::Large
        } else {
            return None;
        };
        Some((flaw, Urgency::new(shortest, (squares / left - 1.0).max(0.0))))
    }

    /// Whether the least angle is less than the bound, where it is near.
    #[inline(never)]
    fn is_nearly_skinny(&self, live: &Live, corners: [VertexId; 3]) -> bool {
        let shape = Shape::new(live.positions(corners));
        let Shape { uv, squares, .. } = shape;
        let (left, right) = (uv * uv, self.cosine_square * squares);
        let is_clear = |slack: f64| {
            (left - right).abs() > slack * squares && slack < 0.01 && right.is_normal()
        };
        // As if they were rounded; only where that does not decide, whether they are.
        let wide = ROUNDING + self.rounding / shape.shortest.sqrt();
        let is_exact = || corners.iter().all(|&v| live.kernel.is_exact_position(id(v)));
        if is_clear(wide) || is_exact() && is_clear(ROUNDING) {
            return left > right && uv > 0.0;
        }
        let squares = near_edges(&live.kernel, corners).map(|edge| dot(edge, edge));
        let (left, squares) = cosines(sorted(squares));
        let right = self.cosine_square * squares;
        if (left - right).abs() > ROUNDING * squares && right.is_normal() {
            return left > right;
        }
        // Which edge is shortest may be in doubt as well.
        let [p, q, r] = corners;
        [[p, q, r], [q, r, p], [r, p, q]].into_iter().any(|at| self.is_less(at, live))
    }

    /// Of a triangle whose shortest and longest edges have these squares.
    #[inline(never)]
    fn is_large(&self, live: &Live, corners: [VertexId; 3], shortest: f64, longest: f64) -> bool {
        let at = live.positions(corners);
        let (u, v) = (minus(at[1], at[0]), minus(at[2], at[0]));
        let (mut area, mut longest) = (0.5 * (u[0] * v[1] - u[1] * v[0]).abs(), longest);
        if shortest <= self.clear_from || !longest.is_finite() {
            (area, longest) = exact_sizes(live, corners);
        }
        area > self.area_max
            || self.size.is_some_and(|size| {
                let third = |axis: usize| (at[0][axis] + at[1][axis] + at[2][axis]) / 3.0;
                longest.sqrt() > size([third(0), third(1)])
            })
    }

    /// Whether the angle at the last corner is less than the bound, exactly.
    fn is_less(&self, corners: [VertexId; 3], live: &Live) -> bool {
        if self.cosine_square >= 1.0 {
            return false;
        }
        let [a, b, c] = corners;
        let [uv, over] = products([c, a, b], self.cosine_square, live);
        uv == Sign::Positive && over == Sign::Positive
    }

    /// Whether a vertex sees a piece at so wide an angle that it encroaches.
    pub(super) fn is_in_lens(&self, live: &Live, v: VertexId, ends: [VertexId; 2]) -> bool {
        let at = |v: VertexId| live.kernel.position(id(v));
        let [a, b] = ends.map(|end| minus(at(end), at(v)));
        let (aa, bb, ab) = (dot(a, a), dot(b, b), dot(a, b));
        let (left, right) = (ab * ab, self.lens * aa * bb);
        let slack = ROUNDING + self.rounding / aa.min(bb).sqrt();
        if (left - right).abs() > slack * aa * bb && slack < 0.01 && aa * bb > 1e-280 {
            return ab < 0.0 && left > right;
        }
        let [ab, over] = products([v, ends[0], ends[1]], self.lens, live);
        ab == Sign::Negative && over != Sign::Negative
    }

    /// Makes the place for a vertex that destroys a triangle the last vertex of the kernel.
    pub(super) fn push_centre(&self, live: &mut Live, corners: [VertexId; 3]) -> Option<VertexId> {
        let corners = self.shortest_first(live, corners);
        let at = live.positions(corners);
        let is_fine = self.is_fine(square(at[0], at[1]));
        let near = is_fine.then(|| centre(at, self.centre, self.cotangent)).flatten();
        let p = if let Some(near) = near {
            live.kernel.push_plain(near)
        } else {
            let at = corners.map(|v| live.kernel.exact(id(v)).x);
            live.kernel.push_exact(exact_centre(&at, self.centre, self.cotangent)?)
        };
        Some(VertexId::new(p as usize))
    }

    /// Whether positions are off by far less than a shortest edge of this square; not where that under- or overflows.
    #[inline]
    fn is_fine(&self, shortest: f64) -> bool {
        shortest > self.fine_from && shortest.is_normal()
    }

    /// The corners in their order, the shortest edge being that from the first to the second.
    pub(super) fn shortest_first(&self, live: &Live, corners: [VertexId; 3]) -> [VertexId; 3] {
        let at = live.positions(corners);
        let first = shortest_edge(at);
        let [p, q, _] = rotated(at, first);
        if self.is_fine(square(p, q)) {
            return rotated(corners, first);
        }
        let squares = exact_edges(&live.kernel, corners).map(|edge| vector::square(&edge));
        rotated(corners, shortest_of(squares))
    }
}

/// The edges from each corner to the next, exactly.
fn exact_edges(kernel: &Constructed<2>, corners: [VertexId; 3]) -> [Vector; 3] {
    let [a, b, c] = corners.map(|v| kernel.exact(id(v)).x);
    [between(&a, &b), between(&b, &c), between(&c, &a)]
}

/// The same over about the longest, each to the nearest doubles.
pub(super) fn near_edges(kernel: &Constructed<2>, corners: [VertexId; 3]) -> [[f64; 2]; 3] {
    let exact = exact_edges(kernel, corners);
    let top = exact.as_flattened().iter().filter_map(Dyadic::magnitude).max().unwrap_or(0);
    exact.map(|edge| edge.map(|x| x.scaled(-top).to_f64()))
}

/// The area and the square of the longest edge, to the nearest doubles.
fn exact_sizes(live: &Live, corners: [VertexId; 3]) -> (f64, f64) {
    let edges = exact_edges(&live.kernel, corners);
    let area = vector::cross(&edges[0], &edges[1]).half().to_f64().abs();
    let longest = edges.iter().map(|edge| vector::square(edge).to_f64()).fold(0.0, f64::max);
    (area, longest)
}

/// The signs of `u . v` and of `(u . v)^2 - c |u|^2 |v|^2` for the edges u, v from the first vertex to the two others, exactly.
pub(super) fn products(vertices: [VertexId; 3], c: f64, live: &Live) -> [Sign; 2] {
    let [z, a, b] = vertices.map(|v| live.kernel.exact(id(v)).x);
    let (u, v) = (between(&z, &a), between(&z, &b));
    let uv = vector::dot(&u, &v);
    let squares = &vector::square(&u) * &vector::square(&v);
    let over = &uv * &uv - &squares * &Dyadic::from(c);
    [uv.sign(), over.sign()]
}

/// A triangle in doubles: the products of the two edges u and v from the corner that is opposite the shortest one.
struct Shape {
    uv: f64,
    /// |u|^2 |v|^2
    squares: f64,
    /// The squared length of the shortest.
    shortest: f64,
}

impl Shape {
    #[inline]
    fn new(at: [[f64; 2]; 3]) -> Self {
        let [a, b, c] = rotated(at, shortest_edge(at));
        let (u, v, w) = (minus(a, c), minus(b, c), minus(b, a));
        Self { uv: dot(u, v), squares: dot(u, u) * dot(v, v), shortest: dot(w, w) }
    }
}

/// The squared lengths of a triangle's edges, in increasing order.
#[inline(always)]
fn sorted_squares([p, q, r]: [[f64; 2]; 3]) -> [f64; 3] {
    sorted([square(p, q), square(q, r), square(r, p)])
}

#[inline(always)]
fn sorted([first, second, third]: [f64; 3]) -> [f64; 3] {
    let sorted = |a: f64, b: f64| if b < a { (b, a) } else { (a, b) };
    let (low, high) = sorted(first, second);
    let (low, third) = sorted(low, third);
    let (middle, high) = sorted(third, high);
    [low, middle, high]
}

/// `(2 u . v)^2` and `4 |u|^2 |v|^2` of the two longer edges, by the law of cosines, from the squared lengths of all three. Nothing cancels, the
/// shortest being at most either: of positive numbers, all is off by a few roundings.
#[inline(always)]
fn cosines([shortest, middle, longest]: [f64; 3]) -> (f64, f64) {
    let twice_uv = middle + (longest - shortest);
    (twice_uv * twice_uv, 4.0 * middle * longest)
}

/// From which corner, to the next one, the shortest edge of a triangle runs.
#[inline]
fn shortest_edge([p, q, r]: [[f64; 2]; 3]) -> usize {
    shortest_of([square(p, q), square(q, r), square(r, p)])
}

/// The first of the smallest.
#[inline]
fn shortest_of<T: PartialOrd>([pq, qr, rp]: [T; 3]) -> usize {
    if pq <= qr && pq <= rp {
        0
    } else if qr <= rp {
        1
    } else {
        2
    }
}

#[inline]
fn rotated<T: Copy>([a, b, c]: [T; 3], first: usize) -> [T; 3] {
    match first {
        0 => [a, b, c],
        1 => [b, c, a],
        _ => [c, a, b],
    }
}

#[inline(always)]
fn square(p: [f64; 2], q: [f64; 2]) -> f64 {
    dot(minus(q, p), minus(q, p))
}

#[inline(always)]
pub(super) fn minus(p: [f64; 2], q: [f64; 2]) -> [f64; 2] {
    [p[0] - q[0], p[1] - q[1]]
}

#[inline(always)]
pub(super) fn dot(u: [f64; 2], v: [f64; 2]) -> f64 {
    u[0] * v[0] + u[1] * v[1]
}
