//! STL, read only: ascii and binary. Corners with equal coordinates become one point.

use crate::document::Document;
use crate::error::{ReadError, at};
use crate::shapes::Shapes;
use crate::text::{Tokens, decode};

/// Header of 80 bytes, then a count of 4; each triangle is a normal, three corners and two bytes.
const HEADER: usize = 84;
const TRIANGLE: usize = 50;

pub(crate) fn read(bytes: &[u8]) -> Result<Document, ReadError> {
    let says_solid = bytes.trim_ascii_start().starts_with(b"solid");
    // Some binary files say `solid` too: only text holds a `facet` or ends at once.
    let head = &bytes[..bytes.len().min(1000)];
    let is_text = says_solid && (head.is_ascii() && !head.contains(&0));
    if is_text { read_text(&decode(bytes)) } else { read_binary(bytes) }
}

fn read_binary(bytes: &[u8]) -> Result<Document, ReadError> {
    let Some((header, body)) = bytes.split_at_checked(HEADER) else {
        return Err(ReadError::truncated(0, "the number of triangles"));
    };
    let announced = header.last_chunk::<4>().map_or(0, |count| u32::from_le_bytes(*count));
    let announced = usize::try_from(announced).unwrap_or(usize::MAX);
    let (triangles, rest) = body.as_chunks::<TRIANGLE>();
    if triangles.len() != announced || !rest.is_empty() {
        let (of, found) = ("triangles", triangles.len());
        return Err(if rest.is_empty() {
            ReadError::CountDiffers { at: at(0), of, announced, found }
        } else {
            ReadError::truncated(0, format!("the end of triangle {found} of {announced}"))
        });
    }
    let mut shapes = Shapes::new(3);
    for triangle in triangles {
        let mut corners = [[0.0; 3]; 3];
        let reals = triangle[12..48].as_chunks::<4>().0;
        for (x, bytes) in corners.as_flattened_mut().iter_mut().zip(reals) {
            *x = f32::from_le_bytes(*bytes).into();
        }
        shapes.face(&corners)?;
    }
    Ok(shapes.finish())
}

/// Only `vertex x y z` and `endfacet` matter; the words between are stepped over.
fn read_text(text: &str) -> Result<Document, ReadError> {
    let mut shapes = Shapes::new(3);
    let mut tokens = Tokens::new(text, None);
    let mut corners: Vec<[f64; 3]> = Vec::new();
    let mut ended = false;
    while let Ok(token) = tokens.next("") {
        match token.text {
            "vertex" if token.leads => {
                corners.push([
                    tokens.number("a coordinate")?,
                    tokens.number("a coordinate")?,
                    tokens.number("a coordinate")?,
                ]);
            }
            "endfacet" if token.leads => {
                if corners.len() != 3 {
                    let found = format!("{} vertices", corners.len());
                    return Err(ReadError::malformed(token.line, "three vertices", &found));
                }
                shapes.face(&corners)?;
                corners.clear();
            }
            "endsolid" if token.leads => ended = true,
            _ => {}
        }
    }
    if !ended || !corners.is_empty() {
        return Err(ReadError::truncated(text.lines().count(), "endsolid"));
    }
    Ok(shapes.finish())
}

#[cfg(test)]
mod tests;
