//! The affine hull of the sites: its dimension, a simplex that spans it, axes that it projects onto one to one.
//!
//! **Why it is enough to add one axis.** Let k+1 sites be independent on the k axes `A`. Their flat projects onto `A` one
//! to one, so a further site is in the flat if and only if it is so in each projection onto `A` and one more axis.
//! **Cost.** O(n D) exact orientations if all sites lie in a lower flat; a few otherwise.

use delone_mesh::{Mesh, VertexId};
use delone_predicates::{Kernel, Projected, Sign};

/// A simplex of sites, positively oriented on `axes`, that spans the affine hull of all.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Flat {
    pub(crate) simplex: Vec<u32>,
    pub(crate) axes: Vec<usize>,
}

/// The flat of the sites in `order`, with the earliest sites that span it. `order` is not empty.
pub(crate) fn span<const D: usize>(kernel: &impl Kernel<D>, order: &[u32]) -> Flat {
    let mut flat = Flat { simplex: vec![order[0]], axes: Vec::new() };
    let mut ids = vec![order[0] as usize];
    for &site in &order[1..] {
        if flat.axes.len() == D {
            break;
        }
        ids.push(site as usize);
        match independent_axis(kernel, &mut flat.axes, &ids) {
            Some(sign) => {
                flat.simplex.push(site);
                if sign == Sign::Negative {
                    flat.simplex.swap(0, 1);
                    ids.swap(0, 1);
                }
            }
            None => {
                ids.pop();
            }
        }
    }
    flat
}

/// Adds to `axes`, in increasing order, one on which `ids` are independent; their orientation on the new axes.
fn independent_axis<const D: usize>(
    kernel: &impl Kernel<D>,
    axes: &mut Vec<usize>,
    ids: &[usize],
) -> Option<Sign> {
    for axis in (0..D).filter(|axis| !axes.contains(axis)).collect::<Vec<_>>() {
        let place = axes.partition_point(|&a| a < axis);
        axes.insert(place, axis);
        let sign = kernel.orient_on(axes, ids);
        if sign != Sign::Zero {
            return Some(sign);
        }
        axes.remove(place);
    }
    None
}

/// Something to do in a flat of any dimension.
pub(crate) trait InFlat {
    /// Does it, in a flat that is seen as all of R^K.
    fn run<const K: usize>(self, kernel: &impl Kernel<K>) -> Mesh<K>;
}

/// Does the work in the flat, of dimension 1 to D - 1, that the kernel's vertices lie in.
pub(crate) fn in_flat<const D: usize>(
    kernel: impl Kernel<D>,
    flat: &Flat,
    work: impl InFlat,
) -> Mesh<D> {
    match flat.axes.len() {
        1 => in_axes::<D, 1>(kernel, flat, work),
        2 => in_axes::<D, 2>(kernel, flat, work),
        3 => in_axes::<D, 3>(kernel, flat, work),
        4 => in_axes::<D, 4>(kernel, flat, work),
        5 => in_axes::<D, 5>(kernel, flat, work),
        6 => in_axes::<D, 6>(kernel, flat, work),
        k => panic!("sites span {k} dimensions: predicates go to 7"),
    }
}

fn in_axes<const D: usize, const K: usize>(
    kernel: impl Kernel<D>,
    flat: &Flat,
    work: impl InFlat,
) -> Mesh<D> {
    let axes = std::array::from_fn(|i| flat.axes[i]);
    Mesh::embed(&work.run(&Projected::<D, K, _>::new(kernel, axes)))
}

/// Vertices in line as a mesh of dimension 1 or 0.
pub(crate) fn chain<const D: usize>(kernel: &impl Kernel<D>, order: &[u32]) -> Mesh<D> {
    let mut line: Vec<VertexId> = order.iter().map(|&site| VertexId::new(site as usize)).collect();
    line.sort_unstable_by(|&u, &v| kernel.compare_lexicographic(u, v));
    Mesh::chain(&line)
}
