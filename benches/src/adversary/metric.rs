//! Directions, lengths, radii and smallest spheres against vector algebra over integers: cross products in space, no Gram matrix.

use std::cmp::Ordering;

use delone_predicates::{Adaptive, Constructed, Exact, Metric, Sign};
use rug::Integer;

use super::{Tally, judge, points};
use crate::oracle;
use crate::random::Random;

/// In space; the third coordinate is zero in the plane.
type Vector = [Integer; 3];

/// Dot products, comparisons of lengths and radii, and smallest spheres of one tuple of points by every kernel, against the oracle. D is 2 or 3.
pub fn round_of_metric<const D: usize>(random: &mut Random, tally: &mut Tally) {
    let points: [[f64; D]; 5] = points(random);
    let at: Vec<Vector> = oracle::shifted(&points)
        .into_iter()
        .map(|p| std::array::from_fn(|axis| p.get(axis).cloned().unwrap_or_default()))
        .collect();
    let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|i| &at[i]);
    let expected = Answers {
        dot: oracle::sign(&dot(&minus(b, a), &minus(d, c))),
        lengths: order(&square(&minus(b, a)), &square(&minus(d, c))),
        edges: radii(&edge(a, b), &edge(c, e)),
        triangles: radii(&triangle(a, b, c), &triangle(c, d, e)),
        mixed: radii(&triangle(a, b, c), &edge(d, e)),
        edge: (a != b).then(|| -oracle::sign(&dot(&minus(a, e), &minus(b, e)))),
        triangle: in_triangle([a, b, c], e),
    };
    tally.zeros += expected.zeros();
    let kernels = (
        Adaptive::new(points),
        Adaptive::dynamic(points),
        Exact::new(points),
        Constructed::new(points.to_vec()),
    );
    check(tally, &kernels.0, &expected, &points);
    check(tally, &kernels.1, &expected, &points);
    check(tally, &kernels.2, &expected, &points);
    check(tally, &kernels.3, &expected, &points);
}

/// What is asked of points 0 to 4.
struct Answers {
    dot: i8,
    lengths: i8,
    edges: i8,
    triangles: i8,
    mixed: i8,
    /// Nothing of one point twice.
    edge: Option<i8>,
    /// Nothing if the triangle is flat.
    triangle: Option<i8>,
}

impl Answers {
    fn zeros(&self) -> u64 {
        let all = [self.dot, self.lengths, self.edges, self.triangles, self.mixed];
        all.into_iter().chain(self.edge).chain(self.triangle).map(|sign| u64::from(sign == 0)).sum()
    }
}

fn check<const D: usize>(
    tally: &mut Tally,
    kernel: &impl Metric<D>,
    expected: &Answers,
    points: &[[f64; D]],
) {
    let turned = |order: Ordering| Sign::from(order);
    judge(tally, kernel.dot([0usize, 1, 2, 3]), expected.dot, points);
    judge(tally, turned(kernel.compare_lengths([0usize, 1], [2, 3])), expected.lengths, points);
    judge(tally, turned(kernel.compare_radii(&[0usize, 1], &[2, 4])), expected.edges, points);
    let triangles = kernel.compare_radii(&[0usize, 1, 2], &[2, 3, 4]);
    judge(tally, turned(triangles), expected.triangles, points);
    let mixed = kernel.compare_radii(&[3usize, 4], &[2, 0, 1]);
    judge(tally, turned(mixed), -expected.mixed, points);
    if let Some(sign) = expected.edge {
        judge(tally, kernel.in_smallest_sphere(&[0usize, 1], 4), sign, points);
    }
    if let Some(sign) = expected.triangle {
        judge(tally, kernel.in_smallest_sphere(&[2usize, 0, 1], 4), sign, points);
    }
}

fn order(a: &Integer, b: &Integer) -> i8 {
    a.cmp(b) as i8
}

/// The order of two fractions, of denominators that are not negative; over zero is infinite.
fn radii(a: &(Integer, Integer), b: &(Integer, Integer)) -> i8 {
    match (a.1.is_zero(), b.1.is_zero()) {
        (false, false) => order(&Integer::from(&a.0 * &b.1), &Integer::from(&b.0 * &a.1)),
        (a, b) => i8::from(a) - i8::from(b),
    }
}

/// The squared radius of the sphere over an edge; infinite if it is one point twice.
fn edge(a: &Vector, b: &Vector) -> (Integer, Integer) {
    let length = square(&minus(b, a));
    (Integer::from(&length * &length), length * 4)
}

/// The squared radius of the circle through three points: the product of the sides, squared, over 4 |u x v|^2.
fn triangle(a: &Vector, b: &Vector, c: &Vector) -> (Integer, Integer) {
    let (u, v, w) = (minus(b, a), minus(c, a), minus(c, b));
    (square(&u) * square(&v) * square(&w), square(&cross(&u, &v)) * 4)
}

/// The sign of the power of `q` to the smallest sphere through three points, negated; nothing if they are on a line. The centre
/// is at a + (|u|^2 v x n + |v|^2 n x u) / 2 |n|^2, n = u x v.
fn in_triangle([a, b, c]: [&Vector; 3], q: &Vector) -> Option<i8> {
    let (u, v, q) = (minus(b, a), minus(c, a), minus(q, a));
    let n = cross(&u, &v);
    if square(&n).is_zero() {
        return None;
    }
    let (along_u, along_v) = (cross(&v, &n), cross(&n, &u));
    let centre = dot(&q, &along_u) * square(&u) + dot(&q, &along_v) * square(&v);
    Some(oracle::sign(&(centre - square(&q) * square(&n))))
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|axis| Integer::from(&a[axis] - &b[axis]))
}

fn dot(a: &Vector, b: &Vector) -> Integer {
    a.iter().zip(b).map(|(a, b)| Integer::from(a * b)).sum()
}

fn square(a: &Vector) -> Integer {
    dot(a, a)
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    let minor = |i: usize, j: usize| Integer::from(&a[i] * &b[j]) - Integer::from(&a[j] * &b[i]);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}
