//! The commands that add Steiner points.

use clap::{Args, ValueEnum};
use delone_conforming::ConformOptions;

use super::{Fill, Report, Source};

/// What the commands that add Steiner points have in common.
#[derive(Args)]
pub(crate) struct Adding {
    #[command(flatten)]
    pub(crate) source: Source,
    /// What to do with segments that cross
    #[arg(long, value_enum, default_value_t = Crossings::Reject)]
    pub(crate) crossings: Crossings,
    #[command(flatten)]
    pub(crate) limits: Limits,
    #[command(flatten)]
    pub(crate) report: Report,
}

/// Steiner points are on segments between points in doubles: crossings are rounded, or refused.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Crossings {
    /// List every crossing and stop
    Reject,
    /// Make each crossing a vertex at the nearest doubles, and cut again what crosses then
    Snap,
}

#[derive(Args)]
pub(crate) struct Conform {
    #[command(flatten)]
    pub(crate) adding: Adding,
    /// Which subsegments are split
    #[arg(long, value_enum, default_value_t = Method::Delaunay)]
    pub(crate) method: Method,
    /// With saalfeld, the most cuts of one segment: one that would take more, along a narrow gap, is split as by gabriel
    #[arg(long, value_name = "N", default_value_t = ConformOptions::default().cuts_max)]
    pub(crate) cuts_max: usize,
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

/// How far `compare` lets a method with Steiner points go.
#[derive(Args, Clone, Copy)]
pub(crate) struct Bounds {
    /// Stop a method with Steiner points at so many vertices; its row says so [default: ten for each site, and 10000]
    #[arg(long, value_name = "N", requires = "only")]
    pub(crate) vertices_max: Option<usize>,
    /// Stop each run of a method with Steiner points after so many seconds; its row says so
    #[arg(long, value_name = "SECONDS", default_value_t = 5.0, requires = "only")]
    pub(crate) time_limit: f64,
}

#[derive(Args)]
pub(crate) struct Refine {
    #[command(flatten)]
    pub(crate) adding: Adding,
    /// Where points go, and what is too near a segment
    #[arg(long, value_enum, default_value_t = Refinement::OffCentre)]
    pub(crate) method: Refinement,
    /// The least angle inside, in degrees: proven up to 20.7, usual up to 33
    #[arg(long, value_name = "DEGREES", default_value_t = 20.7)]
    pub(crate) angle_min: f64,
    /// The largest area of a triangle inside
    #[arg(long, value_name = "AREA")]
    pub(crate) area_max: Option<f64>,
    /// The longest edge inside: a number, or a file of lines `x y size`, between which sizes grow by no more than the distance
    #[arg(long, value_name = "FIELD")]
    pub(crate) size: Option<String>,
    /// What is inside; files and pictures then hold the inside alone. With `none`, edges of the hull become segments
    #[arg(long, value_enum, default_value_t = Fill::Exterior)]
    pub(crate) fill: Fill,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Refinement {
    /// Off-centres, and free vertices near a segment go before it is split: the fewest vertices
    OffCentre,
    /// Chew's second algorithm: circumcentres, and free vertices near a segment go before it is split
    Chew,
    /// Ruppert's algorithm: circumcentres, and diametral disks of segments are kept empty
    Ruppert,
}

impl Refinement {
    /// As results name it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::OffCentre => "off-centre",
            Self::Chew => "chew",
            Self::Ruppert => "ruppert",
        }
    }
}
