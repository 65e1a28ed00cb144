//! The regions in which points lie, exactly.

use delone_predicates::{Constructed, Kernel, Sign};
use delone_sites::Noded;

use super::{FillError, SeedFault};
use crate::Cdt;
use crate::regions::{RegionId, Regions};

/// The region of each seed. O(n) a seed.
pub(super) fn regions(
    cdt: &Cdt,
    graph: &impl Noded,
    regions: &Regions,
    seeds: &[[f64; 2]],
) -> Result<Vec<RegionId>, FillError> {
    let mut kernel = graph.kernel();
    let mut found = Vec::with_capacity(seeds.len());
    let mut faults = Vec::new();
    for (seed, &at) in seeds.iter().enumerate() {
        if !at.iter().all(|x| x.is_finite()) {
            faults.push(SeedFault::NotFinite { seed });
            continue;
        }
        let p = kernel.push_plain(at) as usize;
        match segment_at(graph, &kernel, p) {
            Some(ends) => {
                let ends = ends.map(|v| graph.positions()[v]);
                faults.push(SeedFault::OnSegment { seed, at, ends });
            }
            None => found.push(region_at(cdt, regions, &kernel, p)),
        }
    }
    if faults.is_empty() { Ok(found) } else { Err(FillError::Seeds(faults)) }
}

/// The subsegment on which a vertex of the kernel lies, ends included.
fn segment_at(graph: &impl Noded, kernel: &Constructed<2>, p: usize) -> Option<[usize; 2]> {
    let is_between = |[a, b]: [usize; 2]| {
        let [from_a, to_b] =
            [kernel.compare_lexicographic(a, p), kernel.compare_lexicographic(p, b)];
        from_a == to_b || from_a.is_eq() || to_b.is_eq()
    };
    let mut ends = graph.subsegments().iter().map(|ends| ends.map(|v| v as usize));
    ends.find(|&[a, b]| is_between([a, b]) && kernel.orient(&[a, b, p]) == Sign::Zero)
}

/// The region of a vertex of the kernel that is on no segment.
fn region_at(cdt: &Cdt, regions: &Regions, kernel: &Constructed<2>, p: usize) -> RegionId {
    let mesh = cdt.mesh();
    let mut solid = cdt.cells().filter(|_| mesh.dimension() == Some(2));
    // On an edge that is no segment, or at a vertex of none, all triangles around are of one region.
    let holds = solid.find(|&cell| {
        mesh.facets(cell).all(|h| {
            let [a, b] = [mesh.origin(h), mesh.destination(h)].map(|v| v.index());
            kernel.orient(&[a, b, p]) != Sign::Negative
        })
    });
    holds.map_or(0, |cell| regions.of_cell(cell))
}
