//! A sweep over noded segments: what is next below and above each site, and whether any two segments cross.
//!
//! **Paper.** [SH76]. The segments that the sweep line meets are kept in their order along it. Two segments that cross are
//! neighbours in that order just before the first crossing, so it suffices to look at those that become neighbours.
//! **In.** Vertices numbered in lexicographic order, the order of the sweep; segments over them, smaller end first, that are
//! noded but for crossings: no vertex lies inside a segment, no two are equal. **Cost.** O((n + m) log m) orientations.
//! **Invariant.** 1. Until the first crossing the segments alive are totally ordered along the line.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | equal abscissae, vertical segments | the order is lexicographic: as if sheared by an infinitesimal | `the_sweep_agrees_with_all_pairs` |
//! | segments with a common end | are ordered by their other ends, and do not cross | `spokes_with_a_common_end_do_not_cross` |

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::ops::Bound;

use delone_predicates::{Kernel, Sign};

/// A segment by its ends, the smaller vertex first.
pub type Ends = [u32; 2];

/// The order from bottom to top of two segments that the sweep line meets at once.
///
/// # Panics
/// If an end of one lies inside the other.
pub fn compare_along(kernel: &impl Kernel<2>, segments: &[Ends], e: u32, f: u32) -> Ordering {
    if e == f {
        return Ordering::Equal;
    }
    let ([a, b], [c, d]) = (segments[e as usize], segments[f as usize]);
    // The sign of "e is above f", seen from an end of one that lies between the ends of the other.
    let above = if a == c {
        orient(kernel, a, d, b)
    } else if a > c {
        orient(kernel, c, d, a)
    } else {
        -orient(kernel, a, b, c)
    };
    match above {
        Sign::Positive => Ordering::Greater,
        Sign::Negative => Ordering::Less,
        Sign::Zero => {
            panic!("segments {e} and {f} are not noded: an end of one lies inside the other")
        }
    }
}

/// For each vertex the segments next below and above, among those that begin before it and end after it.
///
/// # Panics
/// If a vertex lies inside a segment.
pub fn below_and_above(
    kernel: &impl Kernel<2>,
    count: usize,
    segments: &[Ends],
) -> Vec<[Option<u32>; 2]> {
    let mut neighbours = Vec::with_capacity(count);
    let mut sweep = Sweep::new(kernel, segments);
    for vertex in (0u32..).take(count) {
        sweep.end_at(vertex, |_, _| false);
        neighbours.push(sweep.around(At::Vertex(vertex)));
        sweep.begin_at(vertex, |_, _| false);
    }
    neighbours
}

/// Whether the interiors of any two segments meet.
pub(crate) fn any_crossing(kernel: &impl Kernel<2>, count: usize, segments: &[Ends]) -> bool {
    let crosses = |e: u32, f: u32| {
        let ([a, b], [c, d]) = (segments[e as usize], segments[f as usize]);
        orient(kernel, a, b, c) * orient(kernel, a, b, d) == Sign::Negative
            && orient(kernel, c, d, a) * orient(kernel, c, d, b) == Sign::Negative
    };
    let mut sweep = Sweep::new(kernel, segments);
    (0u32..)
        .take(count)
        .any(|vertex| sweep.end_at(vertex, crosses) || sweep.begin_at(vertex, crosses))
}

fn orient(kernel: &impl Kernel<2>, a: u32, b: u32, v: u32) -> Sign {
    kernel.orient(&[a as usize, b as usize, v as usize])
}

/// A place along the sweep line.
#[derive(Clone, Copy)]
enum At {
    Segment(u32),
    /// A vertex on no segment that is alive.
    Vertex(u32),
}

/// A place with what it takes to compare it.
struct Place<'k, K> {
    kernel: &'k K,
    segments: &'k [Ends],
    at: At,
}

impl<K: Kernel<2>> Place<'_, K> {
    fn against(&self, vertex: u32, segment: u32) -> Ordering {
        let [a, b] = self.segments[segment as usize];
        match orient(self.kernel, a, b, vertex) {
            Sign::Positive => Ordering::Greater,
            Sign::Negative => Ordering::Less,
            Sign::Zero => panic!("segment {segment} is not noded: vertex {vertex} lies inside it"),
        }
    }
}

impl<K: Kernel<2>> Ord for Place<'_, K> {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self.at, other.at) {
            (At::Segment(e), At::Segment(f)) => compare_along(self.kernel, self.segments, e, f),
            (At::Vertex(v), At::Segment(e)) => self.against(v, e),
            (At::Segment(e), At::Vertex(v)) => self.against(v, e).reverse(),
            (At::Vertex(u), At::Vertex(v)) => u.cmp(&v),
        }
    }
}

impl<K: Kernel<2>> PartialOrd for Place<'_, K> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<K: Kernel<2>> PartialEq for Place<'_, K> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl<K: Kernel<2>> Eq for Place<'_, K> {}

/// The segments that the line meets, and those to come.
struct Sweep<'k, K> {
    kernel: &'k K,
    segments: &'k [Ends],
    alive: BTreeSet<Place<'k, K>>,
    /// Segments by first end.
    begins: Vec<(u32, u32)>,
    /// Segments by second end.
    ends: Vec<(u32, u32)>,
    begun: usize,
    ended: usize,
}

impl<'k, K: Kernel<2>> Sweep<'k, K> {
    fn new(kernel: &'k K, segments: &'k [Ends]) -> Self {
        let by_end = |end: usize| {
            let mut list: Vec<(u32, u32)> =
                segments.iter().map(|ends| ends[end]).zip(0u32..).collect();
            list.sort_unstable();
            list
        };
        let (begins, ends) = (by_end(0), by_end(1));
        Self { kernel, segments, alive: BTreeSet::new(), begins, ends, begun: 0, ended: 0 }
    }

    fn place(&self, at: At) -> Place<'k, K> {
        Place { kernel: self.kernel, segments: self.segments, at }
    }

    /// The segments next below and above a place.
    fn around(&self, at: At) -> [Option<u32>; 2] {
        let here = self.place(at);
        let below = self.alive.range((Bound::Unbounded, Bound::Excluded(&here))).next_back();
        let above = self.alive.range((Bound::Excluded(&here), Bound::Unbounded)).next();
        [below, above].map(|found| match found?.at {
            At::Segment(segment) => Some(segment),
            At::Vertex(_) => None,
        })
    }

    /// Takes out the segments that end at `vertex`; whether two that become neighbours `meet`.
    fn end_at(&mut self, vertex: u32, meet: impl Fn(u32, u32) -> bool) -> bool {
        while let Some(&(_, segment)) = self.ends.get(self.ended).filter(|(v, _)| *v == vertex) {
            self.ended += 1;
            self.alive.remove(&self.place(At::Segment(segment)));
        }
        match self.around(At::Vertex(vertex)) {
            [Some(below), Some(above)] => meet(below, above),
            _ => false,
        }
    }

    /// Puts in the segments that begin at `vertex`; whether one and a neighbour `meet`.
    fn begin_at(&mut self, vertex: u32, meet: impl Fn(u32, u32) -> bool) -> bool {
        while let Some(&(_, segment)) = self.begins.get(self.begun).filter(|(v, _)| *v == vertex) {
            self.begun += 1;
            let near = self.around(At::Segment(segment));
            if near.into_iter().flatten().any(|neighbour| meet(neighbour, segment)) {
                return true;
            }
            self.alive.insert(self.place(At::Segment(segment)));
        }
        false
    }
}
