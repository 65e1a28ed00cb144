//! Voronoi inputs of Boost.Polygon: `n`, n points `x y`, then optionally `m` and m segments `x1 y1 x2 y2`.

use super::take_points;
use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;
use crate::text::Tokens;

pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let mut tokens = Tokens::new(text, Some('#'));
    let mut shapes = Shapes::new(2);
    let points = tokens.count("a number of points")?;
    for point in take_points(&mut tokens, points)? {
        shapes.point(&point)?;
    }
    if !tokens.is_done() {
        let segments = tokens.count("a number of segments")?;
        for _ in 0..segments {
            let ends = take_points(&mut tokens, 2)?;
            shapes.segment(&ends[0], &ends[1])?;
        }
    }
    tokens.finish("the end of the file")?;
    Ok(shapes.finish())
}
