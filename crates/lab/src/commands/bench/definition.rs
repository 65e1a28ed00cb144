//! Benchmarks as data: what is run, on what, what it shows, and what the answer is.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::failure::Failure;

/// A benchmark.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(crate) struct Definition {
    /// Its name in records.
    pub(crate) name: String,
    /// What it shows, and what not.
    pub(crate) analysis: String,
    pub(crate) task: Task,
    /// Who takes part, by name, in the order of the turns.
    pub(crate) engines: Vec<String>,
    #[serde(default = "rounds")]
    pub(crate) rounds: u32,
    /// How often each engine builds in one turn.
    #[serde(default = "times")]
    pub(crate) times: u32,
    /// Seconds that one turn may take; who takes more has no turn on larger inputs of a workload.
    #[serde(default = "limit")]
    pub(crate) limit: f64,
    /// Of a table, the names in it that are ours.
    #[serde(default)]
    pub(crate) ours: Vec<String>,
    #[serde(default, rename = "input")]
    pub(crate) inputs: Vec<Input>,
    #[serde(default, rename = "file")]
    pub(crate) files: Vec<Given>,
}

fn rounds() -> u32 {
    3
}

fn times() -> u32 {
    2
}

fn limit() -> f64 {
    120.0
}

/// What an engine is asked to do.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Task {
    /// A Delaunay triangulation of points.
    Delaunay,
    /// A constrained Delaunay triangulation.
    Cdt,
    /// A table of its own, of calls, each checked by its tally.
    Table,
}

impl Task {
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Delaunay => "delaunay",
            Self::Cdt => "cdt",
            Self::Table => "table",
        }
    }
}

/// A workload at several sizes.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Input {
    pub(crate) workload: String,
    #[serde(default = "seed")]
    pub(crate) seed: u64,
    /// Only so many of its segments, the first ones.
    pub(crate) segments: Option<usize>,
    /// By number of sites asked for, the fingerprint of the one answer; empty: not pinned yet.
    pub(crate) answers: BTreeMap<String, String>,
}

/// A file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Given {
    /// Where it is, from the folder that the program is run in.
    pub(crate) path: PathBuf,
    /// The fingerprint of the one answer; empty: not pinned yet.
    #[serde(default)]
    pub(crate) answer: String,
}

fn seed() -> u64 {
    1
}

impl Input {
    /// What it is called in records.
    pub(crate) fn label(&self) -> String {
        match self.segments {
            None => self.workload.clone(),
            Some(segments) => format!("{}, {segments} segments", self.workload),
        }
    }

    /// The sizes with their answers, in increasing order.
    pub(crate) fn sizes(&self) -> Result<Vec<(usize, &str)>, Failure> {
        let mut sizes: Vec<(usize, &str)> = Vec::new();
        for (n, answer) in &self.answers {
            let count = n.parse().map_err(|_| {
                Failure::input(format!(
                    "{}: answers are by number of sites, not {n}",
                    self.workload
                ))
            })?;
            sizes.push((count, answer));
        }
        sizes.sort_unstable();
        Ok(sizes)
    }
}

/// Who can take part.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Engines {
    pub(crate) engine: Vec<Engine>,
}

/// A program that triangulates, or prints a table.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Engine {
    pub(crate) name: String,
    /// Words, with {self} {root} {task} {in} {out} {times}.
    pub(crate) command: String,
    /// Whether its answer must be the pinned one, bit for bit; others may break ties as they like.
    #[serde(default)]
    pub(crate) ours: bool,
    /// What to do if it is not there.
    #[serde(default)]
    pub(crate) build: String,
}

/// Reads a definition, or the engines.
pub(crate) fn read<T: for<'d> Deserialize<'d>>(path: &Path) -> Result<T, Failure> {
    let refuse = |why: String| Failure::input(format!("{}: {why}", path.display()));
    let text = std::fs::read_to_string(path).map_err(|error| refuse(error.to_string()))?;
    toml::from_str(&text).map_err(|error| refuse(error.to_string()))
}
