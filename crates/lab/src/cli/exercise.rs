//! What can be asked of the pieces of the lecture's exercise: `delone text`, `svg2lar`, `sample`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

/// A file, or standard input when none is named.
#[derive(Args)]
pub(crate) struct Piped {
    /// A file, or - for standard input
    #[arg(default_value = "-")]
    pub(crate) input: PathBuf,
    /// The input's format, if neither ending nor content tells
    #[arg(long)]
    pub(crate) format: Option<String>,
}

#[derive(Args)]
pub(crate) struct Text {
    /// The text; there are outlines of " L a r and the blank, and strokes of all printable characters of ASCII
    pub(crate) text: String,
    /// In single strokes, open chains of lines, instead of outlines
    #[arg(long)]
    pub(crate) strokes: bool,
    /// Where the shorter ones of several lines are
    #[arg(long, value_enum, default_value_t = Align::Left)]
    pub(crate) align: Align,
    /// Turn everything by so many degrees, counter-clockwise
    #[arg(long, default_value_t = 0.0, allow_negative_numbers = true)]
    pub(crate) angle: f64,
    /// Put so many thousandths of a line's height between characters
    #[arg(long, default_value_t = 0)]
    pub(crate) spacing: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Align {
    /// On the left
    Left,
    /// In the middle
    Centre,
    /// On the right
    Right,
}

#[derive(Args)]
pub(crate) struct SvgToLar {
    #[command(flatten)]
    pub(crate) source: Piped,
    /// No remarks on standard error
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

#[derive(Args)]
pub(crate) struct Sample {
    #[command(flatten)]
    pub(crate) source: Piped,
    /// How many points (jittered and Poisson: about)
    #[arg(short, long, default_value_t = 1000)]
    pub(crate) n: usize,
    /// Seed
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// How they are spread
    #[arg(long, value_enum, default_value_t = Method::Uniform)]
    pub(crate) method: Method,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Method {
    /// Independently, uniform in the inside
    Uniform,
    /// One in each square of a lattice, if it is inside
    Jittered,
    /// Uniform, but no two nearer than a distance made for about so many
    Poisson,
    /// Uniform along the boundary
    Boundary,
}
