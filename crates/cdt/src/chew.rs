//! Chew's constrained Delaunay triangulation by divide and conquer over slabs.
//!
//! ```text
//!      |  c  |           The sites in lexicographic order; a slab is a run of them. A segment that spans a slab cuts it in
//!   ---|--/--|---f       two; of the pieces only those that hold a site (regions) are kept, each with the spanning segments
//!      | a   |           next below and above it. Inside a region the sites are triangulated as far as they see each other
//!   ---|-----|---g       past the pieces of segments in the slab. Two neighbouring slabs are merged window by window along
//!      |  b  |           their common wall, a window being what lies between two segments that cross it.
//! ```
//!
//! **Paper.** [Che89] (and its conference form of 1987): O(n log n) in the worst case. Where we differ: Chew's infinite
//! vertices, where half of a segment leaves the slab, are not stored. Narrow slabs are divided region by region (`divide.rs`),
//! and regions higher than wide are cut across y where no segment is in the way (`across.rs`). Both halves of each segment stand in the rings of
//! their ends from the start, and a half whose other end is outside the slab is known by that end's index. Windows are
//! merged as in Guibas and Stolfi's Delaunay algorithm [GS85], with faces told from gaps by walking round them.
//! **In.** A noded PSLG as a kernel over its sites in lexicographic order, and subsegments as pairs of ranks.
//! **Out.** The constrained Delaunay mesh and its constrained half-edges.
//!
//! **Invariants.** For every region of a solved slab: 1. the edges between its sites are exactly the CDT's with respect to
//! the pieces of segments in the slab; 2. each face between them is a triangle or a gap; around the region the halves that
//! leave it separate the gaps, one gap for each half (or one in all); 3. a gap's boundary is a chain convex towards the gap.
//!
//! **Cost.** O(n log n) time: each level of the division does O(1) work for each site, half and edge made or removed.
//! Memory: 13 bytes for each half-edge, some 80 bytes a site, regions aside.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | equal abscissae | indices compare: as if sheared by an infinitesimal | `chew_agrees_on_small_grids` |
//! | cocircular sites | the perturbation decides | `chew_agrees_on_small_grids` |
//! | sites in line along a tangent | strict tests leave ties alone, so the nearest one is taken | `chew_agrees_on_small_grids` |
//! | sites of one height at a cut across | abscissae compare: as if cuts fell to the right | `chew_agrees_where_it_cuts_across` |
//! | all sites in line | no face: a chain | `a_chain_has_its_segments` |
//! | one half bounds a region's only gap | the gap's chain starts at the half on the right side of it | `chew_agrees_on_random_sets` |

mod across;
mod divide;
mod hand_over;
mod leaves;
mod merge;
mod moment;
mod region;
mod rings;
mod zip;

use delone_predicates::PlaneKernel;
use delone_probe::Probe;
use delone_sites::{Ends, Swept};

use across::Across;
use divide::Run;
pub(crate) use hand_over::hand_over;
use region::{Lists, Region};
use rings::Rings;

/// The triangulation in the making.
struct Chew<'k, 'p, K, P> {
    kernel: &'k K,
    probe: &'p mut P,
    segments: &'k [Ends],
    /// What the caller calls the sites.
    names: &'k [u32],
    rings: Rings,
    /// For each site the segments next below and above it.
    bounds: Vec<[Option<u32>; 2]>,
    lists: Lists,
    run: Run,
    across: Across,
    /// The regions of the slabs that are solved and wait for their merge, slab by slab, from bottom to top.
    regions: Vec<Region>,
    /// Of one merge: the regions it makes, and the segments that cross the wall.
    merged: Vec<Region>,
    wall: Vec<u32>,
}

/// The edges of the CDT of sites, ranked lexicographically and called `names[rank]` by the caller, and segments, as a sweep over them has
/// found them; takes what it says of neighbours.
pub(crate) fn chew<'k, K: PlaneKernel, P: Probe>(
    kernel: &'k K,
    swept: &'k mut Swept,
    names: &'k [u32],
    probe: &mut P,
) -> Rings {
    let rings = Rings::new(swept);
    let bounds = std::mem::take(&mut swept.neighbours);
    let (segments, count) = (&swept.pieces, bounds.len());
    let mut work = Chew {
        kernel,
        probe,
        segments,
        names,
        rings,
        bounds,
        lists: Lists::new(segments.len()),
        run: Run::new(count, segments.len()),
        across: Across::new(count),
        regions: Vec::new(),
        merged: Vec::new(),
        wall: Vec::new(),
    };
    let count = u32::try_from(count).expect("sites have 32-bit ids");
    if count > 0 {
        work.solve(0, count);
    }
    work.rings
}
