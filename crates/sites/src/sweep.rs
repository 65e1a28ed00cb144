//! A sweep over segments: cuts them at the vertices on them, tells what is next below and above each vertex, and whether any
//! two segments cross.
//!
//! **Paper.** [SH76]. The pieces that the sweep line meets are kept in their order along it. Two that cross are
//! neighbours in that order just before the first crossing, so it suffices to look at those that become neighbours. Where we add:
//! a piece ends at each vertex that the line finds on it, and what goes on from there begins anew; segments over one
//! another are one piece, as long as they are.
//! **In.** Vertices numbered in lexicographic order, the order of the sweep; segments over them, smaller end first, or of no
//! length: those are skipped. **Out.** The noded pieces; nothing if two segments cross, at a vertex or elsewhere.
//! **Cost.** O((n + m) log m) orientations for m pieces: one search for each vertex finds the pieces that end there side by side,
//! what is next below and above them, and where those that begin there go.
//! **Invariant.** 1. Until the first crossing the pieces alive are totally ordered along the line.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | equal abscissae, vertical segments | the order is lexicographic: as if sheared by an infinitesimal | `the_sweep_agrees_with_all_pairs` |
//! | segments with a common end | are ordered by their other ends, and do not cross | `spokes_with_a_common_end_do_not_cross` |
//! | a vertex inside a segment | the piece ends there | `the_sweep_nodes_as_strips_do` |
//! | segments over one another | one piece with several members | `the_sweep_nodes_as_strips_do` |
//! | segments that cross at a vertex | nothing, as if they crossed elsewhere: the caller nodes first | `the_sweep_nodes_as_strips_do` |

mod line;

use std::cmp::Ordering;

use delone_predicates::{Kernel, Sign};
use line::Line;

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

/// What a sweep finds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Swept {
    /// Pieces with no vertex inside, each once, in the order of their smaller ends; those of one vertex from bottom to top.
    pub pieces: Vec<Ends>,
    /// The pieces in the order of their larger ends; those of one vertex from bottom to top, as they are in `pieces` at their
    /// smaller ends.
    pub by_larger_end: Vec<u32>,
    /// For each vertex the pieces next below and above, among those that begin before it and end after it.
    pub neighbours: Vec<[Option<u32>; 2]>,
    /// Segments and the pieces that they consist of, those of each segment from its smaller end on.
    pub members: Vec<[u32; 2]>,
}

/// Sweeps over segments between `count` vertices. `None` if some cross: see the module's text.
#[must_use]
pub fn sweep(kernel: &impl Kernel<2>, count: usize, segments: &[Ends]) -> Option<Swept> {
    let mut sweep = Sweep::new(kernel, count, segments);
    for vertex in (0u32..).take(count) {
        sweep.pass(vertex).ok()?;
    }
    Some(sweep.swept)
}

fn orient(kernel: &impl Kernel<2>, a: u32, b: u32, v: u32) -> Sign {
    kernel.orient(&[a as usize, b as usize, v as usize])
}

/// Two pieces cross.
struct Crossed;

/// No segment.
const NONE: u32 = u32::MAX;

/// The pieces that the line meets, and the segments to come.
struct Sweep<'k, K> {
    kernel: &'k K,
    segments: &'k [Ends],
    alive: Line,
    /// A piece that is alive goes from its first end towards the end of a member, which may be farther than its own end.
    swept: Swept,
    /// The first member of each piece.
    first: Vec<u32>,
    /// For each vertex a piece that is to end there, if it is still alive.
    ending: Vec<u32>,
    /// For each segment the next member of its piece.
    next: Vec<u32>,
    /// Segments by smaller end: those of vertex v begin at place `starts[v]`.
    begins: Vec<u32>,
    starts: Vec<u32>,
    /// The segments that begin at the vertex, or go on from it.
    beginning: Vec<u32>,
    /// The pieces that end at the vertex.
    ended: Vec<u32>,
}

impl<'k, K: Kernel<2>> Sweep<'k, K> {
    fn new(kernel: &'k K, count: usize, segments: &'k [Ends]) -> Self {
        let (starts, begins) = by_smaller_end(count, segments);
        let swept = Swept {
            pieces: Vec::with_capacity(segments.len()),
            by_larger_end: Vec::with_capacity(segments.len()),
            neighbours: Vec::with_capacity(count),
            members: Vec::with_capacity(segments.len()),
        };
        let (first, next) = (Vec::with_capacity(segments.len()), vec![NONE; segments.len()]);
        let (alive, beginning, ended) = (Line::default(), Vec::new(), Vec::new());
        let ending = vec![NONE; count];
        Self {
            kernel,
            segments,
            alive,
            swept,
            first,
            ending,
            next,
            begins,
            starts,
            beginning,
            ended,
        }
    }

    fn piece_count(&self) -> u32 {
        u32::try_from(self.swept.pieces.len())
            .expect("pieces until the first crossing are fewer than ids")
    }

    /// Passes over a vertex: ends the pieces there, begins those that begin or go on there, and looks at new neighbours.
    fn pass(&mut self, vertex: u32) -> Result<(), Crossed> {
        let pieces = &self.swept.pieces;
        let side = |piece: u32| {
            let [a, b] = pieces[piece as usize];
            if b == vertex { Sign::Zero } else { orient(self.kernel, a, b, vertex) }
        };
        // Those that end here lie side by side: the order is total. (Inv 1)
        let known = self.alive.find(self.ending[vertex as usize]).map(|mut place| {
            let is_here = |piece: u32| side(piece) == Sign::Zero;
            while let Some(before) = self.alive.previous(place)
                && self.alive.at(before).is_some_and(is_here)
            {
                place = before;
            }
            place
        });
        let mut place =
            known.unwrap_or_else(|| self.alive.search(|piece| side(piece) == Sign::Positive));
        let mut ended = std::mem::take(&mut self.ended);
        ended.clear();
        while let Some(piece) = self.alive.at(place).filter(|&piece| side(piece) == Sign::Zero) {
            ended.push(piece);
            place = self.alive.remove(place);
        }
        let [below, above] = self.alive.around(place);
        self.swept.neighbours.push([below, above]);
        self.beginning.clear();
        for &piece in &ended {
            self.end(piece, vertex);
        }
        let is_new = !ended.is_empty();
        self.ended = ended;
        let range = [vertex, vertex + 1].map(|v| self.starts[v as usize] as usize);
        self.beginning.extend(&self.begins[range[0]..range[1]]);
        if self.beginning.is_empty() {
            return if is_new && self.cross(below, above) { Err(Crossed) } else { Ok(()) };
        }
        let lowest = self.piece_count();
        self.begin(vertex);
        let highest = self.piece_count() - 1;
        for piece in (lowest..=highest).rev() {
            place = self.alive.insert(place, piece);
        }
        let crossed = self.cross(below, Some(lowest)) || self.cross(Some(highest), above);
        if crossed { Err(Crossed) } else { Ok(()) }
    }

    /// Ends a piece at a vertex. Its members that are longer begin there.
    fn end(&mut self, piece: u32, vertex: u32) {
        self.swept.pieces[piece as usize][1] = vertex;
        self.swept.by_larger_end.push(piece);
        let mut member = self.first[piece as usize];
        while member != NONE {
            self.swept.members.push([member, piece]);
            if self.segments[member as usize][1] != vertex {
                self.beginning.push(member);
            }
            member = self.next[member as usize];
        }
    }

    /// Makes pieces, from bottom to top, of the segments that begin at a vertex: one of all that have one direction.
    fn begin(&mut self, vertex: u32) {
        let (kernel, segments) = (self.kernel, self.segments);
        let to = |segment: u32| segments[segment as usize][1];
        let turn = |e: u32, f: u32| match to(e) == to(f) {
            true => Sign::Zero,
            false => orient(kernel, vertex, to(e), to(f)),
        };
        self.beginning.sort_unstable_by(|&e, &f| match turn(e, f) {
            Sign::Positive => Ordering::Less,
            Sign::Zero => e.cmp(&f),
            Sign::Negative => Ordering::Greater,
        });
        for piece in self.beginning.chunk_by(|&e, &f| turn(e, f) == Sign::Zero) {
            self.ending[to(piece[0]) as usize] =
                u32::try_from(self.swept.pieces.len()).expect("counted before");
            self.swept.pieces.push([vertex, to(piece[0])]);
            self.first.push(piece[0]);
            for (place, &member) in piece.iter().enumerate() {
                self.next[member as usize] = piece.get(place + 1).copied().unwrap_or(NONE);
            }
        }
    }

    /// Whether two pieces, or what their members go on as, cross; the first is below the second.
    fn cross(&self, e: Option<u32>, f: Option<u32>) -> bool {
        let (Some(e), Some(f)) = (e, f) else { return false };
        let [[a, b], [c, d]] = [e, f].map(|piece| self.swept.pieces[piece as usize]);
        let is_lower =
            |e: u32, f: u32| self.kernel.compare(1, e as usize, f as usize) == Ordering::Less;
        if a == c || b == d || [a, b].iter().all(|&e| is_lower(e, c) && is_lower(e, d)) {
            return false;
        }
        let side = |a, b, v| orient(self.kernel, a, b, v);
        side(a, b, c) * side(a, b, d) == Sign::Negative
            && side(c, d, a) * side(c, d, b) == Sign::Negative
    }
}

/// The segments of some length by their smaller ends: where those of each vertex begin, and all of them.
fn by_smaller_end(count: usize, segments: &[Ends]) -> (Vec<u32>, Vec<u32>) {
    let long = || (0u32..).zip(segments).filter(|(_, [a, b])| a != b);
    let mut starts = vec![0u32; count + 2];
    long().for_each(|(_, ends)| starts[ends[0] as usize + 2] += 1);
    for vertex in 2..starts.len() {
        starts[vertex] += starts[vertex - 1];
    }
    let mut begins = vec![0; starts[count + 1] as usize];
    for (segment, ends) in long() {
        let place = &mut starts[ends[0] as usize + 1];
        begins[*place as usize] = segment;
        *place += 1;
    }
    (starts, begins)
}
