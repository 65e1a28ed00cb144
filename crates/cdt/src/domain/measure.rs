//! The area of each region, and a point inside it.

use delone_predicates::{Constructed, Kernel, Sign};
use delone_sites::Noded;

use crate::area::Areas;
use crate::regions::Regions;
use crate::{Area, Cdt};

/// A triangle by its vertices, counter-clockwise, leftmost first: so that rounding does not depend on how it is stored.
type Triangle = [usize; 3];

/// For each region its area and an interior point; none for the exterior.
pub(super) fn measure(
    cdt: &Cdt,
    graph: &impl Noded,
    regions: &Regions,
) -> Vec<(Area, Option<[f64; 2]>)> {
    let (mesh, ranks) = (cdt.mesh(), graph.ranks());
    let mut kernel = graph.kernel();
    let mut triangles: Vec<Vec<Triangle>> = vec![Vec::new(); regions.count()];
    for cell in cdt.cells().filter(|_| mesh.dimension() == Some(2)) {
        let mut triangle = [0, 1, 2].map(|corner| mesh.vertex(cell, corner).index());
        let leftmost = (0..3).min_by_key(|&corner| ranks[triangle[corner]]).unwrap_or(0);
        triangle.rotate_left(leftmost);
        triangles[regions.of_cell(cell) as usize].push(triangle);
    }
    let areas = Areas::new(&kernel);
    let areas: Vec<Area> = triangles.iter().map(|region| areas.sum(region)).collect();
    let exterior = triangles.first_mut().map(std::mem::take); // infinity is its inside
    drop(exterior);
    let seeds: Vec<Option<[f64; 2]>> =
        triangles.iter_mut().map(|region| interior_point(&mut kernel, &ranks, region)).collect();
    areas.into_iter().zip(seeds).collect()
}

/// The rounded centroid of the largest triangle (about) whose centroid, rounded, is strictly inside.
fn interior_point(
    kernel: &mut Constructed<2>,
    ranks: &[u32],
    triangles: &mut [Triangle],
) -> Option<[f64; 2]> {
    let place = |t: &Triangle| t.map(|v| ranks[v]);
    triangles.sort_by(|s, t| {
        about(kernel, t).total_cmp(&about(kernel, s)).then_with(|| place(s).cmp(&place(t)))
    });
    triangles.iter().find_map(|&[a, b, c]| {
        let [p, q, r] = [a, b, c].map(|v| kernel.positions()[v]);
        let centre = [0, 1].map(|x| p[x] / 3.0 + q[x] / 3.0 + r[x] / 3.0);
        if !centre.iter().all(|x| x.is_finite()) {
            return None;
        }
        let d = kernel.push_plain(centre) as usize;
        let sides = [[a, b], [b, c], [c, a]];
        sides.iter().all(|&[u, v]| kernel.orient(&[u, v, d]) == Sign::Positive).then_some(centre)
    })
}

/// The area, about; a guide to where there is room.
fn about(kernel: &Constructed<2>, triangle: &Triangle) -> f64 {
    let half = |v: usize| kernel.positions()[v].map(|x| x / 2.0); // no difference overflows
    let [a, b, c] = triangle.map(half);
    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
}
