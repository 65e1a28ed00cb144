//! The values after a PLY header, one at a time, from text or from bytes.

use std::fmt;

use super::Scalar;
use crate::error::ReadError;
use crate::text::Tokens;

/// One value: a whole number or a real, as its type says.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Value {
    Whole(i64),
    Real(f64),
}

impl Value {
    pub(crate) fn real(self) -> f64 {
        match self {
            // At most 32 bits, so exact.
            Self::Whole(i) => i as f64,
            Self::Real(x) => x,
        }
    }

    pub(crate) fn whole(self) -> Option<usize> {
        match self {
            Self::Whole(i) => usize::try_from(i).ok(),
            Self::Real(_) => None,
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Whole(i) => write!(f, "{i}"),
            Self::Real(x) => write!(f, "{x}"),
        }
    }
}

pub(crate) trait Body {
    fn value(&mut self, scalar: Scalar) -> Result<Value, ReadError>;
    /// The line last read, 0 in bytes.
    fn line(&self) -> usize;
    /// Nothing may follow.
    fn finish(&mut self) -> Result<(), ReadError>;
}

pub(crate) struct Ascii<'a> {
    tokens: Tokens<'a>,
    header_lines: usize,
    line: usize,
}

impl<'a> Ascii<'a> {
    pub(crate) fn new(text: &'a str, header_lines: usize) -> Self {
        Self { tokens: Tokens::new(text, None), header_lines, line: header_lines }
    }
}

impl Body for Ascii<'_> {
    fn value(&mut self, scalar: Scalar) -> Result<Value, ReadError> {
        let shift = self.header_lines + 1;
        let token = self.tokens.next("the next value").map_err(|error| error.after_line(shift))?;
        self.line = self.header_lines + token.line;
        let real = matches!(scalar, Scalar::F32 | Scalar::F64);
        let whole = if real { None } else { token.text.parse().ok().map(Value::Whole) };
        whole
            .or_else(|| crate::text::parse_number(token.text).filter(|_| real).map(Value::Real))
            .ok_or_else(|| {
                ReadError::malformed(self.line, "a number of the property's type", token.text)
            })
    }

    fn line(&self) -> usize {
        self.line
    }

    fn finish(&mut self) -> Result<(), ReadError> {
        let want = "the end of the file, or larger counts in the header";
        self.tokens.finish(want).map_err(|error| error.after_line(self.header_lines + 1))
    }
}

pub(crate) struct Binary<'a> {
    rest: &'a [u8],
    big: Order,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    Little,
    Big,
}

impl<'a> Binary<'a> {
    pub(crate) fn little(rest: &'a [u8]) -> Self {
        Self { rest, big: Order::Little }
    }

    pub(crate) fn big(rest: &'a [u8]) -> Self {
        Self { rest, big: Order::Big }
    }

    /// The next `N` bytes, little end first.
    fn take<const N: usize>(&mut self) -> Result<[u8; N], ReadError> {
        let Some((head, rest)) = self.rest.split_first_chunk::<N>() else {
            return Err(ReadError::truncated(0, "the next value"));
        };
        self.rest = rest;
        let mut bytes = *head;
        if self.big == Order::Big {
            bytes.reverse();
        }
        Ok(bytes)
    }
}

impl Body for Binary<'_> {
    fn value(&mut self, scalar: Scalar) -> Result<Value, ReadError> {
        Ok(match scalar {
            Scalar::I8 => Value::Whole(i8::from_le_bytes(self.take()?).into()),
            Scalar::U8 => Value::Whole(u8::from_le_bytes(self.take()?).into()),
            Scalar::I16 => Value::Whole(i16::from_le_bytes(self.take()?).into()),
            Scalar::U16 => Value::Whole(u16::from_le_bytes(self.take()?).into()),
            Scalar::I32 => Value::Whole(i32::from_le_bytes(self.take()?).into()),
            Scalar::U32 => Value::Whole(u32::from_le_bytes(self.take()?).into()),
            Scalar::F32 => Value::Real(f32::from_le_bytes(self.take()?).into()),
            Scalar::F64 => Value::Real(f64::from_le_bytes(self.take()?)),
        })
    }

    fn line(&self) -> usize {
        0
    }

    fn finish(&mut self) -> Result<(), ReadError> {
        if self.rest.is_empty() || self.rest.iter().all(u8::is_ascii_whitespace) {
            return Ok(());
        }
        let found = format!("{} bytes more", self.rest.len());
        Err(ReadError::malformed(0, "the end of the file, or larger counts in the header", &found))
    }
}
