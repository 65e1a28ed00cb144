//! Shorthand for the tests of the formats.

use crate::document::Document;
use crate::error::ReadError;
use crate::format::Format;
use crate::read::{Source, one, read_bytes};
use crate::write::write;

/// The one document of a text in a known format.
pub(crate) fn read_as(format: Format, text: &str) -> Result<Document, ReadError> {
    let source = Source { name: "t", bytes: text.as_bytes(), format: Some(format), nodes: None };
    one(read_bytes(&source)?, "t")
}

/// The one document of a text, its format told by name and content.
pub(crate) fn read_named(name: &str, text: &str) -> Document {
    let source = Source { name, bytes: text.as_bytes(), ..Source::default() };
    one(read_bytes(&source).unwrap(), name).unwrap()
}

/// All documents of a text, as (points, segments).
pub(crate) fn all(name: &str, text: &str) -> Vec<Document> {
    read_bytes(&Source { name, bytes: text.as_bytes(), ..Source::default() }).unwrap()
}

/// The message of a refusal.
pub(crate) fn refusal(format: Format, text: &str) -> String {
    read_as(format, text).unwrap_err().to_string()
}

/// What a document is written as.
pub(crate) fn written(document: &Document, format: Format) -> String {
    let mut out = Vec::new();
    write(document, format, &mut out).unwrap();
    String::from_utf8(out).unwrap()
}
