//! Test polygons of poly2tri: `x y` lines of one ring; `HOLE` starts another ring, `STEINER` starts free points.

use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;
use crate::text::{lines, number};

pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let mut shapes = Shapes::new(2);
    let mut ring = Vec::new();
    let mut free = false;
    for line in lines(text, Some('#')) {
        if matches!(line.text, "HOLE" | "STEINER") {
            shapes.ring(&std::mem::take(&mut ring))?;
            free = line.text == "STEINER";
            continue;
        }
        let mut fields = line.fields();
        let (Some(x), Some(y), None) = (fields.next(), fields.next(), fields.next()) else {
            return Err(ReadError::malformed(line.number, "`x y`, HOLE or STEINER", line.text));
        };
        let point =
            [number(x, line.number, "a coordinate")?, number(y, line.number, "a coordinate")?];
        if free {
            shapes.point(&point)?;
        } else {
            ring.push(point);
        }
    }
    shapes.ring(&ring)?;
    Ok(shapes.finish())
}
