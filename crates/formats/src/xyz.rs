//! Point lists: `.xyz .pts .pwn .xy .csv` and plain `.txt`, one point a line.
//!
//! **In.** Two columns are points in the plane, three and more are points in space; what comes after the third column
//! (normals, colours, weights) is kept as attributes and noted. A first line with one whole number is a count, a first line of four
//! numbers before lines of two is a bounding box; a CSV may have a header line that names its columns (`x`, `y`, `z`,
//! `w` or `weight`; any other column becomes an attribute). `#` starts a comment. Contour files put `{`, `}`,
//! `v ..` or `//v ..` lines between their points: those lines are left out and counted.
//!
//! A count that differs is noted and not refused: nothing refers to these points by number.

use std::io::{self, Write};

use crate::document::Document;
use crate::error::ReadError;
use crate::text::{Line, is_count, lines, number, parse_number};
use crate::write::{Lost, shortest};

/// Reads a list; `header` columns only where a first line of names is found.
pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let mut rows = lines(text, Some('#')).peekable();
    let mut notes = Vec::new();
    let mut announced = None;
    if let Some(first) = rows.peek().copied() {
        let mut fields = first.fields();
        match (fields.next(), fields.next()) {
            (Some(only), None) if is_count(only) => {
                announced = only.parse::<usize>().ok();
                rows.next();
            }
            (Some(name), _) if parse_number(name).is_none() && is_header(&first) => {
                rows.next();
                return read_named(&first, rows);
            }
            _ => {
                let next_width = rows.clone().nth(1).map(|line| line.fields().count());
                if first.fields().count() == 4 && next_width == Some(2) {
                    notes.push("first line is a bounding box: dropped".to_owned());
                    rows.next();
                }
            }
        }
    }
    let mut document = read_columns(rows)?;
    let count = document.point_count();
    if let Some(announced) = announced.filter(|&announced| announced != count) {
        notes.push(format!("header announces {announced} points, {count} follow"));
    }
    document.notes.splice(0..0, notes);
    Ok(document)
}

fn is_header(line: &Line<'_>) -> bool {
    line.fields().any(|name| name.eq_ignore_ascii_case("x"))
}

fn read_columns<'a>(rows: impl Iterator<Item = Line<'a>>) -> Result<Document, ReadError> {
    let mut document = Document::new(2);
    let mut width = None;
    let mut skipped = 0_usize;
    for line in rows {
        let leader = line.fields().next().unwrap_or("");
        let lone = skipped > 0 && line.fields().nth(1).is_none();
        if leader.chars().all(|c| "{}/v".contains(c)) || lone {
            skipped += 1;
            continue;
        }
        let row = line
            .fields()
            .map(|field| number(field, line.number, "a coordinate"))
            .collect::<Result<Vec<f64>, _>>()?;
        let expected = *width.get_or_insert(row.len());
        if row.len() != expected || expected < 2 {
            let want = if expected < 2 {
                "2 or 3 coordinates".into()
            } else {
                format!("{expected} numbers")
            };
            return Err(ReadError::malformed(line.number, want, line.text));
        }
        document.dimension = expected.min(3);
        document.push_point(&row, line.number)?;
        document.attributes_per_point = expected.saturating_sub(3);
        document.attributes.extend(row.iter().skip(3));
    }
    if width > Some(3) {
        let width = width.unwrap_or(0);
        document.note(format!("{width} columns: those after the third kept as attributes"));
    }
    if skipped > 0 {
        document.note(format!("{skipped} lines that hold no point left out"));
    }
    Ok(document)
}

/// A table whose first line names the columns.
fn read_named<'a>(
    header: &Line<'a>,
    rows: impl Iterator<Item = Line<'a>>,
) -> Result<Document, ReadError> {
    let names: Vec<String> = header.fields().map(str::to_ascii_lowercase).collect();
    let column = |name: &str| names.iter().position(|n| n == name);
    let (x, y) = match (column("x"), column("y")) {
        (Some(x), Some(y)) => (x, y),
        _ => return Err(ReadError::malformed(header.number, "columns x and y", header.text)),
    };
    let mut axes = vec![x, y];
    axes.extend(column("z"));
    let weight = column("w").or_else(|| column("weight"));
    let others: Vec<usize> =
        (0..names.len()).filter(|i| !axes.contains(i) && Some(*i) != weight).collect();
    let mut document = Document::new(axes.len());
    document.attributes_per_point = others.len();
    let mut weights = Vec::new();
    for line in rows {
        let row = line
            .fields()
            .map(|field| number(field, line.number, "a number"))
            .collect::<Result<Vec<f64>, _>>()?;
        if row.len() != names.len() {
            let want = format!("{} numbers", names.len());
            return Err(ReadError::malformed(line.number, want, line.text));
        }
        let point: Vec<f64> = axes.iter().map(|&i| row[i]).collect();
        document.push_point(&point, line.number)?;
        document.attributes.extend(others.iter().map(|&i| row[i]));
        weights.extend(weight.map(|i| row[i]));
    }
    document.weights = weight.map(|_| weights);
    Ok(document)
}

/// Writes coordinates between blanks, one point a line.
pub(crate) fn write_xyz(document: &Document, out: &mut impl Write) -> io::Result<()> {
    for point in document.points.chunks_exact(document.dimension.max(1)) {
        let row: Vec<String> = point.iter().map(|&x| shortest(x)).collect();
        writeln!(out, "{}", row.join(" "))?;
    }
    Ok(())
}

/// Writes a table with a header: coordinates, weight, attributes `a0, a1, ..`.
pub(crate) fn write_csv(document: &Document, out: &mut impl Write) -> io::Result<()> {
    let mut names: Vec<String> =
        ["x", "y", "z"][..document.dimension.min(3)].iter().map(|&n| n.to_owned()).collect();
    names.extend(document.weights.iter().map(|_| "w".to_owned()));
    names.extend((0..document.attributes_per_point).map(|i| format!("a{i}")));
    writeln!(out, "{}", names.join(","))?;
    let per = document.attributes_per_point;
    for (i, point) in document.points.chunks_exact(document.dimension.max(1)).enumerate() {
        let weight = document.weights.iter().filter_map(|weights| weights.get(i));
        let attributes = document.attributes.iter().skip(i * per).take(per);
        let row: Vec<String> =
            point.iter().chain(weight).chain(attributes).map(|&x| shortest(x)).collect();
        writeln!(out, "{}", row.join(","))?;
    }
    Ok(())
}

/// What a point list cannot hold.
pub(crate) fn lost(document: &Document, keeps_weights_and_attributes: Keeps, lost: &mut Lost) {
    lost.faces_and_segments(document);
    lost.if_any("point markers", document.point_markers.len());
    if keeps_weights_and_attributes == Keeps::Coordinates {
        lost.if_any("weights", document.weights.as_ref().map_or(0, Vec::len));
        lost.if_any("attributes", document.attributes.len());
    }
}

/// What columns a point list has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Keeps {
    Coordinates,
    Columns,
}

#[cfg(test)]
mod tests;
