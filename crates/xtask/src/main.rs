//! The project's own chores: `cargo xtask test`, `tidy`, `mutants`, `setup`, `bench`.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program for the terminal")]

mod bench;
mod mutants;
mod peers;
mod run;
mod setup;
mod test;
mod tidy;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(name = "cargo xtask", about = "The project's own chores")]
struct Arguments {
    #[command(subcommand)]
    chore: Chore,
}

#[derive(Subcommand)]
enum Chore {
    /// Install what the tests need, if absent, and run every test
    Test,
    /// Install what the tests need with the system's package manager
    Setup,
    /// Build everybody who takes part in `delone bench`, and run it: bench.csv, bench.html, bench.tex
    Bench {
        /// Words for `delone bench`, after --
        #[arg(last = true)]
        words: Vec<String>,
    },
    /// Check arrows between crates, file sizes, paper keys, and that each degeneracy names its test
    Tidy,
    /// Apply each wrong patch of mutants.toml to a copy of the project: some test must fail
    Mutants {
        /// Only those whose name contains this
        #[arg(long)]
        only: Option<String>,
    },
}

/// The root of the workspace.
fn root() -> PathBuf {
    let crates = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    crates.ancestors().nth(2).expect("xtask is two folders down").to_path_buf()
}

fn main() -> ExitCode {
    let outcome = match Arguments::parse().chore {
        Chore::Test => test::test(),
        Chore::Setup => setup::setup().and_then(|()| peers::build()),
        Chore::Bench { words } => bench::bench(&words),
        Chore::Tidy => tidy::tidy(),
        Chore::Mutants { only } => mutants::mutants(only.as_deref()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}
