//! Polygon test sets of Manifold: `name ntriangles epsilon nrings`, then per ring `n` and n points; several a file.

use super::take_points;
use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;
use crate::text::Tokens;

pub(crate) fn read(text: &str) -> Result<Vec<Document>, ReadError> {
    let mut tokens = Tokens::new(text, Some('#'));
    let mut documents = Vec::new();
    while !tokens.is_done() {
        let name = tokens.next("a name")?.text.to_owned();
        tokens.count("a number of triangles")?;
        tokens.number("a tolerance")?;
        let rings = tokens.count("a number of rings")?;
        let mut shapes = Shapes::new(2);
        for _ in 0..rings {
            let points = tokens.count("a number of points")?;
            shapes.ring(&take_points(&mut tokens, points)?)?;
        }
        let mut document = shapes.finish();
        document.name = name;
        documents.push(document);
    }
    Ok(documents)
}
