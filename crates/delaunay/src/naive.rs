//! The definition, as an algorithm: every simplex whose circumball is empty, found by trying all.
//!
//! **In.** A kernel over a few vertices. **Out.** The cells, each sorted, in lexicographic order, as
//! [`crate::Delaunay::canonical`] gives them. **Cost.** O(n^(D+2)): for n up to 40 in the plane, 20 in space.
//! **Not** the judge's oracle, which shares nothing with the kernels (`delone-check`); this is the twin that runs under
//! any kernel.

use delone_mesh::{Mesh, VertexId};
use delone_predicates::{Kernel, Side, Sign};

use crate::flat::{InFlat, in_flat, span};

/// The Delaunay mesh of the kernel's vertices in `order`, from the cells of [`naive_delaunay`], in the flat that they span.
///
/// # Panics
/// If `order` names a vertex twice, or one that the kernel does not know, or two vertices are at one position.
pub fn naive_mesh<const D: usize>(kernel: &impl Kernel<D>, order: &[u32]) -> Mesh<D> {
    if order.is_empty() {
        return Mesh::empty();
    }
    let flat = span(kernel, order);
    let kernel = kernel.reordered(order);
    let mut mesh = match flat.axes.len() {
        0 => Mesh::simplex(&[VertexId::new(0)]),
        k if k == D => assembled(&kernel, order.len()),
        _ => in_flat(kernel, &flat, Assembled(order.len())),
    };
    mesh.relabel(|vertex| VertexId::new(order[vertex.index()] as usize));
    mesh
}

/// The work of [`assembled`], in a flat.
struct Assembled(usize);

impl InFlat for Assembled {
    fn run<const K: usize>(self, kernel: &impl Kernel<K>) -> Mesh<K> {
        assembled(kernel, self.0)
    }
}

/// The cells, turned positive, put together.
fn assembled<const D: usize>(kernel: &impl Kernel<D>, count: usize) -> Mesh<D> {
    let cells = naive_delaunay(kernel, count);
    let mut corners: Vec<VertexId> = cells.iter().map(|&v| VertexId::new(v as usize)).collect();
    for cell in corners.chunks_exact_mut(D + 1) {
        if kernel.orient(cell) == Sign::Negative {
            cell.swap(0, 1);
        }
    }
    Mesh::from_cells(D, &corners).expect("Delaunay cells tile the convex hull")
}

/// All Delaunay cells of vertices 0 to `count - 1`, which must span R^D.
///
/// # Panics
/// If there are 2^32 vertices or more.
pub fn naive_delaunay<const D: usize>(kernel: &impl Kernel<D>, count: usize) -> Vec<u32> {
    let mut cells = Vec::new();
    let mut simplex: Vec<usize> = (0..=D).collect();
    while simplex.last().is_some_and(|&last| last < count) {
        if is_delaunay(kernel, &simplex, count) {
            cells.extend(simplex.iter().map(|&v| u32::try_from(v).expect("few vertices")));
        }
        next_subset(&mut simplex, count);
    }
    cells
}

fn is_delaunay<const D: usize>(kernel: &impl Kernel<D>, simplex: &[usize], count: usize) -> bool {
    let mut oriented = simplex.to_vec();
    match kernel.orient(&oriented) {
        Sign::Zero => return false,
        Sign::Negative => oriented.swap(0, 1),
        Sign::Positive => {}
    }
    let others = (0..count).filter(|v| !simplex.contains(v));
    others.into_iter().all(|q| kernel.in_sphere(&oriented, q) == Side::Negative)
}

/// The next subset of `0..count` of this size, in lexicographic order; past the last one its end is `count`.
fn next_subset(subset: &mut [usize], count: usize) {
    let size = subset.len();
    let Some(place) = (0..size).rev().find(|&i| subset[i] + size - i < count) else {
        subset[size - 1] = count;
        return;
    };
    let start = subset[place] + 1;
    for (offset, slot) in subset[place..].iter_mut().enumerate() {
        *slot = start + offset;
    }
}
