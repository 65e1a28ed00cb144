//! Triangles that do not keep the bounds, by urgency.
//!
//! Urgency is a shortest edge up to a factor of a half or so of its square, then a least angle up to an eighth or so of its squared
//! tangent: few values, each with a list in the order in which triangles came. Nothing is compared; the first list that is not empty
//! is the first bit set.
//!
//! **Cost.** O(1). 20 bytes for each triangle queued at one time, and 4 KiB for each factor of two in the shortest edges' squares.

use delone_mesh::{CellId, VertexId};

/// A triangle as it was when it was queued.
type Entry = (CellId, [VertexId; 3]);

/// No entry.
const NONE: u32 = u32::MAX;

/// Exponents of doubles, and the first bit of mantissas.
const LEVELS: usize = 1 << 12;

/// Least angles that are told apart.
const STEPS: usize = 1 << 8;

/// Bits in a word.
const WORD: usize = 64;

/// How soon it is a triangle's turn: less is sooner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Urgency {
    level: usize,
    step: usize,
}

impl Urgency {
    /// Short edges first, up to a factor of 1.5 or 1.33 of their squares; among those, small angles first, by their squared tangent.
    /// Either alone takes more vertices: the first on curves, the second where edges of all lengths meet. So do wider factors: with 2
    /// there are graphs that take a sixth more.
    pub(super) fn new(shortest: f64, tangent_square: f64) -> Self {
        let bits = |x: f64, shift: u32| usize::try_from(x.to_bits() >> shift).unwrap_or(usize::MAX);
        // Of tangents the exponent and three bits of the mantissa; below 2^-31 all are one.
        let least = bits(0.5f64.powi(31), 49);
        Self {
            level: bits(shortest, 51).min(LEVELS - 1),
            step: bits(tangent_square, 49).saturating_sub(least).min(STEPS - 1),
        }
    }
}

/// The triangles of one level: for each step the first and the last entry.
#[derive(Clone, Debug)]
struct Level {
    ends: [[u32; 2]; STEPS],
    filled: [u64; STEPS / WORD],
}

/// See the module's text.
#[derive(Debug)]
pub(super) struct Queue {
    levels: Vec<Option<Box<Level>>>,
    filled: [u64; LEVELS / WORD],
    /// Which words of that are not zero.
    words: u64,
    /// Each with the one after it, on its list or on that of those that are free.
    entries: Vec<(Entry, u32)>,
    free: u32,
}

impl Default for Queue {
    fn default() -> Self {
        let levels = (0..LEVELS).map(|_| None).collect();
        Self { levels, filled: [0; LEVELS / WORD], words: 0, entries: Vec::new(), free: NONE }
    }
}

impl Queue {
    /// Queues a triangle.
    pub(super) fn push(&mut self, urgency: Urgency, cell: CellId, corners: [VertexId; 3]) {
        let new = self.place(((cell, corners), NONE));
        let Urgency { level, step } = urgency;
        set(&mut self.filled, level);
        self.words |= 1 << (level / WORD);
        let level = self.levels[level].get_or_insert_with(|| {
            Box::new(Level { ends: [[NONE; 2]; STEPS], filled: [0; STEPS / WORD] })
        });
        set(&mut level.filled, step);
        let [first, last] = &mut level.ends[step];
        if *first == NONE {
            *first = new;
        } else {
            self.entries[*last as usize].1 = new;
        }
        *last = new;
    }

    /// The first of the most urgent.
    pub(super) fn pop(&mut self) -> Option<Entry> {
        let word = first(&[self.words])?;
        let at = word * WORD + first(&[self.filled[word]])?;
        let level = self.levels[at].as_mut()?;
        let step = first(&level.filled)?;
        let [head, _] = &mut level.ends[step];
        let place = *head;
        let (entry, next) = self.entries[place as usize];
        *head = next;
        if next == NONE {
            clear(&mut level.filled, step);
            if first(&level.filled).is_none() {
                clear(&mut self.filled, at);
                self.words &= !(u64::from(self.filled[word] == 0) << word);
            }
        }
        self.entries[place as usize].1 = self.free;
        self.free = place;
        Some(entry)
    }

    /// Where an entry was put.
    fn place(&mut self, entry: (Entry, u32)) -> u32 {
        match self.free {
            NONE => {
                self.entries.push(entry);
                u32::try_from(self.entries.len() - 1).expect("entries are fewer than ids")
            }
            place => {
                self.free = self.entries[place as usize].1;
                self.entries[place as usize] = entry;
                place
            }
        }
    }
}

fn set(words: &mut [u64], bit: usize) {
    words[bit / WORD] |= 1 << (bit % WORD);
}

fn clear(words: &mut [u64], bit: usize) {
    words[bit / WORD] &= !(1 << (bit % WORD));
}

/// The first bit that is set.
fn first(words: &[u64]) -> Option<usize> {
    let (place, word) = words.iter().enumerate().find(|(_, word)| **word != 0)?;
    Some(place * WORD + usize::try_from(word.trailing_zeros()).unwrap_or(0))
}

#[cfg(test)]
mod tests;
