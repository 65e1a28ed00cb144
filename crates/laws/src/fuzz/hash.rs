//! A hash that chains numbers through the project's own generator.

use delone::workloads::Rng;

#[derive(Default)]
pub(super) struct Hash(u64);

impl Hash {
    pub(super) fn take(&mut self, word: u64) {
        self.0 = Rng::new(self.0.rotate_left(23) ^ word).next_u64();
    }

    pub(super) fn text(&mut self, text: &str) {
        self.bytes(text.as_bytes());
    }

    pub(super) fn bytes(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.take(u64::from(byte)));
    }

    pub(super) fn value(&self) -> u64 {
        self.0
    }
}
