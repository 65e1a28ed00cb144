//! A kernel that notes what it is asked, in the input's own ids.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::rc::Rc;

use delone_predicates::{Id, Kernel, PlaneKernel, Sign, all_axes};

/// Questions noted for one step; more are only counted.
const NOTED_MAX: usize = 200;

/// Questions with their answers, and how many there were.
#[derive(Default)]
pub(super) struct Notes {
    lines: RefCell<Vec<String>>,
    asked: RefCell<u64>,
}

impl Notes {
    /// What was asked since the last call.
    pub(super) fn take(&self) -> (u64, Vec<String>) {
        (self.asked.take(), self.lines.take())
    }

    fn note(&self, line: impl FnOnce() -> String) {
        *self.asked.borrow_mut() += 1;
        let mut lines = self.lines.borrow_mut();
        if lines.len() < NOTED_MAX {
            lines.push(line());
        }
    }
}

/// Answers as `kernel` does.
pub(super) struct Recording<'n, K> {
    kernel: K,
    /// The input's id of each vertex, if they were put in another order.
    names: Option<Rc<[u32]>>,
    notes: &'n Notes,
}

impl<'n, K> Recording<'n, K> {
    pub(super) const fn new(kernel: K, notes: &'n Notes) -> Self {
        Self { kernel, names: None, notes }
    }

    fn name<V: Id>(&self, v: V) -> usize {
        self.names.as_ref().map_or(v.index(), |names| names[v.index()] as usize)
    }

    fn list<V: Id>(&self, simplex: &[V]) -> String {
        simplex.iter().map(|&v| self.name(v).to_string()).collect::<Vec<_>>().join(", ")
    }
}

const fn symbol(sign: Sign) -> &'static str {
    match sign {
        Sign::Negative => "< 0",
        Sign::Zero => "= 0",
        Sign::Positive => "> 0",
    }
}

impl<'n, const D: usize, K: Kernel<D>> Kernel<D> for Recording<'n, K> {
    type Reordered = Recording<'n, K::Reordered>;

    const HIDES: bool = K::HIDES;

    fn reordered(&self, order: &[u32]) -> Self::Reordered {
        let name = |v: &u32| self.names.as_ref().map_or(*v, |names| names[*v as usize]);
        let names: Rc<[u32]> = order.iter().map(name).collect();
        let kernel = self.kernel.reordered(order);
        Recording { kernel, names: Some(names), notes: self.notes }
    }

    fn orient_on<V: Id>(&self, axes: &[usize], simplex: &[V]) -> Sign {
        let sign = self.kernel.orient_on(axes, simplex);
        let on = if axes == all_axes::<D>() { String::new() } else { format!(" on {axes:?}") };
        self.notes.note(|| format!("orient({}){on} {}", self.list(simplex), symbol(sign)));
        sign
    }

    fn lifted_on<V: Id>(&self, axes: &[usize], simplex: &[V], q: V) -> Sign {
        let sign = self.kernel.lifted_on(axes, simplex, q);
        self.notes.note(|| {
            format!("in_sphere({}; {}) {}", self.list(simplex), self.name(q), symbol(sign))
        });
        sign
    }

    fn compare<V: Id>(&self, axis: usize, u: V, v: V) -> Ordering {
        self.kernel.compare(axis, u, v)
    }
}

impl<K: PlaneKernel> PlaneKernel for Recording<'_, K> {
    fn cross<V: Id>(&self, vertices: [V; 4]) -> Sign {
        let sign = self.kernel.cross(vertices);
        self.notes.note(|| format!("cross({}) {}", self.list(&vertices), symbol(sign)));
        sign
    }
}
