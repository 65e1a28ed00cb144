//! Half-edges in rings: for each site the half-edges that leave it, counter-clockwise.
//!
//! Half-edge `h` and its other half `h ^ 1` lie side by side; segment `e` is the halves `2 e` (from its first end) and
//! `2 e + 1`, and its halves are never removed. The face on the left of `h` goes on with `around(h)`.

use delone_sites::Swept;

/// A half-edge, by index.
pub(super) type Half = u32;

const NONE: u32 = u32::MAX;

/// A half-edge.
#[derive(Clone, Copy, Debug)]
struct Record {
    origin: u32,
    next: Half,
    previous: Half,
}

const EMPTY: Record = Record { origin: NONE, next: NONE, previous: NONE };

/// The rings of all sites. The sector of half-edge `h` is the angle from it counter-clockwise to the next in its ring.
#[derive(Debug)]
pub(crate) struct Rings {
    halves: Vec<Record>,
    /// Some half-edge of each site's ring.
    start: Vec<Half>,
    /// First halves of removed edges, to be used again.
    free: Vec<Half>,
    segments: u32,
}

impl Rings {
    /// The rings that hold both halves of each segment.
    pub(super) fn new(swept: &Swept) -> Self {
        let (segments, sites) = (&swept.pieces, swept.neighbours.len());
        let count = u32::try_from(segments.len()).expect("a planar graph's edges have 32-bit ids");
        // A triangulation has fewer than three edges for each site.
        let mut halves = Vec::with_capacity(6 * sites);
        halves.extend(segments.as_flattened().iter().map(|&origin| Record { origin, ..EMPTY }));
        let mut rings =
            Self { halves, start: vec![NONE; sites], free: Vec::new(), segments: count };
        // Counter-clockwise from straight down: to later sites from bottom to top, to earlier ones from top to bottom.
        let mut later = segments.as_slice();
        let mut earlier = swept.by_larger_end.as_slice();
        let mut ring: Vec<Half> = Vec::new();
        let mut begun = 0u32;
        for site in (0u32..).take(sites) {
            let right = later.iter().take_while(|ends| ends[0] == site).count();
            let left = earlier.iter().take_while(|&&e| segments[e as usize][1] == site).count();
            ring.clear();
            ring.extend((begun..).take(right).map(|e| 2 * e));
            ring.extend(earlier[..left].iter().rev().map(|e| 2 * e + 1));
            begun += u32::try_from(right).expect("a segment's id");
            (later, earlier) = (&later[right..], &earlier[left..]);
            if let [first, .., last] | [first @ last] = ring[..] {
                rings.start[site as usize] = first;
                rings.link(last, first);
                ring.windows(2).for_each(|pair| rings.link(pair[0], pair[1]));
            }
        }
        rings
    }

    #[inline]
    pub(super) fn origin(&self, h: Half) -> u32 {
        self.halves[h as usize].origin
    }

    #[inline]
    pub(super) fn destination(&self, h: Half) -> u32 {
        self.halves[(h ^ 1) as usize].origin
    }

    #[inline]
    pub(super) fn next(&self, h: Half) -> Half {
        self.halves[h as usize].next
    }

    #[inline]
    pub(super) fn previous(&self, h: Half) -> Half {
        self.halves[h as usize].previous
    }

    /// The half-edge after `h` around the face on its left.
    #[inline]
    pub(super) fn around(&self, h: Half) -> Half {
        self.previous(h ^ 1)
    }

    #[inline]
    pub(super) fn is_segment(&self, h: Half) -> bool {
        h / 2 < self.segments
    }

    /// Some half-edge that leaves `v`, if it is a site and has one.
    pub(super) fn start(&self, v: u32) -> Option<Half> {
        self.start.get(v as usize).copied().filter(|&h| h != NONE)
    }

    /// The half-edges that leave `v`, counter-clockwise, from its start.
    pub(super) fn halves(&self, v: u32) -> impl Iterator<Item = Half> + Clone + '_ {
        let first = self.start(v);
        let mut turned = first;
        std::iter::from_fn(move || {
            let h = turned?;
            turned = Some(self.next(h)).filter(|&after| Some(after) != first);
            Some(h)
        })
    }

    /// Half-edges there are or were; a removed one has no ring.
    pub(super) fn len(&self) -> u32 {
        u32::try_from(self.halves.len()).expect("half-edges have 32-bit ids")
    }

    /// Whether it is there and has not been handed over.
    #[inline]
    pub(super) fn is_waiting(&self, h: Half) -> bool {
        let Record { origin, next, .. } = self.halves[h as usize];
        origin != NONE && next != NONE
    }

    /// Puts a facet in place of a half-edge's origin and ring. Faces can still be walked round.
    #[inline]
    pub(super) fn hand_over(&mut self, h: Half, facet: u32) {
        let half = &mut self.halves[h as usize];
        (half.origin, half.next) = (NONE, facet);
    }

    /// The facet of a half-edge that was handed over.
    #[inline]
    pub(super) fn facet(&self, h: Half) -> Option<u32> {
        let Record { origin, next, .. } = self.halves[h as usize];
        (origin == NONE).then_some(next)
    }

    /// A new edge from `l` to `r`; its halves come after `at_l` and `at_r` in the rings, or are alone in them.
    #[inline]
    pub(super) fn join(&mut self, l: u32, r: u32, at_l: Option<Half>, at_r: Option<Half>) -> Half {
        let h = self.free.pop().unwrap_or_else(|| {
            let h = self.len();
            self.halves.extend([EMPTY; 2]);
            h
        });
        self.insert(h, l, at_l);
        self.insert(h ^ 1, r, at_r);
        h
    }

    #[inline]
    fn insert(&mut self, h: Half, origin: u32, at: Option<Half>) {
        let Some(before) = at else {
            self.start[origin as usize] = h;
            self.halves[h as usize] = Record { origin, next: h, previous: h };
            return;
        };
        let place = &mut self.halves[before as usize].next;
        let after = std::mem::replace(place, h);
        self.halves[after as usize].previous = h;
        self.halves[h as usize] = Record { origin, next: after, previous: before };
    }

    /// Makes `after` come after `before` in the ring of both.
    #[inline]
    fn link(&mut self, before: Half, after: Half) {
        self.halves[before as usize].next = after;
        self.halves[after as usize].previous = before;
    }

    /// Removes an edge that is no segment.
    pub(super) fn remove(&mut self, h: Half) {
        for h in [h, h ^ 1] {
            let Record { origin, next: after, previous: before } = self.halves[h as usize];
            self.halves[after as usize].previous = before;
            self.halves[before as usize].next = after;
            self.halves[h as usize].next = NONE;
            let start = &mut self.start[origin as usize];
            if *start == h {
                *start = if after == h { NONE } else { after };
            }
        }
        self.free.push(h & !1);
    }
}
