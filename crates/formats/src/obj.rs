//! Wavefront OBJ: `v x y z`, `l i j ..`, `f i j k ..`; indices count from 1, or backwards from -1.
//!
//! `l` lines become segments, `f` faces; `v` beyond the third number, normals, texture coordinates, groups and
//! materials are dropped. An index may name a vertex that stands later in the file. Everything in the plane z = 0 is
//! read as 2D.

use std::io::{self, Write};

use crate::document::Document;
use crate::error::{ReadError, at, shorten};
use crate::text::{Line, lines, number};
use crate::write::Lost;

pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let mut document = Document::new(3);
    let mut elements = Vec::new();
    for line in lines(text, Some('#')) {
        let keyword = line.text.split_whitespace().next().unwrap_or("");
        match keyword {
            "v" => vertex(&line, &mut document)?,
            "l" | "f" | "p" => elements.push((line, document.point_count())),
            "vn" | "vt" | "vp" | "g" | "o" | "s" | "mtllib" | "usemtl" | "mg" | "usemap" => {}
            _ => return Err(ReadError::malformed(line.number, "an OBJ keyword", line.text)),
        }
    }
    for (line, known) in elements {
        element(&line, known, &mut document)?;
    }
    Ok(document.flattened_if_plane())
}

fn vertex(line: &Line<'_>, document: &mut Document) -> Result<(), ReadError> {
    let point = line
        .text
        .split_whitespace()
        .skip(1)
        .map(|field| number(field, line.number, "a coordinate"))
        .collect::<Result<Vec<f64>, _>>()?;
    if point.len() < 3 {
        return Err(ReadError::malformed(line.number, "`v x y z`", line.text));
    }
    document.push_point(&point, line.number)?;
    Ok(())
}

fn element(line: &Line<'_>, known: usize, document: &mut Document) -> Result<(), ReadError> {
    let mut fields = line.text.split_whitespace();
    let keyword = fields.next();
    let corners = fields
        .map(|field| corner(field, line.number, known, document.point_count()))
        .collect::<Result<Vec<u32>, _>>()?;
    let wanted = match keyword {
        Some("l") => 2,
        Some("f") => 3,
        _ => 1,
    };
    if corners.len() < wanted {
        return Err(ReadError::malformed(
            line.number,
            format!("{wanted} or more corners"),
            line.text,
        ));
    }
    match keyword {
        Some("l") => document.segments.extend(corners.windows(2).map(|pair| [pair[0], pair[1]])),
        Some("f") => document.push_face(corners),
        _ => {}
    }
    Ok(())
}

/// `i`, `i/t`, `i//n`, `i/t/n`; negative `i` counts back from the vertices `known` where the line stands.
fn corner(field: &str, line: usize, known: usize, points: usize) -> Result<u32, ReadError> {
    let text = field.split('/').next().unwrap_or("");
    let Ok(written) = text.parse::<i64>() else {
        return Err(ReadError::malformed(line, "a vertex index", field));
    };
    let magnitude = usize::try_from(written.unsigned_abs()).unwrap_or(usize::MAX);
    let index = if written > 0 { magnitude.checked_sub(1) } else { known.checked_sub(magnitude) };
    index.filter(|&i| i < points && written != 0).and_then(|i| u32::try_from(i).ok()).ok_or_else(
        || ReadError::IndexOutOfRange {
            at: at(line),
            index: shorten(text),
            first: 1,
            count: points,
        },
    )
}

pub(crate) fn write(document: &Document, out: &mut impl Write) -> io::Result<()> {
    for point in document.points.chunks_exact(document.dimension.max(1)) {
        let z = if document.dimension == 2 { " 0" } else { "" };
        writeln!(out, "v {}{z}", crate::off::row(point))?;
    }
    let segments = document.segments.iter().map(|s| ("l", &s[..]));
    let triangles = document.triangles.iter().map(|t| ("f", &t[..]));
    let polygons = document.polygons.iter().map(|p| ("f", &p[..]));
    for (keyword, corners) in segments.chain(triangles).chain(polygons) {
        write!(out, "{keyword}")?;
        corners.iter().try_for_each(|&v| write!(out, " {}", u64::from(v) + 1))?;
        writeln!(out)?;
    }
    Ok(())
}

pub(crate) fn lost(document: &Document, lost: &mut Lost) {
    lost.if_any("tetrahedra", document.tets.len());
    lost.seeds(document);
    lost.labels(document);
}

#[cfg(test)]
mod tests;
