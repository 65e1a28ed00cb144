//! The law of readers: whatever bytes they are given, they say what is there or refuse, and what they say is sound.

mod samples;

use delone::formats::{Document, Format, Source, one, read_bytes, write};

use super::plane::document;
use crate::choices::Choices;
use crate::fuzz::file::File;
use crate::generate;
use samples::{SAMPLES, binary};

/// The name of the law, and the law.
pub(in crate::fuzz) const OF_READERS: (&str, fn(&File) -> usize) = ("readers", readers);

fn readers(file: &File) -> usize {
    let told = [Some(file.format), None];
    for format in told {
        let source = Source { name: "file", bytes: &file.bytes, format, nodes: None };
        match read_bytes(&source) {
            Ok(documents) => {
                for document in &documents {
                    accept(document, file.bytes.len());
                }
                if let [document] = &documents[..] {
                    again(document);
                }
            }
            Err(error) => assert!(!error.to_string().is_empty(), "a refusal says why"),
        }
    }
    told.len()
}

/// The invariants of documents.
fn accept(document: &Document, size: usize) {
    assert!([2, 3].contains(&document.dimension), "a dimension of {}", document.dimension);
    assert_eq!(document.points.len() % document.dimension, 0, "whole points");
    let count = document.point_count();
    // Curves are flattened, into eight pieces each at most.
    assert!(count <= 64 * (size + 1), "{count} points from {size} bytes");
    let ids = document.segments.as_flattened().iter().chain(document.triangles.as_flattened());
    let ids = ids.chain(document.tets.as_flattened()).chain(document.polygons.iter().flatten());
    assert!(ids.max().is_none_or(|&v| (v as usize) < count), "an index names no point");
    for (name, length, full) in [
        ("point markers", document.point_markers.len(), count),
        ("segment markers", document.segment_markers.len(), document.segments.len()),
        ("weights", document.weights.as_ref().map_or(0, Vec::len), count),
        ("attributes", document.attributes.len(), count * document.attributes_per_point),
    ] {
        assert!(length == 0 || length == full, "{length} {name}, not {full}");
    }
}

/// What is written in the project's own format is read again.
fn again(document: &Document) {
    let mut bytes = Vec::new();
    if !document.points.iter().all(|x| x.is_finite()) {
        return;
    }
    write(document, Format::Lar, &mut bytes).expect("what is finite can be written");
    let source = Source { name: "", bytes: &bytes, format: Some(Format::Lar), nodes: None };
    let again = read_bytes(&source).and_then(|documents| one(documents, "")).expect("it is LAR");
    assert_eq!(again.points, document.points, "coordinates");
    assert_eq!(again.segments, document.segments, "segments");
}

/// What readers trip over.
const TOKENS: [&[u8]; 26] = [
    b"nan",
    b"inf",
    b"-0",
    b"1e999",
    b"5e-324",
    b"-1",
    b"0",
    b"4294967295",
    b"4294967296",
    b"18446744073709551615",
    b"99999999999999999999",
    b"1/0",
    b"0x1p3",
    b"\n",
    b" ",
    b"\"",
    b"{",
    b"}",
    b"[",
    b"]",
    b"(",
    b",",
    b"<a>",
    b"\0",
    b"\xff\xfe",
    "\u{e9}".as_bytes(),
];

/// The most changes of one file.
const CHANGES_MAX: usize = 6;

/// A file of some format, written by this project or by hand, then damaged.
pub(in crate::fuzz) fn file(choices: &mut dyn Choices) -> File {
    let (format, mut bytes) = whole(choices);
    for _ in 0..choices.index(CHANGES_MAX + 1) {
        let place = choices.index(bytes.len() + 1);
        let end = bytes.len().min(place + choices.index(24));
        match choices.below(7) {
            0 => drop(bytes.drain(place..end)),
            1 => bytes.truncate(place),
            2 => {
                let run = bytes[place..end].to_vec();
                let to = choices.index(bytes.len() + 1);
                bytes.splice(to..to, run);
            }
            3 => bytes[place..end].reverse(),
            4 => {
                let byte = choices.bits().to_le_bytes()[0];
                bytes.splice(place..end.min(place + 1), [byte]);
            }
            _ => {
                let token = TOKENS[choices.index(TOKENS.len())];
                let kept = if choices.one_in(2) { place } else { end };
                bytes.splice(place..kept, token.iter().copied());
            }
        }
    }
    // What is read as another format than it is must be refused as well.
    let format = if choices.one_in(12) { any_format(choices) } else { format };
    File { format, bytes }
}

fn any_format(choices: &mut dyn Choices) -> Format {
    Format::NAMES[choices.index(Format::NAMES.len())].0
}

fn whole(choices: &mut dyn Choices) -> (Format, Vec<u8>) {
    match choices.below(4) {
        0 => {
            let format = any_format(choices);
            let mut bytes = Vec::new();
            let document = document(&generate::crossing(choices));
            // What cannot be written leaves what there was until then, which is as good.
            let _ = write(&document, format, &mut bytes);
            (format, bytes)
        }
        1 => binary(choices),
        _ => {
            let (format, text) = SAMPLES[choices.index(SAMPLES.len())];
            (format, text.as_bytes().to_vec())
        }
    }
}
