//! `delone replay`.

use std::path::PathBuf;

use clap::Args;

use super::{Source, Voice};

#[derive(Args)]
pub(crate) struct Replay {
    #[command(flatten)]
    pub(crate) source: Source,
    /// Write the page to this file
    #[arg(long, value_name = "FILE", default_value = "replay.html")]
    pub(crate) html: PathBuf,
    /// Refuse more sites than this
    #[arg(long, value_name = "N", default_value_t = 500)]
    pub(crate) sites_max: usize,
    #[command(flatten)]
    pub(crate) voice: Voice,
}
