//! A kernel that counts what it is asked, and which stage answered.

use std::cell::Cell;
use std::cmp::Ordering;

use crate::kernel::{Id, Kernel, PlaneKernel, all_axes};
use crate::{Side, Sign, Stage, perturb};

/// What was asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Question {
    /// The orientation of a simplex in all axes.
    Orient,
    /// A lifted determinant in all axes: in_circle, in_sphere.
    Lifted,
    /// An orientation or a lifted determinant on some axes.
    OnAxes,
    /// The sign of a cross product.
    Cross,
    /// The order of two vertices along an axis or lexicographically.
    Compare,
}

impl Question {
    /// All, in order.
    pub const ALL: [Self; 5] =
        [Self::Orient, Self::Lifted, Self::OnAxes, Self::Cross, Self::Compare];
}

/// Calls by question and stage. One for each thread; [`Tally::merge`] adds them up.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    calls: [[Cell<u64>; Stage::ALL.len()]; Question::ALL.len()],
    perturbed: Cell<u64>,
}

impl Tally {
    /// How often a stage answered a question.
    #[must_use]
    pub fn answered(&self, question: Question, stage: Stage) -> u64 {
        self.calls[question as usize][stage as usize].get()
    }

    /// How often a question was asked.
    #[must_use]
    pub fn asked(&self, question: Question) -> u64 {
        Stage::ALL.iter().map(|&stage| self.answered(question, stage)).sum()
    }

    /// How many ties the perturbation decided.
    #[must_use]
    pub fn perturbed(&self) -> u64 {
        self.perturbed.get()
    }

    /// Adds the counts of another.
    pub fn merge(&self, other: &Self) {
        let pairs = self.calls.iter().flatten().zip(other.calls.iter().flatten());
        for (cell, more) in pairs.chain([(&self.perturbed, &other.perturbed)]) {
            cell.set(cell.get() + more.get());
        }
    }

    fn count(&self, question: Question, stage: Stage) {
        let cell = &self.calls[question as usize][stage as usize];
        cell.set(cell.get() + 1);
    }
}

/// Answers as `kernel` does, and counts into a tally, as do the kernels that it is reordered to.
///
/// ```
/// use delone_predicates::{Adaptive, Counting, Kernel, Question, Stage, Tally};
/// let tally = Tally::default();
/// let kernel = Counting::new(Adaptive::new([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]), &tally);
/// kernel.in_sphere(&[0usize, 1, 2], 3);
/// assert_eq!(tally.answered(Question::Lifted, Stage::StaticFilter), 1); // nothing is rounded on so small a lattice
/// assert_eq!(tally.perturbed(), 1);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Counting<'t, K> {
    kernel: K,
    tally: &'t Tally,
}

impl<'t, K> Counting<'t, K> {
    /// `kernel`, counted into `tally`.
    pub const fn new(kernel: K, tally: &'t Tally) -> Self {
        Self { kernel, tally }
    }
}

impl<'t, const D: usize, K: Kernel<D>> Kernel<D> for Counting<'t, K> {
    type Reordered = Counting<'t, K::Reordered>;

    const HIDES: bool = K::HIDES;

    fn reordered(&self, order: &[u32]) -> Self::Reordered {
        Counting::new(self.kernel.reordered(order), self.tally)
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        if *axes == all_axes::<D>() {
            return self.orient(simplex);
        }
        self.tally.count(Question::OnAxes, Stage::Untold);
        self.kernel.orient_on(axes, simplex)
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        if *axes == all_axes::<D>() {
            return self.lifted(simplex, q);
        }
        self.tally.count(Question::OnAxes, Stage::Untold);
        self.kernel.lifted_on(axes, simplex, q)
    }

    fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
        self.tally.count(Question::Compare, Stage::Untold);
        self.kernel.compare(axis, u, v)
    }

    fn compare_lexicographic<V: Id>(&self, u: V, v: V) -> Ordering {
        self.tally.count(Question::Compare, Stage::Untold);
        self.kernel.compare_lexicographic(u, v)
    }

    fn orient<V: Id>(&self, simplex: &[V]) -> Sign {
        self.orient_staged(simplex).0
    }

    fn lifted<V: Id>(&self, simplex: &[V], q: V) -> Sign {
        self.lifted_staged(simplex, q).0
    }

    fn orient_staged<V: Id>(&self, simplex: &[V]) -> (Sign, Stage) {
        let (sign, stage) = self.kernel.orient_staged(simplex);
        self.tally.count(Question::Orient, stage);
        (sign, stage)
    }

    fn lifted_staged<V: Id>(&self, simplex: &[V], q: V) -> (Sign, Stage) {
        let (sign, stage) = self.kernel.lifted_staged(simplex, q);
        self.tally.count(Question::Lifted, stage);
        (sign, stage)
    }

    fn in_sphere<V: Id>(&self, simplex: &[V], q: V) -> Side {
        self.lifted(simplex, q).side().unwrap_or_else(|| {
            self.tally.perturbed.set(self.tally.perturbed.get() + 1);
            perturb::tie(self, &all_axes::<D>(), simplex, q, Sign::Positive)
        })
    }
}

impl<K: PlaneKernel> PlaneKernel for Counting<'_, K> {
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        self.tally.count(Question::Cross, Stage::Untold);
        self.kernel.cross(vertices)
    }
}
