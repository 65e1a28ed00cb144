//! D2: no facet is in conflict with the two cells it separates.
//!
//! A triangulation of the convex hull in which, across every interior facet, the vertex of one cell
//! is not inside the sphere of the other is Delaunay everywhere (Delaunay's lemma). Under the
//! perturbation "not inside" has no ties, so the triangulation is the only one. One side of each
//! facet suffices: both give the same sign. With some facets exempt, the same test proves a
//! constrained Delaunay triangulation.

use crate::cells::Triangulation;
use crate::exact::{Integer, Sign};
use crate::facets::Facets;
use crate::fault::Fault;
use crate::options::Ties;
use crate::sites::{witness, witnesses};
use crate::space::Place;
use crate::verdict::Report;

/// D2 on all interior facets whose number in [`Facets::groups`] is not `exempt`.
pub(crate) fn check_local<const D: usize, I: Integer>(
    t: &Triangulation<'_, D, I>,
    facets: &Facets<'_>,
    exempt: impl Fn(usize) -> bool,
    ties: Ties,
    report: &mut Report,
) {
    for (number, group) in facets.groups().enumerate() {
        let [f, g] = group else { continue };
        let (simplex, q) = (facets.cell(f), facets.apex(g));
        let orientation = match t.signs[facets.cell_number(f)] {
            Some(Sign::Zero) | None => continue, // told by T1 or T2
            Some(sign) => sign,
        };
        if exempt(number) || simplex.contains(&q) {
            continue; // a cell that occurs twice was told by T1
        }
        let place = t.space.in_sphere(simplex, orientation, q);
        let cell = || witnesses(t.space.points, simplex);
        let inside = || witness(t.space.points, q);
        match place {
            Place::Outside => {}
            Place::Inside => report.fault(Fault::NotDelaunay { cell: cell(), inside: inside() }),
            Place::On { perturbed_inside } => {
                report.tie();
                if perturbed_inside && ties == Ties::Strict {
                    report.fault(Fault::WrongTie { cell: cell(), inside: inside() });
                }
            }
        }
    }
}
