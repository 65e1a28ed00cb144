//! *Delaunay cells*: what is left of a triangulation when cospherical simplices are united.
//!
//! The perturbation looks at a frame of reference, and other programs break ties as they like. The cells do not depend on
//! any of this: two simplices on both sides of an unconstrained facet belong to one cell if the apex of one lies exactly
//! on the sphere of the other.

use delone::predicates::{Exact, Kernel, Sign, all_axes};

/// The vertex sets of the cells of a triangulation, sorted.
///
/// `simplices` are flat, `corners` ids each, as `canonical()` has them; `constrained` are edges that are not crossed,
/// smaller end first, sorted.
#[must_use]
pub fn delaunay_cells<const D: usize>(
    points: &[[f64; D]],
    simplices: &[u32],
    corners: usize,
    constrained: &[[u32; 2]],
) -> Vec<Vec<u32>> {
    if corners < 3 {
        return simplices.chunks(corners.max(1)).map(<[u32]>::to_vec).collect();
    }
    let kernel = Exact::new(points);
    let count = simplices.len() / corners;
    let mut parents: Vec<usize> = (0..count).collect();
    for [(facet, one, _), (_, other, apex)] in interior_facets(simplices, corners) {
        let fixed = <[u32; 2]>::try_from(&facet[..])
            .is_ok_and(|edge| constrained.binary_search(&edge).is_ok());
        let simplex = &simplices[one * corners..(one + 1) * corners];
        if !fixed && is_cospherical(&kernel, simplex, apex) {
            let (a, b) = (root(&mut parents, one), root(&mut parents, other));
            parents[a] = b;
        }
    }
    let mut cells = vec![Vec::new(); count];
    for (simplex, vertices) in simplices.chunks(corners).enumerate() {
        cells[root(&mut parents, simplex)].extend_from_slice(vertices);
    }
    cells.retain(|cell| !cell.is_empty());
    for cell in &mut cells {
        cell.sort_unstable();
        cell.dedup();
    }
    cells.sort_unstable();
    cells
}

/// The vertices of a facet, the simplex it belongs to, and the vertex opposite.
type Seen = (Vec<u32>, usize, u32);

/// Every facet of two simplices, as each of them sees it.
fn interior_facets(simplices: &[u32], corners: usize) -> Vec<[Seen; 2]> {
    let mut seen: Vec<Seen> = Vec::with_capacity(simplices.len());
    for (simplex, vertices) in simplices.chunks(corners).enumerate() {
        for (i, &apex) in vertices.iter().enumerate() {
            let mut facet = vertices.to_vec();
            facet.remove(i);
            facet.sort_unstable();
            seen.push((facet, simplex, apex));
        }
    }
    seen.sort_unstable();
    let pairs = seen.chunk_by(|a, b| a.0 == b.0);
    pairs.filter_map(|pair| <[Seen; 2]>::try_from(pair.to_vec()).ok()).collect()
}

fn root(parents: &mut [usize], mut at: usize) -> usize {
    while parents[at] != at {
        parents[at] = parents[parents[at]];
        at = parents[at];
    }
    at
}

/// Whether `apex`, in the flat of the simplex, lies on its circumsphere.
fn is_cospherical<const D: usize>(kernel: &Exact<&[[f64; D]]>, simplex: &[u32], apex: u32) -> bool {
    let ids: Vec<usize> = simplex.iter().map(|&v| v as usize).collect();
    let all = all_axes::<D>();
    let axes = (0..1u32 << D)
        .filter(|mask| mask.count_ones() as usize + 1 == ids.len())
        .map(|mask| all.into_iter().filter(|axis| mask >> axis & 1 == 1).collect::<Vec<_>>())
        .find(|axes| kernel.orient_on(axes, &ids) != Sign::Zero)
        .expect("a simplex of a triangulation is not flat");
    kernel.lifted_on(&axes, &ids, apex as usize) == Sign::Zero
}
