//! Triangulations over vertices in exact ratios: what the judges of crossings and of Steiner points have in common.
//!
//! A vertex is `(x : y : w)` in big integers, `w > 0`. A1 to A6 and A8 are those of [`crate::judge_arranged`].

use crate::exact::determinant::determinant;
use crate::exact::{Integer, Number, Pure, Sign};
use crate::fault::{Fault, Witness};
use crate::options::Ties;
use crate::verdict::Report;
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};

/// `(x : y : w)`, with `w > 0`.
pub(crate) type Ratio = [Pure; 3];

/// The cells at an edge, by direction: the vertex opposite the edge from smaller to larger vertex, and the other way.
pub(crate) type Sides = BTreeMap<[u32; 2], [Option<u32>; 2]>;

pub(crate) struct Scene<'a> {
    /// The input points: the first vertices.
    pub(crate) points: &'a [[f64; 2]],
    /// All vertices.
    pub(crate) at: Vec<Ratio>,
    pub(crate) cells: &'a [u32],
    pub(crate) segments: &'a [[u32; 2]],
    pub(crate) constrained: &'a [[u32; 2]],
}

impl Scene<'_> {
    /// Whether the ids are those of vertices, and of points for segments: of `count` vertices in all.
    pub(crate) fn check_ids(&self, count: usize, report: &mut Report) -> bool {
        let points = self.points.len();
        let within = |ids: &[u32], count: usize| ids.iter().all(|&id| (id as usize) < count);
        let sound = self.cells.len().is_multiple_of(3)
            && within(self.cells, count)
            && within(self.constrained.as_flattened(), count)
            && within(self.segments.as_flattened(), points);
        if !sound {
            let expected = format!("whole cells over ids below {count}, segments below {points}");
            let length = self.cells.len();
            report.fault(Fault::BadLength { array: "cells", length, expected });
        }
        sound
    }

    pub(crate) fn witness(&self, v: u32) -> Witness {
        Witness { id: v, at: self.points.get(v as usize).map_or(Vec::new(), |p| p.to_vec()) }
    }

    pub(crate) fn witnesses(&self, ids: &[u32]) -> Vec<Witness> {
        ids.iter().map(|&v| self.witness(v)).collect()
    }

    /// A1. Two parallel lines have no crossing: `w = 0`.
    pub(crate) fn check_distinct(&self, report: &mut Report) {
        for v in (0u32..).take(self.at.len()) {
            if self.at[v as usize][2].exact_sign() != Sign::Positive {
                report.fault(Fault::UnusedPoint { point: self.witness(v) });
                return;
            }
        }
        let mut used: Vec<u32> = self.cells.to_vec();
        used.sort_unstable();
        used.dedup();
        used.sort_by(|&u, &v| self.compare(u, v));
        for pair in used.windows(2) {
            if self.compare(pair[0], pair[1]).is_eq() {
                let point = self.witness(pair[1]);
                report.fault(Fault::DuplicatePoint { point, first: pair[0] });
            }
        }
    }

    pub(crate) fn compare(&self, u: u32, v: u32) -> Ordering {
        let (p, q) = (&self.at[u as usize], &self.at[v as usize]);
        let axis = |x: usize| match p[x].times(&q[2]).minus(&q[x].times(&p[2])).exact_sign() {
            Sign::Negative => Ordering::Less,
            Sign::Zero => Ordering::Equal,
            Sign::Positive => Ordering::Greater,
        };
        axis(0).then_with(|| axis(1))
    }

    pub(crate) fn orient(&self, simplex: [u32; 3]) -> Sign {
        let rows: Vec<Pure> = simplex.iter().flat_map(|&v| self.at[v as usize].clone()).collect();
        // Columns x, y, w; the sign of (1, x, y) is the same.
        determinant(3, &rows).exact_sign()
    }

    /// A2, A3.
    pub(crate) fn edges(&self, report: &mut Report) -> Sides {
        report.check("A2: every cell is positive", |report| {
            for (cell, corners) in self.cells.as_chunks::<3>().0.iter().enumerate() {
                if self.orient(*corners) != Sign::Positive {
                    report.fault(Fault::NegativeCell { cell, corners: self.witnesses(corners) });
                }
            }
        });
        let mut sides = Sides::new();
        report.check("A3: an edge has at most one cell on either side", |report| {
            for (cell, &[a, b, c]) in self.cells.as_chunks::<3>().0.iter().enumerate() {
                for [u, v, apex] in [[a, b, c], [b, c, a], [c, a, b]] {
                    let slot =
                        &mut sides.entry([u.min(v), u.max(v)]).or_default()[usize::from(u > v)];
                    if slot.replace(apex).is_some() {
                        let facet = self.witnesses(&[u, v]);
                        report.fault(Fault::FoldedFacet { facet, cells: [cell, cell] });
                    }
                }
            }
        });
        sides
    }

    /// A4: follows the boundary, counter-clockwise, from one of its edges.
    pub(crate) fn check_boundary(&self, sides: &Sides, report: &mut Report) {
        report.check("A4: the boundary is one convex polygon, wound once", |report| {
            let mut next: BTreeMap<u32, u32> = BTreeMap::new();
            for (&[u, v], &side) in sides {
                let [from, to] = match side {
                    [Some(_), None] => [u, v],
                    [None, Some(_)] => [v, u],
                    _ => continue,
                };
                if next.insert(from, to).is_some() {
                    let ridge = self.witnesses(&[from]);
                    report.fault(Fault::OpenBoundary { ridge, facets: 3 });
                }
            }
            let Some(&start) = next.keys().next() else { return };
            let (mut at, mut turns, mut length) = (start, 0, 0);
            loop {
                let Some((b, c)) = next.get(&at).and_then(|b| Some((*b, *next.get(b)?))) else {
                    let ridge = self.witnesses(&[at]);
                    report.fault(Fault::OpenBoundary { ridge, facets: 1 });
                    return;
                };
                let straight_back = self.compare(at, b) != self.compare(b, c);
                match self.orient([at, b, c]) {
                    Sign::Positive => {}
                    Sign::Zero if !straight_back => {}
                    _ => {
                        let facet = self.witnesses(&[at, b]);
                        report.fault(Fault::ReflexRidge { facet, beyond: self.witness(c) });
                    }
                }
                // Turning left all the way, the direction passes from leftwards to rightwards once in each round.
                turns += usize::from(self.compare(at, b).is_gt() && self.compare(b, c).is_lt());
                length += 1;
                at = b;
                if at == start || length > next.len() {
                    break;
                }
            }
            if turns != 1 || length != next.len() {
                report.fault(Fault::Disconnected { what: "boundary edges", pieces: turns.max(2) });
            }
        });
    }

    /// A5: every vertex is used, or equals one that is.
    pub(crate) fn check_used(&self, report: &mut Report) {
        report.check("A5: every vertex is used, or equals one that is", |report| {
            let used: BTreeSet<u32> = self.cells.iter().copied().collect();
            let mut sorted: Vec<u32> = used.iter().copied().collect();
            sorted.sort_by(|&u, &v| self.compare(u, v));
            for v in (0u32..).take(self.at.len()).filter(|v| !used.contains(v)) {
                let is_crossing = v as usize >= self.points.len();
                if is_crossing || sorted.binary_search_by(|&u| self.compare(u, v)).is_err() {
                    report.fault(Fault::UnusedPoint { point: self.witness(v) });
                }
            }
        });
    }

    /// A6: the edges on segments.
    pub(crate) fn check_chains(&self, sides: &Sides, report: &mut Report) -> BTreeSet<[u32; 2]> {
        let mut neighbours: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for &[u, v] in sides.keys() {
            neighbours.entry(u).or_default().push(v);
            neighbours.entry(v).or_default().push(u);
        }
        let mut covered = BTreeSet::new();
        report.check("A6: every segment is a chain of edges, exactly in line", |report| {
            for (segment, ends) in self.segments.iter().enumerate() {
                if let Err(stuck) = self.follow(*ends, &neighbours, &mut covered) {
                    let (ends, stuck) = (self.witnesses(ends), self.witness(stuck));
                    report.fault(Fault::BrokenSegment { segment, ends, stuck });
                }
            }
        });
        let flagged: BTreeSet<[u32; 2]> =
            self.constrained.iter().map(|&[u, v]| [u.min(v), u.max(v)]).collect();
        report.check("A6: the flagged edges are those on segments", |report| {
            for edge in covered.difference(&flagged) {
                report.fault(Fault::MissingFlag { edge: self.witnesses(edge), segment: 0 });
            }
            for edge in flagged.difference(&covered) {
                report.fault(Fault::ExtraFlag { edge: self.witnesses(edge) });
            }
        });
        covered
    }

    /// Follows a segment edge by edge; or says where no edge leads on.
    pub(crate) fn follow(
        &self,
        [start, end]: [u32; 2],
        neighbours: &BTreeMap<u32, Vec<u32>>,
        covered: &mut BTreeSet<[u32; 2]>,
    ) -> Result<(), u32> {
        let forwards = self.compare(start, end);
        // Equal points: that which is used stands for all.
        let used = |v: u32| {
            let found = neighbours.keys().copied();
            if neighbours.contains_key(&v) {
                Some(v)
            } else {
                found.into_iter().find(|&u| self.compare(u, v).is_eq())
            }
        };
        let (mut at, end) = (used(start).ok_or(start)?, used(end).ok_or(end)?);
        while at != end {
            let leads_on = |&&next: &&u32| {
                self.compare(at, next) == forwards
                    && self.compare(next, end) != forwards.reverse()
                    && (next == end || self.orient([at, end, next]) == Sign::Zero)
            };
            let next = *neighbours[&at].iter().find(leads_on).ok_or(at)?;
            covered.insert([at.min(next), at.max(next)]);
            at = next; // nearer to the end: the loop ends
        }
        Ok(())
    }

    /// A8: across all edges but some.
    pub(crate) fn check_local(
        &self,
        sides: &Sides,
        claim: &str,
        exempt: &BTreeSet<[u32; 2]>,
        ties: Ties,
        report: &mut Report,
    ) {
        report.check(claim, |report| {
            for (&[u, v], &side) in sides.iter().filter(|(edge, _)| !exempt.contains(*edge)) {
                let [Some(left), Some(right)] = side else { continue };
                let triangle = [u, v, left];
                let fault = |this: &Self| (this.witnesses(&triangle), this.witness(right));
                match self.in_circle(triangle, right) {
                    Sign::Positive => {
                        let (cell, inside) = fault(self);
                        report.fault(Fault::NotDelaunay { cell, inside });
                    }
                    Sign::Negative => {}
                    Sign::Zero => {
                        report.tie();
                        if ties == Ties::Strict && self.tie_is_inside(triangle, right) {
                            let (cell, inside) = fault(self);
                            report.fault(Fault::WrongTie { cell, inside });
                        }
                    }
                }
            }
        });
    }

    /// The sign of `(a - v) . (b - v)`.
    pub(crate) fn dot(&self, v: u32, [a, b]: [u32; 2]) -> Sign {
        let [v, a, b] = [v, a, b].map(|v| &self.at[v as usize]);
        let along = |p: &Ratio, x: usize| p[x].times(&v[2]).minus(&v[x].times(&p[2]));
        let term = |x: usize| along(a, x).times(&along(b, x));
        term(0).plus(&term(1)).exact_sign()
    }

    /// Positive if `q` is inside the circle of a positive triangle: the determinant of the rows `(x, y, |p|^2, 1)`, `q`
    /// last, each times the square of its `w`.
    pub(crate) fn in_circle(&self, [a, b, c]: [u32; 3], q: u32) -> Sign {
        let row = |v: u32| {
            let [x, y, w] = &self.at[v as usize];
            [x.times(w), y.times(w), x.times(x).plus(&y.times(y)), w.times(w)]
        };
        let rows: Vec<Pure> = [a, b, c, q].into_iter().flat_map(row).collect();
        determinant(4, &rows).exact_sign()
    }

    /// The perturbation: the heights are raised, infinitely more for larger vertices.
    pub(crate) fn tie_is_inside(&self, triangle: [u32; 3], q: u32) -> bool {
        let mut corners = [0, 1, 2];
        corners.sort_by(|&i, &j| self.compare(triangle[j], triangle[i]));
        for i in corners {
            if self.compare(q, triangle[i]).is_gt() {
                return false; // q is lifted most
            }
            let mut tilted = triangle;
            tilted[i] = q;
            match self.orient(tilted) {
                Sign::Zero => {}
                sign => return sign == Sign::Positive,
            }
        }
        false
    }
}
