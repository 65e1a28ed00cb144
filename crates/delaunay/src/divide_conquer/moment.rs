//! What a probe that watches is shown: all blocks that are done, each with its hull.

use delone_predicates::Kernel;
use delone_probe::{Moment, Probe};

use super::merge::Work;
use super::patch::{GHOST, Patch, Place};

impl<K: Kernel<2>, P: Probe> Work<'_, K, P> {
    /// Shows what there is after a step about the sites at places `i` to `j - 1`.
    #[inline(always)]
    pub(super) fn show(&mut self, block: [Place; 2], title: impl FnOnce() -> String) {
        if self.probe.watches() {
            show_all(&self.patch, self.probe, self.names, block, &title());
        }
    }
}

fn show_all(
    patch: &Patch<'_>,
    probe: &mut impl Probe,
    names: &[u32],
    [i, j]: [Place; 2],
    title: &str,
) {
    let name = |place: Place| names[place as usize];
    let (mut triangles, mut edges) = (Vec::new(), Vec::new());
    for [a, b, c] in patch.triangles() {
        // A slot that is not in use yet has three equal corners.
        if a == b {
            continue;
        }
        match [a, b, c].iter().position(|&v| v == GHOST) {
            None => triangles.push([a, b, c].map(name)),
            Some(0) => edges.push([b, c].map(name)),
            Some(1) => edges.push([c, a].map(name)),
            Some(_) => edges.push([a, b].map(name)),
        }
    }
    let marked = &names[i as usize..j as usize];
    probe.show(&Moment { title, triangles: &triangles, edges: &edges, marked });
}
