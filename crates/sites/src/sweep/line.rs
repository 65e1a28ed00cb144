//! A sorted list of segments: in chunks, so that a place is found in O(log m) comparisons and taken in O(sqrt m) moves of
//! four bytes, which are one copy. The order is the caller's. A segment in the list is found by its chunk, without a comparison.

/// A chunk of more is cut in two.
const CHUNK: usize = 256;

/// No chunk.
const NONE: u32 = u32::MAX;

/// The list. No chunk is empty.
#[derive(Debug, Default)]
pub(super) struct Line {
    chunks: Vec<Chunk>,
    /// For each segment that is or was in the list the name of its chunk.
    home: Vec<u32>,
    /// For each chunk, by name, where it is among the chunks; `NONE` if it is no more.
    places: Vec<u32>,
}

#[derive(Debug)]
struct Chunk {
    name: u32,
    segments: Vec<u32>,
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
        let last = |chunk: &Chunk| chunk.segments[chunk.segments.len() - 1];
        let chunk = self.chunks.partition_point(|chunk| is_below(last(chunk)));
        let here = self.segments(chunk);
        let index = here.map_or(0, |chunk| chunk.partition_point(|&segment| is_below(segment)));
        self.tidy(Place { chunk, index })
    }

    /// The place of a segment, if it is in the list.
    pub(super) fn find(&self, segment: u32) -> Option<Place> {
        let name = *self.home.get(segment as usize)?;
        let chunk = *self.places.get(name as usize)?;
        let segments = self.segments(chunk as usize)?;
        // Compared by the dozen: the first part that has it, then the place in it.
        const PART: usize = 16;
        let has = |part: &[u32]| part.iter().fold(false, |has, &other| has | (other == segment));
        let part = segments.chunks(PART).position(has)?;
        let rest = segments[part * PART..].iter().position(|&other| other == segment)?;
        Some(Place { chunk: chunk as usize, index: part * PART + rest })
    }

    /// The place before, if there is one.
    pub(super) fn previous(&self, place: Place) -> Option<Place> {
        if let Some(index) = place.index.checked_sub(1) {
            return Some(Place { index, ..place });
        }
        let chunk = place.chunk.checked_sub(1)?;
        Some(Place { chunk, index: self.chunks[chunk].segments.len() - 1 })
    }

    fn segments(&self, chunk: usize) -> Option<&[u32]> {
        self.chunks.get(chunk).map(|chunk| &chunk.segments[..])
    }

    /// The same place, named as [`Place`] says.
    fn tidy(&self, place: Place) -> Place {
        match self.segments(place.chunk) {
            None if place.chunk > 0 => {
                let chunk = self.chunks.len() - 1;
                Place { chunk, index: self.chunks[chunk].segments.len() }
            }
            Some(chunk) if place.index == chunk.len() && place.chunk + 1 < self.chunks.len() => {
                Place { chunk: place.chunk + 1, index: 0 }
            }
            _ => place,
        }
    }

    /// The segment at a place.
    pub(super) fn at(&self, place: Place) -> Option<u32> {
        self.segments(place.chunk)?.get(place.index).copied()
    }

    /// The segments before a place and at it.
    pub(super) fn around(&self, place: Place) -> [Option<u32>; 2] {
        [self.previous(place).and_then(|before| self.at(before)), self.at(place)]
    }

    /// Takes out the segment at a place; the place of the next one.
    pub(super) fn remove(&mut self, place: Place) -> Place {
        let Chunk { name, segments } = &mut self.chunks[place.chunk];
        segments.remove(place.index);
        if segments.is_empty() {
            self.places[*name as usize] = NONE;
            self.chunks.remove(place.chunk);
            self.moved(place.chunk);
        }
        self.tidy(place)
    }

    /// Puts a segment in at a place; its place.
    pub(super) fn insert(&mut self, place: Place, segment: u32) -> Place {
        if self.chunks.is_empty() {
            self.put_chunk(0, Vec::with_capacity(CHUNK));
        }
        let Chunk { name, segments } = &mut self.chunks[place.chunk];
        segments.insert(place.index, segment);
        if self.home.len() <= segment as usize {
            self.home.resize(segment as usize + 1, NONE);
        }
        self.home[segment as usize] = *name;
        if segments.len() < CHUNK {
            return place;
        }
        let half = segments.split_off(CHUNK / 2);
        self.put_chunk(place.chunk + 1, half);
        if place.index < CHUNK / 2 {
            return place;
        }
        Place { chunk: place.chunk + 1, index: place.index - CHUNK / 2 }
    }

    /// A new chunk, of these segments.
    fn put_chunk(&mut self, chunk: usize, segments: Vec<u32>) {
        let name = u32::try_from(self.places.len()).expect("chunks are fewer than segments");
        segments.iter().for_each(|&segment| self.home[segment as usize] = name);
        self.places.push(NONE);
        self.chunks.insert(chunk, Chunk { name, segments });
        self.moved(chunk);
    }

    /// Chunks from this one on have moved.
    fn moved(&mut self, from: usize) {
        for (place, chunk) in (0u32..).zip(&self.chunks).skip(from) {
            self.places[chunk.name as usize] = place;
        }
    }
}

#[cfg(test)]
mod tests;
