//! NumPy's `.npy`: a table of doubles, a point a row, two or three columns.
//!
//! Magic bytes, a version, the length of a header, a header that is a Python dictionary, then the numbers. Read are versions 1 to 3,
//! `'<f8'`, in C order; what is something else is named. Written is version 1.0, the numbers on a boundary of 64 bytes.

use std::io::{self, Write};

use crate::document::Document;
use crate::error::{ReadError, at};
use crate::write::Lost;

pub(crate) const MAGIC: &[u8] = b"\x93NUMPY";
const COLUMNS: &str = "a table of two or three columns: shape (n, 2) or (n, 3)";

pub(crate) fn read(bytes: &[u8]) -> Result<Document, ReadError> {
    let rest = bytes.strip_prefix(MAGIC);
    let rest = rest.ok_or_else(|| ReadError::malformed(0, "\\x93NUMPY", &first_of(bytes)))?;
    let (header, data) = split(rest)?;
    let header = Header::of(header)?;
    if header.descr != "<f8" {
        let expected = "doubles, little end first: descr '<f8'";
        return Err(ReadError::malformed(0, expected, &header.descr));
    }
    if header.fortran_order {
        return Err(ReadError::malformed(0, "C order: fortran_order False", "True"));
    }
    let [count, dimension @ (2 | 3)] = header.shape[..] else {
        return Err(ReadError::malformed(0, COLUMNS, &format!("{:?}", header.shape)));
    };
    let (numbers, odd) = data.as_chunks::<8>();
    let announced = count.saturating_mul(dimension);
    if numbers.len() != announced || !odd.is_empty() {
        let found = numbers.len();
        return Err(ReadError::CountDiffers { at: at(0), of: "coordinates", announced, found });
    }
    if u32::try_from(count).is_err() {
        return Err(ReadError::TooMany { at: at(0), of: "points" });
    }
    let points = numbers.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect();
    Ok(Document { points, points_listed: count, ..Document::new(dimension) })
}

fn first_of(bytes: &[u8]) -> String {
    String::from_utf8_lossy(&bytes[..bytes.len().min(8)]).into_owned()
}

/// The header's text and the data, after the version and the header's length.
fn split(bytes: &[u8]) -> Result<(&str, &[u8]), ReadError> {
    let ends = || ReadError::truncated(0, "the end of the header");
    let (version, rest) = bytes.split_first_chunk::<2>().ok_or_else(ends)?;
    let (length, rest) = match version[0] {
        1 => {
            let (length, rest) = rest.split_first_chunk::<2>().ok_or_else(ends)?;
            (u32::from(u16::from_le_bytes(*length)), rest)
        }
        2 | 3 => {
            let (length, rest) = rest.split_first_chunk::<4>().ok_or_else(ends)?;
            (u32::from_le_bytes(*length), rest)
        }
        other => return Err(ReadError::malformed(0, "version 1, 2 or 3", &other.to_string())),
    };
    let length = usize::try_from(length).unwrap_or(usize::MAX);
    let (header, data) = rest.split_at_checked(length).ok_or_else(ends)?;
    let header = std::str::from_utf8(header).map_err(|_| {
        ReadError::malformed(0, "a header of text", &String::from_utf8_lossy(header))
    })?;
    Ok((header, data))
}

/// What the dictionary says.
struct Header {
    descr: String,
    fortran_order: bool,
    shape: Vec<usize>,
}

impl Header {
    fn of(text: &str) -> Result<Self, ReadError> {
        let value = |key: &str| {
            let after = text.split_once(&format!("'{key}'")).map(|(_, after)| after.trim_start());
            let value = after.and_then(|after| after.strip_prefix(':')).map(str::trim_start);
            value.ok_or_else(|| ReadError::malformed(0, format!("a header with '{key}'"), text))
        };
        let descr = value("descr")?;
        // A list of fields stands in brackets: no quoted text begins there.
        let quoted = descr.strip_prefix('\'').and_then(|rest| rest.split_once('\''));
        let order = value("fortran_order")?;
        let (is_fortran, is_c) = (order.starts_with("True"), order.starts_with("False"));
        if !is_fortran && !is_c {
            return Err(ReadError::malformed(0, "fortran_order True or False", order));
        }
        let shape = value("shape")?;
        let listed = shape.strip_prefix('(').and_then(|rest| rest.split_once(')'));
        let shape: Option<Vec<usize>> = listed.and_then(|(inside, _)| {
            let items = inside.split(',').map(str::trim).filter(|item| !item.is_empty());
            items.map(|item| item.parse().ok()).collect()
        });
        Ok(Self {
            descr: quoted.map_or(descr, |(name, _)| name).to_owned(),
            fortran_order: is_fortran,
            shape: shape
                .ok_or_else(|| ReadError::malformed(0, "a shape", value("shape").unwrap_or("")))?,
        })
    }
}

/// Numbers begin at a multiple of this.
const ALIGNED: usize = 64;
/// Magic, version, length of the header.
const BEFORE: usize = MAGIC.len() + 4;

pub(crate) fn write(document: &Document, out: &mut impl Write) -> io::Result<()> {
    let columns = document.dimension.max(1);
    let mut header = format!(
        "{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {columns}), }}",
        document.point_count()
    );
    let length = (BEFORE + header.len() + 1).next_multiple_of(ALIGNED) - BEFORE;
    header.extend(std::iter::repeat_n(' ', length - 1 - header.len()));
    header.push('\n');
    let length = u16::try_from(length).expect("three numbers have few digits");
    out.write_all(MAGIC)?;
    out.write_all(&[1, 0])?;
    out.write_all(&length.to_le_bytes())?;
    out.write_all(header.as_bytes())?;
    document.points.iter().try_for_each(|x| out.write_all(&x.to_le_bytes()))
}

/// What a table of coordinates cannot hold.
pub(crate) fn lost(document: &Document, lost: &mut Lost) {
    lost.faces_and_segments(document);
    lost.labels(document);
}

#[cfg(test)]
mod tests;
