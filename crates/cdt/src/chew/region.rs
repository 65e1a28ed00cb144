//! Regions, and the lists of segments that leave them. Nothing is allocated for each: a list goes from segment to segment.

/// No segment.
const NONE: u32 = u32::MAX;

/// Which wall of the slab.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wall {
    Left,
    Right,
}

/// A list of segments from bottom to top, linked in [`Lists`].
#[derive(Clone, Copy, Debug)]
pub(super) struct List {
    first: u32,
    last: u32,
}

impl List {
    pub(super) const EMPTY: Self = Self { first: NONE, last: NONE };

    pub(super) fn first(self) -> Option<u32> {
        some(self.first)
    }
}

/// For each segment the next one in the list that it is in. It is in one for each wall at most: the left wall's list of
/// the region that holds its second end, and the right wall's of the one that holds its first, as long as the other end is outside.
#[derive(Debug)]
pub(super) struct Lists {
    next: Vec<[u32; 2]>,
}

impl Lists {
    pub(super) fn new(segments: usize) -> Self {
        Self { next: vec![[NONE; 2]; segments] }
    }

    pub(super) fn push(&mut self, list: &mut List, wall: Wall, segment: u32) {
        self.next[segment as usize][wall as usize] = NONE;
        self.append(list, wall, List { first: segment, last: segment });
    }

    /// The same at the other end.
    pub(super) fn push_below(&mut self, list: &mut List, wall: Wall, segment: u32) {
        let above = std::mem::replace(list, List::EMPTY);
        self.push(list, wall, segment);
        self.append(list, wall, above);
    }

    /// `list` and then `other`.
    pub(super) fn append(&mut self, list: &mut List, wall: Wall, other: List) {
        if list.first == NONE {
            *list = other;
        } else if other.first != NONE {
            self.next[list.last as usize][wall as usize] = other.first;
            list.last = other.last;
        }
    }

    /// The next segment of the list that `segment` is in.
    pub(super) fn after(&self, segment: u32, wall: Wall) -> Option<u32> {
        some(self.next[segment as usize][wall as usize])
    }
}

fn some(segment: u32) -> Option<u32> {
    (segment != NONE).then_some(segment)
}

/// A region of a slab.
#[derive(Clone, Copy, Debug)]
pub(super) struct Region {
    /// The spanning segment next below.
    pub(super) low: Option<u32>,
    /// The spanning segment next above.
    pub(super) high: Option<u32>,
    /// Segments that leave the region through the slab's left wall.
    pub(super) left: List,
    /// And through the right wall.
    pub(super) right: List,
    /// The region's first site.
    pub(super) first: u32,
    /// The region's last site.
    pub(super) last: u32,
}

impl Region {
    /// One without sites, to take in others.
    pub(super) const fn above(low: Option<u32>) -> Self {
        Self { low, high: None, left: List::EMPTY, right: List::EMPTY, first: NONE, last: 0 }
    }

    pub(super) const fn holds_a_site(&self) -> bool {
        self.first != NONE
    }

    /// Takes in the sites of another region.
    pub(super) fn take(&mut self, other: &Self) {
        self.first = self.first.min(other.first);
        self.last = self.last.max(other.last);
    }
}
