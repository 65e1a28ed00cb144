//! The regions in which points lie, exactly.

use delone_mesh::{CellId, HalfEdge};
use delone_predicates::{Sign, orient2d};
use delone_sites::Pslg;

use super::{FillError, SeedFault};
use crate::Cdt;
use crate::regions::{RegionId, Regions};

/// The region of each seed. O(n) a seed.
pub(super) fn regions(
    cdt: &Cdt,
    pslg: &Pslg,
    regions: &Regions,
    seeds: &[[f64; 2]],
) -> Result<Vec<RegionId>, FillError> {
    let mut found = Vec::with_capacity(seeds.len());
    let mut faults = Vec::new();
    for (seed, &at) in seeds.iter().enumerate() {
        if !at.iter().all(|x| x.is_finite()) {
            faults.push(SeedFault::NotFinite { seed });
            continue;
        }
        match segment_at(pslg, at) {
            Some(ends) => faults.push(SeedFault::OnSegment { seed, at, ends }),
            None => found.push(region_at(cdt, pslg, regions, at)),
        }
    }
    if faults.is_empty() { Ok(found) } else { Err(FillError::Seeds(faults)) }
}

/// The subsegment on which a point lies, ends included.
fn segment_at(pslg: &Pslg, p: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    let points = pslg.sites().points();
    let mut ends = pslg.subsegments().iter().map(|ends| ends.map(|site| points[site as usize]));
    ends.find(|&[a, b]| {
        let between = (0..2).all(|x| a[x].min(b[x]) <= p[x] && p[x] <= a[x].max(b[x]));
        between && orient2d(a, b, p) == Sign::Zero
    })
}

/// The region of a point on no segment.
fn region_at(cdt: &Cdt, pslg: &Pslg, regions: &Regions, p: [f64; 2]) -> RegionId {
    let (mesh, points) = (cdt.mesh(), pslg.sites().points());
    let holds = |&cell: &CellId| {
        mesh.facets(cell).all(|h: HalfEdge| {
            let [a, b] = [mesh.origin(h), mesh.destination(h)].map(|v| points[v.index()]);
            orient2d(a, b, p) != Sign::Negative
        })
    };
    let mut solid = cdt.cells().filter(|_| mesh.dimension() == Some(2));
    // On an edge that is no segment, or at a vertex of none, all triangles around are of one region.
    solid.find(holds).map_or(0, |cell| regions.of_cell(cell))
}
