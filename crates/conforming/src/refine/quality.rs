//! Whether a triangle keeps the bounds.
//!
//! The least angle of a triangle is opposite its shortest edge. It is less than the bound if `(u . v)^2 > c |u|^2 |v|^2` for the
//! two edges u, v from there, c being the square of the bound's cosine. In doubles the two sides are off by a few roundings,
//! and by what rounded positions are off: where they are no further apart than that, exact numbers decide.

use delone_mesh::VertexId;
use delone_predicates::{Dyadic, Sign};

use super::centre::centre;
use super::{Centre, RefineOptions, SizeField};
use crate::apexes::Apexes;
use crate::live::{Live, Steiner, id};
use crate::split::squared_radius;

/// Relative, of a dozen roundings.
const ROUNDING: f64 = 1e-14;

/// Bits up to which radii are equal that are so but for the precision of parameters.
const EQUAL_BITS: i64 = 40;

/// What is wrong with a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Flaw {
    None,
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
}

impl<'a> Quality<'a> {
    pub(super) fn new(options: &RefineOptions<'a>) -> Self {
        let angle = options.angle_deg_min.clamp(0.0, 60.0).to_radians();
        let cosine_square = angle.cos().powi(2);
        let double = (2.0 * cosine_square - 1.0).max(0.0);
        Self {
            centre: options.centre,
            cosine_square,
            lens: double * double,
            cotangent: 1.0 / (angle / 2.0).tan(),
            area_max: options.area_max,
            size: options.size,
        }
    }

    /// What is wrong, and how urgent that is: less is more.
    pub(super) fn flaw(&self, live: &Live, corners: [VertexId; 3]) -> (Flaw, u64) {
        let [p, q, r] = from_shortest(live, corners);
        let [a, b, c] = [p, q, r].map(|v| live.kernel.position(id(v)));
        let (u, v) = (minus(a, c), minus(b, c));
        let (uu, vv, uv) = (dot(u, u), dot(v, v), dot(u, v));
        let shortest = dot(minus(b, a), minus(b, a));
        let (left, right) = (uv * uv, self.cosine_square * uu * vv);
        let is_rounded = [p, q, r].iter().any(|&v| !live.kernel.is_exact_position(id(v)));
        let mut slack = ROUNDING;
        if is_rounded {
            let far = [a, b, c].as_flattened().iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            slack += 32.0 * f64::EPSILON * far / shortest.sqrt();
        }
        let is_clear = (left - right).abs() > slack * uu * vv && slack < 0.01 && right.is_normal();
        let urgency = urgency(shortest, (uu * vv / (uv * uv) - 1.0).max(0.0));
        let is_skinny = if is_clear {
            left > right && uv > 0.0
        } else {
            // Which edge is shortest may be in doubt as well.
            [[p, q, r], [q, r, p], [r, p, q]].into_iter().any(|at| self.is_skinny(at, live))
        };
        if is_skinny {
            return (Flaw::Skinny, urgency);
        }
        let area = 0.5 * (u[0] * v[1] - u[1] * v[0]).abs();
        if area > self.area_max {
            return (Flaw::Large, urgency);
        }
        let is_long = self.size.is_some_and(|size| {
            let third = |axis: usize| (a[axis] + b[axis] + c[axis]) / 3.0;
            let longest = uu.max(vv).max(shortest);
            longest.sqrt() > size([third(0), third(1)])
        });
        (if is_long { Flaw::Large } else { Flaw::None }, urgency)
    }

    /// Whether the angle at the last corner is less than the bound, exactly.
    fn is_skinny(&self, corners: [VertexId; 3], live: &Live) -> bool {
        if self.cosine_square >= 1.0 {
            return false;
        }
        let [a, b, c] = corners.map(|v| live.kernel.exact(id(v)).x);
        let from = |p: [Dyadic; 2]| {
            let [x, y] = p;
            [x - &c[0], y - &c[1]]
        };
        let (u, v) = (from(a), from(b));
        let dot = |p: &[Dyadic; 2], q: &[Dyadic; 2]| &p[0] * &q[0] + &p[1] * &q[1];
        let uv = dot(&u, &v);
        let squares = &dot(&u, &u) * &dot(&v, &v);
        let over = &uv * &uv - &squares * &Dyadic::from(self.cosine_square);
        uv.sign() == Sign::Positive && over.sign() == Sign::Positive
    }

    /// Whether a vertex sees a piece at so wide an angle that it encroaches. Doubles steer.
    pub(super) fn is_in_lens(&self, live: &Live, v: VertexId, ends: [VertexId; 2]) -> bool {
        let v = live.kernel.position(id(v));
        let [a, b] = ends.map(|end| minus(live.kernel.position(id(end)), v));
        let ab = dot(a, b);
        ab < 0.0 && ab * ab >= self.lens * dot(a, a) * dot(b, b)
    }

    /// Where to put a vertex to destroy a triangle.
    pub(super) fn centre(&self, live: &Live, corners: [VertexId; 3]) -> Option<[f64; 2]> {
        let corners = from_shortest(live, corners).map(|v| live.kernel.position(id(v)));
        centre(corners, self.centre, self.cotangent)
    }

    /// Whether the shortest edge joins two segments of an apex, at one distance from it: no point makes the angle larger.
    pub(super) fn subtends_input_angle(
        &self,
        live: &Live,
        apexes: &Apexes,
        corners: [VertexId; 3],
    ) -> bool {
        let [p, q, r] = from_shortest(live, corners);
        let [on_p, on_q] = [p, q].map(|v| live.steiner_of(v));
        match (on_p, on_q) {
            (Some(&Steiner::On { segment, ref t }), _) => meet(live, apexes, (segment, t), q),
            (_, Some(&Steiner::On { segment, ref t })) => meet(live, apexes, (segment, t), p),
            (None, None) => {
                let lengths = [p, q].map(|v| {
                    live.segment_between([r, v]).map(|segment| live.squared_length(segment))
                });
                let [Some(of_p), Some(of_q)] = lengths else { return false };
                apexes.bits(r).is_some() && nearly_equal(&of_p, &of_q)
            }
            _ => false,
        }
    }
}

/// Short edges first, up to a factor of two of their squares; among those, small angles first, by their squared tangent. Either
/// alone takes more vertices: the first on curves, the second where edges of all lengths meet.
fn urgency(shortest: f64, tangent_square: f64) -> u64 {
    // The bits of doubles that are not negative are in their order; the exponent is above 52 of mantissa.
    shortest.to_bits() >> 52 << 52 | tangent_square.to_bits() >> 12
}

/// Whether a vertex is as far from an apex of a segment as the point of that parameter, on another segment of it.
fn meet(live: &Live, apexes: &Apexes, (segment, t): (u32, &Dyadic), v: VertexId) -> bool {
    [0, 1].into_iter().any(|end| {
        let apex = VertexId::new(live.segments[segment as usize][end] as usize);
        if apexes.bits(apex).is_none() {
            return false;
        }
        let Some(other) = squared_radius(live, segment, apex, v) else { return false };
        let t = if end == 0 { t.clone() } else { Dyadic::from(1) - t };
        nearly_equal(&(&(&t * &t) * &live.squared_length(segment)), &other)
    })
}

/// Whether two squared radii are one up to the precision of parameters.
fn nearly_equal(a: &Dyadic, b: &Dyadic) -> bool {
    let difference = a.clone() - b;
    match (difference.magnitude(), a.magnitude()) {
        (Some(off), Some(of)) => off < of - EQUAL_BITS,
        _ => true,
    }
}

/// The corners in their order, the shortest edge being that from the first to the second.
fn from_shortest(live: &Live, [a, b, c]: [VertexId; 3]) -> [VertexId; 3] {
    let [p, q, r] = [a, b, c].map(|v| live.kernel.position(id(v)));
    let square = |p: [f64; 2], q: [f64; 2]| dot(minus(q, p), minus(q, p));
    let (ab, bc, ca) = (square(p, q), square(q, r), square(r, p));
    if ab <= bc && ab <= ca {
        [a, b, c]
    } else if bc <= ca {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

fn minus(p: [f64; 2], q: [f64; 2]) -> [f64; 2] {
    [p[0] - q[0], p[1] - q[1]]
}

fn dot(u: [f64; 2], v: [f64; 2]) -> f64 {
    u[0] * v[0] + u[1] * v[1]
}
