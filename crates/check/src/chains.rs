//! Input segments as chains of edges (K2, K4), and the flags they imply (K3). In the plane.
//!
//! **In.** The edges of a complex, and segments between its points. **Method.** From one end,
//! follow the edge that points exactly towards the other end, found by binary search among the
//! edges around the vertex sorted by direction (on first use); each step ends strictly nearer or at
//! the end, else the segment is broken there. Directions are compared by exact orientations, so
//! each step is exactly collinear and forwards. That nothing crosses the chain follows: its edges
//! belong to a complex whose cells do not overlap. **Cost.** `O(log d)` orientations per step and
//! one sort of each vertex passed.

use crate::cells::Triangulation;
use crate::exact::{Integer, Sign};
use crate::facets::Facets;
use crate::fault::Fault;
use crate::sites::{witness, witnesses};
use crate::space::Space;
use crate::verdict::Report;
use std::cmp::Ordering;

/// Edges (ascending pairs, sorted, distinct) and, around each vertex, its neighbours.
#[derive(Debug)]
pub(crate) struct Edges {
    pub(crate) list: Vec<[u32; 2]>,
    starts: Vec<usize>,
    neighbours: Vec<u32>,
    by_direction: Vec<bool>,
}

impl Edges {
    /// The edges of a complex; in dimension 2 these are its facets, in the same order.
    pub(crate) fn of<I: Integer>(t: &Triangulation<'_, 2, I>, facets: &Facets<'_>) -> Self {
        let mut list: Vec<[u32; 2]> = match t.dimension {
            2 => facets
                .groups()
                .filter_map(|g| <[u32; 2]>::try_from(facets.vertices(&g[0])).ok())
                .collect(),
            1 => t
                .cells
                .chunks_exact(2)
                .enumerate()
                .filter(|(cell, _)| t.signs[*cell].is_some())
                .map(|(_, ends)| [ends[0].min(ends[1]), ends[0].max(ends[1])])
                .collect(),
            _ => Vec::new(),
        };
        if t.dimension < 2 {
            list.sort_unstable();
            list.dedup();
        }
        Self::new(list, t.space.points.len())
    }

    fn new(list: Vec<[u32; 2]>, points: usize) -> Self {
        let mut starts = vec![0; points + 1];
        for &v in list.iter().flatten() {
            starts[v as usize + 1] += 1;
        }
        for i in 0..points {
            starts[i + 1] += starts[i];
        }
        let mut ends = starts.clone();
        let mut neighbours = vec![0; starts[points]];
        for &[a, b] in &list {
            for (v, w) in [(a, b), (b, a)] {
                neighbours[ends[v as usize]] = w;
                ends[v as usize] += 1;
            }
        }
        Self { list, starts, neighbours, by_direction: vec![false; points] }
    }

    /// The neighbours of `v`.
    pub(crate) fn around(&self, v: u32) -> &[u32] {
        &self.neighbours[self.starts[v as usize]..self.starts[v as usize + 1]]
    }

    /// The number of the edge between two vertices.
    pub(crate) fn number(&self, a: u32, b: u32) -> Option<usize> {
        self.list.binary_search(&[a.min(b), a.max(b)]).ok()
    }

    /// The neighbour of `v` exactly in the direction of `target`.
    fn towards<I: Integer>(&mut self, space: &Space<'_, 2, I>, v: u32, target: u32) -> Option<u32> {
        let around = &mut self.neighbours[self.starts[v as usize]..self.starts[v as usize + 1]];
        if !std::mem::replace(&mut self.by_direction[v as usize], true) {
            around.sort_by(|&a, &b| by_direction(space, v, a, b));
        }
        let found = around.binary_search_by(|&w| by_direction(space, v, w, target)).ok()?;
        Some(around[found])
    }
}

/// The order of two directions around `v`: the lexicographically greater half first,
/// counterclockwise in each.
fn by_direction<I: Integer>(space: &Space<'_, 2, I>, v: u32, a: u32, b: u32) -> Ordering {
    let half = |w| space.compare(v, w); // Less: w is greater; Equal: no direction at all
    half(a).cmp(&half(b)).then_with(|| match space.orient_along(&[0, 1], &[v, a, b]) {
        Sign::Positive => Ordering::Less,
        Sign::Zero => Ordering::Equal,
        Sign::Negative => Ordering::Greater,
    })
}

/// The segments over an edge.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Cover {
    /// The first of them.
    pub(crate) first: Option<usize>,
    /// How many there are.
    pub(crate) times: i64,
    /// Those that run from the smaller vertex to the larger, less those that run back.
    pub(crate) net: i64,
}

impl Cover {
    /// One more segment, from the smaller vertex to the larger or back.
    fn pass(&mut self, segment: usize, forwards: bool) {
        self.first.get_or_insert(segment);
        self.times += 1;
        self.net += if forwards { 1 } else { -1 };
    }
}

/// K2: the segments over each edge. Where no edge leads on in line, a `detour` may: the vertices after that one, up to the other
/// end of the segment.
pub(crate) fn cover<I: Integer>(
    t: &Triangulation<'_, 2, I>,
    edges: &mut Edges,
    segments: &[[u32; 2]],
    report: &mut Report,
    mut detour: impl FnMut(&Edges, usize, [u32; 2]) -> Option<Vec<u32>>,
) -> Vec<Cover> {
    let points = t.space.points;
    let mut covered = vec![Cover::default(); edges.list.len()];
    for (segment, ends) in segments.iter().enumerate() {
        if let Some(&id) = ends.iter().find(|&&v| v as usize >= points.len()) {
            report.fault(Fault::SegmentOutOfRange { segment, id, points: points.len() });
            continue;
        }
        let [mut at, end] = ends.map(|v| t.representative[v as usize]);
        let forwards = t.space.compare(at, end);
        while at != end {
            let next = edges.number(at, end).map(|_| end);
            let next = next.or_else(|| edges.towards(&t.space, at, end)).filter(|&next| {
                t.space.compare(at, next) == forwards
                    && t.space.compare(next, end) != forwards.reverse()
            });
            let Some(path) =
                next.map(|next| vec![next]).or_else(|| detour(edges, segment, [at, end]))
            else {
                let (ends, stuck) = (witnesses(points, ends), witness(points, at));
                report.fault(Fault::BrokenSegment { segment, ends, stuck });
                break;
            };
            for next in path {
                if let Some(edge) = edges.number(at, next) {
                    covered[edge].pass(segment, at < next);
                }
                at = next;
            }
        }
    }
    covered
}

/// K3: the flagged edges are exactly those covered. Flags are a set: order and repetition do not
/// matter.
pub(crate) fn check_flags(
    points: &[[f64; 2]],
    edges: &Edges,
    covered: &[Cover],
    flags: &[[u32; 2]],
    report: &mut Report,
) {
    let mut flagged = vec![false; edges.list.len()];
    for &[a, b] in flags {
        match edges.number(a, b) {
            Some(edge) => flagged[edge] = true,
            None => report.fault(Fault::FlagNotEdge { ends: [a, b] }),
        }
    }
    for (number, ends) in edges.list.iter().enumerate() {
        let edge = || witnesses(points, ends);
        match (covered[number].first, flagged[number]) {
            (Some(segment), false) => report.fault(Fault::MissingFlag { edge: edge(), segment }),
            (None, true) => report.fault(Fault::ExtraFlag { edge: edge() }),
            (Some(_), true) | (None, false) => {}
        }
    }
}
