//! The command line: every command and option, with what `--help` says.

mod alpha;
mod bench;
mod exercise;
mod fuzz;
mod replay;
mod steiner;
mod tree;

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
pub(crate) use steiner::{Adding, Bounds, Conform, Crossings as Rounding, Refine, Refinement};

pub(crate) use bench::{Bench, BenchAction, Engine};
pub(crate) use fuzz::{Fuzz, Program, Shrink};
pub(crate) use replay::{Replay, Shown};
pub(crate) use tree::{
    Build, By, Code, Divide, Drawn, Encode, Export, Figure, Growth, Inside, Kind, Leaves, Operate,
    Part, SetOperation, SonsIn, Stats, Tree, TreeAction,
};

pub(crate) use alpha::{Alpha, Asked, Mode};
pub(crate) use exercise::{Align, Method, Piped, Sample, SvgToLar, Text};

#[derive(Parser)]
#[command(
    name = "delone",
    version,
    about = "A laboratory for robust triangulation",
    long_about = "A laboratory for robust triangulation: exact Delaunay and constrained Delaunay triangulations, judged \
                  by a checker that shares nothing with them.",
    after_help = "Exit status: 0 done (and, with --check, proved); 1 a judge or comparison found a difference;\n\
                  2 bad usage or bad input, nothing written; 3 a limit was reached, nothing written.\n\n\
                  Examples:\n  \
                  delone compare                              the built-in suite, every algorithm, judged and timed\n  \
                  delone compare lake.poly --html report.html the same on a file, with a report to look at\n  \
                  delone cdt lake.poly --check --svg lake.svg one triangulation, proved and drawn\n  \
                  delone gen coast -n 10000 | delone cdt - --json"
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Subcommand)]
pub(crate) enum Command {
    /// Run every algorithm on inputs (the built-in suite when none), judge, count, time and compare
    Compare(Compare),
    /// Delaunay or, with weights, regular triangulation, in the input's dimension
    Delaunay(Triangulate),
    /// Constrained Delaunay triangulation of a planar straight-line graph
    Cdt(Cdt),
    /// Conforming Delaunay triangulation: Steiner points on segments until each is a chain of Delaunay edges
    Conform(Conform),
    /// Quality refinement: Steiner points until no triangle inside has a small angle or is too large
    Refine(Refine),
    /// Alpha complex of points, or its filtration, signature or persistent homology
    Alpha(Box<Alpha>),
    /// Draw a text in outlines, as SVG
    Text(Text),
    /// Read the paths of an SVG drawing as a model (V, EV), y up, the longer side at most 1
    #[command(name = "svg2lar")]
    SvgToLar(SvgToLar),
    /// Sample random points inside a drawing, by the even-odd rule
    Sample(Sample),
    /// Triangulate the inside of a soup of boundary edges, holes unknown
    #[command(name = "triangulate2d")]
    Triangulate2d(Triangulate2d),
    /// Quadtrees and octrees of what is inside a boundary: numbers, codes, set operations, pictures
    Tree(Tree),
    /// Judge any triangulation of an input, also another program's
    Check(Check),
    /// Generate a workload
    Gen(Generate),
    /// Convert between file formats
    Convert(Convert),
    /// Draw an input and its triangulation as SVG
    Draw(Draw),
    /// Draw where a rounded orientation is wrong: three published lines, plain doubles beside exact signs
    Classroom(Classroom),
    /// Try every law on structured random inputs, or the judge on another program's output
    Fuzz(Fuzz),
    /// Make a failing input as small as possible
    Shrink(Shrink),
    /// Make a page to go through a construction step by step
    Replay(Replay),
    /// Time engines side by side, peers included, each judged before its times count
    Bench(Bench),
    /// One of our algorithms as an engine of a benchmark
    #[command(hide = true)]
    Engine(Engine),
    /// List the algorithms, the papers they follow, and what they are for
    Cite,
    /// Print a completion script for a shell
    Completions {
        /// Which shell
        shell: Shell,
    },
    /// Print the manual page
    Man,
}

#[derive(Args)]
pub(crate) struct Source {
    /// A file, or - for standard input
    pub(crate) input: PathBuf,
    /// The input's format, if neither ending nor content tells
    #[arg(long)]
    pub(crate) format: Option<String>,
}

#[derive(Args)]
pub(crate) struct Triangulate {
    #[command(flatten)]
    pub(crate) source: Source,
    #[command(flatten)]
    pub(crate) weights: Weights,
    /// Stop after so many seconds, with exit status 3 and nothing written
    #[arg(long, value_name = "SECONDS")]
    pub(crate) time_limit: Option<f64>,
    /// Draw Voronoi's diagram too; with weights, the power diagram
    #[arg(long)]
    pub(crate) voronoi: bool,
    #[command(flatten)]
    pub(crate) run: Run,
    #[command(flatten)]
    pub(crate) report: Report,
}

/// Where weights come from.
#[derive(Args)]
pub(crate) struct Weights {
    /// Take the weights of the points from this file, a number for each, instead of the input's
    #[arg(long = "weights", value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,
}

#[derive(Args)]
pub(crate) struct Cdt {
    #[command(flatten)]
    pub(crate) source: Source,
    #[command(flatten)]
    pub(crate) run: Run,
    #[command(flatten)]
    pub(crate) report: Report,
    /// What to do with segments that cross
    #[arg(long, value_enum, default_value_t = Crossings::Reject)]
    pub(crate) crossings: Crossings,
    /// Refuse also what would be repaired: equal points, points inside segments, overlaps, repeats, segments of no length
    #[arg(long, conflicts_with = "crossings")]
    pub(crate) strict: bool,
    /// What is inside; files and pictures then hold the inside alone
    #[arg(long, value_enum, default_value_t = Fill::None)]
    pub(crate) fill: Fill,
}

#[derive(Args)]
pub(crate) struct Triangulate2d {
    #[command(flatten)]
    pub(crate) source: Source,
    /// What is inside
    #[arg(long, value_enum, default_value_t = Fill::Nesting)]
    pub(crate) fill: Fill,
    /// What to do with segments that cross
    #[arg(long, value_enum, default_value_t = Crossings::Split)]
    pub(crate) crossings: Crossings,
    /// Write the result, in the format of the ending; .lar.json holds (V, [EV, FV]), .poly the input with a point in each hole
    #[arg(short, long = "output", value_name = "OUT")]
    pub(crate) outputs: Vec<PathBuf>,
    /// Write the boundary operators as NAME.1.mtx and NAME.2.mtx (Matrix Market)
    #[arg(long, value_name = "NAME")]
    pub(crate) operators: Option<PathBuf>,
    /// Draw the result, one colour for each region
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// Number vertices and triangles in the drawing
    #[arg(long)]
    pub(crate) numbered: bool,
    /// Write a numbered drawing of each step to this folder: the soup, its CDT, edges by their sides, regions, the inside
    #[arg(long, value_name = "FOLDER")]
    pub(crate) explain: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Fill {
    /// The whole convex hull
    None,
    /// What an odd number of segments separates from infinity
    EvenOdd,
    /// What the directed segments wind around
    Nonzero,
    /// What they wind around counter-clockwise
    Positive,
    /// What lies at odd depth, each segment counted once
    Nesting,
    /// Everything that infinity does not reach
    Exterior,
    /// That, less the regions of the file's holes
    Seeds,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Crossings {
    /// List every crossing and stop
    Reject,
    /// Make each crossing a vertex, exactly
    Split,
    /// Make each crossing a vertex at the nearest doubles, and cut again what crosses then
    Snap,
}

/// How to run an algorithm.
#[derive(Args, Clone)]
pub(crate) struct Run {
    /// Which algorithm (`delone cite` lists them)
    #[arg(long)]
    pub(crate) algorithm: Option<String>,
    /// Who answers predicates
    #[arg(long, value_enum, default_value_t = Kernel::Adaptive)]
    pub(crate) kernel: Kernel,
    /// The order in which sites are inserted; the result does not depend on it
    #[arg(long, value_enum, default_value_t = Order::Brio)]
    pub(crate) order: Order,
    /// Seeds the order of insertion; the result does not depend on it
    #[arg(long, default_value_t = 0)]
    pub(crate) seed: u64,
    /// Threads for algorithms that can use several; the result does not depend on it
    #[arg(long, default_value = "1")]
    pub(crate) threads: NonZeroUsize,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kernel {
    /// Floating-point filters, then exact integers
    Adaptive,
    /// Exact integers only
    Exact,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Order {
    /// Biased randomized rounds along Hilbert's curve
    Brio,
    /// Along Hilbert's curve
    Hilbert,
    /// As given
    AsGiven,
    /// By coordinates
    Lexicographic,
}

/// What to say and write.
#[derive(Args, Clone)]
pub(crate) struct Report {
    /// Write the result, in the format of the ending (.ele .node .poly .lar.json .off .obj .csv ...); may be repeated
    #[arg(short, long = "output", value_name = "OUT")]
    pub(crate) outputs: Vec<PathBuf>,
    /// Judge the output in exact arithmetic and say what was proved
    #[arg(long)]
    pub(crate) check: bool,
    /// Count what the algorithm does
    #[arg(long)]
    pub(crate) counts: bool,
    /// Draw the result
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// Write a report to look at in a browser
    #[arg(long, value_name = "FILE")]
    pub(crate) html: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

/// How to speak.
#[derive(Args, Clone)]
pub(crate) struct Voice {
    /// Print one JSON object and nothing else on standard output
    #[arg(long)]
    pub(crate) json: bool,
    /// No progress and no remarks on standard error
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

#[derive(Args)]
pub(crate) struct Compare {
    /// Files and folders; the built-in suite when none
    pub(crate) inputs: Vec<PathBuf>,
    /// Write one self-contained report with pictures
    #[arg(long, value_name = "FILE")]
    pub(crate) html: Option<PathBuf>,
    /// Write the table as CSV
    #[arg(long, value_name = "FILE", conflicts_with = "scaling")]
    pub(crate) csv: Option<PathBuf>,
    /// Write the table for a paper
    #[arg(long, value_name = "FILE", conflicts_with = "scaling")]
    pub(crate) latex: Option<PathBuf>,
    /// Only these algorithms. Methods with Steiner points run if they are named alone: delaunay, gabriel, saalfeld, or conforming
    /// for all of them; each is judged by its own promise, and they need not agree
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    pub(crate) only: Vec<String>,
    #[command(flatten)]
    pub(crate) bounds: Bounds,
    /// Sites of the built-in suite's inputs, about
    #[arg(short, default_value_t = 10_000)]
    pub(crate) n: usize,
    /// Seeds the built-in suite
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// What to do with inputs whose segments cross; the others stay as they are
    #[arg(long, value_enum, default_value_t = Crossings::Reject)]
    pub(crate) crossings: Crossings,
    /// Report inputs that cannot be read or are refused as rows, and go on
    #[arg(long)]
    pub(crate) keep_going: bool,
    /// Instead, run the algorithms on workloads of these sizes, and plot how their costs grow
    #[arg(
        long,
        value_delimiter = ',',
        num_args = 0..=1,
        value_name = "SIZES",
        default_missing_value = "1000,3000,10000,30000,100000",
        conflicts_with = "inputs"
    )]
    pub(crate) scaling: Vec<usize>,
    /// The workloads for --scaling
    #[arg(
        long,
        value_delimiter = ',',
        value_name = "NAMES",
        default_value = "uniform,grid,clusters,uniform-3d,grid-3d,random-segments,coast,ladder",
        requires = "scaling"
    )]
    pub(crate) workloads: Vec<String>,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Args)]
pub(crate) struct Check {
    /// The input: points, and segments for a constrained or conforming triangulation
    pub(crate) input: PathBuf,
    /// The triangulation to judge
    pub(crate) output: PathBuf,
    /// What it should be
    #[arg(long = "as", value_enum)]
    pub(crate) kind: Claim,
    #[command(flatten)]
    pub(crate) weights: Weights,
    /// Demand the one answer of the lexicographic perturbation, positively oriented, as delone gives it
    #[arg(long)]
    pub(crate) strict: bool,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Claim {
    /// A Delaunay triangulation
    Delaunay,
    /// A constrained Delaunay triangulation
    Cdt,
    /// A conforming Delaunay triangulation with Steiner points in doubles: how far each is off its segment is told if the output names
    /// its subsegments, as .poly, .edge and .lar.json do
    Conforming,
    /// The regular triangulation of points with weights
    Regular,
    /// The alpha filtration, as `delone alpha --filtration` lists it: each simplex with its squared radius
    Alpha,
}

#[derive(Args)]
pub(crate) struct Generate {
    /// The workload
    #[arg(required_unless_present = "list")]
    pub(crate) name: Option<String>,
    /// Sites, about
    #[arg(short, default_value_t = 1000)]
    pub(crate) n: usize,
    /// Seed
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
    /// List the workloads
    #[arg(long)]
    pub(crate) list: bool,
    /// With --list: write a report with a picture of each
    #[arg(long, value_name = "FILE", requires = "list")]
    pub(crate) html: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Args)]
pub(crate) struct Convert {
    #[command(flatten)]
    pub(crate) source: Source,
    /// Write to this file; may be repeated
    #[arg(short, long = "output", value_name = "OUT", required = true)]
    pub(crate) outputs: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) voice: Voice,
}

#[derive(Args)]
pub(crate) struct Draw {
    #[command(flatten)]
    pub(crate) source: Source,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
    /// Number vertices and triangles
    #[arg(long)]
    pub(crate) numbered: bool,
    /// Number edges
    #[arg(long)]
    pub(crate) edges: bool,
    /// Move the triangles apart: their distances from the middle, times this
    #[arg(long, value_name = "FACTOR")]
    pub(crate) explode: Option<f64>,
    /// Four panels: the input, its Delaunay triangulation (missing segments in red), its conforming Delaunay triangulation
    /// (Steiner points in red), its constrained Delaunay triangulation (edges that are not Delaunay in red)
    #[arg(long, conflicts_with_all = ["bare", "explode"])]
    pub(crate) panels: bool,
    /// Draw circumcircles
    #[arg(long)]
    pub(crate) circumcircles: bool,
    /// Draw Voronoi's diagram of the points too; with weights, the power diagram
    #[arg(long, conflicts_with = "bare")]
    pub(crate) voronoi: bool,
    #[command(flatten)]
    pub(crate) weights: Weights,
    /// Draw the input as it is, without triangulating it
    #[arg(long)]
    pub(crate) bare: bool,
    /// Length of the longer side in pixels
    #[arg(long, default_value_t = 800.0)]
    pub(crate) size: f64,
}

#[derive(Args)]
pub(crate) struct Classroom {
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
}
