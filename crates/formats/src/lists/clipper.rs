//! Test suites of Clipper2: blocks that begin with `CAPTION:`, with paths after `SUBJECTS`, `SUBJECTS_OPEN`, `CLIPS`.
//!
//! Each block is a document with its subjects and its clips; open subjects are lines, the rest are rings. A path is a
//! line `x,y x,y ..`, with commas or blanks between any two numbers.

use crate::document::Document;
use crate::error::ReadError;
use crate::shapes::Shapes;
use crate::text::{Line, lines, number};

#[derive(Clone, Copy, Debug)]
enum Paths {
    None,
    Closed,
    Open,
}

pub(crate) fn read(text: &str) -> Result<Vec<Document>, ReadError> {
    let mut documents = Vec::new();
    let mut block: Option<Shapes> = None;
    let mut paths = Paths::None;
    for line in lines(text, None) {
        let keyword = line.text.split([' ', ':', '\t']).next().unwrap_or("");
        match keyword {
            "CAPTION" => {
                documents.extend(block.take().map(Shapes::finish));
                block = Some(Shapes::new(2));
                paths = Paths::None;
            }
            "SUBJECTS" | "CLIPS" => paths = Paths::Closed,
            "SUBJECTS_OPEN" => paths = Paths::Open,
            "CLIPTYPE" | "FILLRULE" | "SOL_AREA" | "SOL_COUNT" => {}
            _ => {
                let shapes = block.as_mut();
                let shapes = shapes
                    .ok_or_else(|| ReadError::malformed(line.number, "CAPTION", line.text))?;
                let points = path(&line)?;
                match paths {
                    Paths::None => {
                        return Err(ReadError::malformed(line.number, "a keyword", line.text));
                    }
                    Paths::Closed => shapes.ring(&points)?,
                    Paths::Open => shapes.line(&points)?,
                }
            }
        }
    }
    documents.extend(block.map(Shapes::finish));
    Ok(documents)
}

fn path(line: &Line<'_>) -> Result<Vec<[f64; 2]>, ReadError> {
    let xs = line
        .fields()
        .map(|field| number(field, line.number, "a coordinate or a keyword"))
        .collect::<Result<Vec<f64>, _>>()?;
    let (points, rest) = xs.as_chunks::<2>();
    if rest.is_empty() {
        Ok(points.to_vec())
    } else {
        Err(ReadError::malformed(line.number, "an even number of coordinates", line.text))
    }
}
