//! Bowyer and Watson's incremental construction, written once for every dimension.
//!
//! ```text
//!    .-----.          .-----.       A site p comes. The cells whose circumball holds it (in conflict) are a
//!   / \ p / \        / \ | / \      cavity that p sees from inside: remove them, and join p to the rim.
//!  .---.-/---.  ->  .---p-----.     Ghost cells stand for the outside of the hull, so that a p outside needs
//!   \ / \ / /        \ /|\ / /      no other treatment.
//!    .---.-.          .-----.
//! ```
//!
//! **Paper.** [Bow81], [Wat81]; ties after [DT11]; order of insertion after [ACR03].
//! **In.** A kernel over distinct vertices; the order to insert them in. **Out.** The Delaunay mesh under the
//! lexicographic perturbation: it depends on the points only, not on the order.
//! **Invariants.** 1. After each insertion the mesh is the Delaunay mesh of the sites so far. 2. A new cell is not flat.
//! 3. Under a kernel of weighted sites the cell that holds a site decides: it is hidden if not in conflict with that one.
//! **Cost.** Expected O(n log n + cells made) in randomized order; about 4 cells removed and 6 made for each site in the
//! plane (on average, without boundary: degree 6), 27 made in space on uniform sites. Memory: 8 (D + 1) bytes a cell, 4
//! for its mark, and the coordinates once more, in order of insertion.
//! **Threads.** One. The cells would be the same on several, since they depend on the points alone; their numbers would not, nor
//! would the time be safe: insertions at once need cavities that do not touch, that is locks on cells, whose outcome depends on
//! who comes first, or colours, which need the cavities before they are dug. Divide and conquer as in the plane has no linear
//! merge in space: the wall between two halves may meet n^2 cells.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | no site | the empty mesh | `few_sites_have_their_dimension` |
//! | all sites in a k-flat, k < D | the mesh of dimension k of their Delaunay triangulation in the flat | `sites_in_a_flat_are_triangulated_in_it` |
//! | a site without a cell (weights only) | it is hidden, and no vertex of the mesh | `hidden_sites_are_those_of_the_definition` |
//! | cospherical sites | the perturbation decides | `a_grid_has_one_triangulation` |

use delone_mesh::{Cavity, CellId, Mesh, VertexId};
use delone_predicates::{Kernel, Projected};
use delone_probe::{Event, Probe, Unstoppable};

use crate::conflict::{View, dig_conflicts_looking, in_conflict};
use crate::flat::{Flat, span};
use crate::locate::{Coin, walk};

/// The Delaunay mesh of the kernel's vertices in `order`, which is dropped early if it is given away. See the module's text.
///
/// # Panics
/// If `order` names a vertex twice, or one that the kernel does not know, or two vertices are at one position.
pub fn bowyer_watson<const D: usize>(
    kernel: &impl Kernel<D>,
    order: impl AsRef<[u32]>,
    probe: &mut impl Probe,
) -> Mesh<D> {
    construct(kernel, order, &mut Unstoppable(probe))
}

/// The same; if the probe does not go on, the mesh of some of the vertices.
pub(crate) fn construct<const D: usize>(
    kernel: &impl Kernel<D>,
    given: impl AsRef<[u32]>,
    probe: &mut impl Probe,
) -> Mesh<D> {
    if given.as_ref().is_empty() {
        return Mesh::empty();
    }
    let flat = span(kernel, given.as_ref());
    let order = starting_with(&flat.simplex, given.as_ref());
    drop(given);
    let kernel = kernel.reordered(&order);
    let mut mesh = match flat.axes.len() {
        0 => Mesh::simplex(&[VertexId::new(0)]),
        k if k == D => build(&kernel, order.len(), probe),
        1 => in_flat::<D, 1>(kernel, &flat, order.len(), probe),
        2 => in_flat::<D, 2>(kernel, &flat, order.len(), probe),
        3 => in_flat::<D, 3>(kernel, &flat, order.len(), probe),
        4 => in_flat::<D, 4>(kernel, &flat, order.len(), probe),
        5 => in_flat::<D, 5>(kernel, &flat, order.len(), probe),
        6 => in_flat::<D, 6>(kernel, &flat, order.len(), probe),
        k => panic!("sites span {k} dimensions: predicates go to 7"),
    };
    mesh.relabel(|vertex| VertexId::new(order[vertex.index()] as usize));
    mesh
}

/// `order` with the sites of `simplex` moved to its front.
pub(crate) fn starting_with(simplex: &[u32], order: &[u32]) -> Vec<u32> {
    let rest = order.iter().filter(|site| !simplex.contains(site));
    simplex.iter().chain(rest).copied().collect()
}

/// The construction in a flat of lower dimension K.
fn in_flat<const D: usize, const K: usize>(
    kernel: impl Kernel<D>,
    flat: &Flat,
    count: usize,
    probe: &mut impl Probe,
) -> Mesh<D> {
    let axes = std::array::from_fn(|i| flat.axes[i]);
    Mesh::embed(&build(&Projected::<D, K, _>::new(kernel, axes), count, probe))
}

/// About as many cells as so many sites of an even cloud have, hull and slots between included: 2 a site in the plane, 6.77 in space. In
/// more dimensions there are too many to be guessed.
fn room(dimension: usize, count: usize) -> usize {
    match dimension {
        2 => 2 * count + 16,
        3 => 7 * count + 64,
        _ => 0,
    }
}

/// Inserts vertices 0 to `count - 1` in this order; the first D+1 are a positive simplex.
fn build<const D: usize, K: Kernel<D>>(
    kernel: &K,
    count: usize,
    probe: &mut impl Probe,
) -> Mesh<D> {
    let first: Vec<VertexId> = (0..=D).map(VertexId::new).collect();
    let mut mesh = Mesh::simplex(&first);
    mesh.reserve(room(D, count));
    let (mut cavity, mut view) = (Cavity::new(), View::default());
    let mut coin = Coin::default();
    let mut hint = CellId::new(0);
    for done in D + 1..count {
        if !probe.goes_on() {
            break;
        }
        let p = VertexId::new(done);
        let seed = walk(&mesh, kernel, hint, p, &mut coin, probe);
        if K::HIDES && !in_conflict(&mesh, kernel, seed, p, probe) {
            probe.on(Event::Site { done: done + 1, total: count });
            continue; // Inv 3
        }
        dig_conflicts_looking(&mesh, kernel, seed, p, (&mut cavity, &mut view), probe);
        hint = mesh.star(&mut cavity, p);
        cavity.rim().for_each(|_| probe.on(Event::CellMade));
        probe.on(Event::Site { done: done + 1, total: count });
    }
    mesh.compact(|_, _| {});
    mesh
}
