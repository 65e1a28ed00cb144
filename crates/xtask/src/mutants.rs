//! Small wrong patches, each of which some test must catch.
//!
//! The list is `mutants.toml`: a file, a text that stands in it once, what to put there, the packages whose tests should
//! fail, and perhaps the one test target among them. A mutant must compile: one that does not proves nothing. Work happens in a copy under `target/mutants`.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde::Deserialize;

#[derive(Deserialize)]
struct List {
    mutant: Vec<Mutant>,
}

#[derive(Deserialize)]
struct Mutant {
    name: String,
    file: PathBuf,
    find: String,
    replace: String,
    packages: Vec<String>,
    /// Only this test target of the packages, if it is named: the quickest net that should catch the mutant.
    net: Option<String>,
}

/// Tries all mutants whose name contains `only`.
pub(crate) fn mutants(only: Option<&str>) -> Result<(), String> {
    let root = crate::root();
    let text = read(&root.join("crates/xtask/mutants.toml"))?;
    let list: List = toml::from_str(&text).map_err(|error| format!("mutants.toml: {error}"))?;
    let copy = root.join("target/mutants/tree");
    let mut survivors = Vec::new();
    let chosen: Vec<&Mutant> =
        list.mutant.iter().filter(|m| only.is_none_or(|part| m.name.contains(part))).collect();
    for mutant in &chosen {
        copy_project(&root, &copy)?;
        let verdict = attempt(&copy, mutant)?;
        println!("{:60} {}", mutant.name, if verdict { "caught" } else { "SURVIVED" });
        if !verdict {
            survivors.push(mutant.name.clone());
        }
    }
    if survivors.is_empty() {
        println!("{} mutants, all caught", chosen.len());
        return Ok(());
    }
    Err(format!("no test catches: {}", survivors.join(", ")))
}

/// Whether the tests of the mutant's packages fail on it.
fn attempt(copy: &Path, mutant: &Mutant) -> Result<bool, String> {
    let path = copy.join(&mutant.file);
    let text = read(&path)?;
    if text.matches(&mutant.find).count() != 1 {
        return Err(format!(
            "{}: its text must stand once in {}",
            mutant.name,
            mutant.file.display()
        ));
    }
    let mutated = text.replacen(&mutant.find, &mutant.replace, 1);
    std::fs::write(&path, mutated).map_err(|error| format!("{}: {error}", path.display()))?;
    if !cargo(copy, mutant, &["test", "--no-run"])? {
        return Err(format!("{}: does not compile, which proves nothing", mutant.name));
    }
    Ok(!cargo(copy, mutant, &["test", "--no-fail-fast"])?)
}

fn cargo(copy: &Path, mutant: &Mutant, words: &[&str]) -> Result<bool, String> {
    let mut command = Command::new("cargo");
    command.args(words).arg("--quiet").current_dir(copy);
    command.env("CARGO_TARGET_DIR", copy.with_file_name("target"));
    command.args(mutant.packages.iter().flat_map(|package| ["--package", package]));
    command.args(mutant.net.iter().flat_map(|net| ["--test", net.as_str()]));
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().map(|status| status.success()).map_err(|error| format!("cargo: {error}"))
}

/// Copies what git knows, leaving files that are equal untouched, so that builds stay incremental.
fn copy_project(root: &Path, copy: &Path) -> Result<(), String> {
    let mut command = Command::new("git");
    command.args(["ls-files", "--cached", "--others", "--exclude-standard"]).current_dir(root);
    let output = command.output().map_err(|error| format!("git does not start: {error}"))?;
    for name in String::from_utf8_lossy(&output.stdout).lines() {
        let (from, to) = (root.join(name), copy.join(name));
        let Ok(bytes) = std::fs::read(&from) else { continue };
        if std::fs::read(&to).is_ok_and(|there| there == bytes) {
            continue;
        }
        let folder = to.parent().ok_or("a file has a folder")?;
        std::fs::create_dir_all(folder)
            .map_err(|error| format!("{}: {error}", folder.display()))?;
        std::fs::write(&to, bytes).map_err(|error| format!("{}: {error}", to.display()))?;
    }
    Ok(())
}

fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}
