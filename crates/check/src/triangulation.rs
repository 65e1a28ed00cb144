//! How the cells fit together: T1 (no cell twice), T3, T6, T7; with [`crate::hull`], that they tile
//! the convex hull.
//!
//! **Claim.** Let `N(x)` be the number of cells that contain a generic point `x`. The two cells of
//! an interior facet lie on opposite sides of it (T2, T3), so `N` changes only across boundary
//! facets: it is the winding number of the boundary around `x`. [`crate::hull`] proves that the
//! boundary is that of a convex body, traversed once. Hence `N` is 1 inside and 0 outside: the
//! cells cover the body and overlap nowhere. All points are vertices (T8), so the body is their
//! convex hull. Euler's formula (T7) and connectedness (T6) follow; they are checked all the same.

use crate::cells::Triangulation;
use crate::exact::Integer;
use crate::facets::{Facet, Facets, Pieces};
use crate::fault::Fault;
use crate::hull::check_hull;
use crate::sites::witnesses;
use crate::verdict::{Level, Report};

/// The facets of the well-formed cells, brought together.
pub(crate) fn facets_of<'t, const D: usize, I: Integer>(
    t: &'t Triangulation<'_, D, I>,
) -> Facets<'t> {
    Facets::new(t.dimension + 1, &t.cells, |cell| t.signs[cell].map(|_| false))
}

/// T1, T3, T5, T6, T7 and the hull. If all is clean, the report reaches [`Level::Triangulation`].
pub(crate) fn check_triangulation<const D: usize, I: Integer>(
    t: &Triangulation<'_, D, I>,
    facets: &Facets<'_>,
    report: &mut Report,
) {
    if t.dimension == 0 {
        check_points(t, report);
    } else {
        let fits = report.check("T1: no cell occurs twice", |r| check_distinct(t, facets, r));
        let fits = fits
            & report.check("T3: facets pair up, with opposite orientations", |r| {
                check_pairs(t, facets, r);
            });
        let boundary: Vec<Facet> = facets.groups().filter(|g| g.len() == 1).map(|g| g[0]).collect();
        if fits && t.sound {
            check_hull(t, facets, &boundary, report);
        }
        report
            .check("T6: the cells are connected across facets", |r| check_connected(t, facets, r));
        report.check("T7: the euler characteristic is 1", |r| check_euler(t, facets, r));
    }
    if report.is_clean() {
        report.reached(Level::Triangulation);
    }
}

/// Dimension 0: one cell, or none if there are no points. That all points equal it, T8 and the flat
/// have shown.
fn check_points<const D: usize, I: Integer>(t: &Triangulation<'_, D, I>, report: &mut Report) {
    report.check("T1: no cell occurs twice", |report| {
        let mut order: Vec<usize> = (0..t.cells.len()).collect();
        order.sort_by_key(|&i| t.cells[i]);
        for pair in order.windows(2) {
            if t.cells[pair[0]] == t.cells[pair[1]] {
                let vertices = vec![t.cells[pair[0]]];
                report.fault(Fault::DuplicateCell { first: pair[0], second: pair[1], vertices });
            }
        }
    });
}

/// Two cells with a facet and its apex in common are one cell twice. Told once, at the facet
/// opposite the least vertex.
fn check_distinct<const D: usize, I: Integer>(
    t: &Triangulation<'_, D, I>,
    facets: &Facets<'_>,
    report: &mut Report,
) {
    for group in facets.groups().filter(|g| g.len() > 1) {
        let mut by_apex = group.to_vec();
        by_apex.sort_by_key(|f| (facets.apex(f), f.number));
        for pair in by_apex.windows(2) {
            let apex = facets.apex(&pair[0]);
            let mut vertices = facets.cell(&pair[0]).to_vec();
            vertices.sort_unstable();
            if apex == facets.apex(&pair[1]) && apex == vertices[0] {
                let (first, second) = (facets.cell_number(&pair[0]), facets.cell_number(&pair[1]));
                report.fault(Fault::DuplicateCell { first, second, vertices });
            }
        }
    }
    debug_assert!(t.dimension > 0, "points have no facets");
}

fn check_pairs<const D: usize, I: Integer>(
    t: &Triangulation<'_, D, I>,
    facets: &Facets<'_>,
    report: &mut Report,
) {
    for group in facets.groups() {
        let facet = || witnesses(t.space.points, &facets.vertices(&group[0]));
        match group {
            [_] => {}
            [f, g] if f.negative != g.negative => {}
            [f, g] => {
                let cells = [facets.cell_number(f), facets.cell_number(g)];
                report.fault(Fault::FoldedFacet { facet: facet(), cells });
            }
            _ => report.fault(Fault::CrowdedFacet { facet: facet(), cells: group.len() }),
        }
    }
}

fn check_connected<const D: usize, I: Integer>(
    t: &Triangulation<'_, D, I>,
    facets: &Facets<'_>,
    report: &mut Report,
) {
    let mut pieces = Pieces::new(t.signs.len());
    for group in facets.groups() {
        for pair in group.windows(2) {
            pieces.join(facets.cell_number(&pair[0]), facets.cell_number(&pair[1]));
        }
    }
    let pieces = pieces.count(|cell| t.signs[cell].is_some());
    if pieces != 1 {
        report.fault(Fault::Disconnected { what: "cells", pieces });
    }
}

/// The alternating sum of the numbers of faces, up to dimension 5.
fn check_euler<const D: usize, I: Integer>(
    t: &Triangulation<'_, D, I>,
    facets: &Facets<'_>,
    report: &mut Report,
) {
    let k = t.dimension;
    if k > 5 {
        return;
    }
    let mut counts: Vec<usize> = (1..k).map(|size| count_faces(&t.cells, k + 1, size)).collect();
    counts.push(facets.groups().count());
    counts.push(t.signs.len());
    let found = alternating_sum(&counts);
    if found != 1 {
        report.fault(Fault::Euler { found, expected: 1 });
    }
}

/// `counts[0] - counts[1] + counts[2] - ..`
pub(crate) fn alternating_sum(counts: &[usize]) -> isize {
    let signed = |n: &usize| isize::try_from(*n).unwrap_or(isize::MAX);
    counts.iter().enumerate().map(|(i, n)| if i % 2 == 0 { signed(n) } else { -signed(n) }).sum()
}

/// How many sets of `size <= 4` vertices occur together in a cell.
pub(crate) fn count_faces(cells: &[u32], stride: usize, size: usize) -> usize {
    let masks: Vec<usize> =
        (0..1usize << stride).filter(|m| m.count_ones() as usize == size).collect();
    let mut faces: Vec<u128> = Vec::new();
    let mut face = Vec::with_capacity(size);
    for corners in cells.chunks_exact(stride) {
        for mask in &masks {
            face.clear();
            face.extend((0..stride).filter(|i| mask >> i & 1 == 1).map(|i| corners[i]));
            face.sort_unstable();
            faces.push(face.iter().fold(0, |key, &v| key << 32 | u128::from(v)));
        }
    }
    faces.sort_unstable();
    faces.dedup();
    faces.len()
}
