//! Zipping one window: the gap between a region on the left and one on the right of the wall is filled with triangles.
//!
//! ```text
//!      \  |  /          From a lower tangent (or from a segment that crosses the wall as the window's floor) upwards: the
//!    lc \ | / rc        edge `base` from l to r; above it the next neighbour of l and of r are candidates. Triangles of
//!     \  \|/  /         either side whose apex is inside the circle of base and candidate are opened. The better candidate
//!  l ---base--- r       gives the triangle and the next base. It ends at an upper tangent, or at the window's ceiling.
//! ```
//!
//! **Paper.** [Che89], after [GS85]. What is special: a candidate must be inside its slab; a segment is never opened; and
//! what lies behind an edge must be a triangle of the slab, not a gap, before it is looked into (pitfall: the slab is tested
//! *before* a ring outside it is read).

use delone_predicates::{PlaneKernel, Side, Sign};
use delone_probe::{Event, Probe};

use super::rings::Half;
use super::{Chew, Region};

/// One window: the slabs `[i, m)` and `[m, j)`, and the segments below and above.
#[derive(Clone, Copy)]
struct Window {
    slab: [u32; 3],
    floor: Option<u32>,
    ceiling: Option<u32>,
}

impl Window {
    fn is_left(&self, v: u32) -> bool {
        let [i, m, _] = self.slab;
        (i..m).contains(&v)
    }

    fn is_right(&self, v: u32) -> bool {
        let [_, m, j] = self.slab;
        (m..j).contains(&v)
    }
}

/// A site of a gap's chain, and its sector that opens into the gap (none if no edge leaves it).
type Stand = (u32, Option<Half>);

impl<K: PlaneKernel, P: Probe> Chew<'_, '_, K, P> {
    pub(super) fn zip(
        &mut self,
        slab: [u32; 3],
        a: &Region,
        b: &Region,
        floor: Option<u32>,
        ceiling: Option<u32>,
    ) {
        let window = Window { slab, floor, ceiling };
        let top = ceiling.and_then(|g| self.inside(window, g));
        let mut base = match floor.filter(|&f| self.inside(window, f).is_some()) {
            Some(floor) => 2 * floor,
            None => {
                let (l, r) = (self.left_start(window, a), self.right_start(window, b));
                let ((l, s), (r, t)) = self.lower_tangent(window, l, r);
                if top == Some([l, r]) {
                    return;
                }
                self.rings.join(l, r, s, t)
            }
        };
        loop {
            let (l, r) = (self.rings.origin(base), self.rings.destination(base));
            let left = self.left_candidate(window, base);
            let right = self.right_candidate(window, base);
            let to_right = match (left, right) {
                (None, None) => break,
                (Some(_), None) => false,
                (None, Some(_)) => true,
                (Some(e), Some(f)) => {
                    let (lc, rc) = (self.rings.destination(e), self.rings.destination(f));
                    self.is_inside([l, r, lc], rc)
                }
            };
            let (next_l, next_r) = match (left, right) {
                (_, Some(f)) if to_right => (l, self.rings.destination(f)),
                (Some(e), _) => (self.rings.destination(e), r),
                _ => break,
            };
            if top == Some([next_l, next_r]) {
                break; // the last triangle closes against the ceiling
            }
            self.probe.on(Event::CellMade);
            base = match (left, right) {
                (_, Some(f)) if to_right => {
                    self.rings.join(l, next_r, Some(base), Some(self.rings.previous(f ^ 1)))
                }
                (Some(e), _) => {
                    self.rings.join(next_l, r, Some(e ^ 1), Some(self.rings.previous(base ^ 1)))
                }
                _ => break,
            };
        }
    }

    /// The ends of a segment that goes from the left slab to the right one.
    fn inside(&self, window: Window, segment: u32) -> Option<[u32; 2]> {
        let [a, b] = self.segments[segment as usize];
        (window.is_left(a) && window.is_right(b)).then_some([a, b])
    }

    #[inline]
    fn orient(&mut self, a: u32, b: u32, c: u32) -> Sign {
        self.probe.on(Event::Orient);
        self.kernel.orient(&[a as usize, b as usize, c as usize])
    }

    #[inline]
    fn is_inside(&mut self, triangle: [u32; 3], q: u32) -> bool {
        self.probe.on(Event::InSphere);
        self.kernel.in_sphere(&triangle.map(|v| v as usize), q as usize) == Side::Positive
    }

    /// The edge from `l` to the left candidate, after opening what the circle of base and candidate opens.
    fn left_candidate(&mut self, window: Window, base: Half) -> Option<Half> {
        let (l, r) = (self.rings.origin(base), self.rings.destination(base));
        let mut e = self.rings.next(base);
        let c = self.rings.destination(e);
        if e == base || !window.is_left(c) || self.orient(l, r, c) != Sign::Positive {
            return None;
        }
        while !self.rings.is_segment(e) {
            let behind = self.rings.next(e);
            let (c, apex) = (self.rings.destination(e), self.rings.destination(behind));
            if apex == r || !window.is_left(apex) || !self.is_triangle(e, behind) {
                break;
            }
            if !self.is_inside([l, r, c], apex) {
                break;
            }
            self.rings.remove(e);
            e = behind;
        }
        Some(e)
    }

    /// The mirror image: the edge from `r` to the right candidate.
    fn right_candidate(&mut self, window: Window, base: Half) -> Option<Half> {
        let (l, r) = (self.rings.origin(base), self.rings.destination(base));
        let mut e = self.rings.previous(base ^ 1);
        let c = self.rings.destination(e);
        if e == base ^ 1 || !window.is_right(c) || self.orient(l, r, c) != Sign::Positive {
            return None;
        }
        while !self.rings.is_segment(e) {
            let behind = self.rings.previous(e);
            let (c, apex) = (self.rings.destination(e), self.rings.destination(behind));
            if apex == l || !window.is_right(apex) || !self.is_triangle(behind, e) {
                break;
            }
            if !self.is_inside([l, r, c], apex) {
                break;
            }
            self.rings.remove(e);
            e = behind;
        }
        Some(e)
    }

    /// Whether the face between `e` and the next of its ring, `f`, is a triangle and no gap.
    fn is_triangle(&mut self, e: Half, f: Half) -> bool {
        let (v, c, d) =
            (self.rings.origin(e), self.rings.destination(e), self.rings.destination(f));
        let third = self.rings.around(e);
        self.rings.destination(third) == d
            && self.rings.around(third) == f ^ 1
            && self.orient(v, c, d) == Sign::Positive
    }

    /// The last site of the left gap's chain.
    fn left_start(&mut self, window: Window, a: &Region) -> Stand {
        let starts = |segment: Option<u32>| {
            segment.filter(|&s| window.is_left(self.segments[s as usize][0]))
        };
        if let Some(f) = starts(window.floor) {
            let [mut v, end] = self.segments[f as usize];
            let (mut s, mut is_first) = (2 * f, true);
            loop {
                let e = self.rings.next(s);
                let d = self.rings.destination(e);
                if !window.is_left(d)
                    || d <= v
                    || (is_first && self.orient(v, end, d) != Sign::Positive)
                {
                    return (v, Some(s));
                }
                (s, v, is_first) = (e ^ 1, d, false);
            }
        }
        if let Some(g) = starts(window.ceiling) {
            let [mut v, end] = self.segments[g as usize];
            let (mut s, mut is_first) = (self.rings.previous(2 * g), true);
            loop {
                let d = self.rings.destination(s);
                if !window.is_left(d)
                    || d <= v
                    || (is_first && self.orient(v, end, d) != Sign::Negative)
                {
                    return (v, Some(s));
                }
                (s, v, is_first) = (self.rings.previous(s ^ 1), d, false);
            }
        }
        (a.last, self.open_sector(a.last))
    }

    /// The first site of the right gap's chain: the mirror image.
    fn right_start(&mut self, window: Window, b: &Region) -> Stand {
        let ends = |segment: Option<u32>| {
            segment.filter(|&s| window.is_right(self.segments[s as usize][1]))
        };
        if let Some(f) = ends(window.floor) {
            let [end, mut v] = self.segments[f as usize];
            let (mut t, mut is_first) = (self.rings.previous(2 * f + 1), true);
            loop {
                let d = self.rings.destination(t);
                if !window.is_right(d)
                    || d >= v
                    || (is_first && self.orient(v, end, d) != Sign::Negative)
                {
                    return (v, Some(t));
                }
                (t, v, is_first) = (self.rings.previous(t ^ 1), d, false);
            }
        }
        if let Some(g) = ends(window.ceiling) {
            let [end, mut v] = self.segments[g as usize];
            let (mut t, mut is_first) = (2 * g + 1, true);
            loop {
                let e = self.rings.next(t);
                let d = self.rings.destination(e);
                if !window.is_right(d)
                    || d >= v
                    || (is_first && self.orient(v, end, d) != Sign::Positive)
                {
                    return (v, Some(t));
                }
                (t, v, is_first) = (e ^ 1, d, false);
            }
        }
        (b.first, self.open_sector(b.first))
    }

    /// The sector of 180 degrees or more at a site all of whose edges go to one side.
    fn open_sector(&mut self, v: u32) -> Option<Half> {
        let first = self.rings.start(v)?;
        let mut s = first;
        loop {
            let after = self.rings.next(s);
            let (d, e) = (self.rings.destination(s), self.rings.destination(after));
            if after == s || self.orient(v, d, e) != Sign::Positive {
                return Some(s);
            }
            s = after;
            assert!(s != first, "Inv 2: edges that all go to one side leave an open sector");
        }
    }

    /// Walks both stands down to the lower common tangent.
    fn lower_tangent(&mut self, window: Window, left: Stand, right: Stand) -> (Stand, Stand) {
        let ((mut l, mut s), (mut r, mut t)) = (left, right);
        loop {
            if let Some(sector) = s {
                let d = self.rings.destination(sector);
                if window.is_left(d) && self.orient(l, r, d) == Sign::Negative {
                    (l, s) = (d, Some(self.rings.previous(sector ^ 1)));
                    continue;
                }
            }
            if let Some(sector) = t {
                let e = self.rings.next(sector);
                let d = self.rings.destination(e);
                if window.is_right(d) && self.orient(l, r, d) == Sign::Negative {
                    (r, t) = (d, Some(e ^ 1));
                    continue;
                }
            }
            return ((l, s), (r, t));
        }
    }
}
