//! The affine hull of the sites: its dimension, a simplex that spans it, axes that it projects onto one to one.
//!
//! **Why it is enough to add one axis.** Let k+1 sites be independent on the k axes `A`. Their flat projects onto `A` one
//! to one, so a further site is in the flat if and only if it is so in each projection onto `A` and one more axis.
//! **Cost.** O(n D) exact orientations if all sites lie in a lower flat; a few otherwise.

use delone_predicates::{Kernel, Sign};

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
