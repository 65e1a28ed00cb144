//! LAR as JSON: `{"V": [[x,y],..], "EV": [[i,j],..], "FV": [[i,j,k],..], "CV": [[i,j,k,l],..]}`, indices from 0.
//!
//! `EV` are segments, `FV` faces, `CV` tetrahedra; all but `V` may be missing. Vertices are kept as listed.

use std::io::{self, Write};

use serde_json::Value;

use crate::document::Document;
use crate::error::{ReadError, at};
use crate::json::{index_list, position, unexpected};
use crate::write::{Lost, shortest};

/// Whether a JSON object is LAR.
pub(crate) fn looks_like(value: &Value) -> bool {
    value.get("V").is_some_and(Value::is_array)
}

pub(crate) fn read(value: &Value) -> Result<Document, ReadError> {
    let Some(vertices) = value.get("V").and_then(Value::as_array) else {
        return Err(unexpected("an array V of vertices", value));
    };
    let dimension = vertices.first().and_then(Value::as_array).map_or(2, Vec::len);
    if !matches!(dimension, 2 | 3) {
        return Err(ReadError::malformed(
            0,
            "vertices of 2 or 3 coordinates",
            &dimension.to_string(),
        ));
    }
    let mut document = Document::new(dimension);
    for vertex in vertices {
        let point = position(vertex)?;
        if point.len() != dimension {
            return Err(unexpected(&format!("a vertex of {dimension} coordinates"), vertex));
        }
        document.push_point(&point, 0)?;
    }
    let points = document.point_count();
    for edge in rows(value, "EV")? {
        match index_list(edge, points)?[..] {
            [a, b] => document.segments.push([a, b]),
            _ => return Err(unexpected("an edge of two vertices in EV", edge)),
        }
    }
    for face in rows(value, "FV")? {
        let corners = index_list(face, points)?;
        if corners.is_empty() {
            return Err(unexpected("a face of some vertices in FV", face));
        }
        document.push_face(corners);
    }
    for cell in rows(value, "CV")? {
        match index_list(cell, points)?[..] {
            [a, b, c, d] => document.tets.push([a, b, c, d]),
            _ => return Err(unexpected("a cell of four vertices in CV", cell)),
        }
    }
    Ok(document)
}

fn rows<'a>(value: &'a Value, name: &str) -> Result<&'a [Value], ReadError> {
    match value.get(name) {
        None | Some(Value::Null) => Ok(&[]),
        Some(Value::Array(rows)) => Ok(rows),
        Some(other) => Err(unexpected(&format!("an array {name}"), other)),
    }
}

pub(crate) fn write(document: &Document, out: &mut impl Write) -> io::Result<()> {
    write!(out, "{{\"V\": [")?;
    for (i, point) in document.points.chunks_exact(document.dimension.max(1)).enumerate() {
        let row: Vec<String> = point.iter().map(|&x| shortest(x)).collect();
        write!(out, "{}[{}]", separator(i), row.join(","))?;
    }
    write!(out, "]")?;
    table("EV", document.segments.iter().map(|s| &s[..]), out)?;
    table("FV", crate::geojson::faces(document), out)?;
    table("CV", document.tets.iter().map(|t| &t[..]), out)?;
    writeln!(out, "}}")
}

fn table<'a>(
    name: &str,
    rows: impl Iterator<Item = &'a [u32]>,
    out: &mut impl Write,
) -> io::Result<()> {
    let mut rows = rows.peekable();
    if rows.peek().is_none() {
        return Ok(());
    }
    write!(out, ",\n\"{name}\": [")?;
    for (i, row) in rows.enumerate() {
        let row: Vec<String> = row.iter().map(u32::to_string).collect();
        write!(out, "{}[{}]", separator(i), row.join(","))?;
    }
    write!(out, "]")
}

fn separator(i: usize) -> &'static str {
    if i == 0 { "" } else { "," }
}

pub(crate) fn lost(document: &Document, lost: &mut Lost) {
    lost.seeds(document);
    lost.labels(document);
}

/// A point's number that names none.
pub(crate) fn out_of_range(index: &Value, count: usize) -> ReadError {
    ReadError::IndexOutOfRange { at: at(0), index: index.to_string(), first: 0, count }
}

#[cfg(test)]
mod tests;
