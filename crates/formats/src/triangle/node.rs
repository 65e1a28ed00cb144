//! `.node`: `n dimension attributes markers`, then n lines `number x y [z] [attributes] [marker]`.

use std::io::{self, Write};

use super::{Items, first_number, header_of, marker, numbered, real};
use crate::document::Document;
use crate::error::ReadError;
use crate::text::Line;
use crate::write::{Lost, shortest};

const HEADER: &str = "`points dimension attributes markers`";

pub(crate) fn read(text: &str) -> Result<Document, ReadError> {
    let mut items = Items::new(text);
    let header = items.next(HEADER)?;
    let document = read_points(&header, &mut items)?;
    items.finish()?;
    Ok(document)
}

/// The points of a `.node` file, or of the first part of a `.poly` file.
pub(crate) fn read_points(header: &Line<'_>, items: &mut Items<'_>) -> Result<Document, ReadError> {
    let [points, dimension, attributes, markers] = header_of(header, HEADER, [0, 2, 0, 0])?;
    if !matches!(dimension, 2 | 3) || markers > 1 {
        return Err(ReadError::malformed(
            header.number,
            "dimension 2 or 3, markers 0 or 1",
            header.text,
        ));
    }
    let mut document = Document::new(dimension);
    document.attributes_per_point = attributes;
    let mut first = 0;
    for i in 0..points {
        let line = items.next("the next point")?;
        if i == 0 {
            first = first_number(&line, "point")?;
        }
        let fields: Vec<&str> = numbered(&line, "point", first + i)?.collect();
        let wanted = dimension.saturating_add(attributes).saturating_add(markers);
        if fields.len() != wanted {
            let want = format!("a number and {wanted} fields");
            return Err(ReadError::malformed(line.number, want, line.text));
        }
        let reals = fields[..dimension + attributes]
            .iter()
            .map(|field| real(field, line.number))
            .collect::<Result<Vec<f64>, _>>()?;
        document.push_point(&reals, line.number)?;
        document.attributes.extend_from_slice(&reals[dimension..]);
        for field in &fields[dimension + attributes..] {
            document.point_markers.push(marker(field, line.number)?);
        }
    }
    document.first_index = u32::from(first == 1);
    Ok(document)
}

pub(crate) fn write(document: &Document, out: &mut impl Write) -> io::Result<()> {
    let markers = usize::from(!document.point_markers.is_empty());
    let (n, per) = (document.point_count(), document.attributes_per_point);
    writeln!(out, "{n} {} {per} {markers}", document.dimension)?;
    for (i, point) in document.points.chunks_exact(document.dimension.max(1)).enumerate() {
        write!(out, "{}", i + usize::from(document.first_index == 1))?;
        let attributes = document.attributes.iter().skip(i * per).take(per);
        for &x in point.iter().chain(attributes) {
            write!(out, " {}", shortest(x))?;
        }
        if let Some(marker) = document.point_markers.get(i) {
            write!(out, " {marker}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}

pub(crate) fn lost(document: &Document, lost: &mut Lost) {
    lost.faces_and_segments(document);
    lost.if_any("weights", document.weights.as_ref().map_or(0, Vec::len));
}
