//! `.ele`: `n corners attributes`, then n lines `number c1 .. [attributes]`; the points are in the `.node` file beside.
//!
//! Elements of second order (6 corners in the plane, 10 in space) give their first 3 or 4, noted.

use std::io::{self, Write};

use super::{Items, first_number, nodes_beside, numbered, real};
use crate::document::Document;
use crate::error::ReadError;
use crate::text::index;
use crate::write::{Lost, shortest};

pub(crate) fn read(text: &str, nodes: Option<&str>) -> Result<Document, ReadError> {
    let mut document = nodes_beside(nodes)?;
    let mut items = Items::new(text);
    let (header, [cells, corners, attributes]) =
        items.header("`elements corners attributes`", [0, document.dimension + 1, 0])?;
    let linear = document.dimension + 1;
    if !matches!((linear, corners), (3, 3 | 6) | (4, 4 | 10)) {
        let want =
            format!("{linear} corners, as the points have {} coordinates", document.dimension);
        return Err(ReadError::malformed(header.number, want, header.text));
    }
    document.attributes_per_cell = attributes;
    let (points, first) = (document.point_count(), usize::from(document.first_index == 1));
    let mut due = 0;
    for i in 0..cells {
        let line = items.next("the next element")?;
        if i == 0 {
            due = first_number(&line, "element")?;
        }
        let fields: Vec<&str> = numbered(&line, "element", due + i)?.collect();
        if fields.len() != corners.saturating_add(attributes) {
            let want = format!("a number, {corners} corners and {attributes} attributes");
            return Err(ReadError::malformed(line.number, want, line.text));
        }
        let cell = fields[..corners]
            .iter()
            .map(|field| index(field, line.number, first, points))
            .collect::<Result<Vec<u32>, _>>()?;
        match cell[..linear] {
            [a, b, c] => document.triangles.push([a, b, c]),
            [a, b, c, d] => document.tets.push([a, b, c, d]),
            _ => {}
        }
        for field in &fields[corners..] {
            document.cell_attributes.push(real(field, line.number)?);
        }
    }
    items.finish()?;
    if corners > linear {
        document.note(format!("elements of {corners} corners: only the first {linear} kept"));
    }
    Ok(document)
}

/// Cells of a document: triangles in the plane, tets in space.
pub(super) fn cells(document: &Document) -> Vec<&[u32]> {
    if document.dimension == 2 {
        document.triangles.iter().map(|t| &t[..]).collect()
    } else {
        document.tets.iter().map(|t| &t[..]).collect()
    }
}

pub(crate) fn write(document: &Document, out: &mut impl Write) -> io::Result<()> {
    let cells = cells(document);
    let per = document.attributes_per_cell;
    let first = document.first_index;
    writeln!(out, "{} {} {per}", cells.len(), document.dimension + 1)?;
    for (i, cell) in cells.iter().enumerate() {
        write!(out, "{}", i + usize::from(first == 1))?;
        for &v in *cell {
            write!(out, " {}", u64::from(v) + u64::from(first))?;
        }
        for &x in document.cell_attributes.iter().skip(i * per).take(per) {
            write!(out, " {}", shortest(x))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

pub(crate) fn lost(document: &Document, lost: &mut Lost) {
    lost.if_any("segments (write a .poly or .edge beside)", document.segments.len());
    lost.if_any("polygons", document.polygons.len());
    if document.dimension == 3 {
        lost.if_any("triangles", document.triangles.len());
    }
}
