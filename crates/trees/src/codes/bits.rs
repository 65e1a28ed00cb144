//! Bits in bytes.

use crate::{CodeFault, Colour};

/// A string of bits, the first one the highest of the first byte.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Bits {
    bytes: Vec<u8>,
    len: usize,
}

impl Bits {
    /// So many bits of these bytes, if there are as many. The rest of the last byte must be zero, and is made so.
    #[must_use]
    pub fn new(mut bytes: Vec<u8>, len: usize) -> Option<Self> {
        if len > bytes.len() * 8 {
            return None;
        }
        bytes.truncate(len.div_ceil(8));
        if let (Some(last), rest @ 1..) = (bytes.last_mut(), len % 8) {
            *last &= !(0xff >> rest);
        }
        Some(Self { bytes, len })
    }

    /// How many.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The bytes that hold them, filled up with zeros.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The bits in order.
    pub fn iter(&self) -> impl Iterator<Item = bool> + Clone + '_ {
        (0..self.len).map(|at| self.bytes[at / 8] >> (7 - at % 8) & 1 == 1)
    }

    pub(crate) fn push(&mut self, bit: bool) {
        if self.len.is_multiple_of(8) {
            self.bytes.push(0);
        }
        self.bytes[self.len / 8] |= u8::from(bit) << (7 - self.len % 8);
        self.len += 1;
    }

    pub(crate) fn of_colours(colours: impl Iterator<Item = Colour>) -> Self {
        let mut bits = Self::default();
        for colour in colours {
            bits.push(colour == Colour::Gray);
            if colour != Colour::Gray {
                bits.push(colour == Colour::Black);
            }
        }
        bits
    }

    pub(crate) fn colours(&self) -> Result<Vec<Colour>, CodeFault> {
        let mut bits = self.iter();
        let mut colours = Vec::new();
        while let Some(gray) = bits.next() {
            colours.push(match gray {
                true => Colour::Gray,
                false => Colour::of(bits.next().ok_or(CodeFault::Truncated { at: self.len })?),
            });
        }
        Ok(colours)
    }
}
