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

use super::Chew;
use super::region::Region;
use super::rings::Half;

/// One window: the slabs `[i, m)` and `[m, j)`, and the segments below and above.
#[derive(Clone, Copy)]
struct Window {
    slab: [u32; 3],
    floor: Option<u32>,
    ceiling: Option<u32>,
}

/// What separates two parts that are zipped.
pub(super) trait Cut {
    /// Whether the part on this hand holds the site.
    fn holds(&self, hand: Hand, v: u32) -> bool;
}

impl Cut for Window {
    #[inline]
    fn holds(&self, hand: Hand, v: u32) -> bool {
        let [i, m, j] = self.slab;
        match hand {
            Hand::Left => (i..m).contains(&v),
            Hand::Right => (m..j).contains(&v),
        }
    }
}

/// One side of the wall. What is done on the right is the mirror image of what is done on the left.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Hand {
    Left,
    Right,
}

/// A site of a gap's chain, and its sector that opens into the gap (none if no edge leaves it).
pub(super) type Stand = (u32, Option<Half>);

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
        let base = match floor.filter(|&f| self.inside(window, f).is_some()) {
            Some(floor) => 2 * floor,
            None => {
                let l = self.nearest(window, Hand::Left, a);
                let r = self.nearest(window, Hand::Right, b);
                let ((l, s), (r, t)) = self.lower_tangent(&window, l, r);
                if top == Some([l, r]) {
                    return;
                }
                self.rings.join(l, r, s, t)
            }
        };
        self.zip_from(&window, base, top);
    }

    /// The same for the upper and the lower part of a region, which are the left and the right hand, from their sites next to the cut.
    pub(super) fn zip_level(&mut self, cut: &impl Cut, [upper, lower]: [Stand; 2]) {
        let ((l, s), (r, t)) = self.lower_tangent(cut, upper, lower);
        let base = self.rings.join(l, r, s, t);
        self.zip_from(cut, base, None);
    }

    /// Zips from a base upwards; `top` are the ends of the window's ceiling, if it goes from one hand to the other.
    #[inline]
    fn zip_from(&mut self, cut: &impl Cut, mut base: Half, top: Option<[u32; 2]>) {
        loop {
            let (l, r) = (self.rings.origin(base), self.rings.destination(base));
            let left = self.candidate(cut, base, Hand::Left);
            let right = self.candidate(cut, base, Hand::Right);
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
        (window.holds(Hand::Left, a) && window.holds(Hand::Right, b)).then_some([a, b])
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

    /// The edge from base's end on this hand to the candidate there, after opening what the circle of base and candidate
    /// opens.
    #[inline(always)] // twice, once for each hand
    fn candidate(&mut self, cut: &impl Cut, base: Half, hand: Hand) -> Option<Half> {
        let (l, r) = (self.rings.origin(base), self.rings.destination(base));
        let (own, other_end) = if hand == Hand::Left { (base, r) } else { (base ^ 1, l) };
        let mut e = self.beside(own, hand);
        let c = self.rings.destination(e);
        if e == own || !cut.holds(hand, c) || self.orient(l, r, c) != Sign::Positive {
            return None;
        }
        while !self.rings.is_segment(e) {
            let behind = self.beside(e, hand);
            let (c, apex) = (self.rings.destination(e), self.rings.destination(behind));
            if apex == other_end || !cut.holds(hand, apex) {
                break;
            }
            let (first, second) = if hand == Hand::Left { (e, behind) } else { (behind, e) };
            // Cheapest first; most apexes are not inside.
            if !self.is_closed(first, second)
                || !self.is_inside([l, r, c], apex)
                || !self.turns_left(first, second)
            {
                break;
            }
            self.rings.remove(e);
            e = behind;
        }
        Some(e)
    }

    /// The next edge of the ring, upwards from the base: counter-clockwise on the left, clockwise on the right.
    #[inline]
    fn beside(&self, h: Half, hand: Hand) -> Half {
        match hand {
            Hand::Left => self.rings.next(h),
            Hand::Right => self.rings.previous(h),
        }
    }

    /// Whether the face between `e` and the next of its ring, `f`, has three sides. It is a triangle, and no gap, if it also
    /// turns left.
    #[inline]
    fn is_closed(&self, e: Half, f: Half) -> bool {
        let third = self.rings.around(e);
        self.rings.destination(third) == self.rings.destination(f)
            && self.rings.around(third) == f ^ 1
    }

    fn turns_left(&mut self, e: Half, f: Half) -> bool {
        let (v, c, d) =
            (self.rings.origin(e), self.rings.destination(e), self.rings.destination(f));
        self.orient(v, c, d) == Sign::Positive
    }

    /// The site of the gap's chain that is nearest to the wall.
    fn nearest(&mut self, window: Window, hand: Hand, region: &Region) -> Stand {
        let (own, other) = if hand == Hand::Left { (0, 1) } else { (1, 0) };
        for (segment, is_floor) in [(window.floor, true), (window.ceiling, false)] {
            let Some(segment) = segment else { continue };
            let ends = self.segments[segment as usize];
            if window.holds(hand, ends[own]) {
                // Away from the segment, into the window: up from the floor, down from the ceiling.
                let half = 2 * segment + u32::from(hand == Hand::Right);
                let is_ccw = is_floor == (hand == Hand::Left);
                let sector = if is_ccw { half } else { self.rings.previous(half) };
                return self.along(window, hand, is_ccw, (ends[own], sector), ends[other]);
            }
        }
        let site = if hand == Hand::Left { region.last } else { region.first };
        (site, self.open_sector(site))
    }

    /// Follows the gap's chain from where a segment to `end` leaves it, as long as it comes nearer to the wall.
    fn along(
        &mut self,
        window: Window,
        hand: Hand,
        is_ccw: bool,
        (mut v, mut s): (u32, Half),
        end: u32,
    ) -> Stand {
        // The first edge may belong to the far side of a gap that goes all around; the chain beyond it is convex.
        let away = if is_ccw { Sign::Positive } else { Sign::Negative };
        let mut is_first = true;
        loop {
            let e = if is_ccw { self.rings.next(s) } else { s };
            let d = self.rings.destination(e);
            let is_nearer = if hand == Hand::Left { d > v } else { d < v };
            if !window.holds(hand, d) || !is_nearer || (is_first && self.orient(v, end, d) != away)
            {
                return (v, Some(s));
            }
            s = if is_ccw { e ^ 1 } else { self.rings.previous(s ^ 1) };
            (v, is_first) = (d, false);
        }
    }

    /// The sector of 180 degrees or more at a site all of whose edges go to one side.
    pub(super) fn open_sector(&mut self, v: u32) -> Option<Half> {
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
    fn lower_tangent(&mut self, cut: &impl Cut, left: Stand, right: Stand) -> (Stand, Stand) {
        let ((mut l, mut s), (mut r, mut t)) = (left, right);
        loop {
            if let Some(sector) = s {
                let d = self.rings.destination(sector);
                if cut.holds(Hand::Left, d) && self.orient(l, r, d) == Sign::Negative {
                    (l, s) = (d, Some(self.rings.previous(sector ^ 1)));
                    continue;
                }
            }
            if let Some(sector) = t {
                let e = self.rings.next(sector);
                let d = self.rings.destination(e);
                if cut.holds(Hand::Right, d) && self.orient(l, r, d) == Sign::Negative {
                    (r, t) = (d, Some(e ^ 1));
                    continue;
                }
            }
            return ((l, s), (r, t));
        }
    }
}
