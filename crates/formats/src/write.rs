//! Writing: one entry for all formats, what each cannot hold, numbers that read back bit for bit, whole files or none.

use std::fmt;
use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use crate::document::Document;
use crate::format::Format;
use crate::xyz::Keeps;
use crate::{geojson, lar, npy, obj, off, triangle, wkt, xyz};

/// Why a document could not be written.
#[derive(Debug)]
#[non_exhaustive]
pub enum WriteError {
    /// The file system refused.
    Io(io::Error),
    /// The format can only be read.
    ReadOnly(Format),
    /// JSON has no word for NaN and infinities.
    NotFinite {
        /// The point.
        point: usize,
    },
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(error) => write!(f, "cannot be written: {error}"),
            Self::ReadOnly(format) => write!(f, "format {format} can only be read; choose another"),
            Self::NotFinite { point } => {
                write!(
                    f,
                    "point {point} is not finite, which this format cannot say; repair it first"
                )
            }
        }
    }
}

impl std::error::Error for WriteError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Io(error) => Some(error),
            _ => None,
        }
    }
}

impl From<io::Error> for WriteError {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

/// Writes a document and returns what the format could not hold, one sentence each.
///
/// # Errors
/// If writing fails, the format is one that is only read, or it is JSON and a coordinate is not finite.
pub fn write(
    document: &Document,
    format: Format,
    out: &mut impl Write,
) -> Result<Vec<String>, WriteError> {
    let mut lost = Lost::default();
    match format {
        Format::Node => {
            triangle::node::lost(document, &mut lost);
            triangle::node::write(document, out)?;
        }
        Format::Poly => {
            triangle::poly::lost(document, &mut lost);
            triangle::poly::write(document, out)?;
        }
        Format::Ele => {
            triangle::ele::lost(document, &mut lost);
            triangle::ele::write(document, out)?;
        }
        Format::Edge => {
            triangle::edge::lost(document, &mut lost);
            triangle::edge::write(document, out)?;
        }
        Format::Neigh => triangle::neigh::write(document, out)?,
        Format::Csv => {
            xyz::lost(document, Keeps::Columns, &mut lost);
            xyz::write_csv(document, out)?;
        }
        Format::Xyz => {
            xyz::lost(document, Keeps::Coordinates, &mut lost);
            xyz::write_xyz(document, out)?;
        }
        Format::Lar => {
            all_finite(document)?;
            lar::lost(document, &mut lost);
            lar::write(document, out)?;
        }
        Format::GeoJson => {
            all_finite(document)?;
            geojson::lost(document, &mut lost);
            geojson::write(document, out)?;
        }
        Format::Wkt => {
            geojson::lost(document, &mut lost);
            wkt::write(document, out)?;
        }
        Format::Off => {
            off::lost(document, &mut lost);
            off::write(document, out)?;
        }
        Format::Obj => {
            obj::lost(document, &mut lost);
            obj::write(document, out)?;
        }
        Format::Npy => {
            npy::lost(document, &mut lost);
            npy::write(document, out)?;
        }
        _ => return Err(WriteError::ReadOnly(format)),
    }
    Ok(lost.sentences)
}

fn all_finite(document: &Document) -> Result<(), WriteError> {
    match document.points.iter().position(|x| !x.is_finite()) {
        Some(i) => Err(WriteError::NotFinite { point: i / document.dimension.max(1) }),
        None => Ok(()),
    }
}

/// Writes a file whole or not at all: into a new file beside it, which is renamed when everything is on disk.
///
/// # Errors
/// Whatever `content` or the file system returns; the path then holds what it held before.
pub fn write_atomically<T, E: From<io::Error>>(
    path: &Path,
    content: impl FnOnce(&mut BufWriter<fs::File>) -> Result<T, E>,
) -> Result<T, E> {
    let beside = unfinished(path).ok_or_else(|| io::Error::from(io::ErrorKind::InvalidInput))?;
    // An existing file of that name is somebody else's: it is neither overwritten nor removed.
    let file = fs::OpenOptions::new().write(true).create_new(true).open(&beside)?;
    let outcome = fill(file, content).and_then(|value| {
        fs::rename(&beside, path)?;
        Ok(value)
    });
    if outcome.is_err() {
        // Nothing to do if this fails too: the error that counts is the first one.
        let _ = fs::remove_file(&beside);
    }
    outcome
}

/// The new file beside `path` that [`write_atomically`] writes in this process; whoever ends the process in between may remove it.
/// None if the path names no file.
#[must_use]
pub fn unfinished(path: &Path) -> Option<PathBuf> {
    let mut beside = std::ffi::OsString::from(".");
    beside.push(path.file_name()?);
    beside.push(format!(".{}.part", std::process::id()));
    Some(path.with_file_name(beside))
}

fn fill<T, E: From<io::Error>>(
    file: fs::File,
    content: impl FnOnce(&mut BufWriter<fs::File>) -> Result<T, E>,
) -> Result<T, E> {
    let mut out = BufWriter::new(file);
    let value = content(&mut out)?;
    out.into_inner().map_err(io::IntoInnerError::into_error)?.sync_all()?;
    Ok(value)
}

/// The fewest digits that read back as the same double: `1`, `0.1`, `1e300`, `-0`.
pub(crate) fn shortest(x: f64) -> String {
    let mut text = format!("{x:?}");
    if let Some(whole) = text.strip_suffix(".0") {
        text.truncate(whole.len());
    }
    text
}

/// What a format cannot hold of a document.
#[derive(Debug, Default)]
pub(crate) struct Lost {
    sentences: Vec<String>,
}

impl Lost {
    pub(crate) fn if_any(&mut self, of: &str, count: usize) {
        if count > 0 {
            self.sentences.push(format!("{count} {of} not written"));
        }
    }

    pub(crate) fn faces_and_segments(&mut self, document: &Document) {
        self.if_any("segments", document.segments.len());
        self.if_any("triangles", document.triangles.len());
        self.if_any("polygons", document.polygons.len());
        self.if_any("tetrahedra", document.tets.len());
        self.seeds(document);
    }

    pub(crate) fn seeds(&mut self, document: &Document) {
        self.if_any("holes", document.holes.len() / document.dimension.max(1));
        self.if_any("regions", document.regions.len());
    }

    pub(crate) fn labels(&mut self, document: &Document) {
        self.if_any("point markers", document.point_markers.len());
        self.if_any("segment markers", document.segment_markers.len());
        self.if_any("weights", document.weights.as_ref().map_or(0, Vec::len));
        self.if_any("attributes", document.attributes.len());
        self.if_any("cell attributes", document.cell_attributes.len());
    }
}

#[cfg(test)]
mod tests;
