//! What a reader says when it refuses a file: where, what stood there, and what should have.

use std::fmt;

/// Where in which file. Line 0 means the fault is not tied to a line (binary data, JSON structure).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// Name of the file, as the caller gave it.
    pub file: String,
    /// 1-based line, or 0.
    pub line: usize,
}

/// Why a file could not be read. Nothing of the file is returned with it.
#[derive(Debug)]
#[non_exhaustive]
pub enum ReadError {
    /// The file system refused.
    Io {
        /// Where.
        at: Place,
        /// What it said.
        source: std::io::Error,
    },
    /// Neither the name's ending nor the content tells the format.
    UnknownFormat {
        /// Where.
        at: Place,
    },
    /// The `.xz` wrapping is damaged, or holds more than the reader accepts.
    Compression {
        /// Where.
        at: Place,
        /// What the decoder said.
        found: String,
    },
    /// Something else stood where the format wants something.
    Malformed {
        /// Where.
        at: Place,
        /// What the format wants there.
        expected: String,
        /// What stood there, shortened.
        found: String,
    },
    /// The file ends inside an item.
    Truncated {
        /// Where.
        at: Place,
        /// What was still to come.
        expected: String,
    },
    /// A header announced another number of items than follow.
    CountDiffers {
        /// Where.
        at: Place,
        /// Items of what.
        of: &'static str,
        /// Announced by the header.
        announced: usize,
        /// Found in the file.
        found: usize,
    },
    /// An item's own number is not the next one: a number is missing or repeated.
    NumberingBroken {
        /// Where.
        at: Place,
        /// Items of what.
        of: &'static str,
        /// The number that was due.
        expected: usize,
        /// The number that stood there.
        found: String,
    },
    /// An index names no point of the file.
    IndexOutOfRange {
        /// Where.
        at: Place,
        /// The index as written.
        index: String,
        /// First valid index.
        first: usize,
        /// Number of points.
        count: usize,
    },
    /// The file refers to points of a `.node` file that was not given.
    NodesMissing {
        /// Where.
        at: Place,
    },
    /// More items than 32-bit indices can name.
    TooMany {
        /// Where.
        at: Place,
        /// Items of what.
        of: &'static str,
    },
    /// One document was asked for, the file holds none or several.
    NotOneDocument {
        /// Where.
        at: Place,
        /// How many it holds.
        count: usize,
    },
    /// The points have another dimension than the caller asked for.
    Dimension {
        /// Where.
        at: Place,
        /// Dimension asked for.
        expected: usize,
        /// Dimension of the document.
        found: usize,
    },
}

impl ReadError {
    /// Where the fault is.
    #[must_use]
    pub fn place(&self) -> &Place {
        match self {
            Self::Io { at, .. }
            | Self::UnknownFormat { at }
            | Self::Compression { at, .. }
            | Self::Malformed { at, .. }
            | Self::Truncated { at, .. }
            | Self::CountDiffers { at, .. }
            | Self::NumberingBroken { at, .. }
            | Self::IndexOutOfRange { at, .. }
            | Self::NodesMissing { at }
            | Self::TooMany { at, .. }
            | Self::NotOneDocument { at, .. }
            | Self::Dimension { at, .. } => at,
        }
    }

    fn place_mut(&mut self) -> &mut Place {
        match self {
            Self::Io { at, .. }
            | Self::UnknownFormat { at }
            | Self::Compression { at, .. }
            | Self::Malformed { at, .. }
            | Self::Truncated { at, .. }
            | Self::CountDiffers { at, .. }
            | Self::NumberingBroken { at, .. }
            | Self::IndexOutOfRange { at, .. }
            | Self::NodesMissing { at }
            | Self::TooMany { at, .. }
            | Self::NotOneDocument { at, .. }
            | Self::Dimension { at, .. } => at,
        }
    }

    /// Readers see text, not names: the file is filled in where it is known.
    pub(crate) fn in_file(mut self, file: &str) -> Self {
        let at = self.place_mut();
        if at.file.is_empty() {
            file.clone_into(&mut at.file);
        }
        self
    }

    /// A fault inside an embedded text (WKT inside XML): lines count from where that begins.
    pub(crate) fn after_line(mut self, line: usize) -> Self {
        let at = self.place_mut();
        if at.line > 0 {
            at.line += line.saturating_sub(1);
        }
        self
    }

    pub(crate) fn malformed(line: usize, expected: impl Into<String>, found: &str) -> Self {
        Self::Malformed { at: at(line), expected: expected.into(), found: shorten(found) }
    }

    pub(crate) fn truncated(line: usize, expected: impl Into<String>) -> Self {
        Self::Truncated { at: at(line), expected: expected.into() }
    }
}

pub(crate) fn at(line: usize) -> Place {
    Place { file: String::new(), line }
}

/// At most 60 characters, so that a binary file given by mistake does not fill the screen.
pub(crate) fn shorten(text: &str) -> String {
    let mut short: String = text.chars().take(60).flat_map(char::escape_debug).collect();
    if text.chars().nth(60).is_some() {
        short.push_str("..");
    }
    short
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let file = if self.file.is_empty() { "input" } else { &self.file };
        if self.line == 0 { write!(f, "{file}") } else { write!(f, "{file}:{}", self.line) }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", self.place())?;
        match self {
            Self::Io { source, .. } => write!(f, "cannot be read: {source}"),
            Self::UnknownFormat { .. } => {
                write!(f, "neither name nor content tells the format; name it with --format")
            }
            Self::Compression { found, .. } => write!(f, "damaged xz data: {found}"),
            Self::Malformed { expected, found, .. } => {
                write!(f, "expected {expected}, found `{found}`")
            }
            Self::Truncated { expected, .. } => write!(f, "file ends before {expected}"),
            Self::CountDiffers { of, announced, found, .. } => {
                write!(f, "header announces {announced} {of}, {found} follow")
            }
            Self::NumberingBroken { of, expected, found, .. } => {
                write!(f, "{of} number {expected} is due, found `{found}`")
            }
            Self::IndexOutOfRange { index, first, count, .. } => {
                write!(f, "index {index} names no point: {count} points are numbered from {first}")
            }
            Self::NodesMissing { .. } => {
                write!(f, "the points are in a .node file of the same name; put it beside this one")
            }
            Self::TooMany { of, .. } => write!(f, "more {of} than 32-bit indices can name"),
            Self::NotOneDocument { count, .. } => {
                write!(f, "holds {count} documents where one is needed; read them all instead")
            }
            Self::Dimension { expected, found, .. } => {
                write!(f, "points have {found} coordinates where {expected} are needed")
            }
        }
    }
}

impl std::error::Error for ReadError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Io { source, .. } => Some(source),
            _ => None,
        }
    }
}
