//! The opponents that are not Rust: built from our own small C++ program against Debian's packages.

use std::path::Path;
use std::process::Command;
use std::time::SystemTime;

use crate::run::run;

const SOURCE: &str = "tests/peers/cgal.cpp";
const BINARY: &str = "target/peers/cgal";

/// Builds the CGAL peer, unless it is newer than its source.
pub(crate) fn build() -> Result<(), String> {
    let root = crate::root();
    let (source, binary) = (root.join(SOURCE), root.join(BINARY));
    if modified(&source).zip(modified(&binary)).is_some_and(|(source, binary)| source < binary) {
        return Ok(());
    }
    let folder = binary.parent().ok_or("the peers have a folder")?;
    std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    run(Command::new("g++")
        .args(["-std=c++17", "-O2", "-DNDEBUG", "-frounding-math"])
        .args(["-o", BINARY, SOURCE, "-lmpfr", "-lgmp"]))
}

fn modified(path: &Path) -> Option<SystemTime> {
    path.metadata().and_then(|metadata| metadata.modified()).ok()
}
