//! Sites of CGAL's segment Delaunay graph (`.cin`): `p x y` and `s x1 y1 x2 y2`, one a line.
//!
//! A last field on the line (a colour) is dropped and noted.

use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;
use crate::text::{lines, number};

pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let mut shapes = Shapes::new(2);
    let mut colours = 0_usize;
    for line in lines(text, Some('#')) {
        let fields: Vec<&str> = line.fields().collect();
        let wanted = match fields.first() {
            Some(&"p") => 2,
            Some(&"s") => 4,
            _ => {
                return Err(ReadError::malformed(
                    line.number,
                    "`p x y` or `s x1 y1 x2 y2`",
                    line.text,
                ));
            }
        };
        if fields.len() < 1 + wanted || fields.len() > 2 + wanted {
            return Err(ReadError::malformed(
                line.number,
                format!("{wanted} coordinates"),
                line.text,
            ));
        }
        colours += usize::from(fields.len() == 2 + wanted);
        let xs = fields[1..=wanted]
            .iter()
            .map(|field| number(field, line.number, "a coordinate"))
            .collect::<Result<Vec<f64>, _>>()?;
        match xs[..] {
            [a, b, c, d] => shapes.segment(&[a, b], &[c, d])?,
            [x, y] => drop(shapes.point(&[x, y])?),
            _ => {}
        }
    }
    if colours > 0 {
        shapes.note(format!("a last field dropped on {colours} lines"));
    }
    Ok(shapes.finish())
}
