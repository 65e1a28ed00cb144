//! Inputs of artem-ogre/CDT: `nv ne`, nv points `x y`, ne edges `i j`, 0-based.

use super::take_points;
use crate::document::Document;
use crate::error::ReadError;
use crate::text::Tokens;

pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let mut tokens = Tokens::new(text, None);
    let points = tokens.count("a number of points")?;
    let edges = tokens.count("a number of edges")?;
    let mut document = Document::new(2);
    for point in take_points(&mut tokens, points)? {
        document.push_point(&point, 0)?;
    }
    for _ in 0..edges {
        let (a, b) = (tokens.index(0, points)?, tokens.index(0, points)?);
        if a == b {
            document.zero_length_dropped += 1;
        } else {
            document.segments.push([a, b]);
        }
    }
    tokens.finish("the end of the file")?;
    if document.zero_length_dropped > 0 {
        document
            .note(format!("{} edges from a point to itself dropped", document.zero_length_dropped));
    }
    Ok(document)
}
