//! The smallest sphere through the corners of a simplex in doubles: bounds of its squared radius, and on which side of each facet
//! its centre lies.
//!
//! **Inside.** Let the centre be the sum of l_i p_i, the l_i adding up to 1. The sphere, and the smallest one through the corners but p_i,
//! have the same power on the facet of these; it follows that p_i is inside the latter just if l_i is negative. So one simplex
//! answers for all its facets, from what its radius needs:
//! * of a triangle with edges u, v from its first corner, the l_i have the signs of u.v, u.u - u.v, v.v - u.v;
//! * of a tetrahedron with d = det[u v w] and n = u^2 (v x w) + v^2 (w x u) + w^2 (u x v), those of 2 d^2 less the
//!   other three, n.(v x w), n.(w x u), n.(u x v), and the squared radius is n^2 / (4 d^2), as in `metric/words.rs`.
//!
//! These are polynomials, and answer for flat simplices too.
//!
//! **The bound.** Let m be the largest coordinate of u, v, w, and e = 2^-53; higher powers of e are in what the constants have
//! to spare. A coordinate of an edge is off by e m; a product of two by 3 e m^2, a coordinate of a cross product, at most 2 m^2, by
//! 8 e m^2; a product of edges, at most 3 m^2, by 14 e m^2. A square of an edge has no cancellation, and is off by 5 e of itself. A
//! coordinate of n, at most 18 m^4, is off by (3 (24 + 28 + 6) + 30) e m^4 = 204 e m^4; d, at most 6 m^3, by 46 e m^3; a product
//! of n and a cross product, at most 108 m^6, by (3 (144 + 408 + 36) + 180) e m^6 = 1944 e m^6; 2 d^2, at most 72 m^6, by 1176 e m^6,
//! and it less three others by (1176 + 5832 + 864) e m^6 = 7872 e m^6.
//!
//! **Range.** For m between 2^-100 and 2^100 nothing overflows. What underflows is less than 2^-1070 by at most 2^7 m^4, far below
//! e^2 m^8: in the constants of bounds in m; the bound of a product of squares has a guard of 2^-400 m^6 instead.

use crate::Sign;

const E: f64 = f64::EPSILON / 2.0;
const GUARD: f64 = 4.0 * f64::MIN_POSITIVE;

/// What doubles tell of the smallest sphere through the corners of a simplex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circumball {
    /// Two doubles that its squared radius is between; infinite where nothing is known.
    pub squared_radius: [f64; 2],
    /// For each corner, as [`crate::Metric::in_smallest_sphere`]: whether it is inside the smallest sphere through the others, if
    /// doubles tell. Nothing is told of the ends of an edge, nor beyond the last corner.
    pub inside: [Option<Sign>; 4],
}

/// Of one to four points of at most three axes, if they are in range.
#[inline(always)]
pub(super) fn circumball<const D: usize>(points: &[[f64; D]]) -> Option<Circumball> {
    match points {
        [_] => Some(Circumball { squared_radius: [0.0; 2], inside: [None; 4] }),
        [a, b] => Some(Circumball { squared_radius: of_edge(&from(b, a)), inside: [None; 4] }),
        [a, b, c] if D == 2 || D == 3 => of_triangle(&from(b, a), &from(c, a), &from(c, b)),
        [a, b, c, d] if D == 3 => of_tetrahedron([b, c, d].map(|p| in_space(&from(p, a)))),
        _ => None,
    }
}

/// A quarter of a square: a sum without cancellation, off by a factor of at most 1 + (D + 3) e.
#[inline(always)]
fn of_edge<const D: usize>(edge: &[f64; D]) -> [f64; 2] {
    let value = dot(edge, edge) / 4.0;
    let error = value * (32.0 * E) + GUARD;
    if value.is_finite() { [(value - error).max(0.0), value + error] } else { [0.0, f64::INFINITY] }
}

const TINY: f64 = f64::from_bits((1023 - 400) << 52);

fn of_triangle<const D: usize>(
    u: &[f64; D],
    v: &[f64; D],
    between: &[f64; D],
) -> Option<Circumball> {
    let m = in_range(size(u).max(size(v)))?;
    let square = m * m;
    let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
    let inside = [
        inside(uv, 16.0 * E * square),
        inside(uu - uv, 48.0 * E * square),
        inside(vv - uv, 48.0 * E * square),
        None,
    ];
    let sides = uu * vv * dot(between, between);
    let of_sides = sides * (32.0 * E) + TINY * (square * square * square);
    let area = cross(&in_space(u), &in_space(v));
    let squared_radius = quotient([sides, of_sides], norm(&area, 8.0 * E * square));
    Some(Circumball { squared_radius, inside })
}

fn of_tetrahedron([u, v, w]: [[f64; 3]; 3]) -> Option<Circumball> {
    let m = in_range(size(&u).max(size(&v)).max(size(&w)))?;
    let square = m * m;
    let [uu, vv, ww] = [dot(&u, &u), dot(&v, &v), dot(&w, &w)];
    let [vw, wu, uv] = [cross(&v, &w), cross(&w, &u), cross(&u, &v)];
    let n: [f64; 3] = std::array::from_fn(|x| uu * vw[x] + vv * wu[x] + ww * uv[x]);
    let d = dot(&u, &vw);
    let [of_u, of_v, of_w] = [dot(&n, &vw), dot(&n, &wu), dot(&n, &uv)];
    let of_origin = 2.0 * d * d - of_u - of_v - of_w;
    let error = 2048.0 * E * (square * square * square);
    let inside = [
        inside(of_origin, 4.0 * error),
        inside(of_u, error),
        inside(of_v, error),
        inside(of_w, error),
    ];
    let volume = norm(&[d, 0.0, 0.0], 48.0 * E * (square * m));
    let squared_radius = quotient(norm(&n, 208.0 * E * (square * square)), volume);
    Some(Circumball { squared_radius, inside })
}

/// The sign of a coordinate of the centre, negated, if it is certain.
#[inline(always)]
fn inside(coordinate: f64, error: f64) -> Option<Sign> {
    (coordinate.abs() > error).then(|| -Sign::of(coordinate))
}

/// The square of a vector each of whose coordinates is off by at most `error`, and how much that may be off: 2 n.f + f.f for
/// the error f, and the roundings of the square.
#[inline(always)]
fn norm(n: &[f64; 3], error: f64) -> [f64; 2] {
    let (square, sum) = (dot(n, n), n[0].abs() + n[1].abs() + n[2].abs());
    [square, (2.0 * sum + 4.0 * error) * (error * (1.0 + 16.0 * E)) + square * (8.0 * E)]
}

/// Bounds of the quotient of the first by four times the second, each with its error.
#[inline(always)]
fn quotient([above, of_above]: [f64; 2], [below, of_below]: [f64; 2]) -> [f64; 2] {
    let least = 4.0 * (below - of_below);
    if least <= 0.0 {
        return [f64::NEG_INFINITY, f64::INFINITY];
    }
    let low = (above - of_above) / (4.0 * (below + of_below));
    let high = (above + of_above) / least;
    [low * (1.0 - 8.0 * E), high * (1.0 + 8.0 * E)] // low may be negative: then it is a bound all the more
}

#[inline(always)]
fn in_range(size: f64) -> Option<f64> {
    const LEAST: f64 = f64::from_bits((1023 - 100) << 52);
    const MOST: f64 = f64::from_bits((1023 + 100) << 52);
    (LEAST..=MOST).contains(&size).then_some(size)
}

#[inline(always)]
fn size<const D: usize>(edge: &[f64; D]) -> f64 {
    edge.iter().fold(0.0, |most, x| x.abs().max(most))
}

#[inline(always)]
fn from<const D: usize>(p: &[f64; D], origin: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|axis| p[axis] - origin[axis])
}

#[inline(always)]
fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    (0..D).map(|axis| a[axis] * b[axis]).sum()
}

/// A vector of the plane with a third coordinate of zero.
#[inline(always)]
fn in_space<const D: usize>(edge: &[f64; D]) -> [f64; 3] {
    std::array::from_fn(|axis| if axis < D { edge[axis] } else { 0.0 })
}

#[inline(always)]
fn cross(u: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| u[i] * v[j] - u[j] * v[i])
}
