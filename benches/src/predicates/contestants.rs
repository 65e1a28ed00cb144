//! Who answers: ours by stage, and the peers, each over all calls of an input.

use std::hint::black_box;

use delone_predicates::{Adaptive, Exact, Kernel, Sign};

use super::Predicate;
use crate::oracle;

/// One way to answer all calls of an input.
pub struct Contestant {
    /// Its name in tables.
    pub name: &'static str,
    /// Runs all calls; the number of positive, and of negative signs.
    pub run: Box<dyn Fn() -> [usize; 2]>,
}

impl std::fmt::Debug for Contestant {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// Everyone, on these calls.
#[must_use]
pub fn contestants(predicate: Predicate, tuples: &[[f64; 3]]) -> Vec<Contestant> {
    let flat = || tuples.iter().map(|&[x, y, _]| [x, y]).collect::<Vec<_>>();
    match predicate {
        Predicate::Orient2d => orient2d(flat()),
        Predicate::InCircle => in_circle(flat()),
        Predicate::Orient3d => orient3d(tuples.to_vec()),
        Predicate::InSphere => in_sphere(tuples.to_vec()),
    }
}

/// A contestant that answers each `N` points by `$answer`.
fn each<const D: usize, const N: usize>(
    name: &'static str,
    points: &[[f64; D]],
    answer: impl Fn(&[[f64; D]; N]) -> f64 + 'static,
) -> Contestant {
    let calls: Vec<[[f64; D]; N]> = points.as_chunks().0.to_vec();
    let run = move || tally(black_box(&calls).iter().map(&answer));
    Contestant { name, run: Box::new(run) }
}

/// A contestant that answers by ids.
fn by_ids<const D: usize>(
    name: &'static str,
    points: &[[f64; D]],
    per_call: usize,
    answer: impl Fn(usize) -> Sign + 'static,
) -> Contestant {
    let calls = points.len() / per_call;
    let run = move || tally((0..black_box(calls)).map(|call| value(answer(call * per_call))));
    Contestant { name, run: Box::new(run) }
}

fn value(sign: Sign) -> f64 {
    f64::from(sign as i8)
}

#[inline(always)]
fn tally(values: impl Iterator<Item = f64>) -> [usize; 2] {
    values.fold([0, 0], |[positive, negative], value| {
        [positive + usize::from(value > 0.0), negative + usize::from(value < 0.0)]
    })
}

/// A point of apfp's.
fn near([x, y]: [f64; 2]) -> apfp::geometry::f64::Coord {
    apfp::geometry::f64::Coord::new(x, y)
}

/// An answer of apfp's.
fn turn(turn: apfp::geometry::Orientation) -> f64 {
    match turn {
        apfp::geometry::Orientation::CounterClockwise => 1.0,
        apfp::geometry::Orientation::CoLinear => 0.0,
        apfp::geometry::Orientation::Clockwise => -1.0,
    }
}

fn orient2d(points: Vec<[f64; 2]>) -> Vec<Contestant> {
    let coord = |[x, y]: [f64; 2]| robust::Coord { x, y };
    let (ours, exact) = (Adaptive::new(points.clone()), Exact::new(points.clone()));
    vec![
        by_ids("kernel", &points, 3, move |i| ours.orient(&[i, i + 1, i + 2])),
        by_ids("exact", &points, 3, move |i| exact.orient(&[i, i + 1, i + 2])),
        each("free", &points, |&[a, b, c]| value(delone_predicates::orient2d(a, b, c))),
        each("robust", &points, move |&[a, b, c]| robust::orient2d(coord(a), coord(b), coord(c))),
        each("geometry-predicates", &points, |&[a, b, c]| geometry_predicates::orient2d(a, b, c)),
        each("apfp", &points, |&[a, b, c]| {
            turn(apfp::geometry::f64::orient2d(&near(a), &near(b), &near(c)))
        }),
        each("rug integers", &points, |call: &[_; 3]| oracle::orient(call).into()),
        each("naive", &points, |[a, b, c]| {
            (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
        }),
    ]
}

fn in_circle(points: Vec<[f64; 2]>) -> Vec<Contestant> {
    let coord = |[x, y]: [f64; 2]| robust::Coord { x, y };
    let (ours, exact) = (Adaptive::new(points.clone()), Exact::new(points.clone()));
    vec![
        by_ids("kernel", &points, 4, move |i| ours.lifted(&[i, i + 1, i + 2], i + 3)),
        by_ids("exact", &points, 4, move |i| exact.lifted(&[i, i + 1, i + 2], i + 3)),
        each("free", &points, |&[a, b, c, d]| value(delone_predicates::in_circle(a, b, c, d))),
        each("robust", &points, move |&[a, b, c, d]| {
            robust::incircle(coord(a), coord(b), coord(c), coord(d))
        }),
        each("geometry-predicates", &points, |&[a, b, c, d]| {
            geometry_predicates::incircle(a, b, c, d)
        }),
        each("apfp", &points, |&[a, b, c, d]| {
            turn(apfp::geometry::f64::incircle(&near(a), &near(b), &near(c), &near(d)))
        }),
        each("rug integers", &points, |call: &[_; 4]| oracle::in_sphere(call).into()),
        each("naive", &points, |&[a, b, c, d]| {
            let [p, q, r] = [a, b, c].map(|v| [v[0] - d[0], v[1] - d[1]]);
            let minor = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
            let height = |p: [f64; 2]| p[0] * p[0] + p[1] * p[1];
            height(p) * minor(q, r) + height(q) * minor(r, p) + height(r) * minor(p, q)
        }),
    ]
}

fn orient3d(points: Vec<[f64; 3]>) -> Vec<Contestant> {
    let coord = |[x, y, z]: [f64; 3]| robust::Coord3D { x, y, z };
    let (ours, exact) = (Adaptive::new(points.clone()), Exact::new(points.clone()));
    vec![
        by_ids("kernel", &points, 4, move |i| ours.orient(&[i, i + 1, i + 2, i + 3])),
        by_ids("exact", &points, 4, move |i| exact.orient(&[i, i + 1, i + 2, i + 3])),
        each("free", &points, |&[a, b, c, d]| value(delone_predicates::orient3d(a, b, c, d))),
        each("robust", &points, move |&[a, b, c, d]| {
            -robust::orient3d(coord(a), coord(b), coord(c), coord(d))
        }),
        each("geometry-predicates", &points, |&[a, b, c, d]| {
            -geometry_predicates::orient3d(a, b, c, d)
        }),
        each("rug integers", &points, |call: &[_; 4]| oracle::orient(call).into()),
        each("naive", &points, |&[a, b, c, d]| {
            let [p, q, r] = [a, b, c].map(|v| [v[0] - d[0], v[1] - d[1], d[2] - v[2]]);
            let minor = |p: [f64; 3], q: [f64; 3]| p[0] * q[1] - p[1] * q[0];
            p[2] * minor(q, r) + q[2] * minor(r, p) + r[2] * minor(p, q)
        }),
    ]
}

fn in_sphere(points: Vec<[f64; 3]>) -> Vec<Contestant> {
    let coord = |[x, y, z]: [f64; 3]| robust::Coord3D { x, y, z };
    let (ours, exact) = (Adaptive::new(points.clone()), Exact::new(points.clone()));
    vec![
        by_ids("kernel", &points, 5, move |i| ours.lifted(&[i, i + 1, i + 2, i + 3], i + 4)),
        by_ids("exact", &points, 5, move |i| exact.lifted(&[i, i + 1, i + 2, i + 3], i + 4)),
        each("free", &points, |&[a, b, c, d, e]| {
            value(delone_predicates::in_sphere(a, b, c, d, e))
        }),
        each("robust", &points, move |&[a, b, c, d, e]| {
            -robust::insphere(coord(a), coord(b), coord(c), coord(d), coord(e))
        }),
        each("geometry-predicates", &points, |&[a, b, c, d, e]| {
            -geometry_predicates::insphere(a, b, c, d, e)
        }),
        each("rug integers", &points, |call: &[_; 5]| oracle::in_sphere(call).into()),
        each("naive", &points, |&[a, b, c, d, e]| {
            let [p, q, r, s] = [a, b, c, d].map(|v| [v[0] - e[0], v[1] - e[1], v[2] - e[2]]);
            let minor = |p: [f64; 3], q: [f64; 3]| p[0] * q[1] - p[1] * q[0];
            let height = |p: [f64; 3]| p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
            let (pq, qr, rs) = (minor(p, q), minor(q, r), minor(r, s));
            let (sp, pr, qs) = (minor(s, p), minor(p, r), minor(q, s));
            let pqr = p[2] * qr - q[2] * pr + r[2] * pq;
            let qrs = q[2] * rs - r[2] * qs + s[2] * qr;
            let rsp = r[2] * sp + s[2] * pr + p[2] * rs;
            let spq = s[2] * pq + p[2] * qs + q[2] * sp;
            (height(r) * spq - height(s) * pqr) + (height(p) * qrs - height(q) * rsp)
        }),
    ]
}
