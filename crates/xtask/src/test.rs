//! Every test of the project, in one command.

use std::process::Command;

use crate::run::{run, succeeds};
use crate::{peers, setup, tidy};

/// Sets up, then runs tidy, the linters and all tests.
pub(crate) fn test() -> Result<(), String> {
    setup::setup()?;
    peers::build()?;
    tidy::tidy()?;
    if succeeds("cargo", &["fmt", "--version"]) {
        run(&mut cargo(&["fmt", "--all", "--check"]))?;
    }
    if succeeds("cargo", &["clippy", "--version"]) {
        run(&mut cargo(&[
            "clippy",
            "--workspace",
            "--all-targets",
            "--quiet",
            "--",
            "-D",
            "warnings",
        ]))?;
    }
    run(cargo(&["doc", "--workspace", "--no-deps", "--quiet"]).env("RUSTDOCFLAGS", "-D warnings"))?;
    run(&mut cargo(&["test", "--workspace"]))
}

fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new("cargo");
    command.args(arguments);
    command
}
