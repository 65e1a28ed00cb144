//! Well-known binary, written as hexadecimal digits, as test suites of GEOS and JTS embed it.
//!
//! Types 1 to 7 of either byte order, with the Z, M and SRID flags of PostGIS and the thousands of ISO; Z and M are
//! dropped and noted.

use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;

const DEPTH_MAX: usize = 64;

/// Whether a text can only be hexadecimal WKB.
pub(crate) fn looks_like(text: &str) -> bool {
    let text = text.trim();
    (text.starts_with("00") || text.starts_with("01"))
        && text.len() >= 10
        && text.bytes().all(|b| b.is_ascii_hexdigit() || b.is_ascii_whitespace())
}

pub(crate) fn read_hex(text: &str) -> Result<Document, ReadError> {
    let digits: Vec<u8> = text.bytes().filter(|b| !b.is_ascii_whitespace()).collect();
    let (pairs, rest) = digits.as_chunks::<2>();
    let mut bytes = Vec::new();
    for pair in pairs {
        let digit = |b: u8| char::from(b).to_digit(16).and_then(|d| u8::try_from(d).ok());
        match (digit(pair[0]), digit(pair[1])) {
            (Some(high), Some(low)) => bytes.push(high * 16 + low),
            _ => {
                return Err(ReadError::malformed(
                    1,
                    "hexadecimal digits",
                    &String::from_utf8_lossy(pair),
                ));
            }
        }
    }
    if !rest.is_empty() {
        return Err(ReadError::malformed(1, "an even number of hexadecimal digits", "one more"));
    }
    let mut reader = Reader { rest: &bytes, big: false, shapes: Shapes::new(2), higher: 0 };
    reader.geometry(0)?;
    if !reader.rest.is_empty() {
        let found = format!("{} bytes more", reader.rest.len());
        return Err(ReadError::malformed(1, "the end of the geometry", &found));
    }
    if reader.higher > 0 {
        reader.shapes.note(format!("Z or M dropped of {} coordinates", reader.higher));
    }
    Ok(reader.shapes.finish())
}

struct Reader<'a> {
    rest: &'a [u8],
    big: bool,
    shapes: Shapes,
    higher: usize,
}

impl Reader<'_> {
    fn geometry(&mut self, depth: usize) -> Result<(), ReadError> {
        if depth > DEPTH_MAX {
            return Err(ReadError::malformed(1, "collections nested at most 64 deep", "more"));
        }
        let [order] = self.take::<1>()?;
        self.big = match order {
            0 => true,
            1 => false,
            _ => return Err(ReadError::malformed(1, "byte order 00 or 01", &order.to_string())),
        };
        let code = self.word()?;
        if code & 0x2000_0000 != 0 {
            self.word()?;
        }
        let iso = code & 0x0fff_ffff;
        let flags = usize::from(code & 0x8000_0000 != 0) + usize::from(code & 0x4000_0000 != 0);
        let width = 2
            + flags
            + match iso / 1000 {
                0 => 0,
                1 | 2 => 1,
                _ => 2,
            };
        match iso % 1000 {
            1 => {
                let point = self.point(width)?;
                // An empty point is written with NaN coordinates.
                if !point.iter().all(|x| x.is_nan()) {
                    self.shapes.point(&point)?;
                }
            }
            2 => {
                let points = self.run(width)?;
                self.shapes.line(&points)?;
            }
            3 => {
                for _ in 0..self.word()? {
                    let points = self.run(width)?;
                    self.shapes.ring(&points)?;
                }
            }
            4..=7 => {
                for _ in 0..self.word()? {
                    self.geometry(depth + 1)?;
                }
            }
            other => return Err(ReadError::malformed(1, "a WKB type 1 to 7", &other.to_string())),
        }
        Ok(())
    }

    fn run(&mut self, width: usize) -> Result<Vec<[f64; 2]>, ReadError> {
        let mut points = Vec::new();
        for _ in 0..self.word()? {
            points.push(self.point(width)?);
        }
        Ok(points)
    }

    fn point(&mut self, width: usize) -> Result<[f64; 2], ReadError> {
        let mut point = [0.0; 2];
        for i in 0..width {
            let x = f64::from_le_bytes(self.take()?);
            if let Some(slot) = point.get_mut(i) {
                *slot = x;
            }
        }
        self.higher += usize::from(width > 2);
        Ok(point)
    }

    fn word(&mut self) -> Result<u32, ReadError> {
        Ok(u32::from_le_bytes(self.take()?))
    }

    /// The next `N` bytes, little end first.
    fn take<const N: usize>(&mut self) -> Result<[u8; N], ReadError> {
        let Some((head, rest)) = self.rest.split_first_chunk::<N>() else {
            return Err(ReadError::truncated(1, "the next number of the geometry"));
        };
        self.rest = rest;
        let mut bytes = *head;
        if self.big {
            bytes.reverse();
        }
        Ok(bytes)
    }
}

#[cfg(test)]
mod tests;
