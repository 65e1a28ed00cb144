//! `delone fuzz` and `delone shrink`.

use std::path::PathBuf;

use clap::Args;

use super::Voice;

#[derive(Args)]
#[command(after_help = "Examples:\n  \
    delone fuzz --seconds 60                                 every target for a minute in all\n  \
    delone fuzz cdt --cases 100000 --shards 8 --state runs   eight processes, resumable\n  \
    delone fuzz --seconds 3600 --shards 2 --state runs       every target on two cores for an hour in all\n  \
    delone fuzz cdt --program 'mycdt {in} {out}'             your program against the judge, failures made small\n  \
    delone fuzz cdt --seed 1 --case 4711                     one case again")]
pub(crate) struct Fuzz {
    /// What to try (--list tells what there is); all targets when none
    pub(crate) targets: Vec<String>,
    /// List the targets and their laws
    #[arg(long)]
    pub(crate) list: bool,
    /// Stop after so many seconds, all targets together [10 if neither this nor --cases is given]
    #[arg(long, value_name = "SECONDS")]
    pub(crate) seconds: Option<f64>,
    /// Stop after so many cases of each target, all shards together
    #[arg(long, value_name = "N")]
    pub(crate) cases: Option<u64>,
    /// Stop at the first failure
    #[arg(long)]
    pub(crate) first: bool,
    /// A case is a pure function of target, seed and number
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// Run this one case, and write its input
    #[arg(long, value_name = "K", conflicts_with_all = ["cases", "seconds", "shard", "shards", "state"])]
    pub(crate) case: Option<u64>,
    /// Keep a file for each target and shard in this folder, and go on from what is there
    #[arg(long, value_name = "FOLDER")]
    pub(crate) state: Option<PathBuf>,
    /// Run only the cases whose number is I modulo N
    #[arg(long, value_name = "I/N", requires = "state")]
    pub(crate) shard: Option<String>,
    /// Run this many processes, a shard each, and merge what they say
    #[arg(long, value_name = "N", requires = "state", conflicts_with = "shard")]
    pub(crate) shards: Option<u64>,
    /// Merge the shards in this folder instead of running any
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["cases", "seconds", "shard", "shards", "state"])]
    pub(crate) merge: Option<PathBuf>,
    /// Let cases take points and segments of the files in this folder
    #[arg(long, value_name = "FOLDER")]
    pub(crate) corpus: Option<PathBuf>,
    /// Write failing inputs, made small, to this folder
    #[arg(short, long, value_name = "FOLDER", default_value = "delone-failures")]
    pub(crate) output: PathBuf,
    #[command(flatten)]
    pub(crate) program: Program,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

/// A program to try in place of the laws.
#[derive(Args, Clone)]
pub(crate) struct Program {
    /// Judge this command's output: {in} stands for the input file, {out} for the file of triangles that it is to write
    #[arg(long, value_name = "COMMAND")]
    pub(crate) program: Option<String>,
    /// Seconds that one run of it may take
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0)]
    pub(crate) timeout: f64,
    /// The ending, and format, of {in} [poly for segments, else node]
    #[arg(long, value_name = "ENDING")]
    pub(crate) in_ending: Option<String>,
    /// The ending, and format, of {out}
    #[arg(long, value_name = "ENDING", default_value = "ele")]
    pub(crate) out_ending: String,
    /// A status other than 0 is a refusal, and no failure
    #[arg(long)]
    pub(crate) accept_refusal: bool,
}

#[derive(Args)]
pub(crate) struct Shrink {
    /// An input that breaks the law
    pub(crate) input: PathBuf,
    /// The law (`delone fuzz --list` tells which there are); judge for a program's output
    #[arg(long, required_unless_present = "program")]
    pub(crate) law: Option<String>,
    /// Whose law it is [cdt if there are segments, else delaunay-2d or delaunay-3d]
    #[arg(long)]
    pub(crate) target: Option<String>,
    /// Write to this file [NAME.min.poly or NAME.min.node beside the input]
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
    /// How many smaller inputs to try
    #[arg(long, default_value_t = 20_000)]
    pub(crate) tests: usize,
    #[command(flatten)]
    pub(crate) program: Program,
    #[command(flatten)]
    pub(crate) voice: Voice,
}
