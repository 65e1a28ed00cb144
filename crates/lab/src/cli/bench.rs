//! `delone bench`.

use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::Voice;

#[derive(Args)]
#[command(
    args_conflicts_with_subcommands = true,
    after_help = "Examples:\n  \
        delone bench --csv now.csv --html now.html       every definition of benches/definitions, peers included\n  \
        delone bench benches/definitions/cdt.toml        one of them\n  \
        delone bench compare before.csv now.csv          ratios with intervals"
)]
pub(crate) struct Bench {
    #[command(subcommand)]
    pub(crate) action: Option<BenchAction>,
    /// Definitions [all of benches/definitions]
    pub(crate) definitions: Vec<PathBuf>,
    /// Who takes part [benches/engines.toml]
    #[arg(long, value_name = "FILE")]
    pub(crate) engines: Option<PathBuf>,
    /// Only these of them
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    pub(crate) only: Vec<String>,
    /// Rounds, in each of which every engine has its turn [as the definition says]
    #[arg(long, value_name = "N")]
    pub(crate) rounds: Option<u32>,
    /// Leave out inputs of more sites
    #[arg(long, value_name = "N")]
    pub(crate) sites_max: Option<usize>,
    /// End with 1 if a peer is wrong, too: else only if an engine of ours is
    #[arg(long)]
    pub(crate) strict: bool,
    /// Write a record of every run
    #[arg(long, value_name = "FILE")]
    pub(crate) csv: Option<PathBuf>,
    /// Write a report with plots
    #[arg(long, value_name = "FILE")]
    pub(crate) html: Option<PathBuf>,
    /// Write tables for a paper
    #[arg(long, value_name = "FILE")]
    pub(crate) latex: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Subcommand)]
pub(crate) enum BenchAction {
    /// Compare two records, engine by engine
    Compare {
        /// The record before
        before: PathBuf,
        /// The record after
        after: PathBuf,
        #[command(flatten)]
        voice: Voice,
    },
}

/// One of our algorithms as an engine of a benchmark: builds a few times and prints what each took.
#[derive(Args)]
pub(crate) struct Engine {
    /// delaunay or cdt
    pub(crate) task: String,
    /// The input
    pub(crate) input: PathBuf,
    /// Where the triangulation goes
    pub(crate) output: PathBuf,
    /// How often to build it
    pub(crate) times: u32,
    #[command(flatten)]
    pub(crate) run: super::Run,
}
