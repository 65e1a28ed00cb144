//! `delone replay`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::{Source, Voice};

/// What is replayed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Shown {
    /// Sites come one by one, then segments
    Insertion,
    /// Blocks of sites, merged two by two
    DivideConquer,
    /// A line that meets sites and circle events
    Sweep,
    /// Strips of sites and segments, merged two by two
    Chew,
}

#[derive(Args)]
pub(crate) struct Replay {
    #[command(flatten)]
    pub(crate) source: Source,
    /// What to show: sites and segments one by one, or an algorithm from inside
    #[arg(long, value_enum, default_value_t = Shown::Insertion)]
    pub(crate) algorithm: Shown,
    /// Write the page to this file
    #[arg(long, value_name = "FILE", default_value = "replay.html")]
    pub(crate) html: PathBuf,
    /// Refuse more sites than this
    #[arg(long, value_name = "N", default_value_t = 500)]
    pub(crate) sites_max: usize,
    #[command(flatten)]
    pub(crate) voice: Voice,
}
