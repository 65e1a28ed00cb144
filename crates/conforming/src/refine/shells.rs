//! Triangles that only a small angle of the input makes skinny: their shortest edge joins two segments that meet at less than 60
//! degrees, at one distance from where they meet. No vertex makes that angle larger (\[MPW03\]).

use delone_mesh::VertexId;
use delone_predicates::{Dyadic, Sign};

use super::quality::{ROUNDING, dot, minus, products};
use crate::apexes::Apexes;
use crate::live::{Live, Steiner, id};
use crate::parameter::Parameter;
use crate::split::{radius, squared_radius};

/// Bits up to which squared radii are equal that are so but for the precision of parameters ([`crate::apexes`]).
const EQUAL_BITS: u32 = 26;

/// The same as a part of a squared radius.
const EQUAL: f64 = 1.0 / (1u64 << EQUAL_BITS) as f64;

/// More than the relative difference of squared radii that agree in so many bits.
const NEARLY: f64 = 2.0 * EQUAL;

/// Whether the shortest edge of a triangle, from its first corner to its second, joins two segments of an apex, at one distance from it: no point
/// makes the angle larger.
pub(super) fn subtends_input_angle(live: &Live, apexes: &Apexes, [p, q, r]: [VertexId; 3]) -> bool {
    let [on_p, on_q] = [p, q].map(|v| live.steiner_of(v));
    match (on_p, on_q) {
        (Some(Steiner::On { segment, t }), _) => meet(live, apexes, (segment, p, t), q),
        (_, Some(Steiner::On { segment, t })) => meet(live, apexes, (segment, q, t), p),
        (None, None) => {
            if apexes.bits(r).is_none() || !may_be_as_far(live, r, [p, q]) {
                return false;
            }
            let segments = [p, q].map(|v| live.segment_between([r, v]));
            let [Some(of_p), Some(of_q)] = segments else { return false };
            is_sharp(live, r, [p, q])
                && match [of_p, of_q].map(|segment| live.length(segment)) {
                    [Some(of_p), Some(of_q)] => is_nearly(of_p, of_q),
                    _ => {
                        let [of_p, of_q] = [of_p, of_q].map(|s| live.squared_length(s));
                        nearly_equal(&of_p, &of_q)
                    }
                }
        }
        _ => false,
    }
}

/// Whether a vertex is as far from an apex of a segment as a point of another segment of it, which is at that parameter.
fn meet(
    live: &Live,
    apexes: &Apexes,
    (segment, p, t): (u32, VertexId, &Parameter),
    v: VertexId,
) -> bool {
    [0, 1].into_iter().any(|end| {
        let apex = VertexId::new(live.segments[segment as usize][end] as usize);
        if apexes.bits(apex).is_none()
            || !may_be_as_far(live, apex, [p, v])
            || !is_sharp(live, apex, [p, v])
        {
            return false;
        }
        if let (Some(other), Some(length)) = (radius(live, segment, apex, v), live.length(segment))
        {
            return is_nearly(t.away_from(end) * length, other);
        }
        let Some(other) = squared_radius(live, segment, apex, v) else { return false };
        let t = t.exactly_away_from(end);
        nearly_equal(&(&(&t * &t) * &live.squared_length(segment)), &other)
    })
}

/// Whether two vertices may be at one distance from a site: `false` if doubles tell that they are not.
fn may_be_as_far(live: &Live, z: VertexId, vertices: [VertexId; 2]) -> bool {
    let z = live.kernel.position(id(z));
    let [p, q] = vertices.map(|v| live.kernel.position(id(v)));
    let [to_p, to_q] = [p, q].map(|v| dot(minus(v, z), minus(v, z)));
    let far = [z, p, q].as_flattened().iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let less = to_p.min(to_q);
    let slack = NEARLY + 16.0 * f64::EPSILON * far / less.sqrt();
    // Not where anything under- or overflows.
    !((to_p - to_q).abs() > slack * less.max(f64::MIN_POSITIVE) && slack < 0.01 && far < 1e150)
}

/// Whether two vertices, each on a segment of an apex z if they are not free, are seen from it at less than 60 degrees. (Others of its segments may
/// make the small angle that it has.)
fn is_sharp(live: &Live, z: VertexId, vertices: [VertexId; 2]) -> bool {
    let [a, b] = vertices.map(|v| further_end(live, z, v));
    let at = |v: VertexId| live.kernel.position(id(v));
    let (u, v) = (minus(at(a), at(z)), minus(at(b), at(z)));
    let (uv, squares) = (dot(u, v), dot(u, u) * dot(v, v));
    let over = 4.0 * uv * uv - squares;
    if over.abs() > ROUNDING * squares && squares > 1e-280 && squares < 1e280 {
        return uv > 0.0 && over > 0.0;
    }
    products([z, a, b], 0.25, live) == [Sign::Positive; 2]
}

/// The end of the segment of `z` that a vertex is on; the vertex itself if it is no point on a segment.
fn further_end(live: &Live, z: VertexId, v: VertexId) -> VertexId {
    match live.steiner_of(v) {
        Some(Steiner::On { segment, .. }) => {
            let [a, b] = live.segments[segment as usize].map(|v| VertexId::new(v as usize));
            if a == z { b } else { a }
        }
        _ => v,
    }
}

/// Whether two radii, each off by a few roundings, are one up to the precision of parameters.
fn is_nearly(a: f64, b: f64) -> bool {
    (a - b).abs() < 0.5 * EQUAL * a
}

/// The same of exact squares.
fn nearly_equal(a: &Dyadic, b: &Dyadic) -> bool {
    let difference = a.clone() - b;
    match (difference.magnitude(), a.magnitude()) {
        (Some(off), Some(of)) => off < of - i64::from(EQUAL_BITS),
        _ => true,
    }
}
