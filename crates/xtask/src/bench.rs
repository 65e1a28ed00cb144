//! The speed tables, in one command.

use std::process::Command;

use crate::run::run;
use crate::{peers, setup};

/// Builds our program and every peer, and runs `delone bench` with these words after those that say where records go.
pub(crate) fn bench(words: &[String]) -> Result<(), String> {
    setup::setup()?;
    peers::build()?;
    let packages = ["-p", "delone-lab", "-p", "delone-benches", "--bins"];
    run(Command::new("cargo").args(["build", "--release"]).args(packages))?;
    let records = ["--csv", "bench.csv", "--html", "bench.html", "--latex", "bench.tex"];
    run(Command::new("target/release/delone").arg("bench").args(records).args(words))
}
