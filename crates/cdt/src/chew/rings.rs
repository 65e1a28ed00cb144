//! Half-edges in rings: for each site the half-edges that leave it, counter-clockwise.
//!
//! Half-edge `h` and its other half `h ^ 1` lie side by side; segment `e` is the halves `2 e` (from its first end) and
//! `2 e + 1`, and its halves are never removed. The face on the left of `h` goes on with `around(h)`.

use std::cmp::Ordering;

use delone_predicates::{PlaneKernel, Sign};
use delone_sites::Ends;

/// A half-edge, by index.
pub(super) type Half = u32;

const NONE: u32 = u32::MAX;

/// The rings of all sites. The sector of half-edge `h` is the angle from it counter-clockwise to the next in its ring.
#[derive(Debug)]
pub(crate) struct Rings {
    origin: Vec<u32>,
    next: Vec<Half>,
    previous: Vec<Half>,
    /// Some half-edge of each site's ring.
    start: Vec<Half>,
    /// First halves of removed edges, to be used again.
    free: Vec<Half>,
    segments: u32,
}

impl Rings {
    /// The rings that hold both halves of each segment.
    pub(super) fn new(kernel: &impl PlaneKernel, sites: usize, segments: &[Ends]) -> Self {
        let origin: Vec<u32> = segments.as_flattened().to_vec();
        let halves = origin.len();
        let count = u32::try_from(segments.len()).expect("a planar graph's edges have 32-bit ids");
        let mut rings = Self {
            origin,
            next: vec![NONE; halves],
            previous: vec![NONE; halves],
            start: vec![NONE; sites],
            free: Vec::new(),
            segments: count,
        };
        let mut sorted: Vec<Half> = (0..2 * count).collect();
        sorted.sort_unstable_by(|&g, &h| {
            let (u, v) = (rings.origin(g), rings.origin(h));
            u.cmp(&v).then_with(|| rings.by_angle(kernel, g, h))
        });
        for ring in sorted.chunk_by(|&g, &h| rings.origin[g as usize] == rings.origin[h as usize]) {
            rings.start[rings.origin[ring[0] as usize] as usize] = ring[0];
            for (&h, &g) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                rings.next[h as usize] = g;
                rings.previous[g as usize] = h;
            }
        }
        rings
    }

    /// The order of two half-edges of one site by angle: those to later sites first, counter-clockwise.
    fn by_angle(&self, kernel: &impl PlaneKernel, g: Half, h: Half) -> Ordering {
        let v = self.origin(g);
        let (to_g, to_h) = (self.destination(g), self.destination(h));
        (to_g < v).cmp(&(to_h < v)).then_with(|| {
            match kernel.orient(&[v as usize, to_g as usize, to_h as usize]) {
                Sign::Positive => Ordering::Less,
                Sign::Zero => Ordering::Equal,
                Sign::Negative => Ordering::Greater,
            }
        })
    }

    #[inline]
    pub(super) fn origin(&self, h: Half) -> u32 {
        self.origin[h as usize]
    }

    #[inline]
    pub(super) fn destination(&self, h: Half) -> u32 {
        self.origin[(h ^ 1) as usize]
    }

    #[inline]
    pub(super) fn next(&self, h: Half) -> Half {
        self.next[h as usize]
    }

    #[inline]
    pub(super) fn previous(&self, h: Half) -> Half {
        self.previous[h as usize]
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

    /// Some half-edge that leaves `v`.
    pub(super) fn start(&self, v: u32) -> Option<Half> {
        Some(self.start[v as usize]).filter(|&h| h != NONE)
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
        u32::try_from(self.origin.len()).expect("half-edges have 32-bit ids")
    }

    pub(super) fn is_removed(&self, h: Half) -> bool {
        self.next(h) == NONE
    }

    /// A new edge from `l` to `r`; its halves come after `at_l` and `at_r` in the rings, or are alone in them.
    pub(super) fn join(&mut self, l: u32, r: u32, at_l: Option<Half>, at_r: Option<Half>) -> Half {
        let h = self.free.pop().unwrap_or_else(|| {
            let h = self.len();
            self.origin.extend([NONE; 2]);
            self.next.extend([NONE; 2]);
            self.previous.extend([NONE; 2]);
            h
        });
        self.origin[h as usize] = l;
        self.origin[(h ^ 1) as usize] = r;
        self.insert(h, at_l);
        self.insert(h ^ 1, at_r);
        h
    }

    fn insert(&mut self, h: Half, at: Option<Half>) {
        let (before, after) = match at {
            Some(at) => (at, self.next(at)),
            None => {
                let v = self.origin(h);
                self.start[v as usize] = h;
                (h, h)
            }
        };
        self.next[before as usize] = h;
        self.previous[h as usize] = before;
        self.next[h as usize] = after;
        self.previous[after as usize] = h;
    }

    /// Removes an edge that is no segment.
    pub(super) fn remove(&mut self, h: Half) {
        for h in [h, h ^ 1] {
            let (before, after) = (self.previous(h), self.next(h));
            self.next[before as usize] = after;
            self.previous[after as usize] = before;
            let start = &mut self.start[self.origin[h as usize] as usize];
            if *start == h {
                *start = if after == h { NONE } else { after };
            }
            self.next[h as usize] = NONE;
        }
        self.free.push(h & !1);
    }
}
