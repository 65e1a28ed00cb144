//! The symbolic perturbation: ties of in_sphere decided by the lexicographic rank of the points.
//!
//! **Paper.** \[DT11\]: each point's lifted height is raised by an infinitesimal whose order of magnitude grows with the
//! point's lexicographic rank. Only the lifting is perturbed, never a position, so orientations keep their zeros.
//!
//! **In.** A simplex that is not flat on the given axes, and `q`, cospherical with it and not one of its vertices.
//! **Out.** The side of `q` after perturbation. **Cost.** At most k+2 orientations in k axes; one in the plane, where
//! four cocircular points have no three in line.
//!
//! **Why.** The lifted determinant is linear in the heights. Where it vanishes, its sign is that of the coefficient of
//! the largest infinitesimal that has one. That of `q` always does (it is the orientation of the simplex): raising `q`
//! takes it out. That of vertex `v` is the orientation with `v` replaced by `q`: raising `v` tilts the lifted
//! hyperplane up on v's side of the opposite facet, so `q` is inside if it lies on that side.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | `q` has the highest rank of all | outside | `the_highest_of_cocircular_points_is_outside` |
//! | `q` on the opposite facet's plane | that vertex says nothing, the next rank decides | `a_coplanar_tie_passes_to_the_next_rank` |

use std::cmp::Ordering;

use crate::kernel::{Id, Kernel};
use crate::{Side, Sign};

/// The most vertices a simplex can have.
const VERTICES_MAX: usize = crate::exact::AXES_MAX + 1;

/// The side of `q`, cospherical with `simplex`, whose `orientation` on `axes` is not zero.
#[cold]
pub(crate) fn tie<const D: usize, V: Id, K: Kernel<D> + ?Sized>(
    kernel: &K,
    axes: &[usize],
    simplex: &[V],
    q: V,
    orientation: Sign,
) -> Side {
    debug_assert!(simplex.iter().all(|&v| v != q), "q is a vertex of the simplex");
    let count = simplex.len();
    let mut replaced = [q; VERTICES_MAX];
    replaced[..count].copy_from_slice(simplex);
    let mut left = [true; VERTICES_MAX];
    for _ in 0..count {
        let i = highest(kernel, simplex, &left);
        if kernel.compare_lexicographic(simplex[i], q) == Ordering::Less {
            return Side::Negative; // q has the highest rank left
        }
        left[i] = false;
        replaced[i] = q;
        let coefficient = match axes.len() {
            k if k == D => kernel.orient(&replaced[..count]),
            _ => kernel.orient_on(axes, &replaced[..count]),
        };
        replaced[i] = simplex[i];
        if coefficient != Sign::Zero {
            return if coefficient == orientation { Side::Positive } else { Side::Negative };
        }
    }
    Side::Negative
}

/// The place of the vertex of the highest rank among those `left`, of which there is one. Mostly only one is asked for.
fn highest<const D: usize, V: Id, K: Kernel<D> + ?Sized>(
    kernel: &K,
    simplex: &[V],
    left: &[bool; VERTICES_MAX],
) -> usize {
    let mut places = (0..simplex.len()).filter(|&i| left[i]);
    let first = places.next().unwrap_or(0);
    places.fold(first, |best, i| {
        let higher = kernel.compare_lexicographic(simplex[i], simplex[best]);
        if higher == Ordering::Greater { i } else { best }
    })
}
