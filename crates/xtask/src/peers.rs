//! The opponents that are not Rust: built from our own small C++ program against Debian's packages.

use std::path::Path;
use std::process::Command;
use std::time::SystemTime;

use crate::run::run;

/// Sources in `tests/peers`, and programs of the same names.
const NAMES: [&str; 2] = ["cgal", "cgal_alpha"];

/// Builds the CGAL peers that are not newer than their sources, all at a time: each takes most of a minute.
pub(crate) fn build() -> Result<(), String> {
    std::thread::scope(|scope| {
        let builds = NAMES.map(|name| scope.spawn(move || build_one(name)));
        builds.into_iter().try_for_each(|build| {
            build.join().unwrap_or_else(|_| Err("the build of a peer panicked".to_owned()))
        })
    })
}

fn build_one(name: &str) -> Result<(), String> {
    let root = crate::root();
    let source = root.join("tests/peers").join(name).with_extension("cpp");
    let binary = root.join("target/peers").join(name);
    if modified(&source).zip(modified(&binary)).is_some_and(|(source, binary)| source < binary) {
        return Ok(());
    }
    let folder = binary.parent().ok_or("the peers have a folder")?;
    std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    run(Command::new("g++")
        .args(["-std=c++17", "-O2", "-DNDEBUG", "-frounding-math", "-o"])
        .args([binary.as_os_str(), source.as_os_str()])
        .args(["-lmpfr", "-lgmp"]))
}

fn modified(path: &Path) -> Option<SystemTime> {
    path.metadata().and_then(|metadata| metadata.modified()).ok()
}
