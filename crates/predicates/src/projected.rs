//! A kernel seen on some of its axes: vertices that all lie in a K-flat of R^D, as vertices of R^K.
//!
//! Positions are projected onto K axes on which the flat is not degenerate; heights stay those of R^D. The lift
//! restricted to a flat is still a function on the flat, so Delaunay in the flat is Delaunay here, ties included.

use std::cmp::Ordering;

use crate::kernel::{Id, Kernel};
use crate::{Sign, exact::AXES_MAX};

/// The kernel `base` of R^D on K of its axes. See the module's text.
#[derive(Clone, Copy, Debug)]
pub struct Projected<const D: usize, const K: usize, B> {
    base: B,
    axes: [usize; K],
}

impl<const D: usize, const K: usize, B: Kernel<D>> Projected<D, K, B> {
    /// The kernel on `axes`, in increasing order. All vertices asked about must lie in one K-flat that projects onto
    /// these axes one to one.
    pub fn new(base: B, axes: [usize; K]) -> Self {
        Self { base, axes }
    }

    /// These axes of the projection as axes of the base, in `slots`.
    fn lift<'s>(&self, axes: &[usize], slots: &'s mut [usize; AXES_MAX]) -> &'s [usize] {
        for (slot, &axis) in slots.iter_mut().zip(axes) {
            *slot = self.axes[axis];
        }
        &slots[..axes.len()]
    }
}

impl<const D: usize, const K: usize, B: Kernel<D>> Kernel<K> for Projected<D, K, B> {
    type Reordered = Projected<D, K, B::Reordered>;

    const HIDES: bool = B::HIDES;

    fn reordered(&self, order: &[u32]) -> Self::Reordered {
        Projected { base: self.base.reordered(order), axes: self.axes }
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        self.base.orient_on(self.lift(axes, &mut [0; AXES_MAX]), simplex)
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        self.base.lifted_on(self.lift(axes, &mut [0; AXES_MAX]), simplex, q)
    }

    fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
        self.base.compare(self.axes[axis], u, v)
    }

    /// The rank is that of R^D. (On the flat the projected order is another one.)
    fn compare_lexicographic<V: Id>(&self, u: V, v: V) -> Ordering {
        self.base.compare_lexicographic(u, v)
    }
}
