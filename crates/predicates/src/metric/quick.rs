//! Filters in doubles for plain points: whether a point is inside the smallest sphere through an edge or a triangle, and bounds of
//! radii up to tetrahedra.
//!
//! **The bound.** As `filter/any.rs`: a product of two edges has D + 2 roundings on its longest path, two of differences, one of a product,
//! D - 1 of a sum. A minor of two rows 2 (D + 2) + 2, the determinant of three rows 3 (D + 2) + 5, at most 32 for D = 7. The permanent
//! is made of the magnitudes of the terms of the products of edges.
//!
//! **Range.** The determinant is used if all differences are zero or between 2^-100 and 2^100. Products of two are then at least 2^-200,
//! whole multiples of 2^-252, and so are their sums; products of two of these of 2^-504, rounded to multiples of 2^-556; the last ones at
//! least 2^-808, if not zero: nothing underflows, and nothing overflows. An angle needs its products of two only: there, a
//! guard is added, as in `filter.rs`.

use crate::filter::any::certain;
use crate::ring::{Ring, dot, minus, times};
use crate::{Approximate, Sign};

use super::formulas::Radius;

const GUARD: f64 = 4.0 * f64::MIN_POSITIVE;

/// A product of edges and the sum of the magnitudes of its terms.
#[derive(Clone, Copy)]
struct Product {
    value: f64,
    size: f64,
}

#[inline(always)]
fn product<const D: usize>(a: &[f64; D], b: &[f64; D]) -> Product {
    let (mut value, mut size) = (0.0, 0.0);
    for axis in 0..D {
        let term = a[axis] * b[axis];
        value += term;
        size += term.abs();
    }
    Product { value, size }
}

#[inline(always)]
fn from<const D: usize>(p: &[f64; D], origin: &[f64; D]) -> [f64; D] {
    std::array::from_fn(|axis| p[axis] - origin[axis])
}

/// The sign for an edge or a triangle and a query, if doubles tell it: positive inside.
#[inline]
pub(super) fn in_ball<const D: usize>(points: &[[f64; D]]) -> Option<Sign> {
    match points {
        [a, b, q] => {
            let Product { value, size } = product(&from(a, q), &from(b, q));
            Some(-certain((value, size + GUARD), D + 2)?)
        }
        [a, b, c, q] => {
            let edges = [from(b, a), from(c, a), from(q, a)];
            let [u, v, w] = &edges;
            if !in_range(edges.as_flattened()) {
                return None;
            }
            let [uu, uv, vv] = [product(u, u), product(u, v), product(v, v)];
            let [uw, vw, ww] = [product(u, w), product(v, w), product(w, w)];
            // Rows (uu uv | uu), (uv vv | vv), (uw vw | ww).
            let gram = uu.value * vv.value - uv.value * uv.value;
            let by_v = uu.value * vv.value - uv.value * vv.value;
            let by_u = uu.value * vv.value - uv.value * uu.value;
            let value = gram * ww.value - by_u * vw.value - by_v * uw.value;
            let (squares, mixed) = (uu.size * vv.size, uv.size * uv.size);
            let size = (squares + mixed) * ww.size
                + (squares + uv.size * uu.size) * vw.size
                + (squares + uv.size * vv.size) * uw.size;
            Some(-certain((value, size), 3 * (D + 2) + 5)?)
        }
        _ => None,
    }
}

#[inline(always)]
fn in_range(differences: &[f64]) -> bool {
    const LEAST: f64 = f64::from_bits((1023 - 100) << 52);
    const MOST: f64 = f64::from_bits((1023 + 100) << 52);
    differences.iter().fold(true, |all, d| {
        let size = d.abs();
        all & (size <= MOST) & ((size >= LEAST) | (size == 0.0))
    })
}

/// Four times the squared radius of one to four plain points, as `metric/words.rs`, over any numbers; for at most three axes.
pub(super) fn radius<T: Ring, const D: usize>(points: &[[T; D]]) -> Option<Radius<T>> {
    let (origin, others) = points.split_first()?;
    let edge = |i: usize, from: &[T; D]| -> [T; D] {
        std::array::from_fn(|axis| minus(others[i][axis].clone(), &from[axis]))
    };
    let edges = |i: usize| edge(i, origin);
    let quotient = |numerator, denominator| Some(Radius { numerator, denominator });
    match others.len() {
        0 => quotient(T::zero(), T::one()),
        1 => quotient(square(&edges(0)), T::one()),
        2 if D <= 3 => {
            let (u, v) = (edges(0), edges(1));
            let sides = square(&u) * &square(&v) * &square(&edge(0, &others[1]));
            quotient(sides, square(&cross(&u, &v)))
        }
        3 if D == 3 => {
            let (u, v, w) = (edges(0), edges(1), edges(2));
            let [vw, wu, uv] = [cross(&v, &w), cross(&w, &u), cross(&u, &v)];
            let [uu, vv, ww] = [&u, &v, &w].map(square);
            let vector = std::array::from_fn(|axis| {
                times(&uu, &vw[axis]) + times(&vv, &wu[axis]) + times(&ww, &uv[axis])
            });
            let volume = (0..D).fold(T::zero(), |sum, axis| sum + times(&u[axis], &vw[axis]));
            quotient(square::<T, 3>(&vector), times(&volume, &volume))
        }
        _ => None,
    }
}

fn square<T: Ring, const D: usize>(edge: &[T; D]) -> T {
    dot(edge, edge)
}

/// The cross product in space; in the plane its third coordinate alone.
fn cross<T: Ring, const D: usize>(u: &[T; D], v: &[T; D]) -> [T; 3] {
    let minor = |i: usize, j: usize| {
        if j < D { minus(times(&u[i], &v[j]), &times(&u[j], &v[i])) } else { T::zero() }
    };
    if D == 3 {
        [minor(1, 2), minus(T::zero(), &minor(0, 2)), minor(0, 1)]
    } else {
        [T::zero(), T::zero(), minor(0, 1)]
    }
}

/// Bounds of the squared radius of plain points, if there is a quick formula.
pub(super) fn bounds<const D: usize>(points: &[[f64; D]]) -> Option<[f64; 2]> {
    if let [a, b] = points {
        return Some(of_edge(a, b));
    }
    let mut near = [[Approximate::exact(0.0); D]; 4];
    for (slot, point) in near.get_mut(..points.len())?.iter_mut().zip(points) {
        *slot = point.map(Approximate::exact);
    }
    let [low, high] = super::ball::bounds(&radius(&near[..points.len()])?);
    // A quarter is exact, but of denormals.
    Some([(low / 4.0).next_down(), (high / 4.0).next_up()])
        .filter(|_| points.len() > 1)
        .or(Some([0.0; 2]))
}

/// A quarter of a square: a sum without cancellation, off by a factor of at most 1 + (D + 3) u.
fn of_edge<const D: usize>(a: &[f64; D], b: &[f64; D]) -> [f64; 2] {
    let edge = from(b, a);
    let value = product(&edge, &edge).value / 4.0;
    let error = value * (16.0 * f64::EPSILON) + GUARD;
    if value.is_finite() { [(value - error).max(0.0), value + error] } else { [0.0, f64::INFINITY] }
}
