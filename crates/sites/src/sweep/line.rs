//! A sorted list of segments: in chunks, so that a place is found in O(log m) comparisons and taken in O(sqrt m) moves of
//! four bytes, which are one copy. The order is the caller's.

/// A chunk of more is cut in two.
const CHUNK: usize = 512;

/// The list. No chunk is empty.
#[derive(Debug, Default)]
pub(super) struct Line {
    chunks: Vec<Vec<u32>>,
}

/// A place in the list: that of the segment which is, or comes to be, at `index` of a chunk. Only the place behind all
/// segments is behind the last of a chunk.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    chunk: usize,
    index: usize,
}

impl Line {
    /// The place of the first segment that is not below, the segments below coming first.
    pub(super) fn search(&self, mut is_below: impl FnMut(u32) -> bool) -> Place {
        let chunk = self.chunks.partition_point(|chunk| is_below(chunk[chunk.len() - 1]));
        let here = self.chunks.get(chunk);
        let index = here.map_or(0, |chunk| chunk.partition_point(|&segment| is_below(segment)));
        self.tidy(Place { chunk, index })
    }

    /// The same place, named as [`Place`] says.
    fn tidy(&self, place: Place) -> Place {
        match self.chunks.get(place.chunk) {
            None if place.chunk > 0 => {
                let chunk = self.chunks.len() - 1;
                Place { chunk, index: self.chunks[chunk].len() }
            }
            Some(chunk) if place.index == chunk.len() && place.chunk + 1 < self.chunks.len() => {
                Place { chunk: place.chunk + 1, index: 0 }
            }
            _ => place,
        }
    }

    /// The segment at a place.
    pub(super) fn at(&self, place: Place) -> Option<u32> {
        self.chunks.get(place.chunk)?.get(place.index).copied()
    }

    /// The segments before a place and at it.
    pub(super) fn around(&self, place: Place) -> [Option<u32>; 2] {
        let before = match place {
            Place { chunk: 0, index: 0 } => None,
            Place { chunk, index: 0 } => self.chunks[chunk - 1].last().copied(),
            Place { chunk, index } => Some(self.chunks[chunk][index - 1]),
        };
        [before, self.at(place)]
    }

    /// Takes out the segment at a place; the place of the next one.
    pub(super) fn remove(&mut self, place: Place) -> Place {
        self.chunks[place.chunk].remove(place.index);
        if self.chunks[place.chunk].is_empty() {
            self.chunks.remove(place.chunk);
        }
        self.tidy(place)
    }

    /// Puts a segment in at a place; its place.
    pub(super) fn insert(&mut self, place: Place, segment: u32) -> Place {
        if self.chunks.is_empty() {
            self.chunks.push(Vec::with_capacity(CHUNK));
        }
        let chunk = &mut self.chunks[place.chunk];
        chunk.insert(place.index, segment);
        if chunk.len() < CHUNK {
            return place;
        }
        let half = chunk.split_off(CHUNK / 2);
        self.chunks.insert(place.chunk + 1, half);
        if place.index < CHUNK / 2 {
            return place;
        }
        Place { chunk: place.chunk + 1, index: place.index - CHUNK / 2 }
    }
}

#[cfg(test)]
mod tests;
