//! Lengths and radii of plain points in integers of fixed widths.
//!
//! **Radii.** With the edges u, v, w from one vertex, the squared radius is
//! * of an edge u^2 / 4;
//! * of a triangle u^2 v^2 (u - v)^2 / (4 (u x v)^2);
//! * of a tetrahedron |u^2 (v x w) + v^2 (w x u) + w^2 (u x v)|^2 / (4 det[u v w]^2).
//!
//! Flat simplices are those whose denominator is zero.
//!
//! **Inside.** A point is inside the smallest sphere through others as `metric/ball.rs` says: of one edge if it sees that at an obtuse
//! angle; of a triangle by a determinant of three rows, whose entries are products of edges.
//!
//! **Head-room.** Coordinates are at most 2^61 in magnitude, so differences, u - v among them, at most 2^b with b = 62. A square
//! of an edge is at most 3 * 2^(2b), 126 bits; a coordinate of u x v at most 2^(2b+1), 126 bits with its sign. So of a triangle the numerator is at most
//! 27 * 2^(6b) < 2^(6b+5), the denominator, without the 4, at most 3 * 2^(4b+2) < 2^(4b+4). Of a tetrahedron the vector is at most 3 * 3 * 2^(2b) *
//! 2^(2b+1) < 2^(4b+5) on each axis, 254 bits with its sign, and the numerator 3 * 2^(8b+10) < 2^(8b+12) = 2^508; the determinant at
//! most 6 * 2^(3b) < 2^(3b+3), and the denominator 2^(6b+6) = 2^378. These are 2, 2, 6, 4, 4, 8, 3 and 6 limbs. The determinant of three
//! rows of products is at most 6 * (3 * 2^(2b))^3 < 2^(6b+8) = 2^380: 6 limbs.

use std::cmp::Ordering;

use super::formulas::order;
use crate::Sign;
use crate::exact::formulas::{minor, space};
use crate::int::Int;

type Vector = [Int<1>; 3];

fn from(p: [i64; 3], origin: [i64; 3]) -> Vector {
    std::array::from_fn(|axis| (p[axis] - origin[axis]).into())
}

fn square([x, y, z]: &Vector) -> Int<2> {
    x.times::<1, 2>(x) + y.times(y) + z.times(z)
}

/// The order of two lengths.
pub(super) fn compare_lengths([a, b]: [[i64; 3]; 2], [c, d]: [[i64; 3]; 2]) -> Ordering {
    order((square(&from(b, a)) - square(&from(d, c))).sign())
}

fn product([a, b, c]: &Vector, [x, y, z]: &Vector) -> Int<2> {
    a.times::<1, 2>(x) + b.times(y) + c.times(z)
}

/// Whether the last point is inside the smallest sphere through the one to three others.
pub(super) fn in_ball(points: &[[i64; 3]]) -> Option<Sign> {
    Some(match *points {
        [a, q] => -square(&from(q, a)).sign(),
        [a, b, q] => -product(&from(a, q), &from(b, q)).sign(),
        [a, b, c, q] => {
            let [u, v, w] = [b, c, q].map(|p| from(p, a));
            let row = |e: &Vector| [product(e, &u), product(e, &v), square(e)];
            let rows = [row(&u), row(&v), row(&w)];
            -space::<2, 4, 6>([&rows[0], &rows[1], &rows[2]]).sign()
        }
        _ => return None,
    })
}

fn cross(u: &Vector, v: &Vector) -> [Int<2>; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| minor(&u[i], &u[j], &v[i], &v[j]))
}

/// The square of a vector; R is 2 N.
fn norm<const N: usize, const R: usize>([x, y, z]: &[Int<N>; 3]) -> Int<R> {
    x.times::<N, R>(x) + y.times(y) + z.times(z)
}

/// A squared radius, four times; infinite if the denominator is zero.
pub(super) struct Radius {
    numerator: Int<8>,
    denominator: Int<6>,
}

impl Radius {
    /// An edge without length is flat, too.
    fn of_edge(u: &Vector) -> Self {
        let numerator = square(u);
        let one = if numerator.sign() == Sign::Zero { Int::ZERO } else { Int::ONE };
        Self { numerator: numerator.extended(), denominator: one }
    }

    /// Of the smallest sphere through one to four points.
    pub(super) fn of_simplex(points: &[[i64; 3]]) -> Option<Self> {
        let (&origin, others) = points.split_first()?;
        let edge = |i: usize| from(others[i], origin);
        Some(match others.len() {
            0 => Self { numerator: Int::ZERO, denominator: Int::ONE },
            1 => Self::of_edge(&edge(0)),
            2 => Self::of_triangle(&edge(0), &edge(1), &from(others[0], others[1])),
            3 => Self::of_tetrahedron(&edge(0), &edge(1), &edge(2)),
            _ => return None,
        })
    }

    fn of_triangle(u: &Vector, v: &Vector, between: &Vector) -> Self {
        let sides: Int<4> = square(u).times(&square(v));
        let numerator: Int<6> = sides.times(&square(between));
        Self { numerator: numerator.extended(), denominator: norm::<2, 4>(&cross(u, v)).extended() }
    }

    fn of_tetrahedron(u: &Vector, v: &Vector, w: &Vector) -> Self {
        let [vw, wu, uv] = [cross(v, w), cross(w, u), cross(u, v)];
        let [uu, vv, ww] = [u, v, w].map(square);
        let vector = std::array::from_fn(|axis| {
            uu.times::<2, 4>(&vw[axis]) + vv.times(&wu[axis]) + ww.times(&uv[axis])
        });
        let volume: Int<3> = space::<1, 2, 3>([u, v, w]);
        Self { numerator: norm::<4, 8>(&vector), denominator: volume.times(&volume) }
    }

    pub(super) fn compare(&self, other: &Self) -> Ordering {
        match [self, other].map(|radius| radius.denominator.sign() == Sign::Zero) {
            [false, false] => {
                let left: Int<14> = self.numerator.times(&other.denominator);
                order((left - other.numerator.times(&self.denominator)).sign())
            }
            [this, that] => this.cmp(&that),
        }
    }
}
