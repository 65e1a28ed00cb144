//! The laws: what holds of every input, whatever it is.
//!
//! | law | says |
//! |---|---|
//! | `valid` | every algorithm's result is what the judge calls (constrained) Delaunay, on the raw input |
//! | `agreement` | all algorithms, orders, kernels and seeds give the same cells |
//! | `order` | the fingerprint depends on the points, not on their order |
//! | `scaling` | times 2^k, where exact: the same cells |
//! | `translation` | moved, where exact: the same cells |
//! | `symmetry` | reflected or turned: the same Delaunay cells |
//! | `euler` | the numbers of cells, facets and vertices fit |
//! | `definition` | on small inputs, brute force by the definition finds the same cells |
//! | `removal` | sites taken out leave what the others make from scratch, and put back make what was there |
//! | `weights` | the regular triangulation is what the judge, and brute force, call so |
//! | `fill` | what is inside by each rule is what the judge says |
//! | `idempotence` | the CDT of a CDT's own edges is itself; without segments it is the Delaunay triangulation |
//! | `area between`, `volume between` | the inner tree is not larger than what is inside, the outer one not smaller |
//! | `codes` | every code of a tree leads back to it; leaves are (2^N - 1) gray + 1 |
//! | `algebra` | trees are sets |
//! | `components` | those of the raster, flooded |

mod constrained;
mod crossings;
mod delaunay;
pub mod trees;

pub use constrained::constrained_laws;
pub use crossings::crossings;
pub use delaunay::delaunay_laws;
pub use trees::{octree_laws, quadtree_laws};

use delone::delaunay::{KernelKind, Options, Order};

use crate::case::Case;
use crate::exact;

/// A law with its name.
#[derive(Clone, Copy, Debug)]
pub struct Law<const D: usize> {
    /// Its name in the table above.
    pub name: &'static str,
    /// Panics if the input breaks it; says in how many ways it was tried.
    pub hold: fn(&Case<D>) -> usize,
}

/// Demands every law of one input.
pub fn obey<const D: usize>(laws: &[Law<D>], case: &Case<D>) {
    for law in laws {
        let _times = (law.hold)(case);
    }
}

/// Inputs of at most this many points are judged in every way.
const THOROUGH_MAX: usize = 40;

/// Every way to run an algorithm.
#[must_use]
pub fn all_options() -> Vec<Options> {
    let orders = [Order::Brio, Order::Hilbert, Order::AsGiven, Order::Lexicographic];
    let kernels = [KernelKind::Adaptive, KernelKind::Exact];
    let mut all = Vec::new();
    for order in orders {
        for kernel in kernels {
            let seeds = if order == Order::Brio { 0..3 } else { 0..1 };
            all.extend(seeds.map(|seed| Options { kernel, order, seed, ..Options::default() }));
        }
    }
    all
}

/// The exact images of the case times powers of two.
fn scalings<const D: usize>(case: &Case<D>) -> Vec<Case<D>> {
    let powers = [-1, 1, -52, 53, -300, 300, -900, 900];
    let exact = powers.into_iter().filter_map(|k| {
        let points = exact::scaled(&case.points, k)?;
        Some(Case { name: format!("{}, times 2^{k}", case.name), points, ..case.clone() })
    });
    exact.collect()
}

/// The exact translates of the case.
fn translations<const D: usize>(case: &Case<D>) -> Vec<Case<D>> {
    let steps = [1.0, -3.0, 1024.0, 1e6, -12_345_678.0];
    let exact = steps.into_iter().filter_map(|step| {
        let mut offset = [step; D];
        offset[0] = -2.0 * step;
        let points = exact::translated(&case.points, offset)?;
        Some(Case { name: format!("{}, moved by {offset:?}", case.name), points, ..case.clone() })
    });
    exact.collect()
}

/// Reflections, quarter turns, and exchanged axes.
fn symmetries<const D: usize>(case: &Case<D>) -> Vec<Case<D>> {
    let last = D - 1;
    let flip = |mut p: [f64; D]| {
        p[0] = -p[0];
        p
    };
    let exchange = |mut p: [f64; D]| {
        p.swap(0, last);
        p
    };
    vec![
        case.mapped("reflected", flip),
        case.mapped("axes exchanged", exchange),
        case.mapped("turned", |p| flip(exchange(p))),
        case.mapped("negated", |p| p.map(|x| -x)),
    ]
}
