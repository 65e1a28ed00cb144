//! Writing files: documents by ending, pictures, reports; whole or not at all.

use std::fmt::Display;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use delone_formats::{Document, Format, unfinished, write, write_atomically};

use crate::failure::Failure;

/// The format of a file to be written.
pub(crate) fn format_to_write(path: &Path) -> Result<Format, Failure> {
    let format = Format::from_path(&path.to_string_lossy()).filter(|format| format.is_written());
    format.ok_or_else(|| {
        Failure::input(format!(
            "{}: the ending names no format that is written: .node .poly .ele .edge .neigh .csv .xyz .lar.json .off .obj .npy \
             .geojson .wkt",
            path.display()
        ))
    })
}

/// Refuses, before any work is done, files that could not be written.
pub(crate) fn check_paths<'p>(paths: impl IntoIterator<Item = &'p Path>) -> Result<(), Failure> {
    for path in paths {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        if folder.is_some_and(|folder| !folder.is_dir()) {
            return Err(Failure::input(format!("{}: there is no such folder", path.display())));
        }
        if path.is_dir() {
            return Err(Failure::input(format!("{}: this is a folder", path.display())));
        }
    }
    Ok(())
}

/// The file that is being written, if one is.
static WRITING: Mutex<Option<PathBuf>> = Mutex::new(None);

/// Writes a file whole or not at all, also if the user interrupts: see [`remove_unfinished`].
fn whole<T, E: From<std::io::Error> + Display>(
    path: &Path,
    content: impl FnOnce(&mut BufWriter<File>) -> Result<T, E>,
) -> Result<T, Failure> {
    let note = |path: Option<PathBuf>| {
        // A lock is only poisoned by a panic, which ends the program.
        *WRITING.lock().unwrap_or_else(PoisonError::into_inner) = path;
    };
    note(Some(path.to_owned()));
    let outcome = write_atomically(path, content);
    note(None);
    outcome.map_err(|error| Failure::input(format!("{}: {error}", path.display())))
}

/// Removes what is there of a file that is being written; for whoever ends the program.
pub(crate) fn remove_unfinished() {
    let writing = WRITING.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(part) = writing.as_deref().and_then(unfinished) {
        // If it is not there, or cannot be removed, nothing is left to be done.
        let _ = fs::remove_file(part);
    }
}

/// Writes a document; returns what its format could not hold.
pub(crate) fn document(path: &Path, document: &Document) -> Result<Vec<String>, Failure> {
    let format = format_to_write(path)?;
    whole(path, |out| write(document, format, out))
}

/// Writes a text.
pub(crate) fn text(path: &Path, text: &str) -> Result<(), Failure> {
    bytes(path, text.as_bytes())
}

/// Writes bytes.
pub(crate) fn bytes(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    whole(path, |out: &mut BufWriter<File>| out.write_all(bytes))
}

/// Prints a document on standard output.
pub(crate) fn print(document: &Document, format: Format) -> Result<(), Failure> {
    let mut bytes = Vec::new();
    write(document, format, &mut bytes).map_err(Failure::input)?;
    print_bytes(&bytes)
}

/// Prints bytes on standard output; a reader that has gone away is no error.
pub(crate) fn print_bytes(bytes: &[u8]) -> Result<(), Failure> {
    match std::io::stdout().write_all(bytes) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::input(format!("standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// The size of a file just written, for people.
pub(crate) fn size(path: &Path) -> String {
    let bytes = fs::metadata(path).map_or(0, |metadata| metadata.len());
    indicatif::HumanBytes(bytes).to_string()
}
