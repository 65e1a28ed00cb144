//! Shorelines of GSHHG as text: `> id level area npoints`, then that many lines `lon lat`, closed.

use crate::document::Document;
use crate::error::{ReadError, at};
use crate::shapes::Shapes;
use crate::text::{lines, number};

pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let mut shapes = Shapes::new(2);
    let mut ring: Option<Ring> = None;
    for line in lines(text, Some('#')) {
        if let Some(header) = line.text.strip_prefix('>') {
            close(ring.take(), &mut shapes)?;
            let last = header.split_whitespace().last().unwrap_or("");
            let announced = crate::text::count(last, line.number, "`> id level area npoints`")?;
            ring = Some(Ring { line: line.number, announced, points: Vec::new() });
            continue;
        }
        let mut fields = line.fields();
        let (Some(x), Some(y), None) = (fields.next(), fields.next(), fields.next()) else {
            return Err(ReadError::malformed(line.number, "two coordinates", line.text));
        };
        let point = [number(x, line.number, "a longitude")?, number(y, line.number, "a latitude")?];
        match &mut ring {
            Some(ring) => ring.points.push(point),
            None => {
                return Err(ReadError::malformed(line.number, "a header line `> ..`", line.text));
            }
        }
    }
    close(ring, &mut shapes)?;
    Ok(shapes.finish())
}

struct Ring {
    line: usize,
    announced: usize,
    points: Vec<[f64; 2]>,
}

fn close(ring: Option<Ring>, shapes: &mut Shapes) -> Result<(), ReadError> {
    let Some(Ring { line, announced, points }) = ring else { return Ok(()) };
    let found = points.len();
    if announced != found {
        return Err(ReadError::CountDiffers { at: at(line), of: "ring points", announced, found });
    }
    shapes.ring(&points)
}
