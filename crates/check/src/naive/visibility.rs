//! Constrained Delaunay triangles by their definition: no constraint crosses them, and no point
//! that their interior sees is in conflict with them.
//!
//! **Visibility.** Point `q` outside a triangle sees its interior iff along some direction the ray
//! from `q` enters the triangle before, or without, meeting a constraint. Sort the directions from
//! `q` to all ends of constraints and to the corners, within the angle under which `q` sees the
//! triangle. Between two consecutive ones nothing changes (constraints do not cross), so one
//! direction in each gap decides: the sum of its two neighbours. Along it compare the first
//! constraint hit with the entry into the triangle, as exact fractions; a constraint on the entered
//! edge blocks.

use super::{framed, simplices};
use crate::exact::lattice::Span;
use crate::exact::{Integer, Lattice, Number, Pure, Sign};
use crate::space::Space;
use std::cmp::Ordering;

type Vector = [Pure; 2];

/// The constrained Delaunay triangulation by its definition, under the perturbation.
///
/// Points may lie on segments and segments may overlap, but two segments must not cross in a point
/// that is not one of `points`. Segments with an end out of range are ignored. On collinear points
/// the answer is that of [`delaunay`](super::delaunay).
#[must_use]
pub fn constrained(points: &[[f64; 2]], segments: &[[u32; 2]]) -> Vec<Vec<u32>> {
    let (ids, space) = framed(Space::<'_, 2, Pure>::new(points, true));
    if space.axes.len() < 2 {
        return super::delaunay(points);
    }
    let span = Span::of(points.iter().flatten().copied()).unwrap_or(Span { low: 0, high: 0 });
    let lattice: Lattice<Pure> = Lattice::new(span.low);
    let at = points.iter().map(|p| p.map(|x| lattice.integer(x))).collect();
    let usable = |s: &&[u32; 2]| {
        s.iter().all(|&v| (v as usize) < points.len())
            && points[s[0] as usize] != points[s[1] as usize]
    };
    let scene = Scene { at, segments: segments.iter().filter(usable).copied().collect() };
    simplices(&space, &ids, |simplex, orientation| {
        let turned = |[a, b, c]: [u32; 3]| match orientation {
            Sign::Negative => [a, c, b],
            _ => [a, b, c],
        };
        let Ok(triangle) = <[u32; 3]>::try_from(simplex).map(turned) else { return false };
        let crossed = scene.segments.iter().any(|&s| crosses(&space, s, triangle));
        !crossed
            && ids.iter().filter(|q| !simplex.contains(q)).all(|&q| {
                !space.conflict(&triangle, Sign::Positive, q) || !scene.sees(&space, q, triangle)
            })
    })
}

/// Whether a segment meets the open triangle: no edge line and not its own line separates the two.
fn crosses<I: Integer>(space: &Space<'_, 2, I>, [s, e]: [u32; 2], [a, b, c]: [u32; 3]) -> bool {
    let outside =
        |u, v| [s, e].iter().all(|&w| space.orient_along(&[0, 1], &[u, v, w]) != Sign::Positive);
    let one_side =
        |sign: Sign| [a, b, c].iter().all(|&w| space.orient_along(&[0, 1], &[s, e, w]) != sign);
    !(outside(a, b)
        || outside(b, c)
        || outside(c, a)
        || one_side(Sign::Positive)
        || one_side(Sign::Negative))
}

struct Scene {
    at: Vec<Vector>,
    segments: Vec<[u32; 2]>,
}

impl Scene {
    /// Whether `q` sees the interior of a positive triangle that no segment crosses.
    fn sees(&self, space: &Space<'_, 2, Pure>, q: u32, triangle: [u32; 3]) -> bool {
        let [a, b, c] = triangle;
        let sides = [[a, b], [b, c], [c, a]];
        let sign = |[u, v]: [u32; 2]| space.orient(&[u, v, q]);
        if sides.iter().all(|&side| sign(side) != Sign::Negative) {
            return true; // inside, or in the interior of a side
        }
        let from_q = |v: u32| difference(&self.at[v as usize], &self.at[q as usize]);
        let corners = triangle.map(from_q);
        // The triangle is seen under less than a half turn, from its rightmost corner to its
        // leftmost.
        let rightmost =
            corners.iter().find(|c| corners.iter().all(|d| cross(c, d) != Sign::Negative));
        let leftmost =
            corners.iter().find(|c| corners.iter().all(|d| cross(c, d) != Sign::Positive));
        let between = |d: &Vector| {
            rightmost.is_some_and(|c| cross(c, d) == Sign::Positive)
                && leftmost.is_some_and(|c| cross(c, d) == Sign::Negative)
        };
        let ends = self.segments.iter().flatten().filter(|&&v| v != q).map(|&v| from_q(v));
        let mut directions: Vec<Vector> = ends.filter(between).collect();
        directions.extend(corners.iter().cloned());
        directions.sort_by(|d, e| match cross(d, e) {
            Sign::Positive => Ordering::Less,
            Sign::Zero => Ordering::Equal,
            Sign::Negative => Ordering::Greater,
        });
        directions.dedup_by(|d, e| cross(e, d) == Sign::Zero);
        directions.windows(2).any(|pair| {
            let ray = [0, 1].map(|x| pair[0][x].plus(&pair[1][x]));
            let entry = sides.iter().filter_map(|&s| self.hit(q, &ray, s)).min_by(compare);
            let blocked = |entry: &Fraction| {
                let hits = self.segments.iter().filter_map(|&s| self.hit(q, &ray, s));
                hits.into_iter().any(|hit| compare(&hit, entry) != Ordering::Greater)
            };
            entry.is_some_and(|entry| !blocked(&entry))
        })
    }

    /// How far along the ray from `q` it crosses a segment, if it does, beyond `q`.
    fn hit(&self, q: u32, ray: &Vector, [s, e]: [u32; 2]) -> Option<Fraction> {
        let [q, s, e] = [q, s, e].map(|v| &self.at[v as usize]);
        let (to_s, to_e, along) = (difference(s, q), difference(e, q), difference(e, s));
        if cross(ray, &to_s).times(cross(ray, &to_e)) != Sign::Negative {
            return None;
        }
        let (over, under) = (cross_value(&to_s, &along), cross_value(ray, &along));
        let zero = Pure::shifted(0, 0);
        let fraction = match under.exact_sign() {
            Sign::Negative => Fraction { over: zero.minus(&over), under: zero.minus(&under) },
            _ => Fraction { over, under },
        };
        (fraction.over.exact_sign() == Sign::Positive).then_some(fraction)
    }
}

/// A fraction with a positive denominator.
struct Fraction {
    over: Pure,
    under: Pure,
}

fn compare(a: &Fraction, b: &Fraction) -> Ordering {
    match a.over.times(&b.under).minus(&b.over.times(&a.under)).exact_sign() {
        Sign::Negative => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Positive => Ordering::Greater,
    }
}

fn difference(p: &Vector, q: &Vector) -> Vector {
    [0, 1].map(|x| p[x].minus(&q[x]))
}

fn cross_value(d: &Vector, e: &Vector) -> Pure {
    d[0].times(&e[1]).minus(&d[1].times(&e[0]))
}

fn cross(d: &Vector, e: &Vector) -> Sign {
    cross_value(d, e).exact_sign()
}
