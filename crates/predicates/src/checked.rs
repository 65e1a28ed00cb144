//! A kernel that is watched by another.

use std::cmp::Ordering;

use crate::kernel::{Id, Kernel, PlaneKernel};
use crate::{Sign, Stage};

/// Answers as `kernel` does, and panics where `judge` would answer otherwise.
///
/// ```
/// use delone_predicates::{Adaptive, Checked, Exact, Kernel, Sign};
/// let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let kernel = Checked::new(Adaptive::new(points), Exact::new(points));
/// assert_eq!(kernel.orient(&[0usize, 1, 2]), Sign::Positive);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Checked<K, J> {
    kernel: K,
    judge: J,
}

impl<K, J> Checked<K, J> {
    /// `kernel` watched by `judge`, over the same points.
    pub const fn new(kernel: K, judge: J) -> Self {
        Self { kernel, judge }
    }
}

/// The answer, if both give it.
fn agreed<A: PartialEq + std::fmt::Debug>(
    answer: A,
    expected: &A,
    what: &str,
    ids: impl Iterator<Item = usize>,
) -> A {
    assert!(
        answer == *expected,
        "{what} of {:?} is {answer:?}, and should be {expected:?}",
        ids.collect::<Vec<_>>()
    );
    answer
}

impl<const D: usize, K: Kernel<D>, J: Kernel<D>> Kernel<D> for Checked<K, J> {
    type Reordered = Checked<K::Reordered, J::Reordered>;

    const HIDES: bool = K::HIDES;

    fn reordered(&self, order: &[u32]) -> Self::Reordered {
        Checked::new(self.kernel.reordered(order), self.judge.reordered(order))
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        let ids = simplex.iter().map(|v| v.index());
        let expected = self.judge.orient_on(axes, simplex);
        agreed(self.kernel.orient_on(axes, simplex), &expected, "orient_on", ids)
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        let ids = simplex.iter().chain([&q]).map(|v| v.index());
        let expected = self.judge.lifted_on(axes, simplex, q);
        agreed(self.kernel.lifted_on(axes, simplex, q), &expected, "lifted_on", ids)
    }

    fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
        let expected = self.judge.compare(axis, u, v);
        let ids = [u, v].into_iter().map(Id::index);
        agreed(self.kernel.compare(axis, u, v), &expected, "compare", ids)
    }

    fn compare_lexicographic<V: Id>(&self, u: V, v: V) -> Ordering {
        let expected = self.judge.compare_lexicographic(u, v);
        let ids = [u, v].into_iter().map(Id::index);
        agreed(self.kernel.compare_lexicographic(u, v), &expected, "compare_lexicographic", ids)
    }

    fn orient<V: Id>(&self, simplex: &[V]) -> Sign {
        self.orient_staged(simplex).0
    }

    fn lifted<V: Id>(&self, simplex: &[V], q: V) -> Sign {
        self.lifted_staged(simplex, q).0
    }

    fn orient_staged<V: Id>(&self, simplex: &[V]) -> (Sign, Stage) {
        let (sign, stage) = self.kernel.orient_staged(simplex);
        let ids = simplex.iter().map(|v| v.index());
        (agreed(sign, &self.judge.orient(simplex), "orient", ids), stage)
    }

    fn lifted_staged<V: Id>(&self, simplex: &[V], q: V) -> (Sign, Stage) {
        let (sign, stage) = self.kernel.lifted_staged(simplex, q);
        let ids = simplex.iter().chain([&q]).map(|v| v.index());
        (agreed(sign, &self.judge.lifted(simplex, q), "lifted", ids), stage)
    }
}

impl<K: PlaneKernel, J: PlaneKernel> PlaneKernel for Checked<K, J> {
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        let ids = vertices.into_iter().map(Id::index);
        agreed(self.kernel.cross(vertices), &self.judge.cross(vertices), "cross", ids)
    }
}
