//! Where a generator's decisions come from: the project's random numbers, or a fuzzer's bytes.

use delone::workloads::Rng;

use crate::corpus::{Corpus, NO_CORPUS};

/// A source of decisions. A generator is a function of it alone.
pub trait Choices {
    /// A number below `bound`; 0 if that is 0.
    fn below(&mut self, bound: u64) -> u64;

    /// 64 bits.
    fn bits(&mut self) -> u64;

    /// Files that a case may take pieces of.
    fn corpus(&self) -> &Corpus {
        NO_CORPUS
    }

    /// An index below `bound`; 0 if that is 0.
    fn index(&mut self, bound: usize) -> usize {
        usize::try_from(self.below(bound as u64)).expect("below a usize")
    }

    /// An integer from `low` to `high`.
    ///
    /// # Panics
    /// If `low > high`.
    fn integer(&mut self, low: i32, high: i32) -> i32 {
        assert!(low <= high, "an empty range has no integer to choose");
        let offset = self.below(u64::from(high.abs_diff(low)) + 1);
        low.wrapping_add_unsigned(u32::try_from(offset).expect("below 2^32"))
    }

    /// True once in `every` choices.
    fn one_in(&mut self, every: u64) -> bool {
        self.below(every) + 1 == every
    }
}

impl Choices for Rng {
    fn below(&mut self, bound: u64) -> u64 {
        Self::below(self, bound)
    }

    fn bits(&mut self) -> u64 {
        self.next_u64()
    }
}

/// Random numbers, beside files to take pieces of.
#[derive(Debug)]
pub struct Beside<'c> {
    /// The decisions.
    pub rng: Rng,
    /// The files.
    pub corpus: &'c Corpus,
}

impl Choices for Beside<'_> {
    fn below(&mut self, bound: u64) -> u64 {
        self.rng.below(bound)
    }

    fn bits(&mut self) -> u64 {
        self.rng.next_u64()
    }

    fn corpus(&self) -> &Corpus {
        self.corpus
    }
}

/// Decisions read off bytes, as a coverage-guided fuzzer makes them; when they run out, every decision is 0.
#[derive(Clone, Copy, Debug)]
pub struct Bytes<'b>(pub &'b [u8]);

impl Bytes<'_> {
    /// The next `count` bytes as a number, little end first.
    fn take(&mut self, count: usize) -> u64 {
        let (head, rest) = self.0.split_at(count.min(self.0.len()));
        self.0 = rest;
        head.iter().rev().fold(0, |sum, &byte| sum << 8 | u64::from(byte))
    }
}

impl Choices for Bytes<'_> {
    fn below(&mut self, bound: u64) -> u64 {
        match bound {
            0 | 1 => 0,
            2..=0x100 => self.take(1) % bound,
            0x101..=0x1_0000 => self.take(2) % bound,
            _ => self.take(8) % bound,
        }
    }

    fn bits(&mut self) -> u64 {
        self.take(8)
    }
}
