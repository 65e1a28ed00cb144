//! Divide and conquer in the plane: cut the sites in halves, triangulate either half, merge.
//!
//! ```text
//!    . . : . .        ._._:_._.        ._._____._.      The sites of a block are cut by a line, across x or across y.
//!    . . : . .   ->   |/|\:/|\|   ->   |/|\ /\/|\|      Either half is triangulated by itself, and a merge stitches
//!    . . : . .        ._._:_._.        ._._V__\._.      the two along the line.
//! ```
//!
//! **Paper.** [GS85], after [LS80]; cuts across both axes by turns after [Dwy87]; a triangulation with ghosts instead of
//! edges as in [She96].
//! **In.** Sites of the plane, for the orders of the cuts; a kernel over them, for everything else. **Out.** The Delaunay
//! mesh under the lexicographic perturbation, the one of [`crate::bowyer_watson`].
//! **Invariants.** 1. A block of k >= 2 sites has 2k - 2 triangles, ghosts included, whatever its shape. So the block of
//! places i to j owns the slots 2i to 2j - 2, its halves [i, m) and [m, j) own theirs, and the two slots between become
//! the bottom and the top ghost of their merge. There is no allocator, and threads share nothing. 2. Cuts depend on the
//! points alone, and the slots on the cuts: the mesh is the same, bit for bit, for any number of threads.
//! **Cost.** O(n log n), whatever the input; O(n log log n) on evenly spread sites but for the cuts. For each uniform site
//! about 6.5 orientations, 7.6 in_sphere tests, 3.1 triangles made, of which 2 stay. 68 bytes a site at the peak: 48 for the
//! mesh, 4 for the order, and the coordinates once more, in the order of the cuts.
//!
//! **Degeneracies.** (See also `merge.rs`.)
//! | case | answer | test |
//! |---|---|---|
//! | no site, one site | the mesh of dimension -1, 0 | `a_dozen_sites_and_fewer` |
//! | all sites in line | 2n - 2 ghosts, handed over as the chain of dimension 1 | `collinear_sites_are_a_chain` |
//! | three sites of a block in line | two edges, 4 ghosts | `every_subset_of_small_grids` |
//! | equal x, equal y | the other coordinate decides on which side of the cut | `every_subset_of_small_grids` |

mod cuts;
mod merge;
mod moment;
mod patch;
#[cfg(test)]
mod tests;

use std::num::NonZeroUsize;

use delone_mesh::{FacetId, Mesh, VertexId};
use delone_predicates::{Kernel, Sign};
use delone_probe::{Event, Probe};
use delone_sites::Sites;
use rayon::prelude::{IntoParallelRefIterator, ParallelIterator, ParallelSliceMut};

use cuts::{Axis, Item, LEAF, POOL, THREAD};
use merge::{Hull, Work};
use patch::{Edge, GHOST, Patch, Place};

/// The Delaunay mesh of `sites`, which are the vertices of `kernel`. See the module's text.
///
/// # Panics
/// If there are more than 2^32 / 6 sites, or the kernel is not over them.
pub fn divide_conquer(
    kernel: &impl Kernel<2>,
    sites: &Sites<2>,
    probe: &mut impl Probe,
) -> Mesh<2> {
    laid_out(kernel, sites.sorted(), cuts::items(sites), probe)
}

/// The same for the vertices of any kernel, which are `sorted` lexicographically: constructed points have no coordinates to sort
/// by, so the kernel is asked O(n log n) times.
///
/// # Panics
/// As [`divide_conquer`].
pub fn divide_conquer_sorted(
    kernel: &impl Kernel<2>,
    sorted: &[u32],
    probe: &mut impl Probe,
) -> Mesh<2> {
    laid_out(kernel, sorted, cuts::items_by(kernel, sorted), probe)
}

/// The mesh of vertices that are `sorted` lexicographically, and their items in the same order.
fn laid_out(
    kernel: &impl Kernel<2>,
    sorted: &[u32],
    mut items: Vec<Item>,
    probe: &mut impl Probe,
) -> Mesh<2> {
    if sorted.len() < 2 {
        return chain_mesh(sorted);
    }
    cuts::cut(&mut items);
    let order: Vec<u32> = items.iter().map(|item| sorted[item.rank() as usize]).collect();
    drop(items);
    let kernel = kernel.reordered(&order);
    let mut arrays = Arrays::new(order.len());
    let patch = Patch::new(&mut arrays.apexes, &mut arrays.twins);
    let mut work = Work { patch, kernel: &kernel, probe, names: &order };
    let hull = solve(&mut work, 0, count(&order), Axis::X);
    drop(kernel);
    probe.on(Event::Site { done: order.len(), total: order.len() });
    if arrays.is_chain(hull) {
        return chain_mesh(sorted);
    }
    arrays.into_mesh(&order)
}

/// The same, bit for bit, on up to `threads` threads. It takes no probe: the counts would be those of the other.
///
/// # Panics
/// As [`divide_conquer`].
pub fn divide_conquer_in_parallel<K: Kernel<2, Reordered: Send + Sync> + Sync>(
    kernel: &K,
    sites: &Sites<2>,
    threads: NonZeroUsize,
) -> Mesh<2> {
    let alone = threads.get() == 1 || sites.len() <= POOL;
    let pool = || rayon::ThreadPoolBuilder::new().num_threads(threads.get()).build().ok();
    // A system that gives no threads gets the same mesh from one.
    let Some(pool) = (!alone).then(pool).flatten() else {
        return divide_conquer(kernel, sites, &mut ());
    };
    pool.install(|| {
        let mut items = cuts::items_in_parallel(sites);
        cuts::cut_in_parallel(&mut items);
        let order: Vec<u32> =
            items.par_iter().map(|item| sites.sorted()[item.rank() as usize]).collect();
        drop(items);
        let arrays = || Arrays::new_in_parallel(order.len());
        let (kernel, mut arrays) = rayon::join(|| kernel.reordered(&order), arrays);
        let patch = Patch::new(&mut arrays.apexes, &mut arrays.twins);
        let hull = solve_in_parallel(patch, &kernel, 0, count(&order), Axis::X);
        drop(kernel);
        if arrays.is_chain(hull) {
            return chain_mesh(sites.sorted());
        }
        arrays.into_mesh_in_parallel(&order)
    })
}

/// How many sites there are, as a place.
fn count(order: &[u32]) -> Place {
    u32::try_from(order.len()).expect("sites have ids of 32 bits")
}

/// Triangulates the sites at places `i` to `j - 1`, two or more.
fn solve<K: Kernel<2>, P: Probe>(
    work: &mut Work<'_, K, P>,
    i: Place,
    j: Place,
    axis: Axis,
) -> Hull {
    if j - i <= 3 {
        let hull = leaf(work, i, j);
        work.show([i, j], || format!("{} sites by themselves", j - i));
        return hull;
    }
    let m = i + (j - i) / 2;
    let left = solve(work, i, m, axis.other());
    let right = solve(work, m, j, axis.other());
    let hull = work.merge(left, right, axis, 2 * m - 2); // Inv 1
    work.show([i, j], || format!("{} and {} sites merged {}", m - i, j - m, axis.name()));
    hull
}

/// The same on the threads there are.
fn solve_in_parallel<K: Kernel<2> + Sync>(
    mut patch: Patch<'_>,
    kernel: &K,
    i: Place,
    j: Place,
    axis: Axis,
) -> Hull {
    if (j - i) as usize <= THREAD {
        return solve(&mut Work { patch, kernel, probe: &mut (), names: &[] }, i, j, axis);
    }
    let m = i + (j - i) / 2;
    let (left, right) = patch.split(3 * (2 * m - 1)); // Inv 1: the slots between go with either
    let (left, right) = rayon::join(
        || solve_in_parallel(left, kernel, i, m, axis.other()),
        || solve_in_parallel(right, kernel, m, j, axis.other()),
    );
    Work { patch, kernel, probe: &mut (), names: &[] }.merge(left, right, axis, 2 * m - 2)
}

/// Two or three sites: a triangle and its ghosts, or a chain of edges, each of them two ghosts back to back.
fn leaf<K: Kernel<2>, P: Probe>(work: &mut Work<'_, K, P>, i: Place, j: Place) -> Hull {
    debug_assert!((2..=LEAF).contains(&((j - i) as usize)), "a leaf has two or three sites");
    let (a, b, c) = (i, i + 1, i + 2);
    let sign = if j - i == 2 { Sign::Zero } else { work.orient(a, b, c) };
    let (b, c) = match sign {
        Sign::Zero => return chain(work, i, j),
        Sign::Positive => (b, c),
        Sign::Negative => (c, b),
    };
    let patch = &mut work.patch;
    let ab = patch.put(2 * i, [a, b, c]);
    let ba = patch.put(2 * i + 1, [b, a, GHOST]);
    let cb = patch.put(2 * i + 2, [c, b, GHOST]);
    let ac = patch.put(2 * i + 3, [a, c, GHOST]);
    patch.glue(ab, ba);
    patch.glue(ab - 2, cb);
    patch.glue(ab - 1, ac);
    patch.chain(ba, ac);
    patch.chain(ac, cb);
    patch.chain(cb, ba);
    work.probe.on(Event::CellMade);
    Hull { bottom: ba, top: ac }
}

/// Sites in line, which are in lexicographic order.
fn chain<K: Kernel<2>, P: Probe>(work: &mut Work<'_, K, P>, i: Place, j: Place) -> Hull {
    let patch = &mut work.patch;
    let mut last: Option<(Edge, Edge)> = None;
    for a in i..j - 1 {
        let there = patch.put(2 * a, [a, a + 1, GHOST]);
        let back = patch.put(2 * a + 1, [a + 1, a, GHOST]);
        patch.glue(there, back);
        if let Some((there_before, back_before)) = last {
            patch.chain(there_before, there);
            patch.chain(back, back_before);
        } else {
            patch.chain(back, there);
        }
        patch.chain(there, back);
        last = Some((there, back));
    }
    let first = 6 * i + 2; // from the first site
    Hull { bottom: first, top: first }
}

/// All triangles, ghosts included. What is not in use yet is 0.
struct Arrays {
    apexes: Vec<VertexId>,
    twins: Vec<FacetId<2>>,
}

impl Arrays {
    fn new(sites: usize) -> Self {
        let facets = Self::facets(sites);
        Self {
            apexes: vec![VertexId::from_raw(0); facets],
            twins: vec![FacetId::from_raw(0); facets],
        }
    }

    /// The same on two threads: what a system gives is cleared first.
    fn new_in_parallel(sites: usize) -> Self {
        let facets = Self::facets(sites);
        let (apexes, twins) = rayon::join(
            || vec![VertexId::from_raw(0); facets],
            || vec![FacetId::from_raw(0); facets],
        );
        Self { apexes, twins }
    }

    /// How many facets the triangles of so many sites have, ghosts included. (Inv 1)
    fn facets(sites: usize) -> usize {
        let facets = 3 * (2 * sites - 2);
        assert!(
            u32::try_from(facets).is_ok(),
            "{sites} sites have more facets than ids of 32 bits"
        );
        facets
    }

    /// Whether the outermost edge has the outside on both sides: all sites are in line.
    fn is_chain(&self, hull: Hull) -> bool {
        self.apexes[self.twins[hull.top as usize].index()].raw() == GHOST
    }

    /// As a mesh of sites, given in the order of the places.
    fn into_mesh(mut self, order: &[u32]) -> Mesh<2> {
        name(&mut self.apexes, order);
        Mesh::from_parts(2, self.apexes, self.twins)
    }

    /// The same on the threads there are.
    fn into_mesh_in_parallel(mut self, order: &[u32]) -> Mesh<2> {
        self.apexes.par_chunks_mut(THREAD).for_each(|apexes| name(apexes, order));
        Mesh::from_parts(2, self.apexes, self.twins)
    }
}

/// Puts sites for places.
fn name(apexes: &mut [VertexId], order: &[u32]) {
    for vertex in apexes {
        *vertex =
            order.get(vertex.index()).map_or(VertexId::GHOST, |&site| VertexId::from_raw(site));
    }
}

/// Sites in line as a mesh of dimension 1: a circle of segments, through the sites in order and the ghost.
fn chain_mesh(sorted: &[u32]) -> Mesh<2> {
    let line: Vec<VertexId> = sorted.iter().map(|&site| VertexId::new(site as usize)).collect();
    Mesh::chain(&line)
}
