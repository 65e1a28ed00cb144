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
    /// The quadtree of what is inside the segments of an input, or the octree of what is inside its faces
    Build(Build),
    /// Numbers of a tree given by its depth-first expression
    Stats(Stats),
    /// Another code of a tree given by its depth-first expression
    Encode(Encode),
    /// Union, intersection or difference of two trees given by their depth-first expressions
    Op(Operate),
    /// Draw a tree with the cells that it stands for, as SVG
    Figure(Figure),
    /// The boundary of a quadtree as segments, black on the left
    Polygons(Export),
    /// A balanced quadtree as triangles with angles from 26.5 to 90 degrees
    Mesh(Export),
    /// Cut the plane until cells are simple: a PR quadtree of points, a PM quadtree of points and segments
    Divide(Divide),
    /// How trees grow from depth to depth
    Growth(Growth),
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
    /// What tree it is of
    #[arg(long, value_enum, default_value_t = Kind::Quad)]
    pub(crate) kind: Kind,
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
    /// What tree it is of
    #[arg(long, value_enum, default_value_t = Kind::Quad)]
    pub(crate) kind: Kind,
    /// Write to this file instead of standard output
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Args)]
pub(crate) struct Operate {
    /// What to do with them
    #[arg(value_enum)]
    pub(crate) operation: SetOperation,
    /// A file with a depth-first expression: ( W B, sons in Morton's order
    pub(crate) first: PathBuf,
    /// Another one, over the same root
    pub(crate) second: PathBuf,
    /// What trees they are of
    #[arg(long, value_enum, default_value_t = Kind::Quad)]
    pub(crate) kind: Kind,
    /// Write to this file instead of standard output
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Args)]
pub(crate) struct Figure {
    /// What to draw
    #[arg(value_enum)]
    pub(crate) figure: Drawn,
    #[command(flatten)]
    pub(crate) source: Source,
    /// The level m of the smallest cells: the resolution is the square's side by 2^m
    #[arg(long, default_value_t = 4, value_parser = clap::value_parser!(u8).range(0..=31))]
    pub(crate) depth: u8,
    /// What the smallest cells become that the boundary passes through
    #[arg(long, value_enum, default_value_t = Leaves::Centre)]
    pub(crate) rule: Leaves,
    /// Which winding numbers are inside
    #[arg(long, value_enum, default_value_t = Inside::EvenOdd)]
    pub(crate) inside: Inside,
    /// The order of sons
    #[arg(long, value_enum, default_value_t = SonsIn::Nw)]
    pub(crate) order: SonsIn,
    /// Write to this file instead of standard output
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Args)]
pub(crate) struct Export {
    #[command(flatten)]
    pub(crate) source: Source,
    /// The level m of the smallest cells: the resolution is the square's side by 2^m
    #[arg(long, default_value_t = 6, value_parser = clap::value_parser!(u8).range(0..=31))]
    pub(crate) depth: u8,
    /// What the smallest cells become that the boundary passes through
    #[arg(long, value_enum, default_value_t = Leaves::Centre)]
    pub(crate) rule: Leaves,
    /// Which winding numbers are inside
    #[arg(long, value_enum, default_value_t = Inside::EvenOdd)]
    pub(crate) inside: Inside,
    /// Which cells are triangulated, or bounded
    #[arg(long, value_enum, default_value_t = Part::Black)]
    pub(crate) part: Part,
    /// Write to this file, in the format of its ending
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: PathBuf,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Args)]
pub(crate) struct Divide {
    #[command(flatten)]
    pub(crate) source: Source,
    /// When a cell is simple
    #[arg(long, value_enum, default_value_t = By::Pm1)]
    pub(crate) by: By,
    /// How many points a cell of a PR quadtree may hold
    #[arg(long, default_value_t = 1)]
    pub(crate) capacity: usize,
    /// The level of the smallest cells
    #[arg(long, default_value_t = 16, value_parser = clap::value_parser!(u8).range(0..=31))]
    pub(crate) depth: u8,
    /// Draw the cells, as SVG
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum Part {
    /// Black ones
    Black,
    /// All of the square
    All,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum By {
    /// At most so many points
    Pr,
    /// One vertex with edges of its own, or no vertex and at most one edge
    Pm1,
    /// One vertex with edges of its own, or no vertex and edges that have a common one
    Pm2,
    /// At most one vertex
    Pm3,
}

#[derive(Args)]
pub(crate) struct Growth {
    #[command(flatten)]
    pub(crate) source: Source,
    /// The first depth
    #[arg(long, default_value_t = 4, value_parser = clap::value_parser!(u8).range(0..=31))]
    pub(crate) from: u8,
    /// The last depth
    #[arg(long, default_value_t = 12, value_parser = clap::value_parser!(u8).range(0..=31))]
    pub(crate) to: u8,
    /// What the smallest cells become that the boundary passes through
    #[arg(long, value_enum, default_value_t = Leaves::Centre)]
    pub(crate) rule: Leaves,
    /// Which winding numbers are inside
    #[arg(long, value_enum, default_value_t = Inside::EvenOdd)]
    pub(crate) inside: Inside,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Kind {
    /// A quadtree
    Quad,
    /// An octree
    Oct,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum SetOperation {
    /// What is in either
    Union,
    /// What is in both
    Intersection,
    /// What is in the first only
    Difference,
    /// What is in one of them only
    Xor,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Drawn {
    /// An object of the plane, its labelled quadtree, the order of sons, the code
    #[value(alias = "1")]
    Labelled,
    /// The quadtree and the bin-tree of an object of the plane
    #[value(alias = "2")]
    Bintree,
    /// A cell cut into eight, and the octree of a solid
    #[value(alias = "3")]
    Octree,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Leaves {
    /// White
    Inner,
    /// Black
    Outer,
    /// As their centre is
    Centre,
    /// Black if at least half of them is inside, exactly; in the plane
    Area,
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
