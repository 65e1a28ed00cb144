//! Readers and writers: files of all kinds become one neutral [`Document`], and back.
//!
//! ```
//! use delone_formats::{Format, Source, one, read_bytes, write};
//!
//! let bytes = b"3 2\n0 0\n1 0\n0 1\n0 1\n1 2\n";
//! let document = one(read_bytes(&Source { name: "corner.txt", bytes, ..Source::default() })?, "corner.txt")?;
//! assert_eq!(document.points_2d()?, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
//! assert_eq!(document.segments, [[0, 1], [1, 2]]);
//!
//! let mut out = Vec::new();
//! let lost = write(&document, Format::Poly, &mut out)?;
//! assert!(lost.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which one do I want
//!
//! | for | take |
//! |---|---|
//! | a file with one input | [`read`] |
//! | a file that may hold many (test suites, WKT, glyphs) | [`read_all`] |
//! | bytes, or a format the name does not tell | [`read_bytes`], [`read_path`] |
//! | a stream | [`write()`] |
//! | a file that is never left half written | [`write_atomically`] around [`write()`] |
//!
//! # The contract
//!
//! **In.** Any bytes. **Out.** What the file says, unjudged: points that repeat, NaN, crossing segments all come through,
//! for the caller's door to refuse. **Fails.** With file, line, what stood there and what should have; never by panic,
//! never after allocating what a header merely announces. **Deterministic.** Yes.
//!
//! Coordinates are the nearest doubles to what is written (`-0` stays). Formats that list coordinates (WKT, GeoJSON, rings,
//! segment soups) have equal ones merged to one vertex per document, zero-length edges dropped; formats that index points
//! keep them as listed. What was tolerated, rounded or dropped stands in [`Document::notes`].
//!
//! **Not here.** Validation and duplicates across a document (`sites`), pictures (`draw`).
//!
//! # Map
//!
//! `document`, `error`, `format` (detection), `read`, `write`; one module per format; `lists` holds the small text formats
//! of test suites, `json` its dialects, `triangle` the files of Triangle and TetGen; `text`, `shapes`, `rational`, `curves`,
//! `xml`, `xz` are shared below them.

mod curves;
mod document;
mod error;
mod format;
mod geojson;
mod json;
mod jts_xml;
mod lar;
mod lists;
mod npy;
mod obj;
mod off;
mod ply;
mod rational;
mod read;
mod shapes;
mod stl;
mod svg;
#[cfg(test)]
mod testing;
mod text;
mod triangle;
mod wkb;
mod wkt;
mod wkt_table;
mod write;
mod xml;
mod xyz;
mod xz;

pub use document::{Document, Region};
pub use error::{Place, ReadError};
pub use format::Format;
pub use read::{Source, one, read, read_all, read_bytes, read_path};
pub use write::{WriteError, unfinished, write, write_atomically};
