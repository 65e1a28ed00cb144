//! The boundary is that of a convex body, traversed once: T5 and the ray test, for
//! `k >= 1`.
//!
//! **In.** A complex with T1, T2, T3; its boundary facets, each with its sign in the oriented
//! boundary.
//!
//! **Checks.** Let `c` be the barycentre of the cell of one boundary facet `F`.
//!
//! 1. Every ridge (face of codimension 2) of the boundary belongs to exactly two boundary facets,
//!    with opposite orientations, and the facets are connected across ridges.
//! 2. At every ridge the boundary is convex or flat: the apex of one facet is not strictly outside
//!    the other.
//! 3. `c` is strictly inside every boundary facet's hyperplane.
//! 4. A ray from `c` through the interior of `F`, meeting no ridge, meets no other facet.
//!
//! **Proof.** (After Mehlhorn, Näher, Schilz, Schirra, Seel, Seidel, Uhrig 1996.) Project the
//! boundary from `c` onto a sphere. By 3 each facet projects injectively, all with the same
//! orientation, by 1 facets meeting in a ridge lie on opposite sides of it; so away from
//! codimension 2 the projection is a covering of the sphere minus a set that does not separate it,
//! and by 4 it has one sheet. So the boundary bounds a body that is star-shaped around `c`. For
//! generic `x`, `y` in the body the plane through `c`, `x`, `y` avoids all faces of codimension 3
//! and cuts the body in a star-shaped polygon, whose corners lie on ridges and are convex or
//! straight by 2. Such a polygon is convex, so the segment `xy` is in the body; by closure, for all
//! `x`, `y`. In the plane the ridges are the hull's vertices: a single cycle that turns left or
//! goes straight and winds once. Coplanar neighbours need no test of their own: by 3 and
//! orientation they lie on opposite sides of their ridge.
//!
//! **Why each is needed.** Without 4 a surface that winds twice around a branch vertex passes;
//! without 2, a star.
//!
//! **The ray** aims at the point of `F` with barycentric weights `1, s, s^2, ..`, a moment curve,
//! which meets each hyperplane at most `k-1` times; so of the tries `s = 3, 4, ..` only finitely
//! many can fail. It meets a facet iff each determinant `det [F_j - c]` with row `i` replaced by
//! the ray's direction is positive, like the determinant itself (Cramer).
//! **Cost.** `k` determinants per boundary facet and one per ridge.

use crate::cells::Triangulation;
use crate::exact::{Integer, Sign};
use crate::facets::{Facet, Facets, Pieces};
use crate::fault::Fault;
use crate::sites::{witness, witnesses};
use crate::space::{Ray, Star};
use crate::verdict::Report;

/// Rays to try before giving up, which is then reported as a fault.
const RAYS_MAX: u32 = 1000;

/// The boundary as a list of facets.
struct Boundary<'t, 'a, const D: usize, I> {
    t: &'t Triangulation<'a, D, I>,
    /// `k` vertices per facet, ascending.
    faces: Vec<u32>,
    /// Whether a facet counts as minus its ascending vertices.
    negative: Vec<bool>,
    /// The cell of the first facet.
    cell: &'t [u32],
}

/// Checks 1 to 4; 3 and 4 only if 1 and 2 are clean.
pub(crate) fn check_hull<const D: usize, I: Integer>(
    t: &Triangulation<'_, D, I>,
    facets: &Facets<'_>,
    boundary: &[Facet],
    report: &mut Report,
) {
    let Some(first) = boundary.first() else {
        return report.fault(Fault::Disconnected { what: "boundary's facets", pieces: 0 });
    };
    let b = Boundary {
        t,
        faces: boundary.iter().flat_map(|f| facets.vertices(f)).collect(),
        negative: boundary.iter().map(|f| f.negative).collect(),
        cell: t.cell(facets.cell_number(first)),
    };
    let ridges = Facets::new(t.dimension, &b.faces, |face| Some(b.negative[face]));
    let closed = report.check("T5: the boundary is closed and connected", |report| {
        b.check_closed(&ridges, report);
    });
    let convex = report.check("hull: the boundary is convex or flat at every ridge", |report| {
        b.check_ridges(&ridges, report);
    });
    if closed && convex {
        report.check("hull: the boundary winds once around an interior point", |report| {
            b.check_winding(report);
        });
    }
}

impl<const D: usize, I: Integer> Boundary<'_, '_, D, I> {
    fn check_closed(&self, ridges: &Facets<'_>, report: &mut Report) {
        let mut pieces = Pieces::new(self.negative.len());
        for group in ridges.groups() {
            if group.len() != 2 || group[0].negative == group[1].negative {
                let ridge = witnesses(self.t.space.points, &ridges.vertices(&group[0]));
                report.fault(Fault::OpenBoundary { ridge, facets: group.len() });
            }
            for pair in group.windows(2) {
                pieces.join(ridges.cell_number(&pair[0]), ridges.cell_number(&pair[1]));
            }
        }
        let pieces = pieces.count(|_| true);
        if pieces != 1 {
            report.fault(Fault::Disconnected { what: "boundary's facets", pieces });
        }
    }

    fn check_ridges(&self, ridges: &Facets<'_>, report: &mut Report) {
        for group in ridges.groups() {
            let [f, g] = group else { continue };
            let (face, apex) = (ridges.cell(f), ridges.apex(g));
            let mut simplex = vec![apex];
            simplex.extend(face);
            let inside = self.t.space.orient(&simplex);
            if inside.flipped_if(self.negative[ridges.cell_number(f)]) == Sign::Negative {
                report.fault(Fault::ReflexRidge {
                    facet: witnesses(self.t.space.points, face),
                    beyond: witness(self.t.space.points, apex),
                });
            }
        }
    }

    fn faces(&self) -> impl Iterator<Item = (&[u32], bool)> {
        self.faces.chunks_exact(self.t.dimension).zip(self.negative.iter().copied())
    }

    fn check_winding(&self, report: &mut Report) {
        let points = self.t.space.points;
        let before = report.count("unseen-facet");
        for (face, negative) in self.faces() {
            let star = Star { cell: self.cell, face, aimed: None };
            if self.t.space.star(&star).flipped_if(negative) != Sign::Positive {
                let (facet, cell) = (witnesses(points, face), witnesses(points, self.cell));
                report.fault(Fault::UnseenFacet { facet, cell });
            }
        }
        if report.count("unseen-facet") > before {
            return;
        }
        let target = &self.faces[..self.t.dimension];
        let facet = witnesses(points, target);
        match (3..3 + RAYS_MAX).find_map(|s| self.hits(Ray { target, s })) {
            Some(1) => {}
            Some(times) => {
                let cell = witnesses(points, self.cell);
                report.fault(Fault::WindsAgain { facet, cell, times });
            }
            None => report.fault(Fault::RayUndecided { facet }),
        }
    }

    /// How many facets the ray meets; `None` if it meets a ridge.
    fn hits(&self, ray: Ray<'_>) -> Option<usize> {
        let mut hits = 0;
        for (face, negative) in self.faces() {
            let signs = (0..face.len()).map(|row| {
                let star = Star { cell: self.cell, face, aimed: Some((row, ray)) };
                self.t.space.star(&star).flipped_if(negative)
            });
            match signs.min() {
                Some(Sign::Negative) => {}
                Some(Sign::Zero) => return None,
                Some(Sign::Positive) | None => hits += 1,
            }
        }
        Some(hits)
    }
}
