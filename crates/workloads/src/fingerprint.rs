//! FNV-1a in 64 bits: a name for an input, the same on every machine.

/// A running FNV-1a hash.
#[derive(Clone, Debug)]
pub(crate) struct Fnv(u64);

impl Fnv {
    pub(crate) fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    pub(crate) fn bytes(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    pub(crate) fn double(&mut self, x: f64) {
        self.bytes(&x.to_bits().to_le_bytes());
    }

    pub(crate) fn value(&self) -> u64 {
        self.0
    }
}
