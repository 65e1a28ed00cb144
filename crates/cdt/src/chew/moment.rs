//! What a probe that watches is shown: the edges in the rings, segments among them.

use delone_probe::{Moment, Probe};

use super::Chew;

impl<K, P: Probe> Chew<'_, '_, K, P> {
    /// Shows what there is after the slabs `[i, m)` and `[m, j)` were merged.
    #[inline(always)]
    pub(super) fn show(&mut self, slab: [u32; 3]) {
        if self.probe.watches() {
            self.show_all(slab);
        }
    }

    fn show_all(&mut self, [i, m, j]: [u32; 3]) {
        let name = |site: u32| self.names[site as usize];
        let alive = (0..self.rings.len()).step_by(2).filter(|&h| self.rings.is_waiting(h));
        let edge = |h| [self.rings.origin(h), self.rings.destination(h)].map(name);
        let edges: Vec<[u32; 2]> = alive.map(edge).collect();
        let title = format!("the strips from sites {} and {} on are merged", name(i), name(m));
        let marked: Vec<u32> = (i..j).map(name).collect();
        self.probe.show(&Moment { title: &title, triangles: &[], edges: &edges, marked: &marked });
    }
}
