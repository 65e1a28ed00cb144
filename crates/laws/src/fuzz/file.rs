//! Files of any bytes as inputs.

use delone::formats::Format;

use crate::shrink::{Effort, drop_runs};

/// The bytes of a file, and what they are said to be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// The format that a reader is told.
    pub format: Format,
    /// The content.
    pub bytes: Vec<u8>,
}

impl File {
    /// The shortest file found, from this one on, that `fails`; bytes that matter little become zeros or blanks.
    pub(super) fn shrunk(&self, effort: &mut Effort, mut fails: impl FnMut(&Self) -> bool) -> Self {
        let mut best = self.clone();
        let mut offer = |best: &mut Self, bytes: Vec<u8>| {
            if effort.tests == 0 || bytes == best.bytes {
                return false;
            }
            effort.tests -= 1;
            let smaller = Self { format: best.format, bytes };
            let kept = fails(&smaller);
            if kept {
                *best = smaller;
            }
            kept
        };
        drop_runs(self.bytes.len(), |start, end| {
            let bytes = [&best.bytes[..start], &best.bytes[end..]].concat();
            offer(&mut best, bytes)
        });
        for place in 0..best.bytes.len() {
            for simple in *b"0 " {
                let mut bytes = best.bytes.clone();
                bytes[place] = simple;
                if b"0 ".contains(&best.bytes[place]) || offer(&mut best, bytes) {
                    break;
                }
            }
        }
        best
    }
}
