//! Rules that a machine can check. Each returns one line for each place where it is broken.

mod arrows;
mod degeneracies;
mod papers;
mod sizes;

use std::path::{Path, PathBuf};
use std::process::Command;

/// A text file of the project.
pub(crate) struct Source {
    /// Relative to the root.
    pub(crate) path: PathBuf,
    pub(crate) text: String,
}

impl Source {
    fn has_extension(&self, extension: &str) -> bool {
        self.path.extension().is_some_and(|found| found == extension)
    }
}

/// Runs all rules.
pub(crate) fn tidy() -> Result<(), String> {
    let root = crate::root();
    let sources = sources(&root)?;
    let mut broken = sizes::broken(&sources);
    broken.extend(arrows::broken(&root, &sources)?);
    broken.extend(papers::broken(&sources)?);
    broken.extend(degeneracies::broken(&sources)?);
    if broken.is_empty() {
        println!("tidy: {} files, no rule broken", sources.len());
        return Ok(());
    }
    Err(format!("tidy:\n{}", broken.join("\n")))
}

/// All tracked and not ignored text files that rules are about.
fn sources(root: &Path) -> Result<Vec<Source>, String> {
    let mut command = Command::new("git");
    command.args(["ls-files", "--cached", "--others", "--exclude-standard"]).current_dir(root);
    let output = command.output().map_err(|error| format!("git does not start: {error}"))?;
    let names = String::from_utf8_lossy(&output.stdout).into_owned();
    let kinds = ["rs", "md", "toml", "cpp", "sh"];
    let paths = names.lines().map(PathBuf::from);
    let paths =
        paths.filter(|path| path.extension().is_some_and(|e| kinds.iter().any(|kind| e == *kind)));
    let mut sources = Vec::new();
    for path in paths.filter(|path| root.join(path).exists()) {
        let text = std::fs::read_to_string(root.join(&path));
        let text = text.map_err(|error| format!("{}: {error}", path.display()))?;
        sources.push(Source { path, text });
    }
    Ok(sources)
}
