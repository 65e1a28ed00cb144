//! PLY, read only: ascii and binary of both byte orders.
//!
//! Kept are `x y z` of `vertex`, the list `vertex_indices` (or `vertex_index`) of `face` and `vertex1 vertex2` of
//! `edge`; every other property and element is stepped over. A float property is widened to the double it equals.
//! Own code, because the header's counts must not size any allocation.

mod body;

use body::{Binary, Body, Value};

use crate::document::Document;
use crate::error::{ReadError, at};
use crate::text::count;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Scalar(Scalar),
    List { length: Scalar, item: Scalar },
}

#[derive(Debug)]
struct Element {
    name: String,
    count: usize,
    properties: Vec<(String, Kind)>,
}

#[derive(Debug)]
struct Header {
    format: String,
    elements: Vec<Element>,
    /// Lines of the header, and where the body begins.
    lines: usize,
    body: usize,
}

pub(crate) fn read(bytes: &[u8]) -> Result<Document, ReadError> {
    let header = header(bytes)?;
    let rest = bytes.get(header.body..).unwrap_or(&[]);
    let mut document = Document::new(3);
    match header.format.as_str() {
        "ascii" => {
            let text = crate::text::decode(rest);
            let mut body = body::Ascii::new(&text, header.lines);
            elements(&header, &mut body, &mut document)?;
        }
        "binary_little_endian" => {
            elements(&header, &mut Binary::little(rest), &mut document)?;
        }
        "binary_big_endian" => {
            elements(&header, &mut Binary::big(rest), &mut document)?;
        }
        other => {
            let want = "ascii, binary_little_endian or binary_big_endian";
            return Err(ReadError::malformed(2, want, other));
        }
    }
    Ok(document)
}

fn header(bytes: &[u8]) -> Result<Header, ReadError> {
    let mut header = Header { format: String::new(), elements: Vec::new(), lines: 0, body: 0 };
    loop {
        let rest = bytes.get(header.body..).unwrap_or(&[]);
        let Some(end) = rest.iter().position(|&b| b == b'\n') else {
            return Err(ReadError::truncated(header.lines + 1, "end_header"));
        };
        header.body += end + 1;
        header.lines += 1;
        let text = crate::text::decode(&rest[..end]);
        let fields: Vec<&str> = text.split_whitespace().collect();
        let line = header.lines;
        match (line, &fields[..]) {
            (1, ["ply"]) => {}
            (1, _) => return Err(ReadError::malformed(1, "ply", &text)),
            (_, ["end_header"]) => return Ok(header),
            (_, ["format", format, _version]) => (*format).clone_into(&mut header.format),
            (_, [] | ["comment" | "obj_info", ..]) => {}
            (_, ["element", name, number]) => header.elements.push(Element {
                name: (*name).to_owned(),
                count: count(number, line, "a number of elements")?,
                properties: Vec::new(),
            }),
            (_, ["property", kind @ .., name]) => {
                let kind = kind_of(kind, line)?;
                match header.elements.last_mut() {
                    Some(element) => element.properties.push(((*name).to_owned(), kind)),
                    None => {
                        return Err(ReadError::malformed(
                            line,
                            "an element before its properties",
                            &text,
                        ));
                    }
                }
            }
            _ => return Err(ReadError::malformed(line, "a PLY header line", &text)),
        }
    }
}

fn kind_of(words: &[&str], line: usize) -> Result<Kind, ReadError> {
    let scalar = |word: &str| {
        Ok(match word {
            "char" | "int8" => Scalar::I8,
            "uchar" | "uint8" => Scalar::U8,
            "short" | "int16" => Scalar::I16,
            "ushort" | "uint16" => Scalar::U16,
            "int" | "int32" => Scalar::I32,
            "uint" | "uint32" => Scalar::U32,
            "float" | "float32" => Scalar::F32,
            "double" | "float64" => Scalar::F64,
            _ => return Err(ReadError::malformed(line, "a PLY type", word)),
        })
    };
    match words {
        ["list", length, item] => Ok(Kind::List { length: scalar(length)?, item: scalar(item)? }),
        [word] => Ok(Kind::Scalar(scalar(word)?)),
        _ => Err(ReadError::malformed(line, "a PLY property", &words.join(" "))),
    }
}

fn elements(
    header: &Header,
    body: &mut impl Body,
    document: &mut Document,
) -> Result<(), ReadError> {
    for element in &header.elements {
        // An element without properties takes no bytes, whatever its count.
        if element.properties.is_empty() {
            continue;
        }
        for _ in 0..element.count {
            match element.name.as_str() {
                "vertex" => vertex(element, body, document)?,
                "face" => face(element, body, document)?,
                "edge" => edge(element, body, document)?,
                _ => {
                    for (_, kind) in &element.properties {
                        property(*kind, body)?;
                    }
                }
            }
        }
    }
    body.finish()
}

fn property(kind: Kind, body: &mut impl Body) -> Result<Vec<Value>, ReadError> {
    match kind {
        Kind::Scalar(scalar) => Ok(vec![body.value(scalar)?]),
        Kind::List { length, item } => {
            let length = body.value(length)?;
            let Some(length) = length.whole() else {
                return Err(ReadError::malformed(
                    body.line(),
                    "a list length",
                    &length.to_string(),
                ));
            };
            let mut list = Vec::new();
            for _ in 0..length {
                list.push(body.value(item)?);
            }
            Ok(list)
        }
    }
}

fn vertex(
    element: &Element,
    body: &mut impl Body,
    document: &mut Document,
) -> Result<(), ReadError> {
    let mut point = [None; 3];
    for (name, kind) in &element.properties {
        let values = property(*kind, body)?;
        let axis = ["x", "y", "z"].iter().position(|axis| axis == name);
        if let (Some(axis), [value]) = (axis, &values[..]) {
            point[axis] = Some(value.real());
        }
    }
    let [Some(x), Some(y), Some(z)] = point else {
        return Err(ReadError::malformed(0, "vertex properties x, y, z", &element.name));
    };
    document.push_point(&[x, y, z], body.line())?;
    Ok(())
}

fn face(element: &Element, body: &mut impl Body, document: &mut Document) -> Result<(), ReadError> {
    for (name, kind) in &element.properties {
        let values = property(*kind, body)?;
        if matches!(name.as_str(), "vertex_indices" | "vertex_index") {
            let corners = values
                .iter()
                .map(|value| point_index(*value, body.line(), document))
                .collect::<Result<Vec<u32>, _>>()?;
            document.push_face(corners);
        }
    }
    Ok(())
}

fn edge(element: &Element, body: &mut impl Body, document: &mut Document) -> Result<(), ReadError> {
    let mut ends = [None; 2];
    for (name, kind) in &element.properties {
        let values = property(*kind, body)?;
        let end = ["vertex1", "vertex2"].iter().position(|end| end == name);
        if let (Some(end), [value]) = (end, &values[..]) {
            ends[end] = Some(point_index(*value, body.line(), document)?);
        }
    }
    if let [Some(a), Some(b)] = ends {
        document.segments.push([a, b]);
    }
    Ok(())
}

fn point_index(value: Value, line: usize, document: &Document) -> Result<u32, ReadError> {
    let count = document.point_count();
    value.whole().filter(|&i| i < count).and_then(|i| u32::try_from(i).ok()).ok_or_else(|| {
        ReadError::IndexOutOfRange { at: at(line), index: value.to_string(), first: 0, count }
    })
}

#[cfg(test)]
mod tests;
