//! Well-known text: every geometry of a file is a document.
//!
//! Own parser: it bounds the nesting of collections, knows `TRIANGLE`, `TIN`, `POLYHEDRALSURFACE` and `LINEARRING`,
//! takes quotients `p/q` as coordinates, closes rings that the file leaves open, and says the line of a fault. Z and M
//! are dropped and noted. A line that begins with `#` is a comment. A leading `SRID=..;` is stepped over. In a file of
//! geometries a line may go on after its geometry is complete (a bracket too many): left out and noted, as by JTS.

use std::io::{self, Write};

use crate::document::Document;
use crate::error::ReadError;
use crate::rational::parse_coordinate;
use crate::shapes::Shapes;
use crate::write::shortest;

/// Collections in collections deeper than this are refused.
const DEPTH_MAX: usize = 64;

const KEYWORDS: [&str; 11] = [
    "POINT",
    "LINESTRING",
    "LINEARRING",
    "POLYGON",
    "TRIANGLE",
    "MULTIPOINT",
    "MULTILINESTRING",
    "MULTIPOLYGON",
    "TIN",
    "POLYHEDRALSURFACE",
    "GEOMETRYCOLLECTION",
];

/// Whether a text begins like a geometry.
pub(crate) fn looks_like(text: &str) -> bool {
    let word: String = text
        .trim_start()
        .chars()
        .take_while(char::is_ascii_alphabetic)
        .collect::<String>()
        .to_ascii_uppercase();
    KEYWORDS.contains(&word.as_str()) || word == "SRID"
}

/// All geometries of a text, comment lines left out.
pub(crate) fn read(text: &str) -> Result<Vec<Document>, ReadError> {
    let mut parser = Parser::new(text);
    let mut documents = Vec::new();
    loop {
        parser.skip_blank_and_comments();
        if parser.rest().is_empty() {
            return Ok(documents);
        }
        let mut document = parser.document()?;
        parser.drop_tail(&mut document);
        documents.push(document);
    }
}

/// Exactly one geometry.
pub(crate) fn read_one(text: &str) -> Result<Document, ReadError> {
    let mut parser = Parser::new(text);
    let document = parser.document()?;
    parser.skip_blank();
    match parser.rest() {
        "" => Ok(document),
        rest => Err(ReadError::malformed(parser.line, "the end of the geometry", rest)),
    }
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
    line: usize,
    shapes: Shapes,
    rounded: usize,
    higher: usize,
}

impl<'a> Parser<'a> {
    fn new(text: &'a str) -> Self {
        Self { text, at: 0, line: 1, shapes: Shapes::new(2), rounded: 0, higher: 0 }
    }

    fn document(&mut self) -> Result<Document, ReadError> {
        self.shapes = Shapes::new(2);
        (self.rounded, self.higher) = (0, 0);
        self.skip_blank();
        if self.rest().starts_with("SRID=") {
            let end = self.rest().find(';').map_or(self.rest().len(), |i| i + 1);
            self.at += end;
        }
        self.geometry(0)?;
        if self.higher > 0 {
            self.shapes.note(format!("Z or M dropped of {} coordinates", self.higher));
        }
        if self.rounded > 0 {
            self.shapes.note(format!(
                "{} rational coordinates rounded to the nearest double",
                self.rounded
            ));
        }
        Ok(std::mem::replace(&mut self.shapes, Shapes::new(2)).finish())
    }

    fn geometry(&mut self, depth: usize) -> Result<(), ReadError> {
        if depth > DEPTH_MAX {
            return Err(ReadError::malformed(
                self.line,
                "collections nested at most 64 deep",
                "more",
            ));
        }
        let kind = self.word();
        if !KEYWORDS.contains(&kind.as_str()) {
            let found = if kind.is_empty() { self.rest().to_owned() } else { kind };
            return Err(ReadError::malformed(self.line, "a WKT geometry", &found));
        }
        let before = (self.at, self.line);
        if !matches!(self.word().as_str(), "Z" | "M" | "ZM") {
            (self.at, self.line) = before;
        }
        let before = (self.at, self.line);
        if self.word() == "EMPTY" {
            return Ok(());
        }
        (self.at, self.line) = before;
        match kind.as_str() {
            "POINT" | "MULTIPOINT" => self.list(Self::points)?,
            "LINESTRING" => self.line_string()?,
            "LINEARRING" => self.ring()?,
            "POLYGON" | "TRIANGLE" => self.list(Self::ring)?,
            "MULTILINESTRING" => self.list(Self::line_string)?,
            "MULTIPOLYGON" | "TIN" | "POLYHEDRALSURFACE" => self.list(|p| p.list(Self::ring))?,
            _ => self.list(|p| p.geometry(depth + 1))?,
        }
        Ok(())
    }

    /// `(item, item, ..)`, or `EMPTY` in its place.
    fn list(&mut self, item: impl Fn(&mut Self) -> Result<(), ReadError>) -> Result<(), ReadError> {
        let before = (self.at, self.line);
        if self.word() == "EMPTY" {
            return Ok(());
        }
        (self.at, self.line) = before;
        self.expect('(')?;
        loop {
            item(self)?;
            if !self.accept(',') {
                return self.expect(')');
            }
        }
    }

    /// A point of a `MULTIPOINT`, in its own brackets or not.
    fn points(&mut self) -> Result<(), ReadError> {
        let before = (self.at, self.line);
        if self.word() == "EMPTY" {
            return Ok(());
        }
        (self.at, self.line) = before;
        let bracketed = self.accept('(');
        let point = self.coordinates()?;
        self.shapes.point(&point)?;
        if bracketed { self.expect(')') } else { Ok(()) }
    }

    fn line_string(&mut self) -> Result<(), ReadError> {
        let points = self.run()?;
        self.shapes.line(&points)
    }

    fn ring(&mut self) -> Result<(), ReadError> {
        let points = self.run()?;
        self.shapes.ring(&points)
    }

    fn run(&mut self) -> Result<Vec<[f64; 2]>, ReadError> {
        let before = (self.at, self.line);
        if self.word() == "EMPTY" {
            return Ok(Vec::new());
        }
        (self.at, self.line) = before;
        self.expect('(')?;
        let mut points = Vec::new();
        loop {
            points.push(self.coordinates()?);
            if !self.accept(',') {
                self.expect(')')?;
                return Ok(points);
            }
        }
    }

    /// Two to four numbers.
    fn coordinates(&mut self) -> Result<[f64; 2], ReadError> {
        let mut point = [0.0; 2];
        let mut count = 0;
        loop {
            self.skip_blank();
            let rest = self.rest();
            let end =
                rest.find(|c: char| c.is_whitespace() || "(),|".contains(c)).unwrap_or(rest.len());
            let field = &rest[..end];
            if field.is_empty() && count >= 2 {
                self.higher += usize::from(count > 2);
                return Ok(point);
            }
            let read = parse_coordinate(field).filter(|_| count < 4);
            let Some(read) = read else {
                return Err(if rest.is_empty() {
                    ReadError::truncated(self.line, "a coordinate")
                } else {
                    ReadError::malformed(
                        self.line,
                        "a coordinate",
                        rest.lines().next().unwrap_or(""),
                    )
                });
            };
            self.at += end;
            if count < 2 {
                point[count] = read.value;
                self.rounded += usize::from(read.inexact);
            }
            count += 1;
        }
    }

    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or("")
    }

    fn word(&mut self) -> String {
        self.skip_blank();
        let rest = self.rest();
        let end = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        self.at += end;
        rest[..end].to_ascii_uppercase()
    }

    fn accept(&mut self, mark: char) -> bool {
        self.skip_blank();
        let found = self.rest().starts_with(mark);
        self.at += usize::from(found);
        found
    }

    fn expect(&mut self, mark: char) -> Result<(), ReadError> {
        if self.accept(mark) {
            return Ok(());
        }
        match self.rest() {
            "" => Err(ReadError::truncated(self.line, format!("`{mark}`"))),
            rest => Err(ReadError::malformed(self.line, format!("`{mark}`"), rest)),
        }
    }

    /// Brackets and commas that go on after a complete geometry, to the end of the line.
    fn drop_tail(&mut self, document: &mut Document) {
        let rest = self.rest();
        let tail = rest.lines().next().unwrap_or("");
        if tail.trim_start().starts_with([',', ')']) {
            self.at += tail.len();
            document.note(format!("text after the geometry left out, line {}", self.line));
        }
    }

    fn skip_blank(&mut self) {
        let rest = self.rest();
        let blank = rest.len() - rest.trim_start().len();
        self.line += rest[..blank].matches('\n').count();
        self.at += blank;
    }

    fn skip_blank_and_comments(&mut self) {
        self.skip_blank();
        while self.rest().starts_with('#') {
            self.at += self.rest().find('\n').unwrap_or(self.rest().len());
            self.skip_blank();
        }
    }
}

/// Writes one `GEOMETRYCOLLECTION`: `MULTIPOINT`, `MULTILINESTRING` of the segments, `MULTIPOLYGON` of the faces.
pub(crate) fn write(document: &Document, out: &mut impl Write) -> io::Result<()> {
    let at = |v: u32| -> String {
        let point = usize::try_from(v).ok().and_then(|v| document.point(v)).unwrap_or(&[]);
        point.iter().map(|&x| shortest(x)).collect::<Vec<_>>().join(" ")
    };
    let z = if document.dimension == 3 { " Z" } else { "" };
    let mut parts = Vec::new();
    if document.point_count() > 0 {
        let points: Vec<String> = document
            .points
            .chunks_exact(document.dimension.max(1))
            .map(|point| format!("({})", crate::off::row(point)))
            .collect();
        parts.push(format!("MULTIPOINT{z} ({})", points.join(", ")));
    }
    if !document.segments.is_empty() {
        let lines: Vec<String> =
            document.segments.iter().map(|&[a, b]| format!("({}, {})", at(a), at(b))).collect();
        parts.push(format!("MULTILINESTRING{z} ({})", lines.join(", ")));
    }
    let faces: Vec<String> = crate::geojson::faces(document)
        .map(|face| {
            let ring: Vec<String> = face.iter().chain(face.first()).map(|&v| at(v)).collect();
            format!("(({}))", ring.join(", "))
        })
        .collect();
    if !faces.is_empty() {
        parts.push(format!("MULTIPOLYGON{z} ({})", faces.join(", ")));
    }
    match parts.is_empty() {
        true => writeln!(out, "GEOMETRYCOLLECTION EMPTY"),
        false => writeln!(out, "GEOMETRYCOLLECTION{z} ({})", parts.join(", ")),
    }
}

#[cfg(test)]
mod tests;
