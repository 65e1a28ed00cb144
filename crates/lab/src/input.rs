//! Reading what a command is given: a file, a folder's files, or standard input.

use std::io::Read;
use std::path::{Path, PathBuf};

use delone_formats::{Document, Format, Source, one, read_bytes, read_path};

use crate::failure::Failure;

/// The most names of documents in a message.
const NAMES_MAX: usize = 5;

/// The format that `--format` names.
pub(crate) fn format_of(name: Option<&str>) -> Result<Option<Format>, Failure> {
    name.map(|name| {
        Format::from_name(name).ok_or_else(|| Failure::input(format!("no format is called {name}")))
    })
    .transpose()
}

/// All documents of a file or of standard input; of `FILE#NAME`, if there is no such file, the one of `FILE` that is called so.
pub(crate) fn read_all(path: &Path, format: Option<&str>) -> Result<Vec<Document>, Failure> {
    let format = format_of(format)?;
    if let Some(file) = file_of_named(path) {
        let mut documents = read_path(&file, format).map_err(Failure::input)?;
        let name = path.to_string_lossy();
        let names: Vec<String> = documents.iter().map(|document| document.name.clone()).collect();
        documents.retain(|document| document.name == name);
        if documents.is_empty() {
            return Err(Failure::input(format!("{name}: there is {}", several(&names))));
        }
        return Ok(documents);
    }
    if path != Path::new("-") {
        return read_path(path, format).map_err(Failure::input);
    }
    let mut bytes = Vec::new();
    std::io::stdin()
        .read_to_end(&mut bytes)
        .map_err(|error| Failure::input(format!("-: {error}")))?;
    read_bytes(&Source { name: "-", bytes: &bytes, format, nodes: None }).map_err(Failure::input)
}

/// The one document of a file or of standard input.
pub(crate) fn read(path: &Path, format: Option<&str>) -> Result<Document, Failure> {
    let (documents, name) = (read_all(path, format)?, path.to_string_lossy());
    if documents.len() > 1 && path != Path::new("-") {
        let names: Vec<String> = documents.into_iter().map(|document| document.name).collect();
        return Err(Failure::input(format!(
            "{name}: holds {} documents where one is needed: name one of {}",
            names.len(),
            several(&names)
        )));
    }
    one(documents, &name).map_err(Failure::input)
}

/// The file that a document is part of, where there is no file of the whole name.
fn file_of_named(path: &Path) -> Option<PathBuf> {
    let (file, _) = path.to_str()?.rsplit_once('#')?;
    let file = PathBuf::from(file);
    (!path.exists() && file.is_file()).then_some(file)
}

/// A few names.
fn several(names: &[String]) -> String {
    let more = if names.len() > NAMES_MAX { ", .." } else { "" };
    format!("{}{more}", names[..names.len().min(NAMES_MAX)].join(", "))
}

/// Replaces the document's weights by those of a file, one number for each point, between blanks, commas or line ends.
/// `#` starts a comment.
pub(crate) fn take_weights(document: &mut Document, file: Option<&Path>) -> Result<(), Failure> {
    let Some(path) = file else { return Ok(()) };
    let name = path.display();
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::input(format!("{name}: {error}")))?;
    let mut weights = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let words = line.split('#').next().unwrap_or("");
        let words = words.split(|c: char| c == ',' || c.is_whitespace());
        for word in words.filter(|word| !word.is_empty()) {
            let weight: f64 = word.parse().map_err(|_| {
                Failure::input(format!("{name}:{number}: {word} is no number: give one a point"))
            })?;
            weights.push(weight);
        }
    }
    document.weights = Some(weights);
    Ok(())
}

/// The files below the given paths, those of folders in order of their names.
pub(crate) fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let mut files = Vec::new();
    for path in paths {
        if path.is_dir() {
            collect(path, &mut files)?;
        } else {
            files.push(path.clone());
        }
    }
    Ok(files)
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> Result<(), Failure> {
    let failed = |error| Failure::input(format!("{}: {error}", folder.display()));
    let mut entries = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        entries.push(entry.map_err(failed)?.path());
    }
    entries.sort();
    for entry in entries {
        if entry.is_dir() {
            collect(&entry, files)?;
        } else if !is_companion(&entry) {
            files.push(entry);
        }
    }
    Ok(())
}

/// Whether a file only completes another one beside it: the points or triangles of a `.poly` file.
fn is_companion(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str());
    let is_part = matches!(ending, Some("ele" | "edge" | "neigh" | "node"));
    let (poly, node) = (path.with_extension("poly"), path.with_extension("node"));
    is_part && (poly.is_file() || (ending != Some("node") && node.is_file()))
}
