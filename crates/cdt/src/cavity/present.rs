//! The segments that are edges of the Delaunay mesh already: most of them, on maps.
//!
//! Each is listed at its smaller end, and one pass over the mesh looks up every edge. Looking around the ends of each segment
//! takes as many steps, but in the order of the segments: with ids that are no neighbours in space, each step waits for memory (three to
//! five times as long, measured on a coast of 10^6 segments).

use delone_mesh::{HalfEdge, VertexId};
use delone_predicates::PlaneKernel;
use delone_probe::{Event, Probe};

use super::Work;

/// Lists of segments by site.
struct Listed {
    /// By site, where its list begins.
    starts: Vec<u32>,
    /// The larger end and the number of each segment, sorted within a list.
    entries: Vec<u64>,
    /// By site, the larger ends of the two in its list; the ghost if there are more.
    near: Vec<[Option<VertexId>; 2]>,
}

impl Listed {
    fn new(sites: usize, segments: &[[u32; 2]]) -> Self {
        let mut starts = vec![0u32; sites + 2];
        segments.iter().for_each(|&[a, b]| starts[a.min(b) as usize + 2] += 1);
        for site in 2..starts.len() {
            starts[site] += starts[site - 1];
        }
        let mut entries = vec![0; segments.len()];
        for (number, &[a, b]) in (0u64..).zip(segments) {
            let place = &mut starts[a.min(b) as usize + 1];
            entries[*place as usize] = u64::from(a.max(b)) << 32 | number;
            *place += 1;
        }
        let near = |site: usize| {
            let list = &mut entries[starts[site] as usize..starts[site + 1] as usize];
            list.sort_unstable();
            let end = |entry: u64| usize::try_from(entry >> 32).map(VertexId::new).ok();
            match *list {
                [] => [None; 2],
                [only] => [end(only), None],
                [first, second] => [end(first), end(second)],
                _ => [Some(VertexId::GHOST); 2],
            }
        };
        let near = (0..sites).map(near).collect();
        Self { starts, entries, near }
    }

    /// Whether a segment between two sites may be listed at the first of them.
    #[inline]
    fn may_hold(&self, a: VertexId, b: VertexId) -> bool {
        let [first, second] = self.near[a.index()];
        (first == Some(b)) | (second == Some(b)) | (first == Some(VertexId::GHOST))
    }

    /// The numbers of the segments between sites `a` and `b`, of which `a` is the smaller.
    fn between(&self, a: usize, b: usize) -> impl Iterator<Item = usize> {
        let list = &self.entries[self.starts[a] as usize..self.starts[a + 1] as usize];
        let wanted = b as u64;
        let first = list.partition_point(|entry| entry >> 32 < wanted);
        let equal = list[first..].iter().take_while(move |&entry| entry >> 32 == wanted);
        equal.map(|&entry| usize::try_from(entry & u64::from(u32::MAX)).expect("32 bits"))
    }
}

impl<K: PlaneKernel> Work<'_, K> {
    /// Marks the edges that are segments. Returns for each segment whether it is an edge.
    pub(super) fn mark_present(
        &mut self,
        sites: usize,
        segments: &[[u32; 2]],
        probe: &mut impl Probe,
    ) -> Vec<bool> {
        let listed = Listed::new(sites, segments);
        let mut present = vec![false; segments.len()];
        for cell in self.mesh.cells() {
            let [a, b, c] = self.mesh.triangle(cell);
            for (corner, a, b) in [(0, b, c), (1, c, a), (2, a, b)] {
                if a >= b || !listed.may_hold(a, b) {
                    continue; // seen from its other side, or none; the ghost comes after all others
                }
                let mut found = false;
                for number in listed.between(a.index(), b.index()) {
                    present[number] = true;
                    probe.on(Event::Subsegment);
                    found = true;
                }
                if found {
                    self.mark(HalfEdge::new(cell, corner));
                }
            }
        }
        present
    }
}
