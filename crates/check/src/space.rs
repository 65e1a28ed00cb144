//! The judge's own predicates: orientation, the sphere test with its tie rule, and the star test of
//! the hull.
//!
//! **In.** Points of `D` coordinates; `k <= D` axes on which the points, which lie in one `k`-flat,
//! keep their affine dimension. **Definitions.** With all rows restricted to the `k` axes,
//!
//! ```text
//! O(p0..pk)    = det [p1 - p0; ..; pk - p0]
//! M(p0..pk; q) = det of the rows (1, p, |p|^2), q last = (-1)^(k+1) det [pi - q, |pi - q|^2]
//! conflict     = O * M < 0: q is strictly inside the sphere
//! ```
//!
//! where `|p|^2` uses all `D` coordinates. (Subtract the row of `q` and expand by the first column;
//! then `|p|^2 - |q|^2 = |p - q|^2 + 2 q.(p - q)`, and the second term is a combination of the
//! other columns, since on the flat each dropped coordinate is an affine function of the kept
//! ones.)
//!
//! A point of weight `w` has the height `|p|^2 - w`, so that the rows of the second form are
//! `[pi - q, |pi - q|^2 + w(q) - w(pi)]`. Then the sphere is the one orthogonal to all of the
//! simplex.
//!
//! **Ties.** Each height `|p|^2` is raised by an infinitesimal, infinitely larger for a point of
//! larger lexicographic rank. When `M = 0`, the first point `v` in descending rank whose height
//! matters decides: `q` itself leaves the sphere; for a `v` of the simplex, `q` falls inside iff
//! the simplex with `v` replaced by `q` keeps its orientation.

use crate::exact::determinant::determinant;
use crate::exact::lattice::Span;
use crate::exact::word;
use crate::exact::{Arithmetic, Balls, Integer, Lattice, Number, Sign};
use std::cmp::Ordering;

/// Where a point lies with respect to the sphere of a simplex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Inside,
    /// Exactly on the sphere; `perturbed_inside` is the verdict of the tie rule.
    On {
        perturbed_inside: bool,
    },
    Outside,
}

/// Points, the axes to judge on, and the numbers to judge with.
#[derive(Debug)]
pub(crate) struct Space<'a, const D: usize, I> {
    pub(crate) points: &'a [[f64; D]],
    /// One for each point; none if all weigh nothing.
    weights: Option<&'a [f64]>,
    pub(crate) axes: Vec<usize>,
    filtered: bool,
    word: Option<Lattice<i128>>,
    exact: Lattice<I>,
}

impl<'a, const D: usize, I: Integer> Space<'a, D, I> {
    /// A space over all `D` axes. The coordinates must be finite.
    pub(crate) fn new(points: &'a [[f64; D]], filtered: bool) -> Self {
        Self::weighted(points, None, filtered)
    }

    /// A space of points with weights, one for each. All must be finite.
    pub(crate) fn weighted(
        points: &'a [[f64; D]],
        weights: Option<&'a [f64]>,
        filtered: bool,
    ) -> Self {
        let coordinates = Span::of(points.iter().flatten().copied());
        let roots = Span::of(weights.unwrap_or(&[]).iter().copied()).map(Span::halved);
        let span = Span::both(coordinates, roots).unwrap_or(Span { low: 0, high: 0 });
        // A difference of weights is less than one more square.
        let small = filtered && word::fits(span.bits(), D, D + usize::from(weights.is_some()));
        Self {
            points,
            weights,
            axes: (0..D).collect(),
            filtered,
            word: small.then(|| Lattice::new(span.low)),
            exact: Lattice::new(span.low),
        }
    }

    /// The sign of `O` along the axes of this space.
    pub(crate) fn orient(&self, simplex: &[u32]) -> Sign {
        self.orient_along(&self.axes, simplex)
    }

    /// The sign of `O` along other axes, one fewer than `simplex` has vertices.
    pub(crate) fn orient_along(&self, axes: &[usize], simplex: &[u32]) -> Sign {
        if simplex.len() < 2 {
            return Sign::Positive; // the empty determinant
        }
        self.decide(&Orientation { points: self.points, axes, simplex })
    }

    /// Where `q` lies with respect to the sphere of `simplex`, whose orientation is `orientation`,
    /// not zero.
    pub(crate) fn in_sphere(&self, simplex: &[u32], orientation: Sign, q: u32) -> Place {
        let lifted =
            Lifted { points: self.points, weights: self.weights, axes: &self.axes, simplex, q };
        let m = self.decide(&lifted).flipped_if(self.axes.len().is_multiple_of(2));
        match orientation.times(m) {
            Sign::Negative => Place::Inside,
            Sign::Positive => Place::Outside,
            Sign::Zero => {
                Place::On { perturbed_inside: self.tie_is_inside(simplex, orientation, q) }
            }
        }
    }

    /// `conflict*`: inside, ties decided by the perturbation.
    pub(crate) fn conflict(&self, simplex: &[u32], orientation: Sign, q: u32) -> bool {
        match self.in_sphere(simplex, orientation, q) {
            Place::Inside => true,
            Place::Outside => false,
            Place::On { perturbed_inside } => perturbed_inside,
        }
    }

    fn tie_is_inside(&self, simplex: &[u32], orientation: Sign, q: u32) -> bool {
        let mut corners: Vec<usize> = (0..simplex.len()).collect();
        corners.sort_unstable_by(|&i, &j| self.compare(simplex[j], simplex[i]));
        for i in corners {
            if self.compare(q, simplex[i]) != Ordering::Less {
                return false; // q is lifted most
            }
            let mut tilted = simplex.to_vec();
            tilted[i] = q;
            match self.orient(&tilted) {
                Sign::Zero => {}
                sign => return sign == orientation,
            }
        }
        false
    }

    /// The order of the weights of two points.
    pub(crate) fn compare_weights(&self, u: u32, v: u32) -> Ordering {
        let weight = |id: u32| self.weights.map_or(0.0, |weights| weights[id as usize]);
        weight(u).partial_cmp(&weight(v)).unwrap_or(Ordering::Equal)
    }

    /// The lexicographic order of two points: their rank.
    pub(crate) fn compare(&self, u: u32, v: u32) -> Ordering {
        lexicographic(&self.points[u as usize], &self.points[v as usize])
    }

    /// `(p - o) x (q - o)` and `(p - o) . (q - o)` along the first two axes, in units of the square of this power of two.
    pub(crate) fn products(&self, o: u32, p: u32, q: u32) -> ([I; 2], i32) {
        let away = |v: u32, x: usize| {
            self.exact.difference(self.points[v as usize][x], self.points[o as usize][x])
        };
        let ([px, py], [qx, qy]) = ([away(p, 0), away(p, 1)], [away(q, 0), away(q, 1)]);
        let cross = px.times(&qy).minus(&py.times(&qx));
        ([cross, px.times(&qx).plus(&py.times(&qy))], self.exact.low())
    }

    /// The sign of `det [F_i - c]` with row `replaced`, if any, replaced by the direction of `ray`,
    /// where `c` is the barycentre of `star.cell` and `F` is `face`.
    pub(crate) fn star(&self, star: &Star<'_>) -> Sign {
        if self.filtered {
            let value = star.value(&Balls, self.points, &self.axes);
            if let Some(sign) = value.sign() {
                return sign;
            }
        }
        star.value(&self.exact, self.points, &self.axes).exact_sign()
    }

    fn decide<F: Formula>(&self, formula: &F) -> Sign {
        if self.filtered {
            if let Some(sign) = formula.value(&Balls).sign() {
                return sign;
            }
            if let Some(sign) = self.word.as_ref().and_then(|w| formula.value(w).sign()) {
                return sign;
            }
        }
        formula.value(&self.exact).exact_sign()
    }
}

/// The lexicographic order of finite coordinates.
pub(crate) fn lexicographic<const D: usize>(p: &[f64; D], q: &[f64; D]) -> Ordering {
    p.partial_cmp(q).unwrap_or(Ordering::Equal)
}

/// Something whose sign is a predicate, computable in any arithmetic.
trait Formula {
    fn value<A: Arithmetic>(&self, arithmetic: &A) -> A::Number;
}

struct Orientation<'a, const D: usize> {
    points: &'a [[f64; D]],
    axes: &'a [usize],
    simplex: &'a [u32],
}

impl<const D: usize> Formula for Orientation<'_, D> {
    fn value<A: Arithmetic>(&self, arithmetic: &A) -> A::Number {
        let base = &self.points[self.simplex[0] as usize];
        let mut rows = Vec::with_capacity(self.axes.len() * self.axes.len());
        for &v in &self.simplex[1..] {
            let p = &self.points[v as usize];
            rows.extend(self.axes.iter().map(|&x| arithmetic.difference(p[x], base[x])));
        }
        determinant(self.axes.len(), &rows)
    }
}

struct Lifted<'a, const D: usize> {
    points: &'a [[f64; D]],
    weights: Option<&'a [f64]>,
    axes: &'a [usize],
    simplex: &'a [u32],
    q: u32,
}

impl<const D: usize> Formula for Lifted<'_, D> {
    fn value<A: Arithmetic>(&self, arithmetic: &A) -> A::Number {
        let q = &self.points[self.q as usize];
        let order = self.axes.len() + 1;
        let mut rows = Vec::with_capacity(order * order);
        for &v in self.simplex {
            let p = &self.points[v as usize];
            let away: [A::Number; D] = std::array::from_fn(|x| arithmetic.difference(p[x], q[x]));
            let square = away[1..].iter().fold(away[0].times(&away[0]), |s, d| s.plus(&d.times(d)));
            rows.extend(self.axes.iter().map(|&x| away[x].clone()));
            rows.push(match self.weights {
                None => square,
                Some(w) => square.plus(&arithmetic.weights(w[self.q as usize], w[v as usize])),
            });
        }
        determinant(order, &rows)
    }
}

/// A face seen from the barycentre `c` of a cell, for the hull's ray test; everything is scaled by
/// the size of the cell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Star<'a> {
    pub(crate) cell: &'a [u32],
    pub(crate) face: &'a [u32],
    /// Replace this row by the direction of a ray.
    pub(crate) aimed: Option<(usize, Ray<'a>)>,
}

/// A ray from `c` through the point of `target` with positive barycentric weights `1, s, s^2 ..`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray<'a> {
    pub(crate) target: &'a [u32],
    pub(crate) s: u32,
}

impl Star<'_> {
    fn value<A: Arithmetic, const D: usize>(
        &self,
        arithmetic: &A,
        points: &[[f64; D]],
        axes: &[usize],
    ) -> A::Number {
        let at = |v: u32, x: usize| {
            let p = points[v as usize][x];
            let mut sum = arithmetic.difference(p, points[self.cell[0] as usize][x]);
            for &w in &self.cell[1..] {
                sum = sum.plus(&arithmetic.difference(p, points[w as usize][x]));
            }
            sum
        };
        let mut rows = Vec::with_capacity(axes.len() * axes.len());
        for (i, &v) in self.face.iter().enumerate() {
            match self.aimed {
                Some((row, ray)) if row == i => rows.extend(axes.iter().map(|&x| {
                    let last = ray.target.len() - 1; // Horner's rule
                    let start = at(ray.target[last], x);
                    ray.target[..last]
                        .iter()
                        .rev()
                        .fold(start, |sum, &t| sum.scaled(ray.s).plus(&at(t, x)))
                })),
                _ => rows.extend(axes.iter().map(|&x| at(v, x))),
            }
        }
        determinant(axes.len(), &rows)
    }
}

#[cfg(test)]
mod tests;
