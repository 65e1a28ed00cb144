//! Inputs of detria: `npoints npolylines nedges`, the polylines' sizes, their types, the points, the polylines' vertex
//! indices, then single edges; all indices 0-based.
//!
//! A polyline is a closed ring whatever its type (0 outline, 1 hole, 2 either); its first index may be repeated last.

use super::take_points;
use crate::document::Document;
use crate::error::ReadError;
use crate::text::Tokens;

pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let mut tokens = Tokens::new(text, None);
    let points = tokens.count("a number of points")?;
    let polylines = tokens.count("a number of polylines")?;
    let edges = tokens.count("a number of edges")?;
    let mut sizes = Vec::new();
    for _ in 0..polylines {
        sizes.push(tokens.count("a polyline's size")?);
    }
    for _ in 0..polylines {
        let kind = tokens.next("a polyline's type")?;
        if !matches!(kind.text, "0" | "1" | "2") {
            return Err(ReadError::malformed(kind.line, "a polyline type 0, 1 or 2", kind.text));
        }
    }
    let mut document = Document::new(2);
    for point in take_points(&mut tokens, points)? {
        document.push_point(&point, 0)?;
    }
    for size in sizes {
        polyline(&mut tokens, size, &mut document)?;
    }
    for _ in 0..edges {
        let (a, b) = (tokens.index(0, points)?, tokens.index(0, points)?);
        edge(&mut document, a, b);
    }
    tokens.finish("the end of the file")?;
    if document.zero_length_dropped > 0 {
        document
            .note(format!("{} edges from a point to itself dropped", document.zero_length_dropped));
    }
    Ok(document)
}

fn polyline(
    tokens: &mut Tokens<'_>,
    size: usize,
    document: &mut Document,
) -> Result<(), ReadError> {
    let mut ring = Vec::new();
    for _ in 0..size {
        ring.push(tokens.index(0, document.point_count())?);
    }
    for pair in ring.windows(2) {
        edge(document, pair[0], pair[1]);
    }
    if let [first, .., last] = ring[..]
        && first != last
    {
        edge(document, last, first);
    }
    Ok(())
}

fn edge(document: &mut Document, a: u32, b: u32) {
    if a == b {
        document.zero_length_dropped += 1;
    } else {
        document.segments.push([a, b]);
    }
}
