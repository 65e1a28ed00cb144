//! The flip of an edge of the plane: two triangles exchange the diagonal of their quadrilateral.
//!
//! ```text
//!        c                 c          h runs from a to b and stays the half-edge opposite c in its triangle: before the
//!       / \               /|\         flip from a to b, afterwards from a to d. Its twin stays opposite d: from b to c
//!      a-h-b     ->      a | b        afterwards. next(h) becomes the new diagonal, seen from a's side.
//!       \ /               \|/
//!        d                 d
//! ```

use crate::{HalfEdge, Mesh};

impl Mesh<2> {
    /// Replaces the edge of `h` by the one that joins the apexes of its two triangles, which must differ. No handle is
    /// retired. Either triangle may be a ghost.
    pub fn flip(&mut self, h: HalfEdge) {
        let t = self.twin(h);
        let (c, d) = (self.apex(h), self.apex(t));
        debug_assert!(c != d, "the apexes of an edge that is flipped differ");
        let (beyond_bc, beyond_ad) = (self.twin(self.next(h)), self.twin(self.next(t)));
        let (at_b, at_a) = (self.prev(h), self.prev(t));
        self.vertices[at_b.index()] = d;
        self.vertices[at_a.index()] = c;
        self.glue(h, beyond_ad);
        self.glue(t, beyond_bc);
        self.glue(self.next(h), self.next(t));
    }
}
