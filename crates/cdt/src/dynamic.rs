//! A CDT under change: vertices and segments are put in and taken out, and it stays the CDT of what is there.
//!
//! **Method.** A segment is put in by flips (`flips.rs`). One that is taken out leaves a free edge, the only one that may be
//! illegal: flips go out from it. Vertices: see `dynamic/vertex.rs`.
//! **Invariant.** 1. After each call the mesh is the CDT of the vertices and the present segments: the same, cell for cell, as if
//! built from these alone.
//! **Not here.** Cutting segments that cross or run through vertices, which is refused; parents: a vertex that splits an edge
//! leaves two, which go one by one.
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a segment that is there already | nothing changes | `segments_come_and_go` |
//! | it crosses another, or runs through a vertex | refused, nothing changes | `what_blocks_a_segment_is_named` |
//! | all vertices in line | none: the mesh is a chain | `what_blocks_a_segment_is_named` |

mod vertex;

use delone_mesh::VertexId;
use delone_predicates::PlaneKernel;
use delone_probe::Probe;

use crate::Cdt;
use crate::flips::{Blocked, Flips};
pub use vertex::Kept;

/// A CDT whose vertices and segments may change.
///
/// ```
/// use delone_cdt::{Dynamic, cavity};
/// use delone_predicates::Adaptive;
/// use delone_sites::Pslg;
///
/// let kite = [[0.0, 0.0], [3.0, 1.0], [6.0, 0.0], [3.0, -1.0]];
/// let pslg = Pslg::new(&kite, &[]).unwrap();
/// let kernel = Adaptive::new(&kite);
/// let mut dynamic = Dynamic::new(cavity(&pslg, &Default::default(), &mut ()), &kernel, 4).unwrap();
/// dynamic.insert_segment([0, 2], &mut ()).unwrap();
/// assert_eq!(dynamic.cdt().canonical(), [0, 1, 2, 0, 2, 3]);
/// assert!(dynamic.remove_segment([0, 2], &mut ()));
/// assert_eq!(dynamic.cdt().canonical(), [0, 1, 3, 1, 2, 3]);
/// assert_eq!(dynamic.remove_vertex(3, &mut ()), Ok(true));
/// assert_eq!(dynamic.cdt().canonical(), [0, 1, 2]);
/// assert!(dynamic.insert_vertex(3, &mut ()));
/// ```
#[derive(Debug)]
pub struct Dynamic<'k, K> {
    flips: Flips<'k, K>,
    /// A vertex that is there, from which walks start.
    hint: VertexId,
}

impl<'k, K: PlaneKernel> Dynamic<'k, K> {
    /// Takes a CDT of some of the vertices 0 to `vertices - 1` of the kernel; `None` if they are in line. The others may come,
    /// all at distinct places. O(n).
    #[must_use]
    pub fn new(cdt: Cdt, kernel: &'k K, vertices: usize) -> Option<Self> {
        if cdt.mesh().dimension() != Some(2) {
            return None;
        }
        let hint = cdt.cells().next().map(|cell| cdt.mesh().vertex(cell, 0))?;
        let (mesh, constrained) = cdt.into_parts();
        Some(Self { flips: Flips::new(mesh, constrained, kernel, vertices), hint })
    }

    /// Puts a segment in. O(m^2) at worst for m edges crossed, and the flips that follow.
    ///
    /// # Errors
    /// If it crosses another, or runs through a vertex; then nothing is changed.
    ///
    /// # Panics
    /// If its ends are one vertex, or are not there.
    pub fn insert_segment(
        &mut self,
        ends: [u32; 2],
        probe: &mut impl Probe,
    ) -> Result<(), Blocked> {
        assert!(ends[0] != ends[1], "a segment has two ends");
        self.flips.insert(ends.map(|v| VertexId::new(v as usize)), probe)
    }

    /// Takes a segment out; whether it was there. Those that share its pieces are not known here: count them.
    ///
    /// # Panics
    /// If its first end is not there.
    pub fn remove_segment(&mut self, ends: [u32; 2], probe: &mut impl Probe) -> bool {
        self.flips.release(ends.map(|v| VertexId::new(v as usize)), probe)
    }

    /// The CDT as it is now. O(n): it is copied.
    #[must_use]
    pub fn cdt(&self) -> Cdt {
        Cdt::new(self.flips.mesh.clone(), self.flips.constrained.clone())
    }
}

#[cfg(test)]
mod tests;
