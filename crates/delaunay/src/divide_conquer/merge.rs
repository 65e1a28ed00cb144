//! The merge: the triangulations of two blocks, one on each side of a line, become that of both.
//!
//! ```text
//!         top                    From the common tangent below, the base l-r rises. The left candidate is the vertex c
//!      .---------.               before l on the hull, as long as it is above the base; while the circle of l, r, c
//!     /L\       /R\              holds the vertex c2 behind the edge c-l, that triangle is not Delaunay in the union: it
//!    /   c     d   \             becomes a ghost, and c2 the candidate. So on the right, in mirror image. Of the two
//!    \    \   /    /             candidates the one whose circle does not hold the other makes the next triangle, in
//!     \    l-r    /              the slot of the ghost that it covers, and the next base. When neither is above the
//!      \__/___\__/               base, it is the common tangent above.
//!         bottom
//! ```
//!
//! **Paper.** [GS85], section 9, on triangles with ghosts instead of quad-edges. An edge that must go is not freed: the
//! triangle before it turns into a ghost where it stands.
//! **In.** Two patches side by side whose sites are separated by the `axis` (see [`super::cuts`]); a ghost of each; two
//! free slots. **Out.** The patch of both; its bottom and top ghosts, which stand in the two slots.
//! **Invariants.** 1. Below the base everything is final. 2. Ghosts form a cycle on either side, but for the stretch that
//! the bottom ghost has replaced. 3. A candidate that is above the base stays above until its own side moves: the base
//! only turns towards it. 4. The hulls are convex: along any line, tilted a little, vertices rise to one last and fall to one
//! first.
//! **Cost.** O(edges made and destroyed + hull edges passed on the way to the tangents).
//!
//! **Degeneracies.**
//! | case | answer | test |
//! |---|---|---|
//! | a third site on the common tangent | tangents go to the nearest sites | `parallel_lines_and_ladders` |
//! | all sites in line | bottom and top ghost are glued back to back | `collinear_sites_are_a_chain` |
//! | candidate in line with the base | not above it | `collinear_sites_are_a_chain` |
//! | four cocircular sites at the base | the perturbation decides | `cocircular_sites_agree` |

use std::cmp::Ordering;

use delone_predicates::{Kernel, Side, Sign};
use delone_probe::{Event, Probe};

use super::cuts::Axis;
use super::patch::{Edge, GHOST, Patch, Place, next, prev};

/// Two ghosts of a block: those that the last merge made at the common tangents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Hull {
    pub(super) bottom: Edge,
    pub(super) top: Edge,
}

/// A site as the kernel takes it.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Site(Place);

impl From<Site> for usize {
    #[inline(always)]
    fn from(site: Site) -> Self {
        site.0 as Self
    }
}

/// A patch in work: the predicates that are asked, who is told, and the sites of the places, for those who are shown it.
pub(super) struct Work<'a, K, P> {
    pub(super) patch: Patch<'a>,
    pub(super) kernel: &'a K,
    pub(super) probe: &'a mut P,
    pub(super) names: &'a [u32],
}

impl<K: Kernel<2>, P: Probe> Work<'_, K, P> {
    /// Merges the blocks with the hulls `left` and `right`. See the module's text.
    pub(super) fn merge(&mut self, left: Hull, right: Hull, axis: Axis, slot: u32) -> Hull {
        // The halves were cut across the other axis: their last and first sites along this one are near the tangents.
        let (left, right) = match axis {
            Axis::X => (left.bottom, right.top),
            Axis::Y => (left.top, right.bottom),
        };
        let g = self.climb(left, axis, Ordering::Greater, |patch, g| patch.end(g));
        let h = self.climb(right, axis, Ordering::Less, |patch, h| patch.start(h));
        let (mut g, mut h) = self.lower_tangent(g, h);
        let (mut l, mut r) = (self.patch.end(g), self.patch.start(h));
        let bottom = self.patch.put(slot, [r, l, GHOST]);
        self.patch.chain(self.patch.before(h), bottom);
        self.patch.chain(bottom, self.patch.after(g));
        let mut below = bottom;
        let (mut c, mut d) = (self.patch.start(g), self.patch.end(h));
        let (mut left_up, mut right_up) = (self.left_turn(l, r, c), self.left_turn(l, r, d));
        let mut ghosts = self.patch.slots();
        while left_up || right_up {
            assert!(ghosts > 0, "Inv 1: each triangle covers a ghost for good");
            ghosts -= 1;
            if left_up {
                c = self.left_candidate(g, l, r, c);
            }
            if right_up {
                d = self.right_candidate(h, l, r, d);
            }
            self.probe.on(Event::CellMade);
            if !left_up || (right_up && self.in_circle(l, r, c, d)) {
                // Triangle (r, d, l): edge d l is the next base, edge l r the last one.
                self.patch.set_apex(h, l);
                self.patch.glue(h - 1, below);
                (below, h, r) = (h - 2, self.patch.after(h), d);
                d = self.patch.end(h);
                right_up = self.left_turn(l, r, d);
                left_up = left_up || self.left_turn(l, r, c); // Inv 3
            } else {
                // Triangle (c, l, r): edge r c is the next base, edge l r the last one.
                self.patch.set_apex(g, r);
                self.patch.glue(g - 2, below);
                (below, g, l) = (g - 1, self.patch.before(g), c);
                c = self.patch.start(g);
                left_up = self.left_turn(l, r, c);
                right_up = right_up || self.left_turn(l, r, d); // Inv 3
            }
        }
        let top = self.patch.put(slot + 1, [l, r, GHOST]);
        self.patch.glue(top, below);
        self.patch.chain(g, top);
        self.patch.chain(top, h);
        Hull { bottom, top }
    }

    /// The ghost whose `vertex` is the greatest, or the least, of the hull along the axis: we climb. (Inv 4)
    fn climb(
        &self,
        start: Edge,
        axis: Axis,
        goal: Ordering,
        vertex: impl Fn(&Patch<'_>, Edge) -> Place,
    ) -> Edge {
        let higher = |e: Edge, f: Edge| {
            let (u, v) = (Site(vertex(&self.patch, e)), Site(vertex(&self.patch, f)));
            axis.compare(self.kernel, u, v) == goal
        };
        let mut ghost = start;
        let mut steps = 0..self.patch.slots();
        while higher(self.patch.after(ghost), ghost) {
            ghost = self.patch.after(ghost);
            assert!(steps.next().is_some(), "Inv 4: a hull does not rise all the way round");
        }
        if ghost == start {
            while higher(self.patch.before(ghost), ghost) {
                ghost = self.patch.before(ghost);
                assert!(steps.next().is_some(), "Inv 4: a hull does not rise all the way round");
            }
        }
        ghost
    }

    /// From ghosts that end at the last site on the left and start at the first one on the right, down to the tangent.
    fn lower_tangent(&mut self, mut g: Edge, mut h: Edge) -> (Edge, Edge) {
        for _ in 0..=self.patch.slots() {
            let (l, r) = (self.patch.end(g), self.patch.start(h));
            let (after, before) = (self.patch.after(g), self.patch.before(h));
            if self.right_turn(l, r, self.patch.end(after)) {
                g = after;
            } else if self.right_turn(l, r, self.patch.start(before)) {
                h = before;
            } else {
                return (g, h);
            }
        }
        panic!("Inv 4: a tangent goes down on convex hulls");
    }

    /// Destroys what is not Delaunay behind the ghost `g`, from `c` to `l`; where it starts then.
    #[inline(always)]
    fn left_candidate(&mut self, g: Edge, l: Place, r: Place, mut c: Place) -> Place {
        loop {
            let inner = self.patch.twin(g); // l c, in the triangle l c c2
            let c2 = self.patch.apex(inner);
            if c2 == GHOST || !self.in_circle(l, r, c, c2) {
                return c;
            }
            let (far, near) = (self.patch.twin(next(inner)), self.patch.twin(prev(inner)));
            let freed = self.patch.put(inner / 3, [c, c2, GHOST]);
            self.patch.glue(freed, far); // c c2
            self.patch.set_apex(g - 2, c2);
            self.patch.glue(g, near); // c2 l
            self.patch.chain(self.patch.before(g), freed);
            self.patch.chain(freed, g);
            c = c2;
        }
    }

    /// The mirror image: behind the ghost `h`, from `r` to `d`; where it ends then.
    #[inline(always)]
    fn right_candidate(&mut self, h: Edge, l: Place, r: Place, mut d: Place) -> Place {
        loop {
            let inner = self.patch.twin(h); // d r, in the triangle d r c2
            let d2 = self.patch.apex(inner);
            if d2 == GHOST || !self.in_circle(l, r, d, d2) {
                return d;
            }
            let (near, far) = (self.patch.twin(next(inner)), self.patch.twin(prev(inner)));
            let freed = self.patch.put(inner / 3, [d2, d, GHOST]);
            self.patch.glue(freed, far); // d2 d
            self.patch.set_apex(h - 1, d2);
            self.patch.glue(h, near); // r d2
            self.patch.chain(freed, self.patch.after(h));
            self.patch.chain(h, freed);
            d = d2;
        }
    }

    #[inline(always)]
    pub(super) fn orient(&mut self, a: Place, b: Place, c: Place) -> Sign {
        self.probe.on(Event::Orient);
        self.kernel.orient(&[Site(a), Site(b), Site(c)])
    }

    #[inline(always)]
    fn left_turn(&mut self, a: Place, b: Place, c: Place) -> bool {
        self.orient(a, b, c) == Sign::Positive
    }

    #[inline(always)]
    fn right_turn(&mut self, a: Place, b: Place, c: Place) -> bool {
        self.orient(a, b, c) == Sign::Negative
    }

    #[inline(always)]
    fn in_circle(&mut self, a: Place, b: Place, c: Place, q: Place) -> bool {
        self.probe.on(Event::InSphere);
        self.kernel.in_sphere(&[Site(a), Site(b), Site(c)], Site(q)) == Side::Positive
    }
}
