//! One file for each command.

mod adding;
mod alpha;
mod bench;
mod check;
mod classroom;
mod compare;
mod conform;
mod convert;
mod draw;
mod engine;
mod exercise;
mod fuzz;
mod generate;
mod meta;
mod refine;
mod replay;
mod shrink;
mod tree;
mod triangulate;
mod triangulate2d;

use crate::cli::Command;
use crate::failure::Failure;

/// Runs the command asked for.
pub(crate) fn run(command: &Command) -> Result<(), Failure> {
    match command {
        Command::Compare(arguments) => compare::compare(arguments),
        Command::Delaunay(arguments) => triangulate::delaunay(arguments),
        Command::Cdt(arguments) => triangulate::cdt(arguments),
        Command::Conform(arguments) => conform::conform(arguments),
        Command::Refine(arguments) => refine::refine(arguments),
        Command::Alpha(arguments) => alpha::alpha(arguments),
        Command::Text(arguments) => exercise::text(arguments),
        Command::SvgToLar(arguments) => exercise::svg_to_lar(arguments),
        Command::Sample(arguments) => exercise::sample(arguments),
        Command::Triangulate2d(arguments) => triangulate2d::triangulate2d(arguments),
        Command::Tree(arguments) => tree::tree(arguments),
        Command::Check(arguments) => check::check(arguments),
        Command::Gen(arguments) => generate::generate(arguments),
        Command::Convert(arguments) => convert::convert(arguments),
        Command::Draw(arguments) => draw::draw(arguments),
        Command::Classroom(arguments) => classroom::classroom(arguments),
        Command::Fuzz(arguments) => fuzz::fuzz(arguments),
        Command::Shrink(arguments) => shrink::shrink(arguments),
        Command::Replay(arguments) => replay::replay(arguments),
        Command::Bench(arguments) => bench::bench(arguments),
        Command::Engine(arguments) => engine::engine(arguments),
        Command::Cite => meta::cite(),
        Command::Completions { shell } => meta::completions(*shell),
        Command::Man => meta::man(),
    }
}
