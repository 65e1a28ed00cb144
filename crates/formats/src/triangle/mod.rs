//! The files of Triangle and TetGen: `.node`, `.poly`, `.ele`, `.edge`, `.neigh`.
//!
//! Shared by all: `#` starts a comment, blank lines mean nothing, every item is one line that begins with its own
//! number. The first point's number, 0 or 1, says how all numbers of the file count; a number that is missing or
//! repeated is refused, and so is a line with more or fewer fields than its header announces.

pub(crate) mod edge;
pub(crate) mod ele;
pub(crate) mod neigh;
pub(crate) mod node;
pub(crate) mod poly;

#[cfg(test)]
mod tests;

use crate::document::Document;
use crate::error::{ReadError, at};
use crate::text::{Line, count, lines, number};

/// The lines of one file, taken one at a time.
pub(crate) struct Items<'a> {
    lines: Box<dyn Iterator<Item = Line<'a>> + 'a>,
    last: usize,
}

impl<'a> Items<'a> {
    pub(crate) fn new(text: &'a str) -> Self {
        Self { lines: Box::new(lines(text, Some('#'))), last: 1 }
    }

    pub(crate) fn next_if_any(&mut self) -> Option<Line<'a>> {
        let line = self.lines.next();
        self.last = line.map_or(self.last, |line| line.number);
        line
    }

    pub(crate) fn next(&mut self, expected: &str) -> Result<Line<'a>, ReadError> {
        self.next_if_any().ok_or_else(|| ReadError::truncated(self.last, expected))
    }

    /// A header: `wanted` whole numbers, those after the first may be absent and are then `defaults`.
    pub(crate) fn header<const N: usize>(
        &mut self,
        expected: &str,
        defaults: [usize; N],
    ) -> Result<(Line<'a>, [usize; N]), ReadError> {
        let line = self.next(expected)?;
        Ok((line, header_of(&line, expected, defaults)?))
    }

    pub(crate) fn finish(&mut self) -> Result<(), ReadError> {
        match self.next_if_any() {
            None => Ok(()),
            Some(line) => {
                let want = "the end of the file, or a larger count in the header";
                Err(ReadError::malformed(line.number, want, line.text))
            }
        }
    }
}

pub(crate) fn header_of<const N: usize>(
    line: &Line<'_>,
    expected: &str,
    defaults: [usize; N],
) -> Result<[usize; N], ReadError> {
    let mut values = defaults;
    let mut fields = line.fields();
    for value in &mut values {
        if let Some(field) = fields.next() {
            *value = count(field, line.number, expected)?;
        }
    }
    match fields.next() {
        None => Ok(values),
        Some(_) => Err(ReadError::malformed(line.number, expected, line.text)),
    }
}

/// Fields of an item's line after its own number, which must be `due`.
pub(crate) fn numbered<'a>(
    line: &Line<'a>,
    of: &'static str,
    due: usize,
) -> Result<impl Iterator<Item = &'a str> + use<'a>, ReadError> {
    let mut fields = line.fields();
    let own = fields.next().unwrap_or("");
    if own.parse() != Ok(due) {
        let found = crate::error::shorten(own);
        return Err(ReadError::NumberingBroken { at: at(line.number), of, expected: due, found });
    }
    Ok(fields)
}

/// The number an item list starts from: its first line's own, if that is 0 or 1.
pub(crate) fn first_number(line: &Line<'_>, of: &'static str) -> Result<usize, ReadError> {
    match line.fields().next() {
        Some("0") => Ok(0),
        Some("1") => Ok(1),
        other => {
            let found = crate::error::shorten(other.unwrap_or(""));
            Err(ReadError::NumberingBroken { at: at(line.number), of, expected: 1, found })
        }
    }
}

/// A marker: a whole number, though some programs write it `0.0`.
pub(crate) fn marker(text: &str, line: usize) -> Result<i64, ReadError> {
    text.parse().map_err(|_| ReadError::malformed(line, "a whole number as marker", text))
}

pub(crate) fn real(text: &str, line: usize) -> Result<f64, ReadError> {
    number(text, line, "a number")
}

/// Points for a file that names them by number: from the `.node` file beside it.
pub(crate) fn nodes_beside(nodes: Option<&str>) -> Result<Document, ReadError> {
    let nodes = nodes.ok_or_else(|| ReadError::NodesMissing { at: at(0) })?;
    let mut document = node::read(nodes).map_err(|error| error.in_file("the .node file beside"))?;
    document.points_listed = document.point_count();
    Ok(document)
}
