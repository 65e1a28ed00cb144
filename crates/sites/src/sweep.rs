//! A sweep over noded segments: what is next below and above each site, and whether any two segments cross.
//!
//! **Paper.** [SH76]. The segments that the sweep line meets are kept in their order along it. Two segments that cross are
//! neighbours in that order just before the first crossing, so it suffices to look at those that become neighbours.
//! **In.** Vertices numbered in lexicographic order, the order of the sweep; segments over them, smaller end first, that are
//! noded but for crossings: no vertex lies inside a segment, no two are equal. **Cost.** O((n + m) log m) orientations: one search
//! for each vertex finds the segments that end there side by side, what is next below and above them, and where those that
//! begin there go.
//! **Invariant.** 1. Until the first crossing the segments alive are totally ordered along the line.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | equal abscissae, vertical segments | the order is lexicographic: as if sheared by an infinitesimal | `the_sweep_agrees_with_all_pairs` |
//! | segments with a common end | are ordered by their other ends, and do not cross | `spokes_with_a_common_end_do_not_cross` |

mod line;

use std::cmp::Ordering;

use delone_predicates::{Kernel, Sign};
use line::{Line, Place};

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
        let place = sweep.end_at(vertex);
        neighbours.push(sweep.alive.around(place));
        sweep.begin_at(vertex, place);
    }
    neighbours
}

/// Whether the interiors of any two segments meet.
pub(crate) fn any_crossing(kernel: &impl Kernel<2>, count: usize, segments: &[Ends]) -> bool {
    let cross = |e: Option<u32>, f: Option<u32>| {
        let (Some(e), Some(f)) = (e, f) else { return false };
        let ([a, b], [c, d]) = (segments[e as usize], segments[f as usize]);
        orient(kernel, a, b, c) * orient(kernel, a, b, d) == Sign::Negative
            && orient(kernel, c, d, a) * orient(kernel, c, d, b) == Sign::Negative
    };
    let mut has_segment = vec![false; count];
    segments.iter().flatten().for_each(|&vertex| has_segment[vertex as usize] = true);
    let mut sweep = Sweep::new(kernel, segments);
    (0u32..).zip(has_segment).filter(|&(_, has)| has).any(|(vertex, _)| {
        let place = sweep.end_at(vertex);
        let [below, above] = sweep.alive.around(place);
        match sweep.begin_at(vertex, place) {
            None => cross(below, above),
            Some([lowest, highest]) => cross(below, Some(lowest)) || cross(Some(highest), above),
        }
    })
}

fn orient(kernel: &impl Kernel<2>, a: u32, b: u32, v: u32) -> Sign {
    kernel.orient(&[a as usize, b as usize, v as usize])
}

/// The segments that the line meets, and those to come.
struct Sweep<'k, K> {
    kernel: &'k K,
    segments: &'k [Ends],
    alive: Line,
    /// Segments by first end.
    begins: Vec<(u32, u32)>,
    begun: usize,
}

impl<'k, K: Kernel<2>> Sweep<'k, K> {
    fn new(kernel: &'k K, segments: &'k [Ends]) -> Self {
        let mut begins: Vec<(u32, u32)> = segments.iter().map(|ends| ends[0]).zip(0u32..).collect();
        begins.sort_unstable();
        Self { kernel, segments, alive: Line::default(), begins, begun: 0 }
    }

    /// Takes out the segments that end at `vertex`; the place where they were, which is the vertex's.
    fn end_at(&mut self, vertex: u32) -> Place {
        let mut place = self.alive.search(|segment| {
            let [a, b] = self.segments[segment as usize];
            match orient(self.kernel, a, b, vertex) {
                Sign::Positive => true,
                Sign::Zero if b != vertex => {
                    panic!("segment {segment} is not noded: vertex {vertex} lies inside it")
                }
                Sign::Zero | Sign::Negative => false,
            }
        });
        // Those that end here lie side by side: the order is total. (Inv 1)
        while self.alive.at(place).is_some_and(|e| self.segments[e as usize][1] == vertex) {
            place = self.alive.remove(place);
        }
        place
    }

    /// Puts in the segments that begin at `vertex`, whose place is given; the lowest and the highest of them.
    fn begin_at(&mut self, vertex: u32, mut place: Place) -> Option<[u32; 2]> {
        let from = self.begun;
        while self.begins.get(self.begun).is_some_and(|&(v, _)| v == vertex) {
            self.begun += 1;
        }
        let new = &mut self.begins[from..self.begun];
        let (kernel, segments) = (self.kernel, self.segments);
        new.sort_unstable_by(|&(_, e), &(_, f)| compare_along(kernel, segments, e, f));
        let ends = [new.first()?.1, new.last()?.1];
        for &(_, segment) in new.iter().rev() {
            place = self.alive.insert(place, segment);
        }
        Some(ends)
    }
}
