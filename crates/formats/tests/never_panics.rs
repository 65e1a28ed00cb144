//! No bytes make a reader panic, hang or allocate by a header's word: arbitrary bytes, and valid files with a few edits.

mod common;

use delone_formats::{Format, Source, read_bytes};
use proptest::collection::vec;
use proptest::prelude::*;

/// A valid file of each format and name.
const SAMPLES: [(&str, &str); 30] = [
    ("a.node", "3 2 1 1\n0 0 0 0.5 1\n1 1 0 0.5 1\n2 0 1 0.5 0\n"),
    (
        "a.poly",
        "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n2 1\n1 1 2 5\n2 2 3 6\n1\n1 0.2 0.2\n1\n1 0.1 0.1 2 0.5\n",
    ),
    ("b.poly", "3 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 1\n1 0\n2 1\n3 1 2 3\n2 1 2\n1 0.1 0.1 0\n0\n"),
    ("a.ele", "1 3 1\n0 0 1 2 7\n"),
    ("a.edge", "1 1\n0 0 1 2\n"),
    ("a.csv", "x,y,w\n0,0,1\n1,0,2\n"),
    ("a.xyz", "2\n0 0 0 1 1\n1 0 0 1 1\n"),
    ("a.lar.json", r#"{"V":[[0,0],[1,0],[0,1]],"EV":[[0,1]],"FV":[[0,1,2]]}"#),
    ("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
    ("b.off", "nOFF\n2\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n"),
    ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nf -1/1 -2 -3\n"),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\nproperty double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0\n",
    ),
    (
        "b.ply",
        "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\nelement face 1\nproperty list int uchar vertex_indices\nend_header\nabcdefghijkl\0\0\0\u{1}\0",
    ),
    (
        "a.stl",
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n",
    ),
    ("a.geojson", r#"{"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[0,1],[0,0]]]]}"#),
    ("a.wkt", "GEOMETRYCOLLECTION(POINT Z (1 2 3),POLYGON((0 0,1/3 0,0 1)))\n"),
    ("a.txt", "2|POINT(0 0)|LINESTRING(0 0,1 0)\n"),
    (
        "a.xml",
        "<run><case><a>POINT(1 2)</a><b>0101000000000000000000F03F0000000000000040</b></case></run>",
    ),
    (
        "a.svg",
        "<svg><g transform='rotate(30)'><path d='M0 0 L1 0 Q 2 2 3 3 A 1 2 3 0 1 9 9 Z'/></g></svg>",
    ),
    ("a.xy", "> 1 1 0.5 3\n0 0\n1 0\n0 1\n"),
    ("a.cin", "s 0 0 1 0\np 5 5\n"),
    ("b.txt", "3 2\n0 0\n1 0\n0 1\n0 1\n1 2\n"),
    ("c.txt", "3 1 1\n3\n0\n0 0\n1 0\n0 1\n0\n1\n2\n0 1\n"),
    ("d.txt", "1\n5 5\n1\n0 0 1 0\n"),
    ("a.edg", "2\n0 0 1/3 1\n1 1 2 0\n"),
    ("a.dat", "0 0\n9 0\n0 9\nHOLE\n1 1\n2 1\n1 2\nSTEINER\n3 3\n"),
    ("b.dat", "3\n0/1 0/1\n9 0\n0 9\n1\n3\n1 1\n2 1\n1 2\n"),
    ("e.txt", "CAPTION: 1.\nSUBJECTS\n0,0, 9,0, 0,9\nCLIPS\n5,5 6,5 5,6\n"),
    ("f.txt", "One 1 -1.0 1\n3\n0 0\n1 0\n0 1\n"),
    (
        "a.json",
        r#"{"glyphs":{"o":{"path":[["moveTo",[[0,0]]],["qCurveTo",[[2,0],[2,2],[0,2]]],["closePath",[]]]}}}"#,
    ),
];

const NODES: &[u8] = b"3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n";

/// What edits put in: words that mean something to some reader.
const WORDS: [&str; 16] = [
    "-1",
    "0",
    "1",
    "18446744073709551615",
    "1e999",
    "nan",
    "(",
    ")",
    "[",
    "{",
    "/",
    "\n",
    "\r",
    "<g>",
    "EMPTY",
    "é",
];

fn read(name: &str, bytes: &[u8], format: Option<Format>) {
    // Whatever comes out, every index of a document must name a point.
    let Ok(documents) = read_bytes(&Source { name, bytes, format, nodes: Some(NODES) }) else {
        return;
    };
    for document in documents {
        let count = document.point_count();
        assert_eq!(document.points.len(), count * document.dimension);
        let segments = document.segments.iter().flatten();
        let triangles = document.triangles.iter().flatten();
        let polygons = document.polygons.iter().flatten();
        let mut all =
            segments.chain(triangles).chain(polygons).chain(document.tets.iter().flatten());
        assert!(all.all(|&v| usize::try_from(v).is_ok_and(|v| v < count)), "index out of range");
    }
}

#[test]
fn the_samples_are_valid() {
    for (name, text) in SAMPLES {
        let outcome =
            read_bytes(&Source { name, bytes: text.as_bytes(), format: None, nodes: Some(NODES) });
        assert!(outcome.is_ok(), "{name}: {outcome:?}");
    }
}

#[test]
fn every_truncation_under_every_format() {
    for (name, text) in SAMPLES {
        for end in 0..text.len() {
            read(name, &text.as_bytes()[..end], None);
        }
        for (format, _) in Format::NAMES {
            read(name, text.as_bytes(), Some(format));
        }
    }
}

proptest! {
    #![proptest_config(common::cases(1000))]

    #[test]
    fn arbitrary_bytes(bytes in vec(any::<u8>(), 0..200)) {
        for (format, _) in Format::NAMES {
            read("a", &bytes, Some(format));
        }
        for (name, _) in SAMPLES {
            read(name, &bytes, None);
        }
        read("a.xz", &[b"\xFD7zXZ\0", &bytes[..]].concat(), None);
    }

    #[test]
    fn arbitrary_words(words in vec(0..WORDS.len(), 0..40)) {
        let text = words.iter().map(|&i| WORDS[i]).collect::<Vec<&str>>().join(" ");
        for (format, _) in Format::NAMES {
            read("a", text.as_bytes(), Some(format));
        }
    }

    #[test]
    fn edited_samples(edits in vec((any::<u16>(), 0_u8..4, any::<u8>(), 0..WORDS.len()), 1..5)) {
        for (name, text) in SAMPLES {
            let mut bytes = text.as_bytes().to_vec();
            for &(place, kind, byte, word) in &edits {
                if bytes.is_empty() {
                    break;
                }
                let at = usize::from(place) % bytes.len();
                match kind {
                    0 => bytes[at] = byte,
                    1 => drop(bytes.remove(at)),
                    2 => drop(bytes.splice(at..at, WORDS[word].bytes())),
                    _ => drop(bytes.splice(at..(at + 3).min(text.len()).min(bytes.len()).max(at), WORDS[word].bytes())),
                }
            }
            read(name, &bytes, None);
        }
    }
}
