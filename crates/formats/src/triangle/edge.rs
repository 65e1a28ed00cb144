//! `.edge`: `n markers`, then n lines `number a b [marker]`; the points are in the `.node` file beside.

use std::io::{self, Write};

use super::{Items, first_number, marker, nodes_beside, numbered};
use crate::document::Document;
use crate::error::ReadError;
use crate::text::index;
use crate::write::Lost;

pub(crate) fn read(text: &str, nodes: Option<&str>) -> Result<Document, ReadError> {
    let mut document = nodes_beside(nodes)?;
    let mut items = Items::new(text);
    read_list(&mut items, &mut document, "edge")?;
    items.finish()?;
    Ok(document)
}

/// The list itself, which `.poly` files have too: segments there, edges here, alike but for the `noun`.
pub(super) fn read_list(
    items: &mut Items<'_>,
    document: &mut Document,
    noun: &'static str,
) -> Result<(), ReadError> {
    let (header, [edges, markers]) = items.header(&format!("`{noun}s markers`"), [0, 0])?;
    if markers > 1 {
        return Err(ReadError::malformed(header.number, "markers 0 or 1", header.text));
    }
    let (points, first) = (document.point_count(), usize::from(document.first_index == 1));
    let mut due = 0;
    for i in 0..edges {
        let line = items.next(&format!("the next {noun}"))?;
        if i == 0 {
            due = first_number(&line, noun)?;
        }
        let fields: Vec<&str> = numbered(&line, noun, due + i)?.collect();
        if fields.len() != 2 + markers {
            let want = format!("a number, two points and {markers} markers");
            return Err(ReadError::malformed(line.number, want, line.text));
        }
        let a = index(fields[0], line.number, first, points)?;
        let b = index(fields[1], line.number, first, points)?;
        document.segments.push([a, b]);
        for field in &fields[2..] {
            document.segment_markers.push(marker(field, line.number)?);
        }
    }
    Ok(())
}

pub(crate) fn write(document: &Document, out: &mut impl Write) -> io::Result<()> {
    let first = u64::from(document.first_index);
    let shift = usize::from(document.first_index == 1);
    writeln!(
        out,
        "{} {}",
        document.segments.len(),
        u8::from(!document.segment_markers.is_empty())
    )?;
    for (i, [a, b]) in document.segments.iter().enumerate() {
        write!(out, "{} {} {}", i + shift, u64::from(*a) + first, u64::from(*b) + first)?;
        if let Some(marker) = document.segment_markers.get(i) {
            write!(out, " {marker}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}

pub(crate) fn lost(document: &Document, lost: &mut Lost) {
    lost.if_any("triangles (write an .ele beside)", document.triangles.len());
    lost.if_any("tetrahedra (write an .ele beside)", document.tets.len());
    lost.if_any("polygons", document.polygons.len());
}
