//! The kernel: what an algorithm may ask about vertices, by id.
//!
//! No algorithm computes with coordinates. It holds a `Kernel<D>` and ids; plain sites, exact-only arithmetic, sites
//! restricted to a flat ([`crate::Projected`]) are kernels, and each algorithm is written once for all of them.

use std::cmp::Ordering;

use crate::{Outlook, Side, Sight, Sign, Stage, perturb};

/// A vertex id as kernels take it: anything small that turns into an index.
pub trait Id: Copy + Eq {
    /// The index of the vertex.
    fn index(self) -> usize;
}

impl<T: Copy + Eq + Into<usize>> Id for T {
    #[inline(always)]
    fn index(self) -> usize {
        self.into()
    }
}

/// All the axes of R^D, `[0, 1, .., D - 1]`.
#[inline(always)]
#[must_use]
pub fn all_axes<const D: usize>() -> [usize; D] {
    std::array::from_fn(|axis| axis)
}

/// Exact answers about vertices of R^D, named by id.
///
/// A *simplex* in k axes is k+1 ids. Three methods are the implementor's; everything else follows from them.
pub trait Kernel<const D: usize> {
    /// The same kernel over vertices in another order, owning its data.
    type Reordered: Kernel<D>;

    /// Whether a site may be hidden: in conflict with no cell, and a vertex of none. So it is with weights.
    const HIDES: bool = false;

    /// Whether this kernel can [`Kernel::look`].
    const LOOKS: bool = false;

    /// The kernel whose vertex `i` is this one's vertex `order[i]`, laid out in that order.
    fn reordered(&self, order: &[u32]) -> Self::Reordered;

    /// The orientation of a simplex projected onto some axes: the sign of `det[p1 - p0; ..; pk - p0]`.
    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign;

    /// Unperturbed: positive if `q` is strictly inside the circumsphere of a simplex that is positively oriented on
    /// `axes`, all these vertices lying in one flat on which those axes are independent.
    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign;

    /// The order of two vertices along one axis.
    fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering;

    /// The orientation of D+1 vertices: positive for a left turn in the plane.
    #[inline]
    fn orient<V: Id>(&self, simplex: &[V]) -> Sign {
        self.orient_on(&all_axes::<D>(), simplex)
    }

    /// Unperturbed in-sphere of a positively oriented simplex of D+1 vertices: positive is inside, zero on the sphere.
    #[inline]
    fn lifted<V: Id>(&self, simplex: &[V], q: V) -> Sign {
        self.lifted_on(&all_axes::<D>(), simplex, q)
    }

    /// [`Kernel::orient`], and the stage that answered.
    #[inline]
    fn orient_staged<V: Id>(&self, simplex: &[V]) -> (Sign, Stage) {
        (self.orient(simplex), Stage::Untold)
    }

    /// [`Kernel::lifted`], and the stage that answered.
    #[inline]
    fn lifted_staged<V: Id>(&self, simplex: &[V], q: V) -> (Sign, Stage) {
        (self.lifted(simplex, q), Stage::Untold)
    }

    /// The lexicographic order of two vertices; equal only for equal positions.
    #[inline]
    fn compare_lexicographic<V: Id>(&self, u: V, v: V) -> Ordering {
        (0..D).map(|axis| self.compare(axis, u, v)).find(|o| o.is_ne()).unwrap_or(Ordering::Equal)
    }

    /// Whether `q` is in the circumsphere of a positively oriented simplex of D+1 vertices, under the symbolic
    /// perturbation ([`crate::perturb`]): never a tie. `q` must differ from the simplex's vertices.
    #[inline]
    fn in_sphere<V: Id>(&self, simplex: &[V], q: V) -> Side {
        match self.lifted(simplex, q).side() {
            Some(side) => side,
            None => self.tied(simplex, q),
        }
    }

    /// [`Kernel::in_sphere`] where [`Kernel::lifted`] is known to be zero.
    #[inline]
    fn tied<V: Id>(&self, simplex: &[V], q: V) -> Side {
        perturb::tie(self, &all_axes::<D>(), simplex, q, Sign::Positive)
    }

    /// How `q` sees another vertex.
    #[inline(always)]
    fn see<V: Id>(&self, sight: &mut Sight, vertex: V, q: V) {
        let _ = (sight, vertex, q);
    }

    /// Prepares for questions about the cells around a cell, positively oriented, whose corners `q` sees so: whether `q` is in their
    /// spheres.
    #[inline(always)]
    fn look(&self, outlook: &mut Outlook, corners: [&Sight; 4]) {
        let _ = (outlook, corners);
    }

    /// [`Kernel::lifted`] of `q` and the cell beyond the facet opposite `corner` of the cell that `q` looked at; its apex is seen so, and
    /// so is `end`, the cell's vertex at corner `corner ^ 1`. `None` if that is to be asked the ordinary way.
    #[inline(always)]
    fn lifted_beyond(
        &self,
        outlook: &Outlook,
        corner: usize,
        end: &Sight,
        apex: &Sight,
    ) -> Option<Sign> {
        let _ = (outlook, corner, end, apex);
        None
    }

    /// Whether `q` is in the smallest sphere through D vertices that span a hyperplane containing `q`, that is, in
    /// their circumsphere within the hyperplane; perturbed. The facet may have either orientation.
    ///
    /// # Panics
    /// If the facet's vertices are affinely dependent.
    fn in_sphere_within<V: Id>(&self, facet: &[V], q: V) -> Side {
        let all = all_axes::<D>();
        let mut kept = [0; D];
        for dropped in 0..D {
            kept[..dropped].copy_from_slice(&all[..dropped]);
            kept[dropped..D - 1].copy_from_slice(&all[dropped + 1..]);
            let axes = &kept[..D - 1];
            let orientation = self.orient_on(axes, facet);
            if orientation != Sign::Zero {
                let sign = orientation * self.lifted_on(axes, facet, q);
                return match sign.side() {
                    Some(side) => side,
                    None => perturb::tie(self, axes, facet, q, orientation),
                };
            }
        }
        panic!(
            "a facet of the hull is never flat in all projections: its vertices are affinely dependent"
        );
    }
}

/// A kernel that is lent.
impl<const D: usize, K: Kernel<D>> Kernel<D> for &K {
    type Reordered = K::Reordered;

    const HIDES: bool = K::HIDES;

    const LOOKS: bool = K::LOOKS;

    fn reordered(&self, order: &[u32]) -> Self::Reordered {
        (**self).reordered(order)
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        (**self).orient_on(axes, simplex)
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        (**self).lifted_on(axes, simplex, q)
    }

    fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
        (**self).compare(axis, u, v)
    }

    fn orient<V: Id>(&self, simplex: &[V]) -> Sign {
        (**self).orient(simplex)
    }

    fn lifted<V: Id>(&self, simplex: &[V], q: V) -> Sign {
        (**self).lifted(simplex, q)
    }

    fn orient_staged<V: Id>(&self, simplex: &[V]) -> (Sign, Stage) {
        (**self).orient_staged(simplex)
    }

    fn lifted_staged<V: Id>(&self, simplex: &[V], q: V) -> (Sign, Stage) {
        (**self).lifted_staged(simplex, q)
    }

    fn compare_lexicographic<V: Id>(&self, u: V, v: V) -> Ordering {
        (**self).compare_lexicographic(u, v)
    }

    fn in_sphere<V: Id>(&self, simplex: &[V], q: V) -> Side {
        (**self).in_sphere(simplex, q)
    }

    fn in_sphere_within<V: Id>(&self, facet: &[V], q: V) -> Side {
        (**self).in_sphere_within(facet, q)
    }

    fn tied<V: Id>(&self, simplex: &[V], q: V) -> Side {
        (**self).tied(simplex, q)
    }

    #[inline(always)]
    fn see<V: Id>(&self, sight: &mut Sight, vertex: V, q: V) {
        (**self).see(sight, vertex, q);
    }

    #[inline(always)]
    fn look(&self, outlook: &mut Outlook, corners: [&Sight; 4]) {
        (**self).look(outlook, corners);
    }

    #[inline(always)]
    fn lifted_beyond(
        &self,
        outlook: &Outlook,
        corner: usize,
        end: &Sight,
        apex: &Sight,
    ) -> Option<Sign> {
        (**self).lifted_beyond(outlook, corner, end, apex)
    }
}

/// What algorithms in the plane ask besides.
pub trait PlaneKernel: Kernel<2> {
    /// The sign of `(b - a) x (d - c)`: positive if `d` is higher than `c` above the line from `a` to `b`.
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign;
}
