//! The collected files, where they are there.

use std::path::{Path, PathBuf};

use delone::formats::{Document, read_all};

use crate::case::Case;
use crate::say;

/// The folder of collected files: `DELONE_DATA`, or `../shared/data` beside the workspace.
#[must_use]
pub fn folder() -> Option<PathBuf> {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data");
    let folder = std::env::var_os("DELONE_DATA").map_or_else(beside, PathBuf::from);
    folder.is_dir().then_some(folder)
}

/// All files below `part` of the folder, sorted; of these, if `DELONE_FILES` is set, those whose paths hold its text.
/// None, said aloud, if the folder is absent.
#[must_use]
pub fn files(part: &str) -> Vec<PathBuf> {
    let Some(folder) = folder() else {
        say(format!("skipped: no collected files for {part} (set DELONE_DATA to their folder)"));
        return Vec::new();
    };
    let mut found = Vec::new();
    let mut folders = vec![folder.join(part)];
    while let Some(folder) = folders.pop() {
        let entries = std::fs::read_dir(&folder).into_iter().flatten().flatten();
        for path in entries.map(|entry| entry.path()) {
            if path.is_dir() { folders.push(path) } else { found.push(path) }
        }
    }
    let asked = std::env::var("DELONE_FILES").unwrap_or_default();
    found.retain(|path| path.to_string_lossy().contains(&asked));
    found.sort();
    found
}

/// The documents of a file that can be read; what cannot is said.
#[must_use]
pub fn documents(path: &Path) -> Vec<Document> {
    match read_all(path) {
        Ok(documents) => documents,
        Err(error) => {
            say(format!("skipped: {error}"));
            Vec::new()
        }
    }
}

/// A document's points as a case of dimension D, if that is its dimension and they are finite.
#[must_use]
pub fn points_of<const D: usize>(document: &Document) -> Option<Case<D>> {
    let finite = document.points.iter().all(|x| x.is_finite());
    (document.dimension == D && finite)
        .then(|| Case::of_points(&document.name, document.points.as_chunks::<D>().0.to_vec()))
}

/// A document's points and segments.
#[must_use]
pub fn pslg_of(document: &Document) -> Option<Case<2>> {
    points_of::<2>(document).map(|case| Case { segments: document.segments.clone(), ..case })
}

/// The inputs of the folder `regressions`: each with the law that its header names.
#[must_use]
pub fn regressions() -> Vec<(String, Document)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("regressions");
    let entries = std::fs::read_dir(&folder).expect("the folder of regressions is there");
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    paths
        .into_iter()
        .map(|path| {
            let text = std::fs::read_to_string(&path).expect("a regression can be read");
            let law = text.lines().next().and_then(|line| line.strip_prefix("# law: "));
            let law = law.unwrap_or_else(|| panic!("{}: no `# law: ` first", path.display()));
            let mut documents = read_all(&path).unwrap_or_else(|error| panic!("{error}"));
            let document = documents.pop().expect("a regression holds one input");
            (law.trim().to_owned(), document)
        })
        .collect()
}
