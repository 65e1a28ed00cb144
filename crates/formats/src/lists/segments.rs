//! Segment soups (`.edg`, arrangement `.dat`): `n`, then n segments `x1 y1 x2 y2`; coordinates may be `p/q`.
//!
//! As in CGAL's own readers the count rules: what follows the n segments is left out, and noted.

use crate::document::Document;
use crate::error::ReadError;
use crate::rational::parse_coordinate;
use crate::shapes::Shapes;
use crate::text::Tokens;

pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let mut tokens = Tokens::new(text, Some('#'));
    let mut shapes = Shapes::new(2);
    let mut rounded = 0;
    let segments = tokens.count("a number of segments")?;
    for _ in 0..segments {
        let a = point(&mut tokens, &mut rounded)?;
        let b = point(&mut tokens, &mut rounded)?;
        shapes.segment(&a, &b)?;
    }
    let after = tokens.len() - tokens.cursor;
    if after > 0 {
        shapes.note(format!("{after} fields after the announced segments left out"));
    }
    note_rounded(&mut shapes, rounded);
    Ok(shapes.finish())
}

/// A point whose coordinates may be rationals; counts those that had to be rounded.
pub(super) fn point(tokens: &mut Tokens<'_>, rounded: &mut usize) -> Result<[f64; 2], ReadError> {
    let mut point = [0.0; 2];
    for x in &mut point {
        let token = tokens.next("a coordinate")?;
        let read = parse_coordinate(token.text).ok_or_else(|| {
            ReadError::malformed(token.line, "a number or a quotient p/q", token.text)
        })?;
        *rounded += usize::from(read.inexact);
        *x = read.value;
    }
    Ok(point)
}

pub(super) fn note_rounded(shapes: &mut Shapes, rounded: usize) {
    if rounded > 0 {
        shapes.note(format!("{rounded} rational coordinates rounded to the nearest double"));
    }
}
