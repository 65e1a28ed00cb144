//! Reads the collected inputs of other people where they are, and counts against their index.
//!
//! The folder is `DELONE_DATA`, or `../../../shared/data` from this crate. Without it the test says so and passes.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use delone_formats::{Document, read_all};

/// Files that are refused, and rightly so.
const REFUSED: [(&str, &str); 2] = [
    (
        "points2d/delaunator-cpp/playgrounds-1356-triangles.json",
        "triangle corners without any points",
    ),
    ("pslg/detria/detria/invalid indices.txt", "a test of out-of-range indices"),
];

/// Files whose counts differ from the index, and why.
const TWO_POINT_RING: &str = "a ring of two points has its edge twice here, once in the index";
const DIFFERENT: [(&str, &str); 8] = [
    ("pslg/earcut/issue107.json", TWO_POINT_RING),
    ("pslg/earcut/water-huge.json", TWO_POINT_RING),
    ("pslg/jts-testxml/general/TestValid2.xml", TWO_POINT_RING),
    ("pslg/polygon-clipping/rings-with-no-area/args.geojson", TWO_POINT_RING),
    (
        "pslg/rust-geo-booleanop/generic_test_cases/daef_polygonwithholes_holed.geojson",
        TWO_POINT_RING,
    ),
    ("pslg/sfcgal/IntersectionTest.txt", "all 623 geometries are read, the index counts 280 cases"),
    (
        "pslg/wildmeshing/rocket.json",
        "curves are open polylines of control points, the index closes them",
    ),
    ("points3d/cgal/alpha_shapes_3/skull.pts", "79 contour headings `v n z ..` are no points"),
];

#[expect(clippy::print_stderr, reason = "a test that was skipped must say so")]
fn folder() -> Option<PathBuf> {
    let named = std::env::var_os("DELONE_DATA").map(PathBuf::from);
    let folder =
        named.unwrap_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data"));
    if folder.join("INDEX.md").is_file() {
        return Some(folder);
    }
    eprintln!("skipped: no data folder at {}", folder.display());
    None
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() { open.push(path) } else { found.push(path) }
        }
    }
    found.sort();
    found
}

/// Sites and edges by path, where the index states them.
fn index(folder: &Path) -> BTreeMap<String, (usize, Option<usize>)> {
    let text = std::fs::read_to_string(folder.join("INDEX.md")).unwrap();
    let rows = text.lines().filter_map(|row| {
        let columns: Vec<&str> = row.split('|').map(str::trim).collect();
        let mut counts = columns.get(3)?.split(" / ");
        let sites = counts.next()?.parse().ok()?;
        Some(((*columns.get(1)?).to_owned(), (sites, counts.next()?.parse().ok())))
    });
    rows.collect()
}

/// Segments as listed; of a mesh without segments, its distinct edges.
fn edges(documents: &[Document]) -> usize {
    let listed: usize = documents.iter().map(|d| d.segments.len() + d.zero_length_dropped).sum();
    if listed > 0 {
        return listed;
    }
    let mut distinct = BTreeSet::new();
    for document in documents {
        let triangles = document.triangles.iter().map(|t| &t[..]);
        for face in triangles.chain(document.polygons.iter().map(|p| &p[..])) {
            for i in 0..face.len() {
                let (a, b) = (face[i], face[(i + 1) % face.len()]);
                distinct.insert((a.min(b), a.max(b)));
            }
        }
    }
    distinct.len()
}

#[test]
fn every_file_is_read_and_counts_as_the_index_says() {
    let Some(folder) = folder() else { return };
    let index = index(&folder);
    let (mut faults, mut compared) = (Vec::new(), 0);
    for kind in ["pslg", "points2d", "points3d"] {
        for path in files(&folder.join(kind)) {
            let name = path.strip_prefix(&folder).unwrap().to_string_lossy().into_owned();
            let refused = REFUSED.iter().any(|(known, _)| *known == name);
            let documents = match read_all(&path) {
                Err(error) if !refused => {
                    faults.push(error.to_string());
                    continue;
                }
                Ok(_) if refused => {
                    faults.push(format!("{name} was expected to be refused"));
                    continue;
                }
                Err(_) => continue,
                Ok(documents) => documents,
            };
            let Some(&(sites, wanted)) = index.get(&name) else { continue };
            let found =
                (documents.iter().map(|d| d.points_listed).sum::<usize>(), edges(&documents));
            let agree = found.0 == sites && wanted.is_none_or(|wanted| wanted == found.1);
            compared += 1;
            if agree == DIFFERENT.iter().any(|(known, _)| *known == name) {
                faults.push(format!("{name}: index {sites} / {wanted:?}, read {found:?}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(compared > 500, "only {compared} files compared");
}

#[test]
fn damaged_files_are_refused() {
    let Some(folder) = folder() else { return };
    for path in files(&folder.join("io-negative")) {
        let outcome = read_all(&path);
        assert!(outcome.is_err(), "{} was read", path.display());
    }
}
