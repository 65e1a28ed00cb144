//! The commands that add Steiner points.

use clap::{Args, ValueEnum};

use super::{Report, Source};

#[derive(Args)]
pub(crate) struct Conform {
    #[command(flatten)]
    pub(crate) source: Source,
    /// Which subsegments are split
    #[arg(long, value_enum, default_value_t = Method::Delaunay)]
    pub(crate) method: Method,
    #[command(flatten)]
    pub(crate) limits: Limits,
    #[command(flatten)]
    pub(crate) report: Report,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Method {
    /// What is missing: the fewest points
    Delaunay,
    /// What has a vertex in its diametral disk
    Gabriel,
    /// By protecting disks, before anything is triangulated
    Saalfeld,
}

impl Method {
    /// Its name in the registry.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Delaunay => "delaunay",
            Self::Gabriel => "gabriel",
            Self::Saalfeld => "saalfeld",
        }
    }
}

/// When to stop: with exit status 3 and what there is by then, which is a valid triangulation.
#[derive(Args, Clone, Copy)]
pub(crate) struct Limits {
    /// Stop at so many vertices, with exit status 3 and the partial result
    #[arg(long, value_name = "N")]
    pub(crate) vertices_max: Option<usize>,
    /// Stop after so many seconds, with exit status 3 and the partial result
    #[arg(long, value_name = "SECONDS")]
    pub(crate) time_limit: Option<f64>,
}
