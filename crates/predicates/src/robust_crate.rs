//! The kernel of the crate `robust`: Shewchuk's adaptive expansions, to compare with.

use std::cmp::Ordering;

use robust::{Coord, Coord3D};

use crate::Sign;
use crate::adaptive::{compare, gather, lifted_exactly, orient_exactly, point, same};
use crate::kernel::{Id, Kernel, PlaneKernel, all_axes};

/// `robust`'s orient2d, incircle, orient3d and insphere. Right while no product under- or overflows.
///
/// What `robust` has not is answered by exact integers: other dimensions, lifted determinants on some of the axes (ties
/// within a hull facet), and the sign of a cross product of four points.
#[derive(Clone, Copy, Debug)]
pub struct RobustCrate<P> {
    points: P,
}

impl<P> RobustCrate<P> {
    /// A kernel over these points.
    pub const fn new(points: P) -> Self {
        Self { points }
    }
}

fn coord<const D: usize>(point: &[f64; D]) -> Coord<f64> {
    let &[x, y] = same(point);
    Coord { x, y }
}

fn coord3d<const D: usize>(point: &[f64; D]) -> Coord3D<f64> {
    let &[x, y, z] = same(point);
    Coord3D { x, y, z }
}

impl<const D: usize, P: AsRef<[[f64; D]]>> Kernel<D> for RobustCrate<P> {
    type Reordered = RobustCrate<Vec<[f64; D]>>;

    fn reordered(&self, order: &[u32]) -> Self::Reordered {
        RobustCrate::new(gather(self.points.as_ref(), order))
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        let at = |v| point(&self.points, v);
        match (axes, simplex) {
            (&[i, j], &[a, b, c]) => {
                let [a, b, c] = [a, b, c].map(|v| Coord { x: at(v)[i], y: at(v)[j] });
                Sign::of(robust::orient2d(a, b, c))
            }
            (&[i, j, k], &[a, b, c, d]) => {
                let [a, b, c, d] =
                    [a, b, c, d].map(|v| Coord3D { x: at(v)[i], y: at(v)[j], z: at(v)[k] });
                Sign::of(-robust::orient3d(a, b, c, d)) // positive there: d below the plane
            }
            _ => orient_exactly(&self.points, axes, simplex).0,
        }
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        if *axes == all_axes::<D>() {
            self.lifted(simplex, q)
        } else {
            lifted_exactly(&self.points, axes, simplex, q).0
        }
    }

    #[inline]
    fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
        compare(&self.points, axis, u, v)
    }

    #[inline]
    fn lifted<V: Id>(&self, simplex: &[V], q: V) -> Sign {
        let at = |v| point(&self.points, v);
        match *simplex {
            [a, b, c] if D == 2 => {
                let [a, b, c, q] = [a, b, c, q].map(|v| coord(at(v)));
                Sign::of(robust::incircle(a, b, c, q))
            }
            [a, b, c, d] if D == 3 => {
                let [a, b, c, d, q] = [a, b, c, d, q].map(|v| coord3d(at(v)));
                Sign::of(-robust::insphere(a, b, c, d, q)) // of the other orientation there
            }
            _ => lifted_exactly(&self.points, &all_axes::<D>(), simplex, q).0,
        }
    }
}

impl<P: AsRef<[[f64; 2]]>> PlaneKernel for RobustCrate<P> {
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        let [a, b, c, d] = vertices.map(|v| point(&self.points, v));
        crate::exact::cross(a, b, c, d).0
    }
}
