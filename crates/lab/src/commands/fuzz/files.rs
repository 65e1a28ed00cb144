//! Inputs as files, and back.

use std::path::{Path, PathBuf};

use delone_formats::{Document, Format, write};
use delone_laws::case::Case;
use delone_laws::corpus::{Corpus, Piece};
use delone_laws::fuzz::{Broken, File, Input};
use delone_laws::generate::NAME;

use crate::failure::Failure;
use crate::output;

/// The document of an input; a file has none.
pub(crate) fn document(input: &Input) -> Option<Document> {
    Some(match input {
        Input::Plane(case) => Document {
            points: case.points.as_flattened().to_vec(),
            segments: case.segments.clone(),
            ..Document::new(2)
        },
        Input::Space(case) => {
            Document { points: case.points.as_flattened().to_vec(), ..Document::new(3) }
        }
        Input::File(_) => return None,
    })
}

/// The input of a document; what it says beyond points and segments is not looked at.
pub(crate) fn input(document: &Document) -> Result<Input, Failure> {
    if let Some(x) = document.points.iter().find(|x| !x.is_finite()) {
        return Err(Failure::input(format!("{}: a coordinate is {x}", document.name)));
    }
    if document.dimension == 3 {
        let points = document.points_3d().map_err(Failure::input)?.to_vec();
        return Ok(Input::Space(Case::of_points(NAME, points)));
    }
    let points = document.points_2d().map_err(Failure::input)?.to_vec();
    Ok(Input::Plane(Case::new(NAME, points, document.segments.clone())))
}

/// `NAME.poly` if there are segments, else `NAME.node`; a file ends in its format's name.
pub(crate) fn path(folder: &Path, name: &str, input: &Input) -> PathBuf {
    folder.join(match input {
        Input::File(file) => format!("{name}.{}", file.format),
        _ if input.segments() > 0 => format!("{name}.poly"),
        _ => format!("{name}.node"),
    })
}

/// Writes an input under a header that names the law it breaks, as the folder of regressions has them. A file is written as it
/// is: its law is that of readers.
pub(crate) fn keep(path: &Path, input: &Input, broken: &Broken) -> Result<(), Failure> {
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        std::fs::create_dir_all(folder).map_err(Failure::input)?;
    }
    let bytes = match input {
        Input::File(file) => file.bytes.clone(),
        _ => with_header(input, broken)?,
    };
    output::bytes(path, &bytes)
}

fn with_header(input: &Input, broken: &Broken) -> Result<Vec<u8>, Failure> {
    let format = if input.segments() > 0 { Format::Poly } else { Format::Node };
    let said: Vec<&str> = broken.message.lines().filter(|line| !line.trim().is_empty()).collect();
    let said = said.first().map_or("", |line| line.trim());
    let mut bytes = format!("# law: {}\n# {}: {said}\n", broken.law, broken.place).into_bytes();
    let document = document(input).expect("files have no header");
    write(&document, format, &mut bytes).map_err(Failure::input)?;
    Ok(bytes)
}

/// A file's one input; for the readers' law, the file itself, of the format that its name ends in.
pub(crate) fn read(path: &Path, target: Option<&str>) -> Result<Input, Failure> {
    if target != Some(READERS) {
        return input(&crate::input::read(path, None)?);
    }
    let name = path.to_string_lossy();
    let formats = Format::NAMES.iter().filter(|(_, ending)| name.ends_with(&format!(".{ending}")));
    let Some(&(format, _)) = formats.max_by_key(|(_, ending)| ending.len()) else {
        return Err(Failure::input(format!("{name}: the ending names no format")));
    };
    let bytes = std::fs::read(path).map_err(|error| Failure::input(format!("{name}: {error}")))?;
    Ok(Input::File(File { format, bytes }))
}

/// The target whose inputs are files.
pub(crate) const READERS: &str = "readers";

/// The inputs of a folder's files, in the order of their names. What is no input is left out, and said to be.
pub(crate) fn corpus(folder: &Path, quiet: bool) -> Result<Corpus, Failure> {
    let entries = std::fs::read_dir(folder)
        .map_err(|error| Failure::input(format!("{}: {error}", folder.display())))?;
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.retain(|path| path.is_file());
    paths.sort();
    let (mut pieces, mut left_out) = (Vec::new(), 0);
    for path in &paths {
        let documents = delone_formats::read_all(path).unwrap_or_default();
        let before = pieces.len();
        pieces.extend(documents.into_iter().filter_map(piece));
        left_out += usize::from(pieces.len() == before);
    }
    if pieces.is_empty() {
        return Err(Failure::input(format!("{}: no file with finite points", folder.display())));
    }
    if left_out > 0 && !quiet {
        eprintln!("{}: {left_out} files hold no finite points", folder.display());
    }
    Ok(Corpus::new(pieces))
}

fn piece(document: Document) -> Option<Piece> {
    let Document { dimension, points, segments, .. } = document;
    let sound = !points.is_empty() && points.iter().all(|x| x.is_finite());
    sound.then_some(Piece { dimension, points, segments })
}

/// Refuses, before any work is done, a folder that could not be made.
pub(crate) fn check_folder(folder: &Path) -> Result<(), Failure> {
    if folder.exists() && !folder.is_dir() {
        return Err(Failure::input(format!("{}: this is no folder", folder.display())));
    }
    output::check_paths(folder.parent().filter(|parent| parent.is_file()))
}
