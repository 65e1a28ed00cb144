//! Reading: one entry for all formats, from files or from bytes.

use std::fs;
use std::path::Path;

use crate::document::Document;
use crate::error::{ReadError, at};
use crate::format::Format;
use crate::lists::contours::Runs;
use crate::triangle::poly::Facets;
use crate::{
    json, jts_xml, lar, lists, npy, obj, off, ply, stl, svg, text, triangle, wkt, wkt_table, xyz,
    xz,
};

/// Bytes to be read, and what is known about them.
#[derive(Clone, Copy, Debug, Default)]
pub struct Source<'a> {
    /// Name for messages and for detecting the format; may be a path.
    pub name: &'a str,
    /// The content, `.xz` or not.
    pub bytes: &'a [u8],
    /// The format, if it is known.
    pub format: Option<Format>,
    /// The `.node` file a `.poly`, `.ele` or `.edge` file takes its points from.
    pub nodes: Option<&'a [u8]>,
}

/// Reads a file that holds exactly one document.
///
/// # Errors
/// As [`read_all`], and [`ReadError::NotOneDocument`].
pub fn read(path: &Path) -> Result<Document, ReadError> {
    one(read_all(path)?, &path.to_string_lossy())
}

/// Reads a file: one document per case of a collection, one document otherwise.
///
/// The documents of a collection are named `file#case`.
///
/// # Errors
/// If the file cannot be read, its format is not known, or anything in it is not as the format wants.
pub fn read_all(path: &Path) -> Result<Vec<Document>, ReadError> {
    read_path(path, None)
}

/// [`read_all`] with the format said, whatever the name.
///
/// # Errors
/// As [`read_all`].
pub fn read_path(path: &Path, format: Option<Format>) -> Result<Vec<Document>, ReadError> {
    let name = path.to_string_lossy();
    let io = |source| ReadError::Io { at: at(0), source }.in_file(&name);
    let bytes = fs::read(path).map_err(io)?;
    let wants_nodes = format.or_else(|| Format::from_path(&name)).is_some_and(Format::wants_nodes);
    let beside = match path.extension() {
        Some(ending) if ending.eq_ignore_ascii_case("xz") => {
            path.with_extension("").with_extension("node")
        }
        _ => path.with_extension("node"),
    };
    let nodes =
        if wants_nodes && beside.is_file() { Some(fs::read(&beside).map_err(io)?) } else { None };
    read_bytes(&Source { name: &name, bytes: &bytes, format, nodes: nodes.as_deref() })
}

/// Reads bytes; for one document take [`one`] of the outcome.
///
/// # Errors
/// As [`read_all`], the file system aside.
pub fn read_bytes(source: &Source<'_>) -> Result<Vec<Document>, ReadError> {
    let documents = decompressed(source).map_err(|error| error.in_file(source.name))?;
    Ok(named(documents, source.name))
}

/// The one document of a reading.
///
/// # Errors
/// [`ReadError::NotOneDocument`].
pub fn one(mut documents: Vec<Document>, name: &str) -> Result<Document, ReadError> {
    match (documents.pop(), documents.len()) {
        (Some(document), 0) => Ok(document),
        (last, rest) => {
            let count = rest + usize::from(last.is_some());
            Err(ReadError::NotOneDocument { at: at(0), count }.in_file(name))
        }
    }
}

fn decompressed(source: &Source<'_>) -> Result<Vec<Document>, ReadError> {
    let plain;
    let bytes = if xz::looks_like(source.bytes) {
        plain = xz::decompress(source.bytes)?;
        &plain
    } else {
        source.bytes
    };
    let format = source.format.or_else(|| Format::detect(source.name, bytes));
    let format = format.ok_or_else(|| ReadError::UnknownFormat { at: at(0) })?;
    read_format(format, bytes, source.nodes)
}

fn read_format(
    format: Format,
    bytes: &[u8],
    nodes: Option<&[u8]>,
) -> Result<Vec<Document>, ReadError> {
    match format {
        Format::Ply => return Ok(vec![ply::read(bytes)?]),
        Format::Stl => return Ok(vec![stl::read(bytes)?]),
        Format::Npy => return Ok(vec![npy::read(bytes)?]),
        _ => {}
    }
    let text = text::decode(bytes);
    let text = &*text;
    let nodes = nodes.map(text::decode);
    let nodes = nodes.as_deref();
    let document = match format {
        Format::Wkt => return wkt::read(text),
        Format::WktTable => return wkt_table::read(text),
        Format::JtsXml => return jts_xml::read(text),
        Format::Json => return json::read(json::parse(text)?),
        Format::Clipper => return lists::clipper::read(text),
        Format::Manifold => return lists::manifold::read(text),
        Format::Node => triangle::node::read(text),
        Format::Poly => triangle::poly::read(text, nodes, Facets::Compound),
        Format::Smesh => triangle::poly::read(text, nodes, Facets::Simple),
        Format::Ele => triangle::ele::read(text, nodes),
        Format::Edge => triangle::edge::read(text, nodes),
        Format::Csv | Format::Xyz => xyz::read(text),
        Format::Lar => lar::read(&json::parse(text)?),
        Format::Off => off::read(text),
        Format::Obj => obj::read(text),
        Format::GeoJson => crate::geojson::read(json::parse(text)?),
        Format::Svg => svg::read(text),
        Format::Gshhg => lists::gshhg::read(text),
        Format::Cin => lists::cin::read(text),
        Format::VertexEdge => lists::vertex_edge::read(text),
        Format::Detria => lists::detria::read(text),
        Format::Boost => lists::boost::read(text),
        Format::SegmentList => lists::segments::read(text),
        Format::P2t => lists::p2t::read(text),
        Format::RingList => lists::contours::read(text, Runs::Closed),
        Format::PolylineList => lists::contours::read(text, Runs::Open),
        Format::Neigh | Format::Ply | Format::Stl | Format::Npy => {
            Err(ReadError::UnknownFormat { at: at(0) })
        }
    };
    Ok(vec![document?])
}

/// `file#case` where the reader named its cases or there are several, `file` otherwise.
fn named(mut documents: Vec<Document>, name: &str) -> Vec<Document> {
    let several = documents.len() > 1;
    for (i, document) in documents.iter_mut().enumerate() {
        document.name = match (several, document.name.as_str()) {
            (false, "") => name.to_owned(),
            (true, "") => format!("{name}#{}", i + 1),
            (_, case) => format!("{name}#{case}"),
        };
    }
    documents
}
