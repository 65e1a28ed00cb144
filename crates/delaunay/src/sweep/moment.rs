//! What a probe that watches is shown: the triangles behind the line, and the edges that the ghosts are, the beach line among them.

use delone_mesh::VertexId;
use delone_probe::{Moment, Probe};

use super::Sweep;

impl<K> Sweep<'_, K> {
    /// Shows what there is after an event of these vertices.
    #[inline(always)]
    pub(super) fn show(&self, probe: &mut impl Probe, event: &str, about: &[VertexId]) {
        if probe.watches() {
            self.show_all(probe, event, about);
        }
    }

    fn show_all(&self, probe: &mut impl Probe, event: &str, about: &[VertexId]) {
        let name = |v: VertexId| self.names[v.index()];
        let marked: Vec<u32> = about.iter().map(|&v| name(v)).collect();
        let told: Vec<String> = marked.iter().map(ToString::to_string).collect();
        let mesh = &self.mesh;
        let solid = mesh.solid_cells().map(|cell| [0, 1, 2].map(|i| name(mesh.vertex(cell, i))));
        // Each ghost is `[upper, lower, GHOST]`. (Inv 1)
        let ghosts = mesh.ghost_cells().map(|cell| [0, 1].map(|i| name(mesh.vertex(cell, i))));
        let (triangles, edges): (Vec<_>, Vec<_>) = (solid.collect(), ghosts.collect());
        let title = format!("{event} of {}", told.join(", "));
        probe.show(&Moment {
            title: &title,
            triangles: &triangles,
            edges: &edges,
            marked: &marked,
        });
    }
}
