//! OFF and nOFF: `OFF`, `vertices faces edges`, vertices, then faces `k i1 .. ik [colour]`.
//!
//! `nOFF` states the dimension before the counts. A prefix of `ST`, `C`, `N` (texture, colour, normal) adds columns
//! that are dropped; colours after a face's corners are dropped. Everything in the plane z = 0 is read as 2D.

use std::io::{self, Write};

use crate::document::Document;
use crate::error::ReadError;
use crate::text::{Line, count, index, lines, number};
use crate::write::{Lost, shortest};

pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let mut rows = lines(text, Some('#'));
    let mut last = 1;
    let mut next = |expected: &str| -> Result<Line<'_>, ReadError> {
        let line = rows.next().ok_or_else(|| ReadError::truncated(last, expected))?;
        last = line.number;
        Ok(line)
    };
    let mut line = next("OFF")?;
    let keyword = line.fields().next().unwrap_or("");
    if !keyword.ends_with("OFF") || keyword.trim_start_matches(['S', 'T', 'C', 'N', 'n']) != "OFF" {
        return Err(ReadError::malformed(line.number, "OFF or nOFF", line.text));
    }
    let mut counts: Vec<&str> = line.fields().skip(1).collect();
    let mut dimension = 3;
    if keyword.contains('n') {
        if counts.is_empty() {
            line = next("a dimension")?;
            counts = line.fields().collect();
        }
        let Some(&first) = counts.first() else {
            return Err(ReadError::malformed(line.number, "a dimension", line.text));
        };
        counts.remove(0);
        dimension = count(first, line.number, "a dimension")?;
        if !matches!(dimension, 2 | 3) {
            return Err(ReadError::malformed(line.number, "dimension 2 or 3", line.text));
        }
    }
    if counts.is_empty() {
        line = next("`vertices faces edges`")?;
        counts = line.fields().collect();
    }
    if !matches!(counts.len(), 2 | 3) {
        return Err(ReadError::malformed(line.number, "`vertices faces edges`", line.text));
    }
    let vertices = count(counts[0], line.number, "a number of vertices")?;
    let faces = count(counts[1], line.number, "a number of faces")?;
    let mut document = Document::new(dimension);
    for _ in 0..vertices {
        vertex(&next("the next vertex")?, &mut document)?;
    }
    for _ in 0..faces {
        face(&next("the next face")?, &mut document)?;
    }
    match rows.next() {
        None => Ok(document.flattened_if_plane()),
        Some(line) => {
            let want = "the end of the file, or larger counts in the header";
            Err(ReadError::malformed(line.number, want, line.text))
        }
    }
}

fn vertex(line: &Line<'_>, document: &mut Document) -> Result<(), ReadError> {
    let point = line
        .fields()
        .take(document.dimension)
        .map(|field| number(field, line.number, "a coordinate"))
        .collect::<Result<Vec<f64>, _>>()?;
    if point.len() < document.dimension {
        let want = format!("{} coordinates", document.dimension);
        return Err(ReadError::malformed(line.number, want, line.text));
    }
    document.push_point(&point, line.number)?;
    Ok(())
}

fn face(line: &Line<'_>, document: &mut Document) -> Result<(), ReadError> {
    let mut fields = line.fields();
    let corners = count(fields.next().unwrap_or(""), line.number, "a number of corners")?;
    let points = document.point_count();
    let face = fields
        .take(corners)
        .map(|field| index(field, line.number, 0, points))
        .collect::<Result<Vec<u32>, _>>()?;
    if face.len() < corners || corners == 0 {
        return Err(ReadError::malformed(line.number, format!("{corners} corners"), line.text));
    }
    document.push_face(face);
    Ok(())
}

/// Writes points, triangles and polygons; a document in the plane becomes `nOFF` of dimension 2.
pub(crate) fn write(document: &Document, out: &mut impl Write) -> io::Result<()> {
    let faces = document.triangles.len() + document.polygons.len();
    if document.dimension == 2 {
        writeln!(out, "nOFF\n2")?;
    } else {
        writeln!(out, "OFF")?;
    }
    writeln!(out, "{} {faces} 0", document.point_count())?;
    crate::xyz::write_xyz(document, out)?;
    let triangles = document.triangles.iter().map(|t| &t[..]);
    for face in triangles.chain(document.polygons.iter().map(|p| &p[..])) {
        write!(out, "{}", face.len())?;
        face.iter().try_for_each(|v| write!(out, " {v}"))?;
        writeln!(out)?;
    }
    Ok(())
}

pub(crate) fn lost(document: &Document, lost: &mut Lost) {
    lost.if_any("segments", document.segments.len());
    lost.if_any("tetrahedra", document.tets.len());
    lost.seeds(document);
    lost.labels(document);
}

/// One row of coordinates, used by OBJ too.
pub(crate) fn row(point: &[f64]) -> String {
    point.iter().map(|&x| shortest(x)).collect::<Vec<String>>().join(" ")
}

#[cfg(test)]
mod tests;
