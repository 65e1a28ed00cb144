//! `delone tree`.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

use super::{Source, Voice};

#[derive(Args)]
pub(crate) struct Tree {
    #[command(subcommand)]
    pub(crate) action: TreeAction,
}

#[derive(Subcommand)]
pub(crate) enum TreeAction {
    /// The quadtree of what is inside the segments of an input
    Build(Build),
    /// Numbers of a quadtree given by its depth-first expression
    Stats(Stats),
    /// Another code of a quadtree given by its depth-first expression
    Encode(Encode),
}

#[derive(Args)]
pub(crate) struct Build {
    #[command(flatten)]
    pub(crate) source: Source,
    /// The level m of the smallest cells: the resolution is the square's side by 2^m
    #[arg(long, default_value_t = 8, value_parser = clap::value_parser!(u8).range(0..=31))]
    pub(crate) depth: u8,
    /// What the smallest cells become that the boundary passes through
    #[arg(long, value_enum, default_value_t = Leaves::Centre)]
    pub(crate) rule: Leaves,
    /// Which winding numbers are inside
    #[arg(long, value_enum, default_value_t = Inside::EvenOdd)]
    pub(crate) inside: Inside,
    /// Write the depth-first expression, sons in Morton's order, to this file
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Args)]
pub(crate) struct Stats {
    /// A file with a depth-first expression: ( W B, sons in Morton's order
    pub(crate) code: PathBuf,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Args)]
pub(crate) struct Encode {
    /// A file with a depth-first expression: ( W B, sons in Morton's order
    pub(crate) code: PathBuf,
    /// The code to print
    #[arg(long = "as", value_enum, default_value_t = Code::Df)]
    pub(crate) code_as: Code,
    /// The order of sons in the depth-first expression
    #[arg(long, value_enum, default_value_t = SonsIn::Morton)]
    pub(crate) order: SonsIn,
    /// Write to this file instead of standard output
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Leaves {
    /// White
    Inner,
    /// Black
    Outer,
    /// As their centre is
    Centre,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Inside {
    /// Odd ones
    EvenOdd,
    /// All but zero
    Nonzero,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum Code {
    /// Depth-first expression: ( W B
    Df,
    /// Depth-first bits, as text
    Bits,
    /// Breadth-first bits, as text
    Levels,
    /// Black leaves, a line of digits each
    Linear,
    /// Plain PBM
    Pbm,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum SonsIn {
    /// South-west, south-east, north-west, north-east
    Morton,
    /// Clockwise from the north-west
    Nw,
    /// Clockwise from the north-east
    Ne,
    /// Clockwise from the south-east
    Se,
    /// Clockwise from the south-west
    Sw,
    /// Along Hilbert's curve
    Hilbert,
}
