//! The area of each region, and a point inside it.

use dashu_int::IBig;
use delone_predicates::{Sign, orient2d};
use delone_sites::Pslg;

use crate::area::Lattice;
use crate::regions::Regions;
use crate::{Area, Cdt};

type Triangle = [[f64; 2]; 3];

/// For each region its area and an interior point; none for the exterior.
pub(super) fn measure(cdt: &Cdt, pslg: &Pslg, regions: &Regions) -> Vec<(Area, Option<[f64; 2]>)> {
    let (mesh, points) = (cdt.mesh(), pslg.sites().points());
    let lattice = Lattice::of(points);
    let mut twice = vec![IBig::ZERO; regions.count()];
    let mut triangles: Vec<Vec<Triangle>> = vec![Vec::new(); regions.count()];
    for cell in cdt.cells().filter(|_| mesh.dimension() == Some(2)) {
        let region = regions.of_cell(cell) as usize;
        let triangle = [0, 1, 2].map(|corner| points[mesh.vertex(cell, corner).index()]);
        twice[region] += lattice.twice_area(triangle);
        if region > 0 {
            triangles[region].push(turned(triangle));
        }
    }
    let seeds = triangles.into_iter().map(interior_point);
    twice.into_iter().map(|twice| lattice.area(twice)).zip(seeds).collect()
}

/// The triangle from its leftmost corner on, so that rounding does not depend on how it is stored.
fn turned([a, b, c]: Triangle) -> Triangle {
    if b < a && b < c {
        [b, c, a]
    } else if c < a && c < b {
        [c, a, b]
    } else {
        [a, b, c]
    }
}

/// The rounded centroid of the largest triangle (about) whose centroid, rounded, is strictly inside.
fn interior_point(mut triangles: Vec<Triangle>) -> Option<[f64; 2]> {
    triangles.sort_by(|s, t| {
        about(t).total_cmp(&about(s)).then_with(|| s.partial_cmp(t).expect("finite"))
    });
    triangles.iter().find_map(|&[a, b, c]| {
        let p = [0, 1].map(|x| a[x] / 3.0 + b[x] / 3.0 + c[x] / 3.0);
        let sides = [[a, b], [b, c], [c, a]];
        sides.iter().all(|&[a, b]| orient2d(a, b, p) == Sign::Positive).then_some(p)
    })
}

/// The area, about; a guide to where there is room.
fn about(&[a, b, c]: &Triangle) -> f64 {
    let half = |p: [f64; 2]| p.map(|x| x / 2.0); // no difference overflows
    let [a, b, c] = [a, b, c].map(half);
    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
}
